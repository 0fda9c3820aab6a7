// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "emulator/cross_test.h"
#include "emulator/emulator_error.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using P = AxisParameter;

namespace {

constexpr double kPeriodS = 0.001;
constexpr double kSeconds = 8.0;

Emulator twoAxes() {
  Emulator emulator;
  for (const char letter : {'X', 'Y'}) {
    LearnedAxis axis;
    axis.axis = letter;
    axis.parameters[P::PositionGain] = letter == 'X' ? 50.0 : 25.0;
    axis.estimates.push_back({P::PositionGain, axis.parameters[P::PositionGain], 20.0, 60.0});
    emulator.axes.push_back(axis);
  }
  return emulator;
}

/// What the axes of the emulator answer. @param reachMm  of X and Y; 0: it stands
TrainingRun runOf(const Emulator& emulator, const char* name, std::array<double, 2> reachMm) {
  TrainingRun run{name, kPeriodS, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
  for (int i = 0; kPeriodS * i < kSeconds; ++i) {
    const double swing = 1.0 - std::cos(2.0 * kPeriodS * i);
    run.axes[0].reference.push_back(reachMm[0] * swing);
    run.axes[1].reference.push_back(reachMm[1] * swing);
    run.observedAt.push_back(kPeriodS * i);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const AxisState& state :
         predict(emulator.axes[axis].parameters, setPointGrid(run.axes[axis], kPeriodS, false),
                 run.observedAt)) {
      run.axes[axis].observed.push_back(state.mm);
    }
  }
  return run;
}

}  // namespace

class TestCrossTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void testsWhatEachRunTeachesOnAll() {
    const Emulator emulator = twoAxes();
    Emulator worn = emulator;
    worn.axes[0].parameters[P::PositionGain] = 40.0;
    const std::vector<TrainingRun> runs{runOf(emulator, "both", {10.0, 5.0}),
                                        runOf(worn, "worn", {10.0, 5.0}),
                                        runOf(emulator, "only X", {10.0, 0.0})};
    const auto test = crossTest(emulator, runs);
    QVERIFY2(test, test ? "" : test.error().text().c_str());
    QCOMPARE(test->runs[2], std::string("only X"));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      QVERIFY(test->rmsMm[i][i] < 1e-6);  // each is right on its own
    }
    // Its gain is another: the lags 1/40 s and 1/50 s differ by 5 ms, at 20 mm/s · sin RMS.
    const double differs = 20.0 * std::sqrt(0.5) * (1.0 / 40.0 - 1.0 / 50.0);
    QVERIFY(std::abs(test->rmsMm[0][1] / differs - 1.0) < 0.05);
    QVERIFY(std::abs(test->rmsMm[1][0] / differs - 1.0) < 0.05);
    // From a run in which Y stands nothing is known of Y; the other way round it does.
    QVERIFY(std::isnan(test->rmsMm[0][2]));
    QVERIFY(test->rmsMm[2][0] < 1e-6);

    QCOMPARE(test->worth.size(), std::size_t{2});
    QCOMPARE(test->worth[1].axis, 'Y');
    const double shorter = 10.0 * std::sqrt(0.5) * (1.0 / 25.0 - 1.0 / 27.5);
    QVERIFY(std::abs(test->worth[1].rmsMm[0] / shorter - 1.0) < 0.05);
    QCOMPARE(test->worth[1].rmsMm[2], 0.0);  // it stands
  }

  void stopsWhenToldTo() {
    const Emulator emulator = twoAxes();
    const TrainingRun run = runOf(emulator, "both", {10.0, 5.0});
    const auto stopped = crossTest(emulator, {&run, 1}, {.progress = [](double) { return false; }});
    QVERIFY(!stopped && stopped.error().code == EmulatorError::Cancelled);
    const auto cancelled = crossTest(emulator, {&run, 1}, {.isCancelled = [] { return true; }});
    QVERIFY(!cancelled && cancelled.error().code == EmulatorError::Cancelled);
  }
};

RIVULET_TEST(TestCrossTest)
#include "tst_cross_test.moc"
