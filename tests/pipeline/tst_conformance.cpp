// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Recorded events of the scheduler are replayed against the net of [P3]: a hundred drawn runs are
// allowed by it, and schedulers that do something else are caught.

#include <QtTest>

#include "base/random.h"
#include "machine/config.h"
#include "pipeline/conformance.h"
#include "pipeline/pipeline.h"
#include "pipeline/reference.h"
#include "pipeline/virtual_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using pipeline::Event;
using pipeline::PolicyKind;
using pipeline::Task;

namespace {

/// Lines and arcs that the machine can reach.
std::string drawProgram(base::Random& random) {
  std::string text = "G90 G64 S2000 M3\n";
  const auto number = [&](std::uint64_t below) { return std::to_string(random.below(below)); };
  const std::uint64_t blocks = 3 + random.below(10);
  for (std::uint64_t i = 0; i < blocks; ++i) {
    switch (random.below(6)) {
      case 0:
        text += "G2 X=IC(3) Y=IC(1) CR=2 F" + std::to_string(500 + random.below(3000)) + "\n";
        break;
      case 1:
        text += "G4 F0.0" + std::to_string(1 + random.below(9)) + "\n";
        break;
      case 2:
        text += "STOPRE\n";
        break;
      default:
        text += "G1 X" + number(15) + " Y" + number(15) + " F" +
                std::to_string(2000 + random.below(6000)) + "\n";
    }
  }
  return text + "M30\n";
}

struct Recorded {
  PolicyKind policy = PolicyKind::TaskDependency;
  pipeline::DispatchOptions dispatch;
  std::vector<Event> events;
  pipeline::VirtualRun run;
};

/// @param scheduler  null: that of the policy
Recorded record(std::uint64_t seed, PolicyKind policy,
                const pipeline::SchedulingPolicy* scheduler = nullptr) {
  static const machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
  base::Random random(seed);
  Recorded recorded;
  recorded.policy = policy;
  recorded.dispatch.processors = 1 + static_cast<int>(random.below(6));
  recorded.dispatch.capacity = 1 + static_cast<int>(random.below(20));
  recorded.dispatch.positionCycle = std::chrono::milliseconds{1 + random.below(15)};
  tests::KeptPoints axes;
  pipeline::Pipeline tasks(config, axes);
  tasks.receive().feed(drawProgram(random));
  tasks.receive().endInput();
  const std::uint64_t longest = 1 + random.below(8'000'000);
  pipeline::VirtualOptions options;
  options.dispatch = recorded.dispatch;
  options.duration = [&](Task, std::uint64_t) {
    return base::Duration{1 + static_cast<std::int64_t>(random.below(longest))};
  };
  options.recorder = [&](const Event& event) { recorded.events.push_back(event); };
  const auto own = pipeline::factsOf(policy).make();
  const auto run =
      pipeline::runVirtual(tasks.stages(), scheduler != nullptr ? *scheduler : *own, options);
  if (!run || !run->hasEnded) {
    qFatal("the run has not ended");
  }
  recorded.run = *run;
  return recorded;
}

pipeline::Conformance check(const Recorded& recorded) {
  const auto result =
      pipeline::checkConformance(recorded.events, recorded.policy, recorded.dispatch);
  if (!result) {
    qFatal("%s", result.error().text().c_str());
  }
  return *result;
}

/// The priorities upside down.
class WrongPriority final : public pipeline::SchedulingPolicy {
 public:
  [[nodiscard]] bool goesBefore(const pipeline::Candidate& a, const pipeline::Candidate& b,
                                const pipeline::Outlook& /*outlook*/) const override {
    return indexOf(a.task) < indexOf(b.task);
  }
};

PolicyKind policyOf(std::uint64_t seed) {
  return seed % 2 == 0 ? PolicyKind::TaskDependency : PolicyKind::DataFlow;
}

}  // namespace

class TestConformance : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aHundredRunsAreAllowed() {
    std::size_t events = 0;
    std::uint64_t preemptions = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const Recorded recorded = record(seed, policyOf(seed));
      const pipeline::Conformance result = check(recorded);
      QVERIFY2(!result.violation,
               (std::to_string(seed) + ": " + result.violation.value_or("")).c_str());
      QCOMPARE(result.events, recorded.events.size());
      events += result.events;
      for (std::size_t i = 0; i < pipeline::kTaskCount; ++i) {
        // TREC: what the scheduler has counted and what the net has.
        const pipeline::TaskRecord& ours = recorded.run.records[i];
        const pipeline::TaskRecord& net = result.records[i];
        preemptions += ours.preemptions;
        QCOMPARE(ours.count, net.count);
        QVERIFY(ours.waitedData == net.waitedData);
        QVERIFY(ours.waitedTurn == net.waitedTurn);
        QVERIFY(ours.responseSum == net.responseSum);
        QVERIFY(ours.responseMin == net.responseMin);
        QVERIFY(ours.responseMax == net.responseMax);
        QCOMPARE(ours.preemptions, net.preemptions);
        QCOMPARE(ours.late, net.late);
      }
    }
    QVERIFY(events > 20'000);
    QVERIFY(preemptions > 100);
  }

  void aWrongPriorityIsCaught() {
    const WrongPriority wrong;
    int caught = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Recorded recorded = record(seed, PolicyKind::TaskDependency, &wrong);
      const pipeline::Conformance result = check(recorded);
      // With as many processors as tasks there is nothing to choose.
      QVERIFY(result.violation || recorded.dispatch.processors > 2);
      if (result.violation) {
        ++caught;
        QVERIFY2(result.violation->find("the net gives the processor to") != std::string::npos,
                 result.violation->c_str());
      }
    }
    QVERIFY(caught >= 8);
  }

  void anotherPolicyIsCaught() {
    int caught = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Recorded recorded = record(seed, policyOf(seed));
      recorded.policy = policyOf(seed + 1);
      caught += check(recorded).violation ? 1 : 0;
    }
    QVERIFY(caught >= 5);
  }

  /// Each kind of lie in a recording.
  void changedEventsAreCaught() {
    Recorded recorded = record(7, PolicyKind::TaskDependency);
    recorded.events.resize(std::min<std::size_t>(recorded.events.size(), 400));
    QVERIFY(!check(recorded).violation);
    const std::vector<Event> events = recorded.events;
    for (std::size_t i = 0; i + 60 < events.size(); i += 3) {
      recorded.events = events;
      recorded.events.erase(recorded.events.begin() + static_cast<std::ptrdiff_t>(i));
      QVERIFY(check(recorded).violation);
      recorded.events = events;
      recorded.events[i].levels[i % pipeline::kBufferCount] += 1;
      QVERIFY(check(recorded).violation);
      recorded.events = events;
      recorded.events.insert(recorded.events.begin() + static_cast<std::ptrdiff_t>(i), events[i]);
      QVERIFY(check(recorded).violation);
    }
  }

  /// Position control that starts a nanosecond before its cycle.
  void anEarlyStartIsCaught() {
    int caught = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Recorded recorded = record(seed, PolicyKind::TaskDependency);
      const base::Duration cycle = recorded.dispatch.positionCycle;
      for (std::size_t i = 1; i < recorded.events.size(); ++i) {
        Event& event = recorded.events[i];
        if (event.kind == Event::Kind::Start && event.task == Task::Position &&
            event.at.time_since_epoch() % cycle == 0ns && recorded.events[i - 1].at < event.at) {
          event.at -= 1ns;
          const auto violation = check(recorded).violation;
          QVERIFY(violation.has_value());
          QVERIFY2(violation->find("position control starts") != std::string::npos,
                   violation->c_str());
          ++caught;
          break;
        }
      }
    }
    QVERIFY(caught > 0);
  }

  void ourOwnPoliciesAreNotInTheNet() {
    const auto result = pipeline::checkConformance({}, PolicyKind::Steady, {});
    QVERIFY(!result);
    QVERIFY(result.error().message.find("steady") != std::string::npos);
  }
};

RIVULET_TEST(TestConformance)
#include "tst_conformance.moc"
