// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Who goes first by each policy.

#include <QtTest>

#include "pipeline/policy_study.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using pipeline::Candidate;
using pipeline::Outlook;
using pipeline::PolicyKind;
using pipeline::Task;

namespace {

bool goesBefore(PolicyKind policy, const Candidate& a, const Candidate& b,
                const Outlook& outlook = {}) {
  const auto scheduler = pipeline::factsOf(policy).make();
  // A strict order: never both.
  if (scheduler->goesBefore(a, b, outlook) && scheduler->goesBefore(b, a, outlook)) {
    qFatal("no order");
  }
  return scheduler->goesBefore(a, b, outlook);
}

}  // namespace

class TestPolicies : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rowsAreInOrder() {
    for (std::size_t i = 0; i < pipeline::policies().size(); ++i) {
      QCOMPARE(static_cast<std::size_t>(pipeline::policies()[i].kind), i);
    }
  }

  void taskDependencyLooksAtTheTaskAlone() {
    const Candidate interpret{Task::Interpret, 50, 0, true};
    const Candidate interpolate{Task::Interpolate, 1, 49, false};
    QVERIFY(goesBefore(PolicyKind::TaskDependency, interpolate, interpret));
    QVERIFY(!goesBefore(PolicyKind::TaskDependency, interpret, interpolate));
  }

  void dataFlowLooksAtTheDifference() {
    const Candidate interpret{Task::Interpret, 9, 5, false};
    const Candidate discrete{Task::Discrete, 5, 2, false};
    const Candidate lookAhead{Task::LookAhead, 6, 2, false};
    QVERIFY(goesBefore(PolicyKind::DataFlow, interpret, discrete));
    QVERIFY(goesBefore(PolicyKind::DataFlow, lookAhead, discrete));
    // Equal: by number.
    QVERIFY(goesBefore(PolicyKind::DataFlow, interpret, lookAhead));
    QVERIFY(!goesBefore(PolicyKind::DataFlow, lookAhead, interpret));
  }

  /// A block that becomes many set points lasts longer than a set point.
  void earliestStarvationCountsSetPoints() {
    const Candidate lookAhead{Task::LookAhead, 5, 1, false};
    const Candidate interpolate{Task::Interpolate, 1, 2, false};
    Outlook outlook;
    outlook.capacity = 50;
    outlook.positionCycle = 4ms;
    outlook.levels = {0, 0, 5, 1, 2};
    outlook.made = {1, 1, 1, 100, 100, 0};
    QVERIFY(goesBefore(PolicyKind::EarliestStarvation, interpolate, lookAhead, outlook));
    // The look-ahead takes so long that it has to begin now.
    outlook.meanTimes[indexOf(Task::LookAhead)] = 100ms;
    QVERIFY(goesBefore(PolicyKind::EarliestStarvation, lookAhead, interpolate, outlook));
  }

  void steadyStaysForABatch() {
    Candidate warm{Task::Interpret, 9, 1, true};
    const Candidate cold{Task::Interpolate, 1, 2, false};
    QVERIFY(goesBefore(PolicyKind::Steady, warm, cold));
    warm.downstream = 20;
    QVERIFY(goesBefore(PolicyKind::Steady, cold, warm));
  }

  /// Too late for both: no time for a switch either.
  void earliestStarvationStaysForABatch() {
    Candidate warm{Task::Interpret, 9, 1, true};
    const Candidate cold{Task::Interpolate, 1, 0, false};
    Outlook outlook;
    outlook.positionCycle = 4ms;
    outlook.levels = {9, 1, 0, 1, 0};
    outlook.meanTimes.fill(100ms);
    QVERIFY(goesBefore(PolicyKind::EarliestStarvation, warm, cold, outlook));
    warm.downstream = 20;
    QVERIFY(goesBefore(PolicyKind::EarliestStarvation, cold, warm, outlook));
  }

  /// The figures of docs/parallel.md for the two policies of [P3], five processors.
  void scoresAreThoseOfFigure13() {
    struct Row {
      int cycleMs;
      std::uint64_t dependency;
      std::uint64_t flow;
    };
    for (const Row& row : {Row{2, 269, 253}, Row{10, 269, 253}, Row{15, 197, 197}}) {
      const pipeline::StudyCase study{5, std::chrono::milliseconds{row.cycleMs}, {}, 0};
      QCOMPARE(pipeline::scorePolicy(PolicyKind::TaskDependency, study, 3s).points, row.dependency);
      QCOMPARE(pipeline::scorePolicy(PolicyKind::DataFlow, study, 3s).points, row.flow);
    }
  }

  /// Where a switch of tasks costs a tenth of a step, ours send more set points than both of [P3],
  /// with fewer switches. With five processors and drawn times, the full buffers of data flow send
  /// more (docs/parallel.md).
  void oursBeatThoseOfThePaper() {
    for (const int processors : {1, 2, 5}) {
      for (const std::uint64_t seed : {0U, 1U, 2U, 3U}) {
        const auto score = [&](PolicyKind policy) {
          return pipeline::scorePolicy(policy, {processors, 10ms, 1ms, seed}, 30s);
        };
        const pipeline::PolicyScore dependency = score(PolicyKind::TaskDependency);
        const pipeline::PolicyScore flow = score(PolicyKind::DataFlow);
        for (const PolicyKind policy : {PolicyKind::EarliestStarvation, PolicyKind::Steady}) {
          const pipeline::PolicyScore ours = score(policy);
          qInfo("%d processors, seed %d, %s:", processors, static_cast<int>(seed),
                pipeline::factsOf(policy).name.data());
          for (const pipeline::PolicyScore& row : {ours, dependency, flow}) {
            qInfo("  %d set points, %d switches, %.1f items held", static_cast<int>(row.points),
                  static_cast<int>(row.switches), row.heldItems);
          }
          QVERIFY(ours.points > dependency.points);
          if (processors < 5 || seed == 0) {
            QVERIFY(ours.points > flow.points);
            QVERIFY(ours.switches < std::min(dependency.switches, flow.switches));
          }
        }
      }
    }
  }
};

RIVULET_TEST(TestPolicies)
#include "tst_policies.moc"
