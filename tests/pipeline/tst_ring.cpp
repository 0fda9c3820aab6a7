// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Ring buffers: order, bounds, and everything that a broken neighbour can leave in shared memory.

#include <QtTest>
#include <thread>

#include "pipeline/ring.h"
#include "support/test_program.h"

using namespace rivulet;
using pipeline::kRingCapacity;
using pipeline::PipelineError;

namespace {

struct Number {
  static constexpr std::string_view kLayout = "B9 number 1";
  std::uint64_t value = 0;
  double half = 0.0;
};

struct OtherNumber {
  static constexpr std::string_view kLayout = "B9 number 2";
  std::uint64_t value = 0;
  double half = 0.0;
};

struct Both {
  pipeline::RingMemory<Number> memory;
  pipeline::RingWriter<Number> writer = *pipeline::RingWriter<Number>::open(memory);
  pipeline::RingReader<Number> reader = *pipeline::RingReader<Number>::open(memory);
};

}  // namespace

class TestRing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itemsComeInOrderAndTheRingIsBounded() {
    Both ring;
    QVERIFY(!ring.reader.pop()->has_value());
    std::uint64_t next = 0;
    for (std::uint64_t round = 0; round < 5; ++round) {
      for (std::uint64_t i = 0; i < kRingCapacity; ++i) {
        QVERIFY(*ring.writer.push({round * kRingCapacity + i, 0.5}));
      }
      QVERIFY(!*ring.writer.push({0, 0.0}));
      QCOMPARE(ring.memory.level(), kRingCapacity);
      for (std::uint64_t i = 0; i < kRingCapacity; ++i) {
        QCOMPARE((*ring.reader.pop())->value, next++);
      }
      QVERIFY(!ring.reader.pop()->has_value());
    }
  }

  void twoThreadsLoseNothing() {
    Both ring;
    constexpr std::uint64_t kItems = 20'000;
    std::thread producer([&] {
      for (std::uint64_t i = 0; i < kItems;) {
        const auto done = ring.writer.push({i, 0.5 * static_cast<double>(i)});
        i += done.has_value() && *done ? 1U : 0U;
        if (done.has_value() && !*done) {
          std::this_thread::yield();
        }
      }
    });
    std::uint64_t next = 0;
    bool isRight = true;
    while (next < kItems && isRight) {
      const auto item = ring.reader.pop();
      isRight = item.has_value();
      if (isRight && *item) {
        isRight = (*item)->value == next && (*item)->half == 0.5 * static_cast<double>(next);
        ++next;
      } else {
        std::this_thread::yield();
      }
    }
    producer.join();
    QVERIFY(isRight);
  }

  void anotherLayoutIsRefused() {
    pipeline::RingMemory<Number> memory;
    memory.layout = pipeline::RingMemory<OtherNumber>::kLayout;
    QVERIFY(memory.layout != pipeline::RingMemory<Number>::kLayout);
    const auto reader = pipeline::RingReader<Number>::open(memory);
    const auto writer = pipeline::RingWriter<Number>::open(memory);
    QVERIFY(!reader && reader.error().code == PipelineError::RingLayout);
    QVERIFY(!writer && writer.error().code == PipelineError::RingLayout);
    QVERIFY(reader.error().message.find("B9") != std::string::npos);
  }

  /// Each bit of an item that waits.
  void rubbishInAnItemIsRefused() {
    for (std::size_t bit = 0; bit < 8 * sizeof(Number); ++bit) {
      Both ring;
      QVERIFY(*ring.writer.push({7, 3.5}));
      ring.memory.places[0].bytes[bit / 8] =
          static_cast<char>(ring.memory.places[0].bytes[bit / 8] ^ (1 << (bit % 8)));
      const auto item = ring.reader.pop();
      QVERIFY(!item);
      QVERIFY(item.error().code == PipelineError::RingRubbish);
    }
  }

  void anOldItemIsRefused() {
    Both ring;
    QVERIFY(*ring.writer.push({7, 3.5}));
    const auto old = ring.memory.places[0];
    for (std::uint64_t i = 0; i < kRingCapacity; ++i) {
      QVERIFY(ring.reader.pop()->has_value());
      QVERIFY(*ring.writer.push({8, 4.0}));
    }
    ring.memory.places[0] = old;  // a whole, right item, but of the round before
    for (std::uint64_t i = 1; i < kRingCapacity; ++i) {
      const auto item = ring.reader.pop();
      if (!item) {
        QVERIFY(item.error().code == PipelineError::RingRubbish);
        return;
      }
    }
    QVERIFY(!ring.reader.pop());
  }

  void countsThatCannotBeAreRefused() {
    for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2},
                                      kRingCapacity + 4, ~std::uint64_t{0}}) {
      Both ring;
      for (int i = 0; i < 3; ++i) {
        QVERIFY(*ring.writer.push({1, 1.0}));
        QVERIFY(ring.reader.pop()->has_value());
      }
      ring.memory.written = count;
      QVERIFY(!ring.reader.pop());
      QVERIFY(!ring.writer.push({1, 1.0}));
      ring.memory.written = 3;
      ring.memory.taken = count;
      QVERIFY(!ring.reader.pop());
      QVERIFY(count <= 2 || !ring.writer.push({1, 1.0}));
    }
  }
};

RIVULET_TEST(TestRing)
#include "tst_ring.moc"
