// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Stops drawn from a seed: who orders them, what they may take, and what they took.
/// @threadsafety one thread.
#pragma once

#include <QtGlobal>
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "gcode/program.h"
#include "machine/machine.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::tests {

using base::Duration;
using base::Instant;
using streaming::FeedOrder;

/// RIVULET_STOPS=1000 draws as many of each kind.
inline std::size_t stopsWanted() {
  const int wanted = qEnvironmentVariableIntValue("RIVULET_STOPS");
  return wanted > 0 ? static_cast<std::size_t>(wanted) : 40;
}

struct Hold {
  Instant ordered{};
  Instant released{};
  std::optional<Instant> written;  ///< into the cell, at the machine
};

/// Holds again and again at drawn times, each until the client has said that the axes stand.
class Operator final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  explicit Operator(std::uint64_t seed) : m_random(seed) {}

  bool stopRequested(Instant now) override { return stopWhen && stopWhen(now); }
  FeedOrder feed(Instant now) override {
    if (orderWhen) {
      return orderWhen(now);
    }
    if (!m_moves || holds.size() > holdsMax) {
      return {};
    }
    if (!m_isHolding && now >= m_next) {
      if (holds.size() == holdsMax) {
        return {};
      }
      m_isHolding = true;
      holds.push_back({now, {}, {}});
      m_next = Instant::max();
    } else if (m_isHolding && seen && seen->stoodAfter && m_next == Instant::max()) {
      m_next = now + base::fromSeconds(0.3 * m_random.uniform());
    } else if (m_isHolding && now >= m_next) {
      m_isHolding = false;
      holds.back().released = now;
      m_next = now + base::fromSeconds(meanS * 2.0 * m_random.uniform());
    }
    return {m_isHolding};
  }
  void update(const streaming::LiveUpdate& update) override {
    seen = update.feed;
    if (machine != nullptr &&
        update.waitingFor == "trace") {  // before it is fetched, and forgotten by the machine
      trace = machine->trace();
    }
    if (update.feed && update.feed->isIgnored) {
      wasIgnored = true;
    }
    if (update.sample && update.sample->feedMmPerS && *update.sample->feedMmPerS > 0.0) {
      begins(update.at);
    }
    executed = update.counters.executed;
  }
  void access(const trace::Access& access) override { longest = std::max(longest, access.took); }
  void note(const trace::Note& note) override { notes.push_back(note.text); }
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }

  void begins(Instant now) {
    if (!m_moves) {
      m_moves = true;
      m_next = now + base::fromSeconds(meanS * m_random.uniform());
    }
  }
  [[nodiscard]] bool hasNote(const std::string& part) const {
    return std::any_of(notes.begin(), notes.end(), [&part](const std::string& note) {
      return note.find(part) != std::string::npos;
    });
  }

  const machine::Machine* machine = nullptr;
  trace::ControlTrace trace;
  std::function<bool(Instant)> stopWhen;
  std::function<FeedOrder(Instant)> orderWhen;
  std::size_t holdsMax = 0;
  double meanS = 1.0;  ///< between two holds
  std::vector<Hold> holds;
  std::optional<streaming::FeedSeen> seen;
  bool wasIgnored = false;
  std::size_t executed = 0;
  Duration longest{};
  std::vector<std::string> notes;

 private:
  base::Random m_random;
  bool m_moves = false;
  bool m_isHolding = false;
  Instant m_next{};
};

inline std::shared_ptr<const gcode::Program> lines(std::size_t count, double lengthMm) {
  std::vector<base::Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({i % 2 == 0 ? lengthMm : 0.0, 0.0, 0.0});
  }
  return streaming::programOf(points);
}

inline double worst(std::vector<double> values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}
inline double median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace rivulet::tests
