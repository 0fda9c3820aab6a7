// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole runs over a network with faults, in real time. With methods window and credit, each point
/// must be executed once and in order, by however many attempts, and a stall must not end a run.
/// `scripts/soak --network` runs many more: RIVULET_SCENARIOS, RIVULET_SCENARIOS_OF_OTHERS,
/// RIVULET_FIRST, RIVULET_JOBS; RIVULET_FAULT draws one kind of fault only, and
/// RIVULET_TELL prints each run with its notes.

#include <fmt/format.h>

#include <QtTest>
#include <array>
#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

#include "network_scenario.h"
#include "opcua/node_map.h"
#include "support/chosen_link.h"
#include "support/loopback_machine.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;
using tests::FaultKind;
using tests::NetworkEvidence;
using tests::NetworkScenario;

namespace {

std::uint64_t environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// What happened under one kind of fault.
struct Tally {
  int runs = 0;
  int survived = 0;
  int stopped = 0;  ///< by the drawn operator
  int resumed = 0;
  int wrong = 0;  ///< points repeated, skipped or foreign
  base::Duration endedAfterMost{};
  std::map<std::string, std::vector<std::uint64_t>> errors;  ///< seeds of the runs
};

/// Stalls that a run has to survive: shorter than the silence that counts as a loss.
constexpr base::Duration kStallSurvived = 9800ms;

std::string describe(const NetworkScenario& scenario, const NetworkEvidence& evidence) {
  std::string text = fmt::format(
      "{}, seed {}, fault {} after {:.2f} s for {:.2f} s: executed {} of {}, repeated {}, skipped "
      "{}, foreign {}, out of order {}; {}",
      base::methodName(scenario.method), scenario.seed, tests::faultName(scenario.fault.kind),
      base::toSeconds(scenario.fault.after), base::toSeconds(scenario.fault.duration),
      evidence.integrity.executed, evidence.total, evidence.integrity.repeated,
      evidence.integrity.skipped, evidence.integrity.foreign, evidence.integrity.outOfOrder,
      evidence.problem);
  for (const streaming::RunReport& attempt : evidence.attempts) {
    text +=
        fmt::format("\n  {}: {}", streaming::outcomeName(attempt.outcome), attempt.error.text());
  }
  for (const std::string& note : evidence.notes) {
    text += "\n  note: " + note;
  }
  return text;
}

}  // namespace

class TestNetworkFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { RIVULET_SKIP_WITHOUT_LINK(); }

  /// However slow the control is: the method has its turn between two reads of the status.
  void slowNetworkDoesNotStarveTheMethod() {
    NetworkScenario scenario;
    scenario.points = 16;
    scenario.oneWay = 120ms;
    const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
    QVERIFY2(evidence.hasSurvived(), describe(scenario, evidence).c_str());
    QVERIFY2(evidence.isWhole(), describe(scenario, evidence).c_str());
    const std::string& slowedBy = evidence.attempts.front().slowedBy;
    QVERIFY2(slowedBy.find("network") != std::string::npos, slowedBy.c_str());
  }

  /// On a server that needs no time the client asks as often as the control changes its cells.
  void fastServerIsAskedAtAPace() {
    NetworkScenario scenario;
    scenario.preset = "ideal";
    scenario.points = 10;
    scenario.feedMmPerMin = 1000.0;
    const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
    QVERIFY2(evidence.hasSurvived() && evidence.isWhole(), describe(scenario, evidence).c_str());
    const double lastsS = base::toSeconds(evidence.attempts.front().duration);
    const auto requests = static_cast<double>(evidence.attempts.front().access.requests);
    QVERIFY2(requests < 300.0 * lastsS, std::to_string(requests / lastsS).c_str());
  }

  /// The server serves one node after another, whoever asks.
  void otherClientsOnlySlowTheRun_data() {
    QTest::addColumn<int>("watched");
    QTest::addColumn<bool>("reads");
    QTest::newRow("100 watched items") << 100 << false;
    QTest::newRow("1000 nodes read") << 0 << true;
  }
  void otherClientsOnlySlowTheRun() {
    if (environment("RIVULET_ROUND_TRIPS", 0) == 0) {
      QSKIP("takes minutes: scripts/soak --round-trips");
    }
    QFETCH(int, watched);
    QFETCH(bool, reads);
    NetworkScenario scenario;
    scenario.points = 28;
    scenario.watchedItems = static_cast<std::size_t>(watched);
    scenario.hasReader = reads;
    const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
    QVERIFY2(evidence.hasSurvived() && evidence.isWhole(), describe(scenario, evidence).c_str());
    const streaming::RunReport& report = evidence.attempts.front();
    qInfo("%.1f s, access p50 %.0f ms, max %.0f ms: %s", base::toSeconds(report.duration),
          base::toMilliseconds(report.access.perRequest.p50),
          base::toMilliseconds(report.access.perRequest.max), report.slowedBy.c_str());
    QVERIFY2(report.slowedBy.find("client") != std::string::npos, report.slowedBy.c_str());
  }

  /// Connects, tries the forms of access and streams. @see docs/methods.md
  void roundTrips() {
    if (environment("RIVULET_ROUND_TRIPS", 0) == 0) {
      QSKIP("takes minutes: scripts/soak --round-trips");
    }
    for (const base::Duration roundTrip : {0ms, 50ms, 200ms, 500ms, 1000ms}) {
      NetworkScenario scenario;
      scenario.points = 28;
      scenario.oneWay = roundTrip / 2;
      scenario.access = streaming::AccessChoice::Best;
      const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
      QVERIFY2(evidence.hasSurvived() && evidence.isWhole(), describe(scenario, evidence).c_str());
      qInfo("round trip %.0f ms: %.1f s", base::toMilliseconds(roundTrip),
            base::toSeconds(evidence.attempts.front().duration));
    }
  }

  /// Some connections at the same time, each cut at another moment between two requests or during
  /// one: nothing but a loss comes of it.
  void cutConnectionsAreLost() {
    constexpr std::uint64_t kThreads = 4;
    constexpr std::uint64_t kCutsEach = 15;
    std::atomic<std::uint64_t> lost{0};
    std::vector<std::thread> threads;
    for (std::uint64_t seed = 1; seed <= kThreads; ++seed) {
      threads.emplace_back([&lost, seed] {
        const tests::LoopbackMachine cell;
        base::Random random(seed);
        for (std::uint64_t i = 0; i < kCutsEach; ++i) {
          lost += isLostWhenCut(cell, random) ? 1 : 0;
        }
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    QCOMPARE(lost.load(), kThreads * kCutsEach);
  }

  /// Methods window and credit in turn, then the methods that cannot be resumed. Those of [P1]
  /// execute old points again when the client is late or gone, as published: that must be reported.
  /// Method file must wait. @see docs/methods.md
  void drawnFaults() {
    const std::uint64_t first = environment("RIVULET_FIRST", 5);
    const std::uint64_t count = environment("RIVULET_SCENARIOS", 6);
    const std::uint64_t others = environment("RIVULET_SCENARIOS_OF_OTHERS", 3);
    constexpr std::array kPair{MethodKind::Window, MethodKind::Credit};
    constexpr std::array kOthers{MethodKind::Position, MethodKind::Signal, MethodKind::File};
    std::vector<NetworkScenario> scenarios;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
      scenarios.push_back(tests::drawNetworkScenario(seed, kPair[seed % kPair.size()]));
    }
    for (std::uint64_t seed = first; seed < first + others; ++seed) {
      scenarios.push_back(tests::drawNetworkScenario(seed, kOthers[seed % kOthers.size()]));
    }
    if (const char* kind = std::getenv("RIVULET_FAULT"); kind != nullptr) {
      std::erase_if(scenarios, [&](const NetworkScenario& scenario) {
        return tests::faultName(scenario.fault.kind) != kind;
      });
    }
    expose(scenarios);
  }

 private:
  /// Asks until the connection is gone. @return it was reported as lost
  static bool isLostWhenCut(const tests::LoopbackMachine& cell, base::Random& random) {
    tests::FaultProxy proxy(cell.endpoint());
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = proxy.endpoint();
    options.connectDeadline = 20s;
    const auto link = tests::openChosen(options);
    if (!link) {
      return false;
    }
    tests::NetworkFault fault;
    fault.kind = FaultKind::Cut;
    fault.after = base::fromSeconds(0.02 * random.uniform());
    proxy.begin(fault);
    const std::vector<opcua::Variable> one{opcua::rParameter(1)};
    for (;;) {
      (*link)->read(one, 20s, opcua::Grouping::List);
      const auto event = (*link)->wait((*link)->now() + 20s);
      if (!event || event->kind != opcua::EventKind::ReadDone) {
        return event && event->kind == opcua::EventKind::ConnectionLost;
      }
      if (const auto pause =
              (*link)->wait((*link)->now() + base::fromSeconds(0.002 * random.uniform()))) {
        return pause->kind == opcua::EventKind::ConnectionLost;
      }
    }
  }

  static bool isResumable(MethodKind method) {
    return method == MethodKind::Window || method == MethodKind::Credit;
  }

  /// What is wrong with a run; empty: nothing.
  static std::string judge(const NetworkScenario& scenario, const NetworkEvidence& evidence) {
    const streaming::RunReport& first = evidence.attempts.front();
    const trace::Integrity& motion = evidence.integrity;
    const bool isResumable = TestNetworkFaults::isResumable(scenario.method);
    if (isResumable && !evidence.isWhole()) {
      return "not every point was executed once";
    }
    // The text of a window's file has no check number; `isFaultless` below must see it.
    const bool isUnchecked =
        scenario.method == MethodKind::File && scenario.fault.kind == FaultKind::FlipRequest;
    if (!base::isPublished(scenario.method) && !isUnchecked && !motion.isFaultless()) {
      return "the machine moved wrongly";
    }
    if (first.isFaultless() && !motion.isFaultless()) {
      return "wrong motion was reported as faultless";
    }
    if (!isResumable && evidence.hasSurvived() && first.isFaultless() && !evidence.isWhole()) {
      return "an incomplete path was reported as complete";
    }
    const bool mustSurvive = isResumable && scenario.fault.kind == FaultKind::Stall &&
                             !scenario.stopAfter && scenario.fault.duration < kStallSurvived;
    if (mustSurvive && !evidence.hasSurvived()) {
      return "a stall ended the run";
    }
    // No fault of the network takes rights away.
    const std::string& said = first.error.message;
    if (said.find("rights") != std::string::npos || said.find("OPC UA user") != std::string::npos) {
      return "a fault of the network was taken for missing rights";
    }
    return {};
  }

  /// Some runs at the same time: they mostly wait.
  static void expose(const std::vector<NetworkScenario>& scenarios) {
    const std::size_t jobs = environment("RIVULET_JOBS", 9);
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::map<std::pair<std::string_view, FaultKind>, Tally> tallies;
    Tally stalls;
    std::vector<std::string> faults;
    const auto work = [&] {
      for (std::size_t i = next++; i < scenarios.size(); i = next++) {
        const NetworkScenario& scenario = scenarios[i];
        const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
        const std::lock_guard lock(mutex);
        const bool isPair =
            base::hasWindows(scenario.method) && scenario.method != MethodKind::File;
        Tally& tally = tallies[{isPair ? "window, credit" : base::methodName(scenario.method),
                                scenario.fault.kind}];
        addTo(tally, scenario.seed, evidence);
        if (isPair && scenario.fault.kind == FaultKind::Stall &&
            scenario.fault.duration < kStallSurvived) {
          addTo(stalls, scenario.seed, evidence);
        }
        if (std::getenv("RIVULET_TELL") != nullptr) {
          qInfo("%s", describe(scenario, evidence).c_str());
        }
        if (const std::string wrong = judge(scenario, evidence); !wrong.empty()) {
          faults.push_back(wrong + ": " + describe(scenario, evidence));
        }
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t job = 0; job < std::min(jobs, scenarios.size()); ++job) {
      threads.emplace_back(work);
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    Tally all;
    for (const auto& [key, tally] : tallies) {
      print(fmt::format("{}, {}", key.first, tests::faultName(key.second)), tally);
      for (const auto& [error, seeds] : tally.errors) {
        qInfo("  %zu times, first with seed %llu: %s", seeds.size(),
              static_cast<unsigned long long>(seeds.front()), error.c_str());
      }
      all.runs += tally.runs;
      all.survived += tally.survived;
      all.stopped += tally.stopped;
      all.resumed += tally.resumed;
      all.wrong += tally.wrong;
      all.endedAfterMost = std::max(all.endedAfterMost, tally.endedAfterMost);
    }
    print("all", all);
    print("stalls shorter than 9.8 s (window, credit)", stalls);
    for (const std::string& fault : faults) {
      qWarning("%s", fault.c_str());
    }
    QVERIFY(faults.empty());
  }

  static void addTo(Tally& tally, std::uint64_t seed, const NetworkEvidence& evidence) {
    const streaming::RunReport& first = evidence.attempts.front();
    ++tally.runs;
    tally.survived += evidence.hasSurvived() ? 1 : 0;
    tally.stopped += first.outcome == streaming::Outcome::Stopped ? 1 : 0;
    tally.resumed += !evidence.hasSurvived() && evidence.isWhole() ? 1 : 0;
    tally.wrong += evidence.integrity.isFaultless() ? 0 : 1;
    tally.endedAfterMost =
        std::max(tally.endedAfterMost, evidence.endedAfter.value_or(base::Duration{}));
    if (first.outcome == streaming::Outcome::Failed) {
      tally.errors[first.error.message].push_back(seed);
    }
  }

  static void print(const std::string& what, const Tally& tally) {
    qInfo(
        "%s: %d runs, %d went through, %d stopped by the operator, %d ended by the fault at most "
        "%.1f s after it; %d of these and the stopped ones resumed to the end; %d with wrong "
        "motion",
        what.c_str(), tally.runs, tally.survived, tally.stopped,
        tally.runs - tally.survived - tally.stopped, base::toSeconds(tally.endedAfterMost),
        tally.resumed, tally.wrong);
  }
};

RIVULET_TEST(TestNetworkFaults)
#include "tst_network_faults.moc"
