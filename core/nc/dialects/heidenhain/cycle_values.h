// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the fixed cycles of Heidenhain have in common: their parameters, and the planes between
/// which they move. @threadsafety plain values.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/axes.h"
#include "nc/dialects/heidenhain/cycles.h"

namespace rivulet::nc::heidenhain {

using Steps = std::vector<CycleStep>;

inline constexpr double kCycleRounding = 1e-9;

/// Reads parameters until one is missing.
class Values {
 public:
  Values(const CycleDefinition& cycle, const CycleSituation& situation)
      : m_cycle(cycle), m_situation(situation) {}

  double q(int number) {
    const Expected<double> value = m_situation.parameters.number(fmt::format("Q{}", number));
    if (!value) {
      note(value.error());
      return 0.0;
    }
    return *value;
  }
  /// A parameter that older controls do not have.
  double q(int number, double otherwise) {
    // Another cycle may have set it before.
    const std::string name = fmt::format("Q{}", number);
    const bool isSet =
        m_cycle.named.empty() ? m_situation.parameters.has(name) : m_cycle.named.contains(name);
    return isSet ? q(number) : otherwise;
  }
  /// Line `number` of an old cycle.
  double old(int number) {
    const auto found = m_cycle.values.find(number);
    if (found == m_cycle.values.end()) {
      note({FaultCode::ValueMissing, fmt::format("CYCL DEF {}.{}", m_cycle.number, number), {}});
      return 0.0;
    }
    return found->second;
  }
  double old(int number, double otherwise) {
    return m_cycle.values.contains(number) ? old(number) : otherwise;
  }
  /// F of a line of an old cycle.
  double oldFeed(int number) { return ofLine(m_cycle.feeds, number, "F"); }
  /// DR of a line of an old cycle.
  bool oldClockwise(int number) { return ofLine(m_cycle.turns, number, "DR") < 0.0; }
  void note(Fault fault) {
    if (!m_fault) {
      m_fault = std::move(fault);
    }
  }
  /// With this value of its parameter the cycle is not made.
  void refuse(std::string_view parameter) {
    note({FaultCode::CycleNotRun, fmt::format("CYCL DEF {} ({})", m_cycle.number, parameter), {}});
  }
  void outOfRange(int number) { refuse(fmt::format("Q{}", number)); }
  [[nodiscard]] const std::optional<Fault>& fault() const { return m_fault; }
  [[nodiscard]] bool isFaulty() const { return m_fault.has_value(); }
  [[nodiscard]] const CycleSituation& situation() const { return m_situation; }

 private:
  double ofLine(const std::map<int, double>& of, int line, std::string_view word) {
    const auto found = of.find(line);
    if (found == of.end()) {
      note({FaultCode::ValueMissing,
            fmt::format("CYCL DEF {}.{} {}", m_cycle.number, line, word),
            {}});
      return 0.0;
    }
    return found->second;
  }

  const CycleDefinition& m_cycle;
  const CycleSituation& m_situation;
  std::optional<Fault> m_fault;
};

/// What the cycles from 200 on have in common: the planes and the moves between them.
class Drilling {
 public:
  explicit Drilling(Values& values) : m_values(values) {
    const CycleSituation& situation = values.situation();
    m_setUp = situation.setUp ? *situation.setUp : values.q(200);
    m_surface = (situation.surface ? *situation.surface : values.q(203)) + situation.surfaceShift;
    const double second = situation.secondSetUp ? *situation.secondSetUp : values.q(204);
    m_retract = m_surface + std::max(second, m_setUp);
    const double depth = values.q(201);
    // A positive depth: the manual leaves it to a machine parameter (displayDepthErr).
    if (depth > 0.0) {
      values.outOfRange(201);
    }
    if (m_setUp < 0.0) {
      values.outOfRange(200);
    }
    m_depth = -depth;
    m_place = situation.at;
  }

  [[nodiscard]] double whole() const { return m_depth; }
  [[nodiscard]] double clearance() const { return m_surface + m_setUp; }
  /// So far below the surface.
  [[nodiscard]] double below(double depth) const { return m_surface - depth; }
  [[nodiscard]] double setUp() const { return m_setUp; }
  [[nodiscard]] double surface() const { return m_surface; }
  /// The second set-up clearance, or the first if that is higher.
  [[nodiscard]] double retraction() const { return m_retract; }

  void rapid(double height) { add({.kind = CycleStep::Kind::Rapid, .to = at(height)}); }
  void feed(double height, double feed) {
    if (feed >= kFeedMax) {
      rapid(height);
    } else {
      add({.kind = CycleStep::Kind::Feed, .to = at(height), .feed = feed});
    }
  }
  void dwell(double seconds) {
    if (seconds > 0.0) {
      add({.kind = CycleStep::Kind::Dwell, .seconds = seconds});
    }
  }
  void add(CycleStep step) { m_steps.push_back(step); }
  [[nodiscard]] base::Vec3 at(double height) const {
    base::Vec3 place = m_place;
    place.set(m_values.situation().toolAxis, height);
    return place;
  }
  /// To the second set-up clearance, if it is farther away than the first.
  void leave() {
    if (m_retract > clearance() + kCycleRounding) {
      rapid(m_retract);
    }
  }
  [[nodiscard]] Steps take() { return std::move(m_steps); }

 private:
  Values& m_values;
  double m_setUp = 0.0;
  double m_surface = 0.0;
  double m_retract = 0.0;
  double m_depth = 0.0;
  base::Vec3 m_place;
  Steps m_steps;
};

/// A feed that the manual lets be 0: then another one counts.
inline double feedOr(double feed, double otherwise) {
  return feed == 0.0 ? otherwise : feed;
}

inline void checkFeed(Values& values, int number, double feed) {
  if (!(feed > 0.0)) {
    values.outOfRange(number);
  }
}

/// Old cycles begin and end where the tool stands, the set-up clearance above the surface.
struct OldHole {
  OldHole(Values& values, const CycleSituation& situation)
      : place(situation.at),
        axis(situation.toolAxis),
        start(situation.at[situation.toolAxis]),
        setUp(std::abs(values.old(1))),
        depth(values.old(2)) {
    if (std::isnan(start)) {
      values.note(
          {FaultCode::RelativeFromUnknownPosition, std::string(1, base::kAxisNames[axis]), {}});
    }
    if (depth > 0.0) {
      values.refuse("DEPTH");
    }
  }
  [[nodiscard]] base::Vec3 at(double height) const {
    base::Vec3 to = place;
    to.set(axis, height);
    return to;
  }
  [[nodiscard]] double surface() const { return start - setUp; }

  base::Vec3 place;
  std::size_t axis;
  double start;
  double setUp;
  double depth;
};

}  // namespace rivulet::nc::heidenhain
