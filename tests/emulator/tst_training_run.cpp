// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "emulator/emulator_error.h"
#include "emulator/training_run.h"
#include "support/test_program.h"

using namespace rivulet::emulator;

namespace {

TrainingRun smallRun() {
  return {.name = "G1",
          .period = 0.001,
          .axes = {{.axis = 'X', .reference = {0.0, 1.0, 2.0}, .observed = {0.0, 0.9}}},
          .observedAt = {0.0, 0.002}};
}

}  // namespace

class TestTrainingRun : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void takesWhatIsSound() { QVERIFY(checkRun(smallRun())); }

  void refusesTimeThatRunsBackwards() {
    TrainingRun run = smallRun();
    run.observedAt = {0.002, 0.001};
    const auto checked = checkRun(run);
    QVERIFY(!checked);
    QVERIFY(checked.error().code == EmulatorError::BadTimes);
    QVERIFY(checked.error().message.find("0.0020 s") != std::string::npos);
  }

  void refusesWhatIsNotANumber() {
    TrainingRun run = smallRun();
    run.axes[0].observed[1] = std::numeric_limits<double>::quiet_NaN();
    const auto checked = checkRun(run);
    QVERIFY(!checked);
    QVERIFY(checked.error().code == EmulatorError::BadNumbers);
    QCOMPARE(checked.error().text(),
             std::string("G1: Position 2 of axis X is not a number: leave this row out of the "
                         "file."));
  }

  void takesSpeedsOrNone() {
    TrainingRun run = smallRun();
    run.axes[0].observedMmPerS = {0.0, 450.0};
    QVERIFY(checkRun(run));
    run.axes[0].observedMmPerS.pop_back();
    const auto checked = checkRun(run);
    QVERIFY(!checked);
    QVERIFY(checked.error().code == EmulatorError::BadTimes);
  }

  void refusesLengthsThatDiffer() {
    TrainingRun run = smallRun();
    run.axes[0].observed.pop_back();
    const auto checked = checkRun(run);
    QVERIFY(!checked);
    QVERIFY(checked.error().code == EmulatorError::BadTimes);
  }
};

RIVULET_TEST(TestTrainingRun)
#include "tst_training_run.moc"
