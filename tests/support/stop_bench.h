// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Stops drawn from a seed: who orders them, what they may take, and what they took.
/// @threadsafety one thread.
#pragma once

#include <QtGlobal>
#include <algorithm>
#include <cmath>
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
  bool leaves(Instant now) override { return leavesWhen && leavesWhen(now); }
  bool letsEnd(Instant now) override { return !leaves(now); }
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
  std::function<bool(Instant)> leavesWhen;
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

/// A circle of 100 mm in chords of 1 mm.
inline std::shared_ptr<const gcode::Program> circles(std::size_t points) {
  std::vector<base::Vec3> all;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = 0.01 * static_cast<double>(i);
    all.push_back({100.0 - 100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0});
  }
  return streaming::programOf(all);
}

/// A whole job with native moves, rapids, arcs, cycles and stretches. @param rounds  of all of them
inline std::string jobText(int rounds) {
  std::string text = "G17 G90 G71 G94 F1500\nT1 M6\nS1000 M3\nG0 X0 Y0 Z20\n";
  for (int i = 0; i < rounds; ++i) {
    text += "SUPA G0 Z60\nSUPA G0 X10 Y10\nG0 X0 Y0 Z20\nG1 Z0\n";
    for (int k = 0; k < 10; ++k) {
      text += "G1 X" + std::to_string(10 * (k % 2)) + " Y" + std::to_string(k) + "\n";
    }
    text += "G0 Z20\nMCALL CYCLE81(20,0,2,-10)\nX5 Y5\nX30 Y5\nX30 Y40\nMCALL\n";
    text += "G0 X0 Y0\nG1 X60 Y0 F3000\nG2 X0 Y0 I-30 J0\n";
  }
  return text + "M30\n";
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
