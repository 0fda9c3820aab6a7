// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/median.h"

#include <QtTest>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/random.h"
#include "support/test_program.h"

using namespace rivulet::base;

class TestMedian : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheSameWithoutAList() {
    Random random(3);
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    for (const std::uint64_t range : {std::uint64_t{1}, std::uint64_t{3}, std::uint64_t{70'000},
                                      std::uint64_t{1} << 33U, std::uint64_t{1} << 62U}) {
      for (std::size_t count = 1; count < 40; ++count) {
        std::vector<std::uint64_t> numbers;
        for (std::size_t i = 0; i < count; ++i) {
          const std::uint64_t number = random.below(range);
          numbers.push_back(i % 3 == 0 ? kMost - number : number);
        }
        const auto forEach = [&numbers](const auto& take) {
          for (const std::uint64_t number : numbers) {
            take(number);
          }
        };
        QCOMPARE(medianOfEach(forEach), median(numbers));
      }
    }
  }
};

RIVULET_TEST(TestMedian)
#include "tst_median.moc"
