// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The commands of emulators: from a trace to an emulator, to a machine, to what it does; and what
/// they say of input that is no good.

#include <fmt/format.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "emulator/axis_model.h"
#include "machine/config.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;

namespace {

struct Outcome {
  int exit = -1;
  QString output;
  QString errors;
  [[nodiscard]] json parsed() const { return json::parse(output.toStdString(), nullptr, false); }
};

Outcome cli(const QStringList& arguments) {
  QProcess process;
  process.start(QStringLiteral(RIVULET_CLI), arguments);
  Outcome outcome;
  if (process.waitForFinished(tests::kRunMs) && process.exitStatus() == QProcess::NormalExit) {
    outcome.exit = process.exitCode();
  }
  outcome.output = QString::fromUtf8(process.readAllStandardOutput());
  outcome.errors = QString::fromUtf8(process.readAllStandardError());
  return outcome;
}

Outcome run(const QStringList& arguments) {
  return cli(QStringList{QStringLiteral("emulator")} + arguments);
}

/// A trace of an axis that follows with 1/40 s of lag; times, set points and positions can be
/// spoilt.
struct Trace {
  std::vector<double> atS;
  std::vector<double> setMm;
  std::vector<double> seenMm;

  explicit Trace(double seconds = 30.0, double reachMm = 20.0) {
    for (int i = 0; 0.004 * i < seconds; ++i) {
      atS.push_back(0.004 * i);
      const double swing = std::sin(1.1 * atS.back()) + 0.2 * std::sin(7.0 * atS.back());
      setMm.push_back(reachMm * swing);
    }
    emulator::AxisParameters law = emulator::firstOrderLag(1.0 / 40.0);
    for (const emulator::AxisState& state : emulator::simulateAxis(law, 0.004, setMm)) {
      seenMm.push_back(state.mm);
    }
  }

  [[nodiscard]] QByteArray text(bool withSetPoints = true, char axis = 'x') const {
    std::string text = withSetPoints ? fmt::format("t_s,{0}_cmd,{0}_fb\n", axis)
                                     : fmt::format("t_s,{}_fb\n", axis);
    for (std::size_t i = 0; i < atS.size(); ++i) {
      text += withSetPoints ? fmt::format("{:.4f},{:.7f},{:.7f}\n", atS[i], setMm[i], seenMm[i])
                            : fmt::format("{:.4f},{:.7f}\n", atS[i], seenMm[i]);
    }
    return QByteArray::fromStdString(text);
  }
};

}  // namespace

class TestEmulatorCommands : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString file(const char* name, const QByteArray& text) {
    QFile out(m_folder.filePath(QString::fromUtf8(name)));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) < 0) {
      qFatal("the test's folder cannot be written");
    }
    return out.fileName();
  }

 private Q_SLOTS:
  void goesFromATraceToAMachine() {
    const QString trace = file("good.csv", Trace().text());
    const QString emulator = m_folder.filePath(QStringLiteral("mine.toml"));
    const Outcome learned = run({QStringLiteral("learn"), trace, QStringLiteral("--output"),
                                 emulator, QStringLiteral("--json")});
    QVERIFY2(learned.exit == 0, qPrintable(learned.errors));
    const double gain =
        learned.parsed()["axes"][0]["parameters"]["position_gain"]["value"].get<double>();
    QVERIFY2(std::abs(gain - 40.0) < 1e-3, qPrintable(QString::number(gain)));
    const auto machine = machine::loadPreset(emulator.toStdString());
    QVERIFY2(machine, machine ? "" : machine.error().text().c_str());
    QCOMPARE((*machine->axisLaw(0))[emulator::AxisParameter::PositionGain], gain);
    QCOMPARE(machine->rapidMmPerS, machine::loadPreset("dmu75")->rapidMmPerS);

    const Outcome good = run({QStringLiteral("monitor"), QStringLiteral("--emulator"), emulator,
                              trace, QStringLiteral("--json")});
    QVERIFY2(good.exit == 0, qPrintable(good.errors));
    QVERIFY(good.parsed()[0]["deviations"].empty());
    Trace shifted;
    for (std::size_t i = shifted.seenMm.size() / 2; i < shifted.seenMm.size(); ++i) {
      shifted.seenMm[i] += 0.05;
    }
    const Outcome bad = run({QStringLiteral("monitor"), QStringLiteral("--emulator"), emulator,
                             file("shifted.csv", shifted.text()), QStringLiteral("--json")});
    QCOMPARE(bad.exit, 1);
    const json deviation = bad.parsed()[0]["deviations"][0];
    QCOMPARE(deviation["axis"].get<std::string>(), std::string("X"));
    QVERIFY(std::abs(deviation["from_s"].get<double>() - 15.0) < 1.1);
    QVERIFY(std::abs(deviation["largest_mm"].get<double>() - 0.05) < 0.01);
  }

  /// From the recording of a run to what another program will do, without any file but these.
  void predictsAnotherProgram() {
    const QString known = file("known.toml",
                               "[emulator]\nversion = 1\npreset = \"dmu75\"\n"
                               "[axes.X.servo]\nposition_gain = 40.0\n"
                               "[axes.Y.servo]\nposition_gain = 30.0\n");
    const QString taught = file("taught.mpf",
                                "G90 G17\nG1 X20 Y0 Z0 F3000\nX20 Y15\nX0 Y15 F1200\nX0 Y0\n"
                                "X30 Y20 Z-2 F6000\nX29 Y19 F300\nX31 Y21\nX29 Y19 Z-1\n"
                                "X0 Y0 Z0 F4000\nM30\n");
    const QString part = file("part.mpf",
                              "G90 G17\nG1 X-15 Y8 F2000\nX10 Y-12 Z-3\nX12 Y30 F5000\n"
                              "X-20 Y-20 Z0\nX-20 Y-19 F100\nX0 Y0 F3000\nM30\n");
    const auto stream = [this](const QString& program, const QString& preset, const char* record) {
      return cli({QStringLiteral("stream"), program, QStringLiteral("--simulate"),
                  QStringLiteral("--preset"), preset, QStringLiteral("--record"),
                  m_folder.filePath(QLatin1String(record)), QStringLiteral("--json")});
    };
    QCOMPARE(stream(taught, known, "taught.rivulet").exit, 0);
    const QString learned = m_folder.filePath(QStringLiteral("learned.toml"));
    const Outcome learning =
        run({QStringLiteral("learn"), m_folder.filePath(QStringLiteral("taught.rivulet")),
             QStringLiteral("--output"), learned});
    QVERIFY2(learning.exit == 0, qPrintable(learning.errors));

    const Outcome machine = stream(part, known, "machine.rivulet");
    const Outcome predicted = stream(part, learned, "predicted.rivulet");
    QVERIFY2(machine.exit == 0 && predicted.exit == 0, qPrintable(predicted.errors));
    QVERIFY(std::abs(machine.parsed()["duration_s"].get<double>() -
                     predicted.parsed()["duration_s"].get<double>()) < 0.02);
    const Outcome test =
        run({QStringLiteral("test"), QStringLiteral("--emulator"), learned,
             m_folder.filePath(QStringLiteral("machine.rivulet")), QStringLiteral("--json")});
    const json fit = test.parsed()[0];
    QVERIFY2(fit["position_rms_mm"].get<double>() < 0.002, qPrintable(test.output));
    QVERIFY(std::abs(fit["contour_rms_mm"].get<double>() -
                     fit["emulated_contour_rms_mm"].get<double>()) < 0.001);
    QVERIFY(fit["contour_rms_mm"].get<double>() > 0.1);  // there is something to predict

    // Feasibility and time estimate take it as any preset.
    const auto feasibility = [&](const QString& preset) {
      return cli({QStringLiteral("feasibility"), QStringLiteral("--program"), part,
                  QStringLiteral("--preset"), preset, QStringLiteral("--json")});
    };
    const Outcome judged = feasibility(learned);
    QVERIFY2(judged.exit == 0, qPrintable(judged.errors));
    const auto seconds = [](const Outcome& outcome) {
      return outcome.parsed()["time_without_pauses_s"].get<double>();
    };
    QCOMPARE(seconds(judged), seconds(feasibility(known)));
    // With a limit of the machine that its engineer adds by hand.
    QFile text(learned);
    QVERIFY(text.open(QIODevice::ReadOnly));
    const QString limited =
        file("limited.toml", text.readAll() + "\n[axes.X]\naccelerationMmPerS2 = 200.0\n");
    QVERIFY(seconds(feasibility(limited)) > 1.05 * seconds(judged));
    QVERIFY(stream(part, limited, "limited.rivulet").parsed()["duration_s"].get<double>() >
            1.05 * predicted.parsed()["duration_s"].get<double>());
    const Outcome refused = feasibility(m_folder.filePath(QStringLiteral("nowhere.toml")));
    QCOMPARE(refused.exit, 2);
  }

  void saysWhatIsWrong_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("named");
    Trace still(30.0, 0.0);
    QTest::newRow("no motion") << still.text() << "No axis moves";
    QTest::newRow("too short") << Trace(0.1).text() << "observed";
    Trace inches;
    for (double& mm : inches.seenMm) {
      mm /= 25.4;
    }
    QTest::newRow("units mixed") << inches.text() << "units";
    Trace reversed;
    std::reverse(reversed.seenMm.begin(), reversed.seenMm.end());
    QTest::newRow("another program") << reversed.text() << "departs from the trace";
    Trace backwards;
    std::swap(backwards.atS[100], backwards.atS[140]);
    QTest::newRow("time runs backwards") << backwards.text() << "ime";
    Trace spoilt;
    spoilt.seenMm[200] = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("not a number") << spoilt.text() << "number";
    QTest::newRow("no set points") << Trace().text(false) << "set points";
    QTest::newRow("no table") << QByteArray("one line\n") << "";
  }
  void saysWhatIsWrong() {
    QFETCH(QByteArray, text);
    QFETCH(QString, named);
    const QString kept = file("kept.toml", "kept\n");
    const Outcome outcome =
        run({QStringLiteral("learn"), file("bad.csv", text), QStringLiteral("--output"), kept});
    QVERIFY2(outcome.exit == 2, qPrintable(QString::number(outcome.exit) + outcome.output));
    QVERIFY2(outcome.errors.contains(named), qPrintable(outcome.errors));
    QCOMPARE(outcome.errors.trimmed().count(QLatin1Char('\n')), 0);  // one sentence
    QFile still(kept);
    QVERIFY(still.open(QIODevice::ReadOnly));
    QCOMPARE(still.readAll(), QByteArray("kept\n"));  // nothing lost
  }

  void learnsTheOneAxisThatMovesAndRefusesOthers() {
    const QString emulator = m_folder.filePath(QStringLiteral("one.toml"));
    QCOMPARE(run({QStringLiteral("learn"), file("one.csv", Trace().text()),
                  QStringLiteral("--output"), emulator})
                 .exit,
             0);
    const Outcome other = run({QStringLiteral("test"), QStringLiteral("--emulator"), emulator,
                               file("other.csv", Trace().text(true, 'y'))});
    QCOMPARE(other.exit, 2);
    QVERIFY2(other.errors.contains(QStringLiteral("axis Y")), qPrintable(other.errors));
  }

  void wantsOneProgramForEachTrace() {
    const QString trace = file("good.csv", Trace().text());
    const QString program = file("p.ngc", "G61\nF3000\nG1 X10 Y0\n");
    const Outcome outcome =
        run({QStringLiteral("learn"), trace, trace, QStringLiteral("--program"), program});
    QCOMPARE(outcome.exit, 2);
    QVERIFY2(outcome.errors.contains(QStringLiteral("--program")), qPrintable(outcome.errors));
  }

  void learnsThePublishedEmulatorFromAnyTraces() {
    Trace x;
    Trace y(30.0, 15.0);
    std::string text = "t_s,x_cmd,x_fb,y_cmd,y_fb\n";
    for (std::size_t i = 0; i < x.atS.size(); ++i) {
      text += fmt::format("{:.4f},{:.6f},{:.6f},{:.6f},{:.6f}\n", x.atS[i], x.setMm[i], x.seenMm[i],
                          y.setMm[i], y.seenMm[i]);
    }
    const QString trace = file("both.csv", QByteArray::fromStdString(text));
    const Outcome matrix = run({QStringLiteral("matrix"), trace, QStringLiteral("--generations"),
                                QStringLiteral("3"), QStringLiteral("--json")});
    QVERIFY2(matrix.exit == 0, qPrintable(matrix.errors));
    QCOMPARE(matrix.parsed()["tests"].size(), std::size_t{1});
    QVERIFY(matrix.parsed()["tests"][0]["root_q_mm"].get<double>() > 0.0);
    QCOMPARE(matrix.parsed()["learned"][0]["parameters"].size(), std::size_t{34});
    const Outcome importance = run(
        {QStringLiteral("importance"), trace, QStringLiteral("--generations"), QStringLiteral("3"),
         QStringLiteral("--lambda"), QStringLiteral("0.8"), QStringLiteral("--json")});
    QVERIFY2(importance.exit == 0, qPrintable(importance.errors));
    double sum = 0.0;
    for (const json& one : importance.parsed()) {
      sum += one["mean"].get<double>();
    }
    QVERIFY(std::abs(sum - 1.0) < 1e-6);
  }
};

RIVULET_TEST(TestEmulatorCommands)
#include "tst_emulator_commands.moc"
