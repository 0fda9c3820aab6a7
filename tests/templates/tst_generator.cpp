// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// RIVULET_UPDATE_GOLDEN=1 rewrites the expected programs in tests/data/templates.

#include <QFile>
#include <QtTest>
#include <algorithm>
#include <set>

#include "support/test_program.h"
#include "templates/continuation.h"
#include "templates/flexible_program.h"
#include "templates/method_template.h"
#include "templates/target.h"

using namespace rivulet;
using base::MethodKind;
using templates::Layout;
using templates::SignalStop;
using templates::TemplateParameters;

namespace {

QStringList linesOf(const std::string& text) {
  return QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

/// The blocks without comments.
QStringList blocksOf(const TemplateParameters& parameters) {
  const auto program = templates::makeProgram(parameters);
  return program ? linesOf(program->text).filter(QRegularExpression(QStringLiteral("^[^;]")))
                 : QStringList();
}

TemplateParameters make(MethodKind method, int pointsPerLoop, Layout layout = Layout::Paper,
                        SignalStop stop = SignalStop::EachSignal,
                        std::array<bool, base::kAxisCount> axes = {true, true, true}) {
  TemplateParameters parameters;
  parameters.method = method;
  parameters.pointsPerLoop = pointsPerLoop;
  parameters.layout = layout;
  parameters.signalStop = stop;
  parameters.axes = axes;
  return parameters;
}

}  // namespace

class TestGenerator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void golden_data() {
    QTest::addColumn<TemplateParameters>("parameters");
    QTest::newRow("signal_7_paper") << make(MethodKind::Signal, 7);
    QTest::newRow("signal_7_contiguous_once")
        << make(MethodKind::Signal, 7, Layout::Contiguous, SignalStop::OncePerLoop);
    QTest::newRow("signal_2_paper_xz")
        << make(MethodKind::Signal, 2, Layout::Paper, SignalStop::EachSignal, {true, false, true});
    QTest::newRow("position_5_paper") << make(MethodKind::Position, 5);
    QTest::newRow("position_1_contiguous_y") << make(MethodKind::Position, 1, Layout::Contiguous,
                                                     SignalStop::EachSignal, {false, true, false});
  }

  void goldenWindow_data() {
    QTest::addColumn<TemplateParameters>("parameters");
    QTest::newRow("window_7") << make(MethodKind::Window, 7);
    TemplateParameters parameters =
        make(MethodKind::Window, 3, Layout::Paper, SignalStop::EachSignal, {true, false, true});
    parameters.windows = 3;
    parameters.baseCell = 40;
    parameters.slotStride = 5;
    parameters.rParameterCount = 200;
    QTest::newRow("window_3_xz_base_40") << parameters;
    QTest::newRow("credit_7") << make(MethodKind::Credit, 7);
    TemplateParameters packed = make(MethodKind::Window, 4);
    packed.packed = true;
    packed.feedPerPoint = true;
    QTest::newRow("window_4_packed") << packed;
    TemplateParameters lifting = make(MethodKind::Window, 2);
    lifting.liftMm = 2.0;
    QTest::newRow("window_2_lifting") << lifting;
    TemplateParameters corrected = make(MethodKind::Window, 2);
    corrected.correctionLimitMm = 0.1;
    QTest::newRow("window_2_corrected") << corrected;
    corrected.method = MethodKind::Credit;
    corrected.axes = {true, false, true};
    corrected.correctionLimitMm = 0.025;
    QTest::newRow("credit_2_xz_corrected") << corrected;
  }
  void goldenWindow() { golden(); }

  void goldenLinuxCnc_data() {
    QTest::addColumn<TemplateParameters>("parameters");
    TemplateParameters parameters = make(MethodKind::Window, 3);
    parameters.target = templates::TargetControl::LinuxCnc;
    QTest::newRow("linuxcnc_window_3") << parameters;
    parameters =
        make(MethodKind::Credit, 2, Layout::Paper, SignalStop::EachSignal, {true, false, true});
    parameters.target = templates::TargetControl::LinuxCnc;
    parameters.windows = 4;
    parameters.baseCell = 20;
    parameters.slowDown = false;
    parameters.feedPerPoint = true;
    QTest::newRow("linuxcnc_credit_2_xz") << parameters;
  }
  void goldenLinuxCnc() { golden(); }

  /// LinuxCNC refuses a program in which an O-word has two beginnings, and lines of 256 characters.
  void linuxCncTakesTheText() {
    TemplateParameters parameters = make(MethodKind::Credit, 30);
    parameters.target = templates::TargetControl::LinuxCnc;
    parameters.windows = 8;
    parameters.slowDown = false;
    parameters.rParameterCount = 1000;
    const QStringList blocks = blocksOf(parameters);
    QVERIFY(!blocks.isEmpty());
    std::set<QString> begun;
    for (const QString& block : blocks) {
      QVERIFY(block.size() < 255);
      const QString first = block.section(QLatin1Char(' '), 0, 1);
      if (first.endsWith(QLatin1String(" if")) || first.endsWith(QLatin1String(" while"))) {
        QVERIFY2(begun.insert(first.section(QLatin1Char(' '), 0, 0)).second, qPrintable(block));
      }
    }
  }

  void aServerSaysWhichControlIsBehindIt() {
    using templates::TargetControl;
    QCOMPARE(templates::targetOf(templates::kLinuxCncApplicationUri), TargetControl::LinuxCnc);
    for (const char* const other : {"", "urn:rivulet:machine", "urn:rivulet:linuxcnc2"}) {
      QCOMPARE(templates::targetOf(other), TargetControl::Sinumerik);
    }
    // What it does not have is left out, and comes back with the next control.
    const TemplateParameters wanted = make(MethodKind::Credit, 2);
    QVERIFY(wanted.slowDown);
    const TemplateParameters there = templates::forTarget(wanted, TargetControl::LinuxCnc);
    QVERIFY(templates::makeProgram(there).has_value());
    QVERIFY(templates::forTarget(wanted, TargetControl::Sinumerik).slowDown);
  }

  void whatOthersDoNotHave_data() {
    QTest::addColumn<TemplateParameters>("parameters");
    TemplateParameters parameters = make(MethodKind::Signal, 7);
    parameters.target = templates::TargetControl::LinuxCnc;
    QTest::newRow("method") << parameters;
    parameters = make(MethodKind::Window, 7);
    parameters.target = templates::TargetControl::LinuxCnc;
    parameters.correctionLimitMm = 0.1;
    QTest::newRow("correction") << parameters;
    parameters.correctionLimitMm = 0.0;
    parameters.packed = true;
    QTest::newRow("packed points") << parameters;
    parameters = make(MethodKind::Credit, 7);
    parameters.target = templates::TargetControl::LinuxCnc;
    QTest::newRow("slower before windows run out") << parameters;
    parameters.slowDown = false;
    parameters.windows = 1;
    QTest::newRow("one window") << parameters;
  }
  void whatOthersDoNotHave() {
    QFETCH(const TemplateParameters, parameters);
    const auto program = templates::makeProgram(parameters);
    QVERIFY(!program);
    QVERIFY(program.error().code == templates::TemplateError::NotOnTarget);
  }

  void golden() {
    QFETCH(const TemplateParameters, parameters);
    const auto program = templates::makeProgram(parameters);
    QVERIFY(program.has_value());
    const QByteArray actual = QByteArray::fromStdString(program->text);
    QFile file(QStringLiteral(RIVULET_SOURCE_DIR "/tests/data/templates/%1.mpf")
                   .arg(QLatin1String(QTest::currentDataTag())));
    if (qEnvironmentVariableIsSet("RIVULET_UPDATE_GOLDEN")) {
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(actual);
      return;
    }
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
    QCOMPARE(linesOf(program->text), linesOf(file.readAll().toStdString()));
    file.seek(0);
    QCOMPARE(actual, file.readAll());
  }

  /// Within a window the axes go on; from one window to the next, full or short, they stop. With
  /// method credit they go on there, too.
  void saysBetweenWhichBlocksItStops() {
    for (const bool isCredit : {false, true}) {
      TemplateParameters parameters;
      parameters.method = isCredit ? MethodKind::Credit : MethodKind::Window;
      parameters.pointsPerLoop = 3;
      const auto program = templates::makeProgram(parameters);
      QVERIFY(program);
      const QStringList lines = QString::fromStdString(program->text).split(QLatin1Char('\n'));
      std::vector<std::uint32_t> motion;
      for (qsizetype i = 0; i < lines.size(); ++i) {
        if (lines[i].startsWith(QStringLiteral("G1 "))) {
          motion.push_back(static_cast<std::uint32_t>(i + 1));
        }
      }
      const auto continuations = templates::continuationsOf(program->text);
      const auto goesOn = [&](std::size_t from, std::size_t to) {
        const base::Continuation wanted{base::LineNumber{motion[from]},
                                        base::LineNumber{motion[to]}};
        return std::binary_search(continuations.begin(), continuations.end(), wanted);
      };
      QCOMPARE(motion.size(), std::size_t{6});  // a full window, and a short one
      QVERIFY(goesOn(0, 1) && goesOn(1, 2) && goesOn(3, 4) && goesOn(4, 5));
      QVERIFY(!goesOn(0, 2) && !goesOn(1, 0));
      for (const std::size_t next : {std::size_t{0}, std::size_t{3}}) {
        QCOMPARE(goesOn(2, next), isCredit);
        QCOMPARE(goesOn(4, next), isCredit);
      }
    }
    QVERIFY(templates::continuationsOf("").empty());
    QVERIFY(templates::continuationsOf("G1 X1\nG1 X2\nM30\n").empty());  // it never stops
  }

  void everyTemplateIsPlainText() {
    for (const MethodKind method : base::kMethodKinds) {
      for (const Layout layout : {Layout::Paper, Layout::Contiguous}) {
        for (int n = 2; n <= 300; n += 13) {
          TemplateParameters parameters = make(method, n, layout);
          parameters.rParameterCount = 4000;
          const auto program = templates::makeProgram(parameters);
          QVERIFY(program.has_value());
          QCOMPARE(program->text.back(), '\n');
          for (const char c : program->text) {
            QVERIFY(c == '\n' || (c >= ' ' && c <= '~'));
          }
          for (const QString& line : linesOf(program->text)) {
            QVERIFY2(line.size() <= 120, qPrintable(line));
          }
        }
      }
    }
  }

  void everySlotMovesOnceInOrder() {
    for (const MethodKind method : base::kPaperMethods) {
      for (const SignalStop stop : {SignalStop::EachSignal, SignalStop::OncePerLoop}) {
        const TemplateParameters parameters = make(method, 8, Layout::Paper, stop);
        const auto cells = templates::planCells(parameters);
        QVERIFY(cells.has_value());
        const QStringList moves =
            blocksOf(parameters).filter(QRegularExpression(QStringLiteral("^G1 ")));
        QCOMPARE(moves.size(), 8);
        for (int slot = 0; slot < 8; ++slot) {
          const std::vector<int> numbers = cells->slotCells(slot);
          QCOMPARE(moves[slot], QStringLiteral("G1 X=R%1 Y=R%2 Z=R%3 F=R3")
                                    .arg(numbers[0])
                                    .arg(numbers[1])
                                    .arg(numbers[2]));
        }
      }
    }
  }

  /// Between the decision to take a window and the motion there is a copy and its check, and no
  /// motion block reads an R-parameter. Every way into the loop passes a STOPRE and the stop cell.
  void windowMovesOnlyFromItsCheckedCopy() {
    for (const int count : {1, 2, 7, 14}) {
      for (const int windows : {1, 2, 3}) {
        TemplateParameters parameters = make(MethodKind::Window, count);
        parameters.windows = windows;
        parameters.rParameterCount = 300;
        const auto cells = templates::planCells(parameters);
        QVERIFY(cells.has_value());
        const QStringList blocks = blocksOf(parameters);
        for (const QString& block : blocks.filter(QRegularExpression(QStringLiteral("^G1 ")))) {
          QVERIFY2(!block.contains(QRegularExpression(QStringLiteral("R[0-9\\[]"))),
                   qPrintable(block));
        }
        const qsizetype take = blocks.indexOf(QStringLiteral("RIV_TAKE:"));
        const qsizetype check =
            blocks.indexOf(QStringLiteral("IF ABS(RIV_S)>0.000001 GOTOF RIV_DAMAGED"));
        const qsizetype firstMove = blocks.indexOf(QRegularExpression(QStringLiteral("^G1 .*")));
        QVERIFY(take > 0 && take < check && check < firstMove);
        const QString latched = QStringLiteral("R%1=RIV_L").arg(cells->latched);
        QCOMPARE(blocks.count(latched), 1);
        QVERIFY(blocks.indexOf(latched) > check && blocks.indexOf(latched) < firstMove);
        const qsizetype next = blocks.indexOf(QStringLiteral("RIV_NEXT:"));
        QCOMPARE(blocks[next + 1], QStringLiteral("STOPRE"));
        QCOMPARE(blocks[next + 3], QStringLiteral("IF R%1>1 GOTOF RIV_STOPPED").arg(cells->run));
        // Every label jumped to exists once, after a GOTOF and before a GOTOB.
        const QRegularExpression jump(QStringLiteral("GOTO([FB]) (RIV_[A-Z]+)$"));
        for (qsizetype i = 0; i < blocks.size(); ++i) {
          const auto match = jump.match(blocks[i]);
          if (match.hasMatch()) {
            const QString label = match.captured(2) + QLatin1Char(':');
            QCOMPARE(blocks.count(label), 1);
            QCOMPARE(blocks.indexOf(label) > i, match.captured(1) == QStringLiteral("F"));
          }
        }
        QCOMPARE(blocks.last(), QStringLiteral("M30"));
      }
    }
  }

  void stopreStandsBeforeEverySignalThatNeedsIt() {
    const QStringList each = blocksOf(make(MethodKind::Signal, 7));
    for (const char* signal : {"R0=0", "R0=1"}) {
      const qsizetype at = each.indexOf(QLatin1String(signal));
      QVERIFY(at > 0);
      QCOMPARE(each[at - 1], QStringLiteral("STOPRE"));
    }
    const QStringList once =
        blocksOf(make(MethodKind::Signal, 7, Layout::Paper, SignalStop::OncePerLoop));
    const qsizetype first = once.indexOf(QStringLiteral("R0=0"));
    QVERIFY(once[first - 1].startsWith(QStringLiteral("G1 X=R31")));
    QVERIFY(once[first + 1].startsWith(QStringLiteral("G1 X=R41")));
    QCOMPARE(once[once.indexOf(QStringLiteral("R0=1")) - 1], QStringLiteral("STOPRE"));
  }

  void programEndsAndResetsAsAgreed() {
    for (const MethodKind method : base::kPaperMethods) {
      const TemplateParameters parameters = make(method, 4);
      const QStringList blocks = blocksOf(parameters);
      QCOMPARE(blocks.last(), QStringLiteral("M30"));
      QCOMPARE(blocks[blocks.size() - 3], QStringLiteral("IF R2<1 GOTOB RIV_LOOP"));
      // The layout number appears once everything the client may write has been reset.
      const auto number =
          QStringLiteral("R4=%1").arg(templates::makeProgram(parameters)->layoutNumber);
      const qsizetype at = blocks.indexOf(number);
      QVERIFY(at > 0);
      for (const char* reset : {"R1=0", "R2=0", "R0=2"}) {
        QCOMPARE(blocks.count(QLatin1String(reset)), 1);
        QVERIFY(blocks.indexOf(QLatin1String(reset)) < at);
      }
      // Every label jumped to exists once.
      for (const char* label : {"RIV_WAIT:", "RIV_LOOP:", "RIV_END:"}) {
        QCOMPARE(blocks.count(QLatin1String(label)), 1);
      }
    }
  }

  void errorsAreThoseOfThePlan() {
    const auto refused = templates::makeProgram(make(MethodKind::Signal, 1));
    QVERIFY(!refused);
    QVERIFY(refused.error().code == templates::TemplateError::TooFewPointsPerLoop);
  }

  void fileNames() {
    QCOMPARE(templates::makeProgram({})->name, std::string("RIVULET_WINDOW_7X2.MPF"));
    QCOMPARE(templates::makeProgram(make(MethodKind::Position, 8))->name,
             std::string("RIVULET_POSITION_8.MPF"));
    constexpr int kManyCells = 200'000;
    std::set<std::string> names;
    std::size_t count = 0;
    for (const MethodKind method : base::kPaperMethods) {
      for (const Layout layout : {Layout::Paper, Layout::Contiguous}) {
        for (unsigned axes = 1; axes < 8; ++axes) {
          for (const int n : {2, 7, 40, 999, 1000, 9999, 16262}) {
            TemplateParameters parameters =
                make(method, n, layout, SignalStop::EachSignal,
                     {(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0});
            parameters.rParameterCount = kManyCells;
            const std::string name = templates::makeProgram(parameters)->name;
            QVERIFY2(name.size() <= 24 + 4, name.c_str());
            QVERIFY(QString::fromStdString(name).contains(
                QRegularExpression(QStringLiteral("^[A-Z]{2}[A-Z0-9_]*\\.MPF$"))));
            names.insert(name);
            ++count;
          }
        }
      }
    }
    for (const int n : {1, 7, 999}) {
      for (const int windows : {1, 2, 8}) {
        for (const int base : {0, 40, 900}) {
          for (const int stride : {0, 5}) {
            TemplateParameters parameters = make(MethodKind::Window, n);
            parameters.windows = windows;
            parameters.baseCell = base;
            parameters.slotStride = stride;
            parameters.rParameterCount = kManyCells;
            names.insert(templates::makeProgram(parameters)->name);
            ++count;
          }
        }
      }
    }
    QCOMPARE(templates::makeProgram(make(MethodKind::Signal, 7))->name,
             std::string("RIVULET_SIGNAL_7.MPF"));
    QCOMPARE(names.size(), count);
  }
};

RIVULET_TEST(TestGenerator)
#include "tst_generator.moc"
