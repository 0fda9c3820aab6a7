// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/envelope.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using rivulet::base::Instant;
using rivulet::base::Random;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Instant at(std::int64_t nanoseconds) {
  return Instant{Duration{nanoseconds}};
}

/// The definition of `visible`, point by point.
std::vector<SeriesPoint> visibleByHand(const std::vector<SeriesPoint>& all, Instant from,
                                       Instant to, std::size_t columns) {
  const auto n = static_cast<std::int64_t>(columns);
  std::vector<std::vector<SeriesPoint>> inColumn(columns);
  std::vector<SeriesPoint> result;
  const SeriesPoint* before = nullptr;
  const SeriesPoint* behind = nullptr;
  for (const SeriesPoint& point : all) {
    if (point.at < from) {
      before = &point;
    } else if (point.at > to) {
      behind = behind == nullptr ? &point : behind;
    } else {
      // The last column whose left border, rounded down to the nanosecond, is not after it.
      std::int64_t column = n - 1;
      while (column > 0 && from + (to - from) * column / n > point.at) {
        --column;
      }
      if (from == to) {
        column = n - 1;
      }
      inColumn[static_cast<std::size_t>(column)].push_back(point);
    }
  }
  if (before != nullptr) {
    result.push_back(*before);
  }
  for (const auto& points : inColumn) {
    const SeriesPoint* min = nullptr;
    const SeriesPoint* max = nullptr;
    const SeriesPoint* gap = nullptr;
    for (const SeriesPoint& point : points) {
      if (std::isnan(point.value)) {
        gap = gap == nullptr ? &point : gap;
        continue;
      }
      min = min == nullptr || point.value < min->value ? &point : min;
      max = max == nullptr || point.value > max->value ? &point : max;
    }
    for (const SeriesPoint& point : points) {
      if (&point == min || &point == max || &point == gap) {
        result.push_back(point);
      }
    }
  }
  if (behind != nullptr) {
    result.push_back(*behind);
  }
  return result;
}

/// NaN equals NaN here.
bool same(const std::vector<SeriesPoint>& a, const std::vector<SeriesPoint>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const SeriesPoint& p, const SeriesPoint& q) {
        const bool isSameValue =
            std::bit_cast<std::uint64_t>(p.value) == std::bit_cast<std::uint64_t>(q.value);
        return p.at == q.at && (isSameValue || (std::isnan(p.value) && std::isnan(q.value)));
      });
}

}  // namespace

class TestEnvelope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void holdsNothingAtFirst() {
    Envelope envelope;
    QVERIFY(envelope.empty());
    QVERIFY(envelope.visible(at(0), at(100), 10).empty());
    QVERIFY(!envelope.range(at(0), at(100)));
  }

  void returnsAllWhereThereIsRoom() {
    Envelope envelope;
    for (int i = 0; i < 5; ++i) {
      envelope.append(at(i * 10), i);
    }
    const auto points = envelope.visible(at(0), at(40), 100);
    QCOMPARE(points.size(), std::size_t{5});
    QVERIFY(points.front() == (SeriesPoint{at(0), 0.0}));
    QVERIFY(points.back() == (SeriesPoint{at(40), 4.0}));
  }

  void letsTheLineEnterAndLeave() {
    Envelope envelope;
    envelope.append(at(0), 1.0);
    envelope.append(at(100), 2.0);
    const auto points = envelope.visible(at(40), at(60), 10);
    QCOMPARE(points.size(), std::size_t{2});
    QVERIFY(!envelope.range(at(40), at(60)));
  }

  void keepsASpikeInALongRun() {
    Envelope envelope;
    for (int i = 0; i < 100'000; ++i) {
      envelope.append(at(i), i == 54'321 ? -7.0 : 1.0);
    }
    const auto points = envelope.visible(at(0), at(100'000), 10);
    QVERIFY(points.size() <= 20);
    QVERIFY(std::find(points.begin(), points.end(), SeriesPoint{at(54'321), -7.0}) != points.end());
    QCOMPARE(envelope.range(at(0), at(100'000))->min, -7.0);
    QCOMPARE(envelope.range(at(54'322), at(100'000))->min, 1.0);
  }

  void showsGaps() {
    Envelope envelope;
    envelope.append(at(0), 1.0);
    envelope.append(at(10), kNaN);
    envelope.append(at(20), kNaN);
    envelope.append(at(30), 2.0);
    const auto points = envelope.visible(at(0), at(30), 1);
    QCOMPARE(points.size(), std::size_t{3});
    QVERIFY(points[1].at == at(10) && std::isnan(points[1].value));
    QVERIFY(!envelope.range(at(5), at(25)));
  }

  void keepsEveryValueToTheBit() {
    PackedPoints packed;
    std::vector<SeriesPoint> all;
    Random random(7);
    const double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 9> odd{-0.0, infinity, -infinity, 1e300, 5e-324,
                                    9e15, -9e15,    0.1 + 0.2, 1e-9};
    std::int64_t now = std::numeric_limits<std::int64_t>::min();
    for (std::size_t i = 0; i < 40 * kPackedBlockSize + 5; ++i) {
      const std::size_t kind = i / kPackedBlockSize;
      double value = static_cast<double>(random.below(2'000'000)) / 1e4 - 100.0;
      if (kind % 4 == 1) {
        value = random.below(10) == 0 ? kNaN : value;
      } else if (kind % 4 == 2) {
        value = odd[random.below(odd.size())];
      } else if (kind % 4 == 3) {
        value = kNaN;
      }
      packed.append({at(now), value});
      all.push_back({at(now), value});
      now += kind == 20 ? (std::int64_t{1} << 56)
                        : (kind % 3 == 0 ? 4'000'000 : static_cast<std::int64_t>(random.below(9)));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      QVERIFY(same({packed[i]}, {all[i]}));
    }
    packed.clear();
    QVERIFY(packed.empty());
  }

  void needsLittleMemory() {
    // 0.1 µm every millisecond, at 50 mm/s.
    Envelope envelope;
    constexpr int kCount = 1'000'000;
    for (int i = 0; i < kCount; ++i) {
      const double mm = 200.0 * std::sin(i * 0.00025);
      envelope.append(at(std::int64_t{i} * 1'000'000), std::round(mm * 1e4) / 1e4);
    }
    const double perValue = static_cast<double>(envelope.memoryBytes()) / kCount;
    QVERIFY2(perValue < 4.0, qPrintable(QString::number(perValue)));
  }

  void takesAnySpan() {
    Envelope envelope;
    envelope.append(at(0), 1.0);
    envelope.append(at(5), 2.0);
    QCOMPARE(envelope.visible(Instant::min(), Instant::max(), 3).size(), std::size_t{2});
    QCOMPARE(envelope.visible(at(5), at(5), 7).size(), std::size_t{2});
    envelope.clear();
    QVERIFY(envelope.empty());
    envelope.append(at(-5), 2.0);
    QCOMPARE(envelope.size(), std::size_t{1});
  }

  void equalsTheDefinition() {
    QVERIFY(rc::check("visible() and range() equal a search point by point", [] {
      const auto seed = *rc::gen::arbitrary<std::uint64_t>();
      Random random(seed);
      const std::size_t count = random.below(random.below(4) == 0 ? 20'000 : 600);
      const bool coarse = random.below(2) == 0;  // equal values and equal instants
      const std::uint64_t gapEvery = random.below(3) == 0 ? 5 : 1'000;
      const bool isDecimal = random.below(2) == 0;
      Envelope envelope;
      std::vector<SeriesPoint> all;
      std::int64_t now = -1'000;
      for (std::size_t i = 0; i < count; ++i) {
        now += static_cast<std::int64_t>(random.below(coarse ? 3 : 1'000));
        double value = coarse ? static_cast<double>(random.below(5)) : random.normal();
        if (isDecimal) {
          value = std::round(value * 1e4) / 1e4;
        }
        if (random.below(gapEvery) == 0) {
          value = kNaN;
        }
        envelope.append(at(now), value);
        all.push_back({at(now), value});
      }
      const auto span = static_cast<std::uint64_t>(now + 1'500);
      for (int query = 0; query < 10; ++query) {
        const Instant a = at(static_cast<std::int64_t>(random.below(span)) - 1'200);
        const Instant b = at(static_cast<std::int64_t>(random.below(span)) - 1'200);
        const Instant from = std::min(a, b);
        const Instant to = std::max(a, b);
        const std::size_t columns = 1 + random.below(40);
        const auto points = envelope.visible(from, to, columns);
        RC_ASSERT(same(points, visibleByHand(all, from, to, columns)));
        RC_ASSERT(points.size() <= 3 * columns + 2);
        const auto range = envelope.range(from, to);
        double min = std::numeric_limits<double>::infinity();
        double max = -min;
        for (const SeriesPoint& point : all) {
          if (point.at >= from && point.at <= to && !std::isnan(point.value)) {
            min = std::min(min, point.value);
            max = std::max(max, point.value);
          }
        }
        RC_ASSERT(range.has_value() == (min <= max));
        RC_ASSERT(!range || (range->min == min && range->max == max));
      }
    }));
  }
};

RIVULET_TEST(TestEnvelope)
#include "tst_envelope.moc"
