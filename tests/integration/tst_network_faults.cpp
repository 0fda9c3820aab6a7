// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole runs over a network with faults, in real time. Each point must be executed once and in
/// order, by however many attempts, and a stall must not end a run. `scripts/soak --network` runs
/// many more: RIVULET_SCENARIOS, RIVULET_FIRST, RIVULET_JOBS.

#include <fmt/format.h>

#include <QtTest>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "network_scenario.h"
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
  int resumed = 0;
  base::Duration endedAfterMost{};
  std::map<std::string, int> errors;
};

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
  return text;
}

}  // namespace

class TestNetworkFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// However slow the control is: the method has its turn between two reads of the status.
  void slowNetworkDoesNotStarveTheMethod() {
    NetworkScenario scenario;
    scenario.points = 16;
    scenario.oneWay = 200ms;
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
    if (environment("RIVULET_SCENARIOS", 0) == 0) {
      QSKIP("takes minutes: scripts/soak --network");
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
    if (environment("RIVULET_SCENARIOS", 0) == 0) {
      QSKIP("takes minutes: scripts/soak --network");
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

  void drawnFaults() {
    const std::uint64_t count = environment("RIVULET_SCENARIOS", 6);
    const std::uint64_t first = environment("RIVULET_FIRST", 5);
    const std::uint64_t jobs = environment("RIVULET_JOBS", 6);
    std::atomic<std::uint64_t> next{first};
    std::mutex mutex;
    std::map<FaultKind, Tally> tallies;
    std::vector<std::string> faults;
    const auto work = [&] {
      for (std::uint64_t seed = next++; seed < first + count; seed = next++) {
        const MethodKind method = seed % 2 == 0 ? MethodKind::Window : MethodKind::Credit;
        const NetworkScenario scenario = tests::drawNetworkScenario(seed, method);
        const NetworkEvidence evidence = tests::exposeToNetwork(scenario);
        const std::lock_guard lock(mutex);
        Tally& tally = tallies[scenario.fault.kind];
        ++tally.runs;
        tally.survived += evidence.hasSurvived() ? 1 : 0;
        tally.resumed += !evidence.hasSurvived() && evidence.isWhole() ? 1 : 0;
        tally.endedAfterMost =
            std::max(tally.endedAfterMost, evidence.endedAfter.value_or(base::Duration{}));
        if (!evidence.hasSurvived()) {
          ++tally.errors[evidence.attempts.front().error.message];
        }
        // Before anything moves, a stall may end the attempt.
        const streaming::RunReport& attempt = evidence.attempts.front();
        const bool hasStreamed = attempt.checkpoint && attempt.checkpoint->granted;
        const bool mustSurvive = scenario.fault.kind == FaultKind::Stall && hasStreamed &&
                                 !scenario.stopAfter && scenario.fault.duration < 9800ms;
        if (!evidence.isWhole() || (mustSurvive && !evidence.hasSurvived())) {
          faults.push_back(describe(scenario, evidence));
        }
      }
    };
    std::vector<std::thread> threads;
    for (std::uint64_t job = 0; job < std::min(jobs, count); ++job) {
      threads.emplace_back(work);
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (const auto& [kind, tally] : tallies) {
      qInfo(
          "%s: %d runs, %d went through, %d resumed to the end, ended at most %.1f s after the "
          "fault",
          std::string(tests::faultName(kind)).c_str(), tally.runs, tally.survived, tally.resumed,
          base::toSeconds(tally.endedAfterMost));
      for (const auto& [error, times] : tally.errors) {
        qInfo("  %d times: %s", times, error.c_str());
      }
    }
    for (const std::string& fault : faults) {
      qWarning("%s", fault.c_str());
    }
    QVERIFY(faults.empty());
  }
};

RIVULET_TEST(TestNetworkFaults)
#include "tst_network_faults.moc"
