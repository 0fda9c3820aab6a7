// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "emulator/emulator.h"
#include "emulator/emulator_error.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using P = AxisParameter;

namespace {

LearnedAxis axisNamed(char letter) {
  LearnedAxis axis;
  axis.axis = letter;
  for (const auto& [parameter, value] :
       std::initializer_list<std::pair<P, double>>{{P::PositionGain, 40.0},
                                                   {P::SpeedGain, 100.0},
                                                   {P::ResetTime, 0.02},
                                                   {P::Coulomb, 60.0},
                                                   {P::CoulombSpeed, 0.5}}) {
    axis.parameters[parameter] = value;
    axis.estimates.push_back({parameter, value, 0.9 * value, 1.1 * value});
  }
  axis.heldOutRmsMm = 2e-4;
  return axis;
}

Emulator twoAxes() {
  return {{axisNamed('X'), axisNamed('Y')}, {"G1", "G\"2"}, "abc", "2026-11-22T08:30:05.123Z"};
}

/// A square, run around once; what is seen is what the emulator answers, and a little more.
TrainingRun squareRun(const Emulator& emulator, double offMm) {
  TrainingRun run{"square", 0.001, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
  for (int i = 0; i < 4000; ++i) {
    const double along = 0.02 * (i % 1000);
    const int side = i / 1000;
    run.axes[0].reference.push_back(side == 0   ? along
                                    : side == 1 ? 20.0
                                    : side == 2 ? 20.0 - along
                                                : 0.0);
    run.axes[1].reference.push_back(side == 0   ? 0.0
                                    : side == 1 ? along
                                    : side == 2 ? 20.0
                                                : 20.0 - along);
    run.observedAt.push_back(0.001 * i);
  }
  for (AxisTrack& track : run.axes) {
    const AxisParameters& parameters = emulator.axes[track.axis == 'X' ? 0 : 1].parameters;
    for (const AxisState& state :
         predict(parameters, setPointGrid(track, run.period, false), run.observedAt)) {
      track.observed.push_back(state.mm + (track.axis == 'X' ? offMm : 0.0));
    }
  }
  return run;
}

}  // namespace

class TestEmulator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isReadAsItWasWritten() {
    const Emulator written = twoAxes();
    const auto read = parseEmulator(printEmulator(written), "mine.toml");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->axes.size(), std::size_t{2});
    QVERIFY(read->axes[1].parameters == written.axes[1].parameters);
    QCOMPARE(read->axes[1].axis, 'Y');
    QCOMPARE(read->axes[0].heldOutRmsMm, 2e-4);
    QCOMPARE(read->dataHash, written.dataHash);
    QCOMPARE(read->date, written.date);
    QCOMPARE(read->runs.size(), std::size_t{2});
  }

  void isReadWithNamesThatTomlDoesNotTake() {
    Emulator written = twoAxes();
    written.runs = {"a\"b\\c", "d\x7F\n"};
    written.date = "\"";
    const auto read = parseEmulator(printEmulator(written), "mine.toml");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->runs, (std::vector<std::string>{"a\"b\\c", "d__"}));
    QCOMPARE(read->date, written.date);
  }

  void refusesOtherFiles_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("not TOML") << QStringLiteral("[emulator\n");
    QTest::newRow("another file") << QStringLiteral("[axes.X]\nstartMm = 0.0\n");
    QTest::newRow("a later version") << QStringLiteral("[emulator]\nversion = 2\n");
    QTest::newRow("no axes") << QStringLiteral("[emulator]\nversion = 1\n");
    QTest::newRow("no gain") << QStringLiteral(
        "[emulator]\nversion = 1\n[axes.X.servo]\nspeed_gain = 10.0\nreset_time = 0.1\n");
    QTest::newRow("out of range") << QStringLiteral(
        "[emulator]\nversion = 1\n[axes.X.servo]\nposition_gain = -1.0\n");
  }
  void refusesOtherFiles() {
    QFETCH(QString, text);
    const auto read = parseEmulator(text.toStdString(), "mine.toml");
    QVERIFY(!read);
    QVERIFY(read.error().code == EmulatorError::BadFile);
    QCOMPARE(read.error().context, std::string("mine.toml"));
  }

  void saysHowFarOffItIs() {
    const Emulator emulator = twoAxes();
    const auto exact = testRun(emulator, squareRun(emulator, 0.0));
    QVERIFY(exact);
    QCOMPARE(exact->positionRmsMm, 0.0);
    QVERIFY(exact->contourRmsMm > 0.001);  // corners are cut
    QCOMPARE(exact->emulatedContourRmsMm, exact->contourRmsMm);
    QVERIFY(exact->speedRmsShare < 0.01);
    const auto shifted = testRun(emulator, squareRun(emulator, 0.05));
    QVERIFY(shifted);
    QVERIFY(std::abs(shifted->positionRmsMm - 0.05) < 1e-9);
  }

  void refusesAnAxisItHasNotLearned() {
    const Emulator both = twoAxes();
    Emulator one = both;
    one.axes.pop_back();
    const auto fit = testRun(one, squareRun(both, 0.0));
    QVERIFY(!fit);
    QVERIFY(fit.error().code == EmulatorError::NoMotion);
    QVERIFY(fit.error().message.find("axis Y") != std::string::npos);
  }

  void takesSetPointsInUnequalSteps() {
    rivulet::trace::Motion motion;
    motion.hasSet = true;
    motion.hasActual = true;
    motion.step = rivulet::base::fromSeconds(0.1);
    for (const double atS : {0.0, 0.1, 0.25, 0.3}) {
      rivulet::trace::MotionSample sample;
      sample.at = rivulet::base::Instant(rivulet::base::fromSeconds(5.0 + atS));
      sample.setMm = {10.0 * atS, 0.0, 0.0};
      motion.samples.push_back(sample);
    }
    const auto run = trainingRunOf(motion, "G1");
    QVERIFY(run);
    QCOMPARE(run->axes[0].reference.size(), std::size_t{4});
    QVERIFY(std::abs(run->axes[0].reference[2] - 2.0) < 1e-9);
    QCOMPARE(run->observedAt.back(), 0.3);
    motion.hasSet = false;
    QVERIFY(trainingRunOf(motion, "G1").error().code == EmulatorError::WrongProgram);
  }
};

RIVULET_TEST(TestEmulator)
#include "tst_emulator.moc"
