// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/motion_samples.h"

#include <QtTest>
#include <vector>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/signals.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

bool isSame(const MotionSample& a, const MotionSample& b) {
  const bool isSameFeed =
      a.feedMmPerS == b.feedMmPerS || (std::isnan(a.feedMmPerS) && std::isnan(b.feedMmPerS));
  return a.at == b.at && a.setMm == b.setMm && a.actualMm == b.actualMm &&
         a.pathMmPerS == b.pathMmPerS && isSameFeed && a.overrideFactor == b.overrideFactor &&
         a.line == b.line;
}

/// Some columns never change, some late.
std::vector<MotionSample> madeSamples(std::size_t count) {
  base::Random random(11);
  std::vector<MotionSample> samples(count);
  base::Instant at{std::chrono::seconds{5}};
  for (std::size_t i = 0; i < count; ++i) {
    MotionSample& sample = samples[i];
    at += base::Duration{1 + static_cast<std::int64_t>(random.below(5'000'000))};
    sample.at = at;
    sample.setMm = {0.0001 * static_cast<double>(random.below(100'000)), random.normal(), 0.0};
    sample.actualMm = {sample.setMm.x + 0.1, sample.setMm.y, i > 300 ? 1.5 : 1.0};
    sample.pathMmPerS = std::abs(random.normal());
    sample.feedMmPerS = i % 50 == 49 ? 20.0 : kNoValue;
    sample.overrideFactor = i < 500 ? 1.0 : 0.5;
    sample.line = static_cast<std::uint32_t>(i / 7);
  }
  return samples;
}

}  // namespace

class TestMotionSamples : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keepEverySample() {
    for (const std::size_t count : {1U, 127U, 128U, 129U, 1000U}) {
      const std::vector<MotionSample> made = madeSamples(count);
      const MotionSamples samples(made);
      QCOMPARE(samples.size(), count);
      QVERIFY(isSame(samples.front(), made.front()) && isSame(samples.back(), made.back()));
      std::size_t next = 0;
      for (const MotionSample& sample : samples) {
        QVERIFY(isSame(sample, made[next++]));
      }
      MotionReader reader(samples);
      base::Random random(1);
      for (std::size_t i = 0; i < 3 * count; ++i) {
        const std::size_t index = i < count ? i : random.below(count);
        QVERIFY(isSame(reader[index], made[index]));
        QVERIFY(isSame(samples[index], made[index]));
      }
    }
  }

  /// The reader has both at once, whichever was asked for first.
  void neighboursAreThereTogether() {
    const std::vector<MotionSample> made = madeSamples(600);
    const MotionSamples samples(made);
    MotionReader reader(samples);
    for (std::size_t i = 1; i + 1 < made.size(); ++i) {
      const MotionSample& after = reader[i + 1];
      const MotionSample& before = reader[i - 1];
      QVERIFY(isSame(before, made[i - 1]) && isSame(after, made[i + 1]));
    }
  }

  void whatDoesNotChangeTakesNothing() {
    const std::vector<MotionSample> made = madeSamples(600);
    const MotionSamples samples(made);
    QVERIFY(samples.isConstant(MotionColumn::SetZ));
    QVERIFY(!samples.isConstant(MotionColumn::ActualZ));
    const PackedValues same = samples.valuesOf(MotionColumn::SetZ);
    QCOMPARE(same.size(), made.size());
    QCOMPARE(same.back(), 0.0);
    const PackedValues late = samples.valuesOf(MotionColumn::ActualZ);
    QVERIFY(late[300] == 1.0 && late[301] == 1.5);
  }

  void aCopyIsAppendedToAlone() {
    const std::vector<MotionSample> made = madeSamples(400);
    const MotionSamples samples(made);
    MotionSamples longer = samples;
    MotionSample more = made.back();
    more.at += base::Duration{1};
    more.setMm.z = 7.0;
    longer.push_back(more);
    QCOMPARE(samples.size(), made.size());
    QVERIFY(samples.isConstant(MotionColumn::SetZ) && isSame(samples.back(), made.back()));
    QVERIFY(isSame(longer.back(), more) && isSame(longer[399], made[399]));
    QCOMPARE(longer.indexAt(more.at), made.size());
  }
};

RIVULET_TEST(TestMotionSamples)
#include "tst_motion_samples.moc"
