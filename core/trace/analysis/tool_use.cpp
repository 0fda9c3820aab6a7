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

}  // namespace

void ToolUseFinder::add(const ControlTrace& piece) {
  if (!m_to && !(piece.samples.empty() && piece.events.empty())) {
    const Instant sampled = piece.samples.empty() ? Instant::max() : piece.samples.front().at;
    m_to = piece.events.empty() ? sampled : std::min(sampled, piece.events.front().from);
  }
  for (const ControlEvent& event : piece.events) {
    m_hasTools = m_hasTools || event.kind == Kind::ToolChange || event.kind == Kind::Spindle ||
                 event.kind == Kind::Coolant;
    take(event);
    m_end = std::max(m_end, event.to);
  }
  m_end = piece.samples.empty() ? m_end : std::max(m_end, piece.samples.back().at);
  m_end = piece.blocks.empty() ? m_end : std::max(m_end, piece.blocks.back().to);
}

std::vector<ToolUse> ToolUseFinder::finish() {
  if (!m_hasTools) {
    return {};
  }
  passTo(m_end);
  // Nothing happened before the first change.
  const ToolUse& first = m_uses.front();
  if (!first.number && m_uses.size() > 1 && first.turning == Duration{} &&
      first.cooling == Duration{}) {
    m_uses.erase(m_uses.begin());
  }
  return std::move(m_uses);
}

void ToolUseFinder::take(const ControlEvent& event) {
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

void ToolUseFinder::passTo(Instant at) {
  const Duration passed = std::max(Duration{}, at - *m_to);
  m_to = std::max(*m_to, at);
  ToolUse& use = m_uses.back();
  use.inSpindle += passed;
  use.turning += m_perMin != 0.0 ? passed : Duration{};
  use.cooling += m_coolant != 0 ? passed : Duration{};
}

void ToolUseFinder::begin(const ControlEvent& event) {
  ToolUse& use = m_uses.emplace_back();
  use.number = static_cast<int>(event.value);
  use.name = event.name;
  use.change = event.to - event.from;
  m_to = std::max(*m_to, event.to);
  m_perMin = 0.0;  // the change stops the spindle
  noteCoolant();
  noteOffset();
}

void ToolUseFinder::turn(double perMin) {
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

void ToolUseFinder::noteCoolant() {
  m_uses.back().flood |= (m_coolant & 1) != 0;
  m_uses.back().mist |= (m_coolant & 2) != 0;
}

void ToolUseFinder::noteOffset() {
  std::vector<int>& offsets = m_uses.back().workOffsets;
  if (m_offset && (offsets.empty() || offsets.back() != *m_offset)) {
    offsets.push_back(*m_offset);
  }
}

std::vector<ToolUse> toolUses(const ControlTrace& trace) {
  ToolUseFinder finder;
  finder.add(trace);
  return finder.finish();
}

}  // namespace rivulet::trace
