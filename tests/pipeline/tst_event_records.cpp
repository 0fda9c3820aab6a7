// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is known of a run from its events alone.

#include <QtTest>

#include "base/random.h"
#include "pipeline/event_records.h"
#include "pipeline/level_history.h"
#include "pipeline/policy_study.h"
#include "pipeline/virtual_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using pipeline::kBufferCount;
using pipeline::kTaskCount;
using pipeline::Task;

class TestEventRecords : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The same as the scheduler's own records, under each policy, with drawn times.
  void eventsTellWhatTheTasksDid() {
    base::Random random(5);
    std::uint64_t preemptions = 0;
    std::uint64_t late = 0;
    for (const pipeline::PolicyFacts& facts : pipeline::policies()) {
      for (const int processors : {1, 2, 4}) {
        pipeline::UnitStages stages;
        pipeline::VirtualOptions options;
        options.dispatch = {processors, 6, 2ms, processors == 2 ? 3ms : 0ms};
        options.until = base::Instant{400ms};
        options.duration = [&random](Task, std::uint64_t) -> base::Duration {
          return std::chrono::microseconds{100 + static_cast<int>(random.below(2500))};
        };
        pipeline::EventRecords records(options.dispatch);
        options.recorder = [&records](const pipeline::Event& event) { records.add(event); };
        const auto policy = facts.make();
        const auto run = pipeline::runVirtual(stages.all(), *policy, options);
        QVERIFY(run.has_value());
        for (std::size_t i = 0; i < kTaskCount; ++i) {
          const pipeline::TaskRecord& ours = records.records()[i];
          const pipeline::TaskRecord& own = run->records[i];
          QCOMPARE(ours.count, own.count);
          QCOMPARE(ours.waitedData, own.waitedData);
          QCOMPARE(ours.waitedTurn, own.waitedTurn);
          QCOMPARE(ours.responseSum, own.responseSum);
          QCOMPARE(ours.responseMin, own.responseMin);
          QCOMPARE(ours.responseMax, own.responseMax);
          QCOMPARE(ours.preemptions, own.preemptions);
          QCOMPARE(ours.late, own.late);
          QCOMPARE(ours.busy, own.busy);
          preemptions += own.preemptions;
          late += own.late;
        }
      }
    }
    QVERIFY(preemptions > 0);
    QVERIFY(late > 0);
  }

  /// However long a run is, each level that was reached is in its stretch.
  void levelsKeepTheirPeaks() {
    base::Random random(7);
    pipeline::LevelHistory history;
    std::vector<std::pair<base::Instant, std::array<int, kBufferCount>>> course;
    base::Instant at{};
    for (int i = 0; i < 5000; ++i) {
      at += std::chrono::microseconds{random.below(20'000)};
      std::array<int, kBufferCount> levels{};
      for (int& level : levels) {
        level = static_cast<int>(random.below(65));
      }
      course.emplace_back(at, levels);
      history.add(at, levels);
    }
    QVERIFY(history.stretches().size() <= pipeline::LevelHistory::kStretches);
    QVERIFY(history.stretches().size() > pipeline::LevelHistory::kStretches / 2);
    std::vector<pipeline::LevelHistory::Stretch> expected(history.stretches().size());
    std::array<int, kBufferCount> levels{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expected[i] = {levels, levels};
      const base::Instant end{history.length() * static_cast<base::Duration::rep>(i + 1)};
      for (; next < course.size() && course[next].first < end; ++next) {
        levels = course[next].second;
        for (std::size_t k = 0; k < kBufferCount; ++k) {
          expected[i].least[k] = std::min(expected[i].least[k], levels[k]);
          expected[i].greatest[k] = std::max(expected[i].greatest[k], levels[k]);
        }
      }
    }
    QCOMPARE(next, course.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QCOMPARE(history.stretches()[i].least, expected[i].least);
      QCOMPARE(history.stretches()[i].greatest, expected[i].greatest);
    }
  }
};

RIVULET_TEST(TestEventRecords)
#include "tst_event_records.moc"
