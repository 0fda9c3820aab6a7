// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <numeric>

#include "base/quantile.h"
#include "base/random.h"
#include "support/test_program.h"
#include "trace/analysis/histogram.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using std::chrono::microseconds;

class TestHistogram : public QObject {
  Q_OBJECT

  static std::vector<Duration> upTo(int count) {
    std::vector<Duration> durations;
    for (int i = 1; i <= count; ++i) {
      durations.emplace_back(microseconds{i});
    }
    return durations;
  }

  static std::size_t sumOf(const Histogram& bins) {
    return std::accumulate(bins.counts.begin(), bins.counts.end(), std::size_t{0}) + bins.above;
  }

 private Q_SLOTS:
  void givesThePercentilesTheNumberCarries() {
    QCOMPARE(percentiles({}).size(), std::size_t{0});
    QCOMPARE(percentiles(upTo(1)).size(), std::size_t{1});
    QCOMPARE(percentiles(upTo(19)).back().perMille, 900);
    QCOMPARE(percentiles(upTo(99)).back().perMille, 950);
    QCOMPARE(percentiles(upTo(100)).back().perMille, 990);
    QVERIFY(percentiles(upTo(100)).back().value == microseconds{99});
    QCOMPARE(percentiles(upTo(999)).back().perMille, 990);
    const std::vector<Percentile> all = percentiles(upTo(1000));
    QCOMPARE(all.size(), std::size_t{5});
    QVERIFY(all[0].value == microseconds{500});
    QVERIFY(all[4].value == microseconds{999});
    QVERIFY(rivulet::base::quantile(upTo(7), 1000) == microseconds{7});
  }

  /// Nothing gets lost, the bins are few, their borders round, and a far one stretches nothing.
  void countsEach() {
    rivulet::base::Random random(3);
    std::vector<Duration> durations;
    for (int i = 0; i < 500; ++i) {
      durations.push_back(rivulet::base::fromMilliseconds(5.0 + 1.5 * random.normal()));
    }
    durations.push_back(std::chrono::seconds{2});
    std::sort(durations.begin(), durations.end());
    const Histogram bins = histogram(durations);
    QCOMPARE(sumOf(bins), durations.size());
    QVERIFY(bins.above >= 1 && bins.above <= 5);
    QVERIFY(bins.counts.size() >= 10 && bins.counts.size() <= 41);
    QVERIFY(bins.width == microseconds{500});
    QCOMPARE(bins.from % bins.width, Duration::zero());
    // Each in its bin.
    for (std::size_t i = 0; i < bins.counts.size(); ++i) {
      const Duration low = bins.from + bins.width * static_cast<int>(i);
      const auto in = std::count_if(durations.begin(), durations.end(), [&](Duration duration) {
        return duration >= low && duration < low + bins.width;
      });
      QCOMPARE(static_cast<std::size_t>(in), bins.counts[i]);
    }
  }

  void copesWithEqualOnes() {
    QVERIFY(histogram({}).counts.empty());
    const Histogram bins = histogram(std::vector<Duration>(7, microseconds{5150}));
    QCOMPARE(bins.counts, std::vector<std::size_t>{7});
    QVERIFY(bins.from == microseconds{5150});
  }
};

RIVULET_TEST(TestHistogram)
#include "tst_histogram.moc"
