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

  void steadyStaysUnlessSetPointsRunShort() {
    const Candidate warm{Task::Interpret, 5, 1, true};
    const Candidate cold{Task::Interpolate, 1, 2, false};
    Outlook outlook;
    outlook.levels = {0, 0, 0, 1, 10};
    QVERIFY(goesBefore(PolicyKind::Steady, warm, cold, outlook));
    outlook.levels.back() = 1;
    QVERIFY(goesBefore(PolicyKind::Steady, cold, warm, outlook));
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

  /// With a cost of each switch, every policy still sends set points; prints how many.
  void scoresWithSwitchCost() {
    for (const int processors : {1, 2, 5}) {
      QByteArray line = QByteArray::number(processors) + ":";
      for (const pipeline::PolicyFacts& policy : pipeline::policies()) {
        const pipeline::PolicyScore score =
            pipeline::scorePolicy(policy.kind, {processors, 10ms, 1ms, 0}, 3s);
        line += " " + QByteArray::number(static_cast<qulonglong>(score.points)) + " (" +
                QByteArray::number(static_cast<qulonglong>(score.switches)) + ")";
        QVERIFY(score.points > 0);
      }
      qInfo("set points (switches), processors %s", line.constData());
    }
  }
};

RIVULET_TEST(TestPolicies)
#include "tst_policies.moc"
