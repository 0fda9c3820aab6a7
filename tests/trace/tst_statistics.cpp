// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/quantile.h"
#include "support/test_program.h"
#include "trace/analysis/statistics.h"

using namespace rivulet::trace;
using rivulet::base::Duration;

class TestStatistics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isZeroForNothing() {
    const DurationStatistics figures = durationStatistics({});
    QCOMPARE(figures.count, std::size_t{0});
    QVERIFY(figures.max == Duration::zero());
    QVERIFY(figures.mean == Duration::zero());
  }

  void takesTheNearestRank() {
    std::vector<Duration> durations;
    for (int i = 100; i >= 1; --i) {
      durations.emplace_back(i);
    }
    const DurationStatistics figures = durationStatistics(durations);
    QCOMPARE(figures.count, std::size_t{100});
    QCOMPARE(figures.p50.count(), 50);
    QCOMPARE(figures.p95.count(), 95);
    QCOMPARE(figures.p99.count(), 99);
    QCOMPARE(figures.max.count(), 100);
    QCOMPARE(figures.mean.count(), 51);  // 50.5 rounded
  }

  void countsAnyNumberInBoundedMemory() {
    rivulet::trace::DurationCounter counter;
    QCOMPARE(counter.statistics().count, std::size_t{0});
    constexpr int kCount = 1'000'000;
    for (int i = 0; i < kCount; ++i) {
      counter.add(Duration(i % 1000 + 1));
    }
    counter.add(Duration(5000));
    const DurationStatistics figures = counter.statistics();
    QCOMPARE(figures.count, std::size_t{kCount + 1});
    QCOMPARE(figures.max.count(), 5000);
    QCOMPARE(figures.mean.count(), 501);  // 500.5 and a little
    QVERIFY(std::abs(figures.p50.count() - 500) < 40);
    QVERIFY(std::abs(figures.p99.count() - 990) < 40);
  }

  void roundsRanksUp() {
    const std::vector<Duration> twenty = [] {
      std::vector<Duration> values;
      for (int i = 1; i <= 20; ++i) {
        values.emplace_back(i);
      }
      return values;
    }();
    QCOMPARE(rivulet::base::quantile(twenty, 950).count(), 19);  // exactly 19 of 20
    QCOMPARE(rivulet::base::quantile(twenty, 960).count(), 20);
    QCOMPARE(rivulet::base::quantile(twenty, 0).count(), 1);
    QCOMPARE(rivulet::base::quantile(twenty, 10).count(), 1);
    QCOMPARE(rivulet::base::quantile(twenty, 1000).count(), 20);
    QCOMPARE(rivulet::base::quantile(std::vector{Duration{7}}, 500).count(), 7);
  }

  void sumsLongRuns() {
    const Duration day = std::chrono::hours{24 * 365 * 100};
    const DurationStatistics figures = durationStatistics({day, day, day, day});
    QVERIFY(figures.mean == day);
  }
};

RIVULET_TEST(TestStatistics)
#include "tst_statistics.moc"
