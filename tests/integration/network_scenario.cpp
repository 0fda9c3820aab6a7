// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "network_scenario.h"

#include <open62541/client_subscriptions.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "base/units.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "support/chosen_link.h"
#include "support/loopback_machine.h"
#include "support/plain_client.h"

namespace rivulet::tests {

namespace {

using base::Duration;
using base::Instant;
using base::MethodKind;
using namespace std::chrono_literals;

constexpr int kAttemptsMax = 5;
constexpr int kQuestionsMax = 40;
/// A run that repeats its loop for ever is stopped.
constexpr Duration kRunMax = 240s;
constexpr double kToleranceMm = 1e-6;

/// The operator: orders at their times, and a look at the clock when the fault strikes.
class Operator final : public streaming::RunSink, public streaming::RunOrders {
 public:
  Operator(const NetworkScenario& scenario, const FaultProxy& proxy, bool isFirst)
      : m_scenario(scenario), m_proxy(proxy), m_isFirst(isFirst) {}

  std::optional<Instant> struckAt;
  std::vector<std::string> notes;

  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note& note) override { notes.push_back(note.text); }
  bool stopRequested(Instant now) override {
    if (!m_startedAt) {
      m_startedAt = now;
    }
    if (!struckAt && m_proxy.hasStruck()) {
      struckAt = now;
    }
    const Duration since = now - *m_startedAt;
    return since > kRunMax || (m_isFirst && m_scenario.stopAfter && since > *m_scenario.stopAfter);
  }
  bool holdRequested(Instant now) override {
    const Duration since = m_startedAt ? now - *m_startedAt : Duration{};
    return m_isFirst && m_scenario.holdAfter && since > *m_scenario.holdAfter &&
           since < *m_scenario.holdAfter + m_scenario.holdFor;
  }
  base::Vec3 correctionMm(Instant now) override {
    const double phase = base::toSeconds(now.time_since_epoch());
    return {0.5 * m_scenario.correctionLimitMm * std::sin(phase), 0.0, 0.0};
  }

 private:
  const NetworkScenario& m_scenario;
  const FaultProxy& m_proxy;
  bool m_isFirst;
  std::optional<Instant> m_startedAt;
};

/// Another client that reads 1000 nodes again and again.
class Reader {
 public:
  explicit Reader(const LoopbackMachine& cell) {
    m_thread = std::thread([this, link = cell.connect()] {
      const std::vector<opcua::Variable> many(1000, opcua::rParameter(1));
      while (!m_stop.load()) {
        link->read(many, 60s, opcua::Grouping::List);
        while (!link->wait(link->now() + 100ms) && !m_stop.load()) {
        }
        link->wait(link->now() + 500ms);
      }
    });
  }
  ~Reader() {
    m_stop.store(true);
    m_thread.join();
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

 private:
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

/// Another client with a subscription of many items.
class Watcher {
 public:
  Watcher(const LoopbackMachine& cell, std::size_t items) : m_client(cell.endpoint()) {
    const UA_UInt16 space = m_client.spaceOf(opcua::kNamespaceUri);
    const UA_CreateSubscriptionResponse made = UA_Client_Subscriptions_create(
        m_client.get(), UA_CreateSubscriptionRequest_default(), nullptr, nullptr, nullptr);
    for (std::size_t i = 0; i < items; ++i) {
      const std::string name = opcua::nodeIdentifier(opcua::rParameter(static_cast<int>(i % 100)));
      UA_MonitoredItemCreateRequest item =
          UA_MonitoredItemCreateRequest_default(opcua::borrowNodeId(space, name));
      item.requestedParameters.samplingInterval = 100.0;
      UA_Client_MonitoredItems_createDataChange(m_client.get(), made.subscriptionId,
                                                UA_TIMESTAMPSTORETURN_NEITHER, item, nullptr,
                                                nullptr, nullptr);
    }
    m_thread = std::thread([this] {
      while (!m_stop.load()) {
        UA_Client_run_iterate(m_client.get(), 50);
      }
    });
  }
  ~Watcher() {
    m_stop.store(true);
    m_thread.join();
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

 private:
  PlainClient m_client;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

class Exposure {
 public:
  explicit Exposure(const NetworkScenario& scenario)
      : m_scenario(scenario),
        m_cell({scenario.preset, scenario.seed, 0}),
        m_proxy(m_cell.endpoint(), scenario.oneWay) {
    base::Random random(scenario.seed);
    std::vector<base::Vec3> points;
    for (std::size_t i = 0; i < scenario.points; ++i) {
      points.push_back({1.5 * static_cast<double>(i),
                        3.0 * std::sin(0.7 * static_cast<double>(i)) + 0.1 * random.uniform(),
                        40.0});
    }
    m_program = streaming::programOf(points);
    m_settings.parameters.method = scenario.method;
    m_settings.parameters.correctionLimitMm = scenario.correctionLimitMm;
    m_settings.feedMmPerS = base::mmPerSFromMmPerMin(scenario.feedMmPerMin);
    m_settings.isCommissioned = true;
    m_settings.deltaMm = 0.5;
    m_settings.startDeadline = 60s;
    m_settings.access = scenario.access;
    m_settings.monitor = scenario.monitor;
    m_settings.origin = {"tester", "here", "2026-11-22T05:00:00Z"};  // the cells are claimed
  }

  NetworkEvidence run() {
    const auto flight = streaming::preflight(*m_cell.connect(), *m_program, m_settings);
    RIVULET_ASSERT(flight.has_value());
    m_points = flight->points.points;
    m_evidence.total = m_points.size();
    std::optional<Reader> reader;
    if (m_scenario.hasReader) {
      reader.emplace(m_cell);
    }
    std::optional<Watcher> watcher;
    if (m_scenario.watchedItems > 0) {
      watcher.emplace(m_cell, m_scenario.watchedItems);
    }
    m_proxy.begin(m_scenario.fault);
    for (int attempt = 0; attempt < kAttemptsMax; ++attempt) {
      attemptOnce(attempt == 0);
      if (isAtEnd()) {
        break;
      }
      m_proxy.begin({});
      const auto beside = m_cell.connect();
      if (!findResume(*beside)) {
        break;
      }
      takeTrace(*beside);
    }
    reader.reset();
    watcher.reset();
    const auto beside = m_cell.connect();
    if (!isResumable() && !beside->reset()) {
      m_evidence.problem = "the operator could not reset the control";
    }
    takeTrace(*beside);
    m_evidence.integrity = trace::judgeIntegrity(m_points, m_blocks, kToleranceMm);
    m_evidence.requests = m_cell.server().requestsServed();
    return std::move(m_evidence);
  }

 private:
  [[nodiscard]] bool isAtEnd() const {
    return m_evidence.attempts.back().outcome == streaming::Outcome::Completed || !isResumable();
  }
  [[nodiscard]] bool isResumable() const {
    return m_scenario.method == MethodKind::Window || m_scenario.method == MethodKind::Credit;
  }

  void attemptOnce(bool isFirst) {
    Operator orders(m_scenario, m_proxy, isFirst);
    const opcua::MonotonicClock clock;
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = m_proxy.endpoint();
    const auto link = tests::openChosen(options);
    streaming::RunReport report;
    if (link) {
      report = streaming::runJob(**link, **link, *m_program, m_settings, orders, orders);
      m_evidence.hasStruck = m_evidence.hasStruck || m_proxy.hasStruck();
      if (isFirst && report.error.code && orders.struckAt) {
        m_evidence.endedAfter = (*link)->now() - *orders.struckAt;
      }
    } else {
      report.error = link.error();
    }
    if (report.checkpoint) {
      m_checkpoint = report.checkpoint;
      m_checkpointSettings = report.settings;
    }
    m_evidence.notes.insert(m_evidence.notes.end(), orders.notes.begin(), orders.notes.end());
    m_evidence.attempts.push_back(std::move(report));
  }

  bool findResume(opcua::UaLink& direct) {
    for (int question = 0; question < kQuestionsMax; ++question) {
      if (!m_checkpoint) {
        // The program may wait for a client that never asked for its cells.
        return direct.reset().has_value();
      }
      const auto resume =
          streaming::resumeFrom(direct, *m_program, m_checkpointSettings, *m_checkpoint);
      if (resume) {
        m_settings.resume = *resume;
        return true;
      }
      m_evidence.problem = resume.error().text();
      if (!m_checkpoint->granted && direct.reset()) {
        m_evidence.problem.clear();
        m_checkpoint.reset();  // nothing of this run has been executed
        return true;
      }
      direct.wait(direct.now() + 500ms);
    }
    return false;
  }

  /// What was executed since the last cycle start.
  void takeTrace(opcua::UaLink& direct) {
    const auto trace = direct.fetchTrace();
    if (!trace) {
      m_evidence.problem = trace.error().text();
      return;
    }
    if (trace->blocks.empty() || (!m_blocks.empty() && trace->blocks.front().from == m_lastStart)) {
      return;
    }
    m_lastStart = trace->blocks.front().from;
    m_blocks.insert(m_blocks.end(), trace->blocks.begin(), trace->blocks.end());
    m_evidence.problem.clear();
  }

  NetworkScenario m_scenario;
  LoopbackMachine m_cell;
  FaultProxy m_proxy;
  std::shared_ptr<const gcode::Program> m_program;
  streaming::RunSettings m_settings;
  std::vector<gcode::StreamPoint> m_points;
  std::vector<trace::ExecutedBlock> m_blocks;
  Instant m_lastStart{};
  std::optional<streaming::Checkpoint> m_checkpoint;
  streaming::RunSettings m_checkpointSettings;
  NetworkEvidence m_evidence;
};

}  // namespace

bool NetworkEvidence::hasSurvived() const {
  return attempts.front().outcome == streaming::Outcome::Completed;
}

NetworkScenario drawNetworkScenario(std::uint64_t seed, MethodKind method) {
  base::Random random = base::Random(seed).fork(7);
  NetworkScenario scenario;
  scenario.seed = seed;
  scenario.method = method;
  scenario.fault = drawNetworkFault(seed, 4s);
  if (base::isPublished(method)) {
    scenario.feedMmPerMin = 1000.0;  // feasible by the equations of [P1]
  }
  const auto sometime = [&] { return base::fromSeconds(4.0 * random.uniform()); };
  if (base::hasWindows(method) && random.below(6) == 0) {
    scenario.holdAfter = sometime();
    scenario.holdFor = sometime();
  }
  if (random.below(6) == 0) {
    scenario.stopAfter = sometime();
  }
  if ((method == MethodKind::Window || method == MethodKind::Credit) && random.below(6) == 0) {
    scenario.correctionLimitMm = 0.1;
  }
  return scenario;
}

NetworkEvidence exposeToNetwork(const NetworkScenario& scenario) {
  return Exposure(scenario).run();
}

}  // namespace rivulet::tests
