// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/tool_use.h"

#include <algorithm>
#include <cmath>

namespace rivulet::trace {

namespace {

using base::Duration;
using base::Instant;
using Kind = ControlEvent::Kind;

Instant endOf(const ControlTrace& trace) {
  Instant end = trace.events.back().to;
  if (!trace.samples.empty()) {
    end = std::max(end, trace.samples.back().at);
  }
  return trace.blocks.empty() ? end : std::max(end, trace.blocks.back().to);
}

Instant beginOf(const ControlTrace& trace) {
  const Instant begin = trace.events.front().from;
  return trace.samples.empty() ? begin : std::min(begin, trace.samples.front().at);
}

/// Goes through the events and keeps what is in force.
class Account {
 public:
  explicit Account(Instant begin) : m_to(begin) { m_uses.emplace_back(); }

  void take(const ControlEvent& event) {
    passTo(event.from);
    switch (event.kind) {
      case Kind::ToolChange:
        begin(event);
        break;
      case Kind::Spindle:
        turn(event.value);
        break;
      case Kind::Coolant:
        m_coolant = static_cast<int>(event.value);
        noteCoolant();
        break;
      case Kind::WorkOffset:
        m_offset = static_cast<int>(event.value);
        noteOffset();
        break;
      case Kind::Edge:
      case Kind::Dwell:
      case Kind::Stop:
        break;
    }
  }

  std::vector<ToolUse> finish(Instant end) {
    passTo(end);
    // Nothing happened before the first change.
    const ToolUse& first = m_uses.front();
    if (!first.number && m_uses.size() > 1 && first.turning == Duration{} &&
        first.cooling == Duration{}) {
      m_uses.erase(m_uses.begin());
    }
    return std::move(m_uses);
  }

 private:
  void passTo(Instant at) {
    const Duration passed = std::max(Duration{}, at - m_to);
    m_to = std::max(m_to, at);
    ToolUse& use = m_uses.back();
    use.inSpindle += passed;
    use.turning += m_perMin != 0.0 ? passed : Duration{};
    use.cooling += m_coolant != 0 ? passed : Duration{};
  }

  void begin(const ControlEvent& event) {
    ToolUse& use = m_uses.emplace_back();
    use.number = static_cast<int>(event.value);
    use.name = event.name;
    use.change = event.to - event.from;
    m_to = std::max(m_to, event.to);
    m_perMin = 0.0;  // the change stops the spindle
    noteCoolant();
    noteOffset();
  }

  void turn(double perMin) {
    m_perMin = perMin;
    if (perMin == 0.0) {
      return;
    }
    ToolUse& use = m_uses.back();
    const double speed = std::abs(perMin);
    use.perMinLeast = use.perMinMost == 0.0 ? speed : std::min(use.perMinLeast, speed);
    use.perMinMost = std::max(use.perMinMost, speed);
    (perMin > 0.0 ? use.clockwise : use.counterclockwise) = true;
  }

  void noteCoolant() {
    m_uses.back().flood |= (m_coolant & 1) != 0;
    m_uses.back().mist |= (m_coolant & 2) != 0;
  }

  void noteOffset() {
    std::vector<int>& offsets = m_uses.back().workOffsets;
    if (m_offset && (offsets.empty() || offsets.back() != *m_offset)) {
      offsets.push_back(*m_offset);
    }
  }

  std::vector<ToolUse> m_uses;
  Instant m_to;
  double m_perMin = 0.0;
  int m_coolant = 0;
  std::optional<int> m_offset;
};

}  // namespace

std::vector<ToolUse> toolUses(const ControlTrace& trace) {
  const bool isThere =
      std::any_of(trace.events.begin(), trace.events.end(), [](const ControlEvent& event) {
        return event.kind == Kind::ToolChange || event.kind == Kind::Spindle ||
               event.kind == Kind::Coolant;
      });
  if (!isThere) {
    return {};
  }
  Account account(beginOf(trace));
  for (const ControlEvent& event : trace.events) {
    account.take(event);
  }
  return account.finish(endOf(trace));
}

}  // namespace rivulet::trace
