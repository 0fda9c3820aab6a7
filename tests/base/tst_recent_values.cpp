// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <vector>

#include "base/quantile.h"
#include "base/random.h"
#include "base/recent_values.h"
#include "support/test_program.h"

using rivulet::base::RecentValues;

class TestRecentValues : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void forgetsTheOldest() {
    RecentValues<int> recent(2);
    QVERIFY(recent.isEmpty());
    recent.add(9);
    QVERIFY(!recent.isFull());
    recent.add(1);
    QVERIFY(recent.isFull());
    QCOMPARE(recent.quantile(1000), 9);
    recent.add(5);
    QCOMPARE(recent.quantile(1000), 5);
    QCOMPARE(recent.quantile(0), 1);
  }

  /// Values that are equal must leave one by one.
  void agreesWithSortingTheLastValues() {
    rivulet::base::Random random(7);
    RecentValues<int> recent(20);
    std::vector<int> all;
    for (int i = 0; i < 500; ++i) {
      all.push_back(static_cast<int>(10.0 * random.uniform()));
      recent.add(all.back());
      std::vector<int> last(all.end() - std::min<std::ptrdiff_t>(20, std::ssize(all)), all.end());
      std::sort(last.begin(), last.end());
      for (const std::size_t perMille : {0U, 500U, 990U, 1000U}) {
        QCOMPARE(recent.quantile(perMille), rivulet::base::quantile(last, perMille));
      }
    }
  }
};

RIVULET_TEST(TestRecentValues)

#include "tst_recent_values.moc"
