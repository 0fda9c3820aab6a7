// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What a program costs grows as its input does: ten times the input takes no more than eleven
/// times the instructions. They are counted and not timed, so that a busy computer changes nothing,
/// by valgrind: most virtual computers count none. What starting costs, by the smallest input, does
/// not belong to it.

#include <fmt/format.h>

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "base/file.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

constexpr double kGrowthMax = 11.0;

const std::string kBegin = "G90 G17 G21 G94\nG1 X0 Y0 Z0 F3000\n";
const std::string kEnd = "M30\n";

/// A path of short moves that winds, as a post-processor writes it.
std::string lines(int count) {
  std::string text = kBegin;
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  for (int i = 0; i < count; ++i) {
    heading += 0.05 * std::sin(0.7 * i) + 0.01;
    x += 0.15 * std::cos(heading);
    y += 0.15 * std::sin(heading);
    text += fmt::format("X{:.4f} Y{:.4f}\n", x, y);
  }
  return text + kEnd;
}

std::string arcs(int count) {
  std::string text = kBegin;
  for (int i = 0; i < count; ++i) {
    text += i % 2 == 0 ? "G2 X4 Y0 I2 J0\n" : "G3 X0 Y0 I-2 J0\n";
  }
  return text + kEnd;
}

std::string expressions(int count) {
  std::string text = "G90 G17 G71 G94\nR1=0 R2=10 R3=0.5\nG1 X0 Y0 Z0 F3000\n";
  for (int i = 0; i < count; ++i) {
    text += "R1=R1+0.01*(R3-0.1)\nG1 X=R1*2+R2 Y=SIN(R1)*R2 Z=-R3\n";
  }
  return text + kEnd;
}

/// All corners in one place.
std::string corners(int count) {
  std::string text = kBegin;
  for (int i = 0; i < count; ++i) {
    text += i % 2 == 0 ? "X0.2\n" : "X0\n";
  }
  return text + kEnd;
}

/// What an oscilloscope exports: set points of a circle, and a position that follows them.
std::string table(int count) {
  std::string text = "t_s;x_set_mm;y_set_mm;x_act_mm\n";
  for (int i = 0; i < count; ++i) {
    const double seconds = 0.004 * i;
    const double x = 50.0 * std::sin(0.7 * seconds);
    text += fmt::format("{:.3f};{:.6f};{:.6f};{:.6f}\n", seconds, x, 50.0 * std::cos(0.7 * seconds),
                        x + 0.001 * std::sin(9.0 * seconds));
  }
  return text;
}

/// A tool that trembles in one place, and stops at every twentieth sample.
std::string stops(int count) {
  std::string text = "t_s;x_set_mm;y_set_mm\n0;-5;0\n0.1;-4;0\n";
  double x = 0.0;
  for (int i = 0; i < 20 * count; ++i) {
    x += i % 20 < 10 ? 0.002 : -0.002;
    text += fmt::format("{:.3f};{:.6f};0\n", 0.2 + 0.004 * i, i % 20 == 10 ? x - 0.002 : x);
  }
  return text + fmt::format("{0:.3f};4;0\n{1:.3f};5;0\n", 0.3 + 0.08 * count, 0.4 + 0.08 * count);
}

const QStringList kCheck{QStringLiteral("check")};
const QStringList kAnalyse{QStringLiteral("analyse")};
const QStringList kStream{QStringLiteral("stream"),   QStringLiteral("--simulate"),
                          QStringLiteral("--feed"),   QStringLiteral("3000"),
                          QStringLiteral("--points"), QStringLiteral("7")};

const QStringList kPlan{QStringLiteral("feasibility"), QStringLiteral("--feed"),
                        QStringLiteral("3000"),        QStringLiteral("--points"),
                        QStringLiteral("7"),           QStringLiteral("--program")};
const QStringList kPetri{QStringLiteral("petri"), QStringLiteral("simulate"),
                         QStringLiteral("--seed"), QStringLiteral("1"), QStringLiteral("--until")};

/// What the command gets.
enum class Input {
  Text,
  Recording,  ///< of a run with the text
  Hdf5,       ///< the table of the text, saved
};

struct Work {
  const char* name;
  QStringList command;  ///< without its file
  const char* file;
  std::string (*text)(int count);  ///< null: the command gets the count itself
  int count;                       ///< the input is as long as this, and ten times
  Input input = Input::Text;
};

const std::array kWork{
    Work{"load lines", kCheck, "PART.NC", lines, 2000},
    Work{"load arcs", kCheck, "PART.NC", arcs, 1000},
    Work{"load expressions", kCheck, "PART.MPF", expressions, 500},
    Work{"simulate and judge", kStream, "PART.NC", lines, 200},
    Work{"simulate corners in one place", kStream, "PART.NC", corners, 50},
    Work{"analyse a recording", kAnalyse, "PART.NC", lines, 200, Input::Recording},
    Work{"analyse a recording of corners in one place", kAnalyse, "PART.NC", corners, 50,
         Input::Recording},
    Work{"analyse stops in one place", kAnalyse, "STOPS.CSV", stops, 1000},
    Work{"import a table", kAnalyse, "TABLE.CSV", table, 2000},
    Work{"plan and time", kPlan, "PART.NC", lines, 150},
    Work{"play a Petri net", kPetri, "", nullptr, 500},
    Work{"import HDF5", kAnalyse, "TABLE.CSV", table, 10'000, Input::Hdf5},
};

}  // namespace

class TestGrowth : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_valgrind;

  static void requireRun(const QString& program, const QStringList& arguments, QByteArray& errors) {
    QProcess process;
    process.start(program, arguments);
    QVERIFY(process.waitForFinished(tests::kRunMs));
    errors = process.readAllStandardError();
    QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
             errors.constData());
  }

  /// @param instructions  gets those of the command with an input of that length
  void count(const Work& work, int length, double& instructions) {
    const QString cli = QStringLiteral(RIVULET_CLI);
    QString path = m_folder.filePath(QString::fromUtf8(work.file));
    if (work.text == nullptr) {
      path = QString::number(length);
    } else {
      QVERIFY(base::writeFile(path.toStdString(), work.text(length)).has_value());
    }
    QByteArray errors;
    if (work.input == Input::Hdf5) {
      const QString packed = m_folder.filePath(QStringLiteral("TABLE.h5"));
      requireRun(cli, kAnalyse + QStringList{path, QStringLiteral("--save"), packed}, errors);
      path = packed;
    } else if (work.input == Input::Recording) {
      const QString recording = m_folder.filePath(QStringLiteral("run.recording"));
      QFile::remove(recording);
      requireRun(cli, kStream + QStringList{path, QStringLiteral("--record"), recording}, errors);
      path = recording;
    }
    requireRun(m_valgrind,
               QStringList{QStringLiteral("--tool=cachegrind"), QStringLiteral("--cache-sim=no"),
                           QStringLiteral("--cachegrind-out-file=/dev/null"), cli} +
                   work.command + QStringList{path},
               errors);
    // "==12== I   refs:      50,380,647"
    const qsizetype at = errors.lastIndexOf("refs:");
    QVERIFY2(at >= 0, errors.constData());
    instructions = errors.mid(at + 5).trimmed().split('\n').first().replace(",", "").toDouble();
    QVERIFY(instructions > 0.0);
  }

 private Q_SLOTS:
  void initTestCase() {
    m_valgrind = QStandardPaths::findExecutable(QStringLiteral("valgrind"));
    if (m_valgrind.isEmpty() || tests::kIsSanitized) {
      QSKIP("Instructions are counted by valgrind, and without a sanitizer.");
    }
    QVERIFY(m_folder.isValid());
  }

  void isLinear_data() {
    QTest::addColumn<std::size_t>("index");
    for (std::size_t i = 0; i < kWork.size(); ++i) {
      QTest::newRow(kWork[i].name) << i;
    }
  }

  void isLinear() {
    QFETCH(std::size_t, index);
    const Work& work = kWork[index];
#ifndef RIVULET_TEST_HDF5
    if (work.input == Input::Hdf5) {
      QSKIP("This Rivulet was built without the library HDF5.");
    }
#endif
    double least = 0.0;
    double once = 0.0;
    double tenfold = 0.0;
    constexpr int kLeast = 10;  // shorter ones have no motion to analyse
    count(work, kLeast, least);
    count(work, kLeast + work.count, once);
    count(work, kLeast + 10 * work.count, tenfold);
    if (QTest::currentTestFailed()) {
      return;
    }
    const double growth = (tenfold - least) / (once - least);
    qInfo("%.0f and %.0f instructions: %.2f times", once - least, tenfold - least, growth);
    QVERIFY2(growth > 5.0, "the input is too short to tell");
    QVERIFY(growth <= kGrowthMax);
  }
};

RIVULET_TEST(TestGrowth)
#include "tst_growth.moc"
