// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 13 of [P3] on its net.

#include <QtTest>

#include "papers/parallel_cnc.h"
#include "support/test_program.h"

using namespace rivulet;

class TestParallelCnc : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void figure13() {
    const auto result = papers::parallelCncExperiment();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QCOMPARE(result->plots.size(), std::size_t(6));
    for (const papers::Check& check : result->checks) {
      QVERIFY2(check.passed(), (check.what + ": " + std::to_string(check.ours)).c_str());
    }
  }

  void sixProcessorsLeaveNothingToSchedule() {
    const auto byTask = papers::runParallelCnc({{"processors", 6}, {"policy", 0}}, 1.0);
    const auto byFlow = papers::runParallelCnc({{"processors", 6}, {"policy", 1}}, 1.0);
    QVERIFY(byTask.has_value() && byFlow.has_value());
    QCOMPARE(byTask->mean, byFlow->mean);
    QCOMPARE(byTask->setPoints, byFlow->setPoints);
    // Fewer processors make fewer set points.
    const auto one = papers::runParallelCnc({{"processors", 1}, {"policy", 0}}, 1.0);
    QVERIFY(one->setPoints < byTask->setPoints);
  }

  void aSlowerMachineFillsTheLastBuffer() {
    const auto run = papers::runParallelCnc({{"position_cycle", 50'000}}, 1.0);
    QVERIFY(run.has_value());
    double highest = 0.0;
    for (const auto& level : run->levels[4]) {
      highest = std::max(highest, level.level);
    }
    QCOMPARE(highest, 50.0);
    QVERIFY(run->setPoints <= 20.0);
  }
};

RIVULET_TEST(TestParallelCnc)
#include "tst_parallel_cnc.moc"
