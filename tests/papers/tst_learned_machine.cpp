// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From traces to a learned emulator, and what it is good for, on virtual machines with known axes.

#include <QtTest>

#include "papers/design_study.h"
#include "papers/learned_machine.h"
#include "papers/tampering.h"
#include "support/test_program.h"
#include "training/sparse_learning.h"

using namespace rivulet;
using namespace rivulet::papers;

namespace {

void requirePassed(const Experiment& experiment) {
  for (const Check& check : experiment.checks) {
    QVERIFY2(check.passed(), qPrintable(QStringLiteral("%1: %2").arg(
                                 QString::fromStdString(check.what), QString::number(check.ours))));
  }
}

}  // namespace

class TestLearnedMachine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void recoversTheAxesOfKnownMachines() {
    Experiment experiment;
    const auto done = addKnownMachines(experiment);
    QVERIFY2(done, done ? "" : done.error().text().c_str());
    QCOMPARE(experiment.checks.size(), std::size_t{2});
    requirePassed(experiment);
  }

  void noticesThatAnAxisIsShifted() {
    const auto experiment = runTampering({.draws = 20});
    QVERIFY2(experiment, experiment ? "" : experiment.error().text().c_str());
    QCOMPARE(experiment->checks.size(), std::size_t{4});
    requirePassed(*experiment);
  }

  void canBeCancelled() {
    QVERIFY(!runTampering({.draws = 3, .progress = [](double) { return false; }}));
  }

  void proposesBetterProgramsThanThePublishedDesigns() {
    const auto experiment = runDesignStudy({.draws = 3, .exchanges = 100});
    QVERIFY2(experiment, experiment ? "" : experiment.error().text().c_str());
    QCOMPARE(experiment->checks.size(), std::size_t{2});
    requirePassed(*experiment);
  }

  void aProgramThatMovesNothingIsNoRun() {
    trace::Motion motion;
    motion.hasActual = true;
    trace::MotionSample sample;
    motion.samples.push_back(sample);
    sample.at += base::fromSeconds(0.1);
    motion.samples.push_back(sample);
    QVERIFY(!training::runOfProgram(motion, "G61\nF100\n", "empty", {}));
    QVERIFY(!training::runOfProgram({}, "G61\nF100\nG1 X10\n", "nothing seen", {}));
    const auto run = training::runOfProgram(motion, "G61\nF100\nG1 X10\n", "a line", {});
    QVERIFY(run);
    QVERIFY(std::abs(run->axes[0].reference.back() - 10.0) < 1e-6);
  }
};

RIVULET_TEST(TestLearnedMachine)
#include "tst_learned_machine.moc"
