// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <thread>

#include "base/spsc_ring.h"
#include "support/test_program.h"

using rivulet::base::SpscRing;

class TestSpscRing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void refusesAndCountsWhenFull() {
    SpscRing<int, 2> ring;
    QVERIFY(ring.tryPush(1));
    QVERIFY(ring.tryPush(2));
    QVERIFY(!ring.tryPush(3));
    QCOMPARE(ring.lost(), std::size_t{1});
    QCOMPARE(ring.tryPop(), std::optional<int>(1));
    QCOMPARE(ring.tryPop(), std::optional<int>(2));
    QVERIFY(!ring.tryPop());
  }

  void keepsOrderBetweenThreads() {
    SpscRing<int, 64> ring;
    constexpr int kCount = 100000;
    std::thread producer([&ring] {
      for (int i = 0; i < kCount;) {
        if (ring.tryPush(i)) {
          ++i;
        } else {
          std::this_thread::yield();
        }
      }
    });
    int expected = 0;
    while (expected < kCount) {
      if (const auto value = ring.tryPop()) {
        if (*value != expected) {
          break;
        }
        ++expected;
      } else {
        std::this_thread::yield();
      }
    }
    if (expected == kCount) {
      producer.join();
    } else {
      producer.detach();
    }
    QCOMPARE(expected, kCount);
  }
};

RIVULET_TEST(TestSpscRing)
#include "tst_spsc_ring.moc"
