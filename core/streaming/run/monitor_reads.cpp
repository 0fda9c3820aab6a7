// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/monitor_reads.h"

#include <algorithm>

#include "base/units.h"
#include "feasibility/client_turn.h"

namespace rivulet::streaming {

namespace {

constexpr base::Duration kStatusInterval = std::chrono::milliseconds{200};
/// Reading the status takes one part in this many of the time at most.
constexpr int kStatusShare = 4;

}  // namespace

MonitorReads::MonitorReads(bool showsAxes, base::Instant now)
    : m_status{{opcua::VariableKind::ChannelStatus, 0}, {opcua::VariableKind::Alarm, 0}},
      m_shownAt(now) {
  for (int axis = 0; showsAxes && axis < static_cast<int>(base::kAxisCount); ++axis) {
    m_display.push_back({opcua::VariableKind::ActualPosition, axis});
  }
  m_display.push_back({opcua::VariableKind::PathFeed, 0});
}

void MonitorReads::showRotary(const std::array<int, base::kRotaryAxisCount>& axisOf) {
  if (m_display.size() <= base::kAxisCount) {
    return;  // the method reads the axes itself
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (axisOf[axis] >= 0) {
      m_rotary.push_back(axis);
      m_display.insert(m_display.end() - 1, {opcua::VariableKind::ActualPosition, axisOf[axis]});
    }
  }
}

const std::vector<opcua::Variable>& MonitorReads::variables(Kind kind) const {
  return kind == Kind::Display  ? m_display
         : kind == Kind::Status ? m_status
                                : m_equipment.variables();
}

bool MonitorReads::isDisplayOverdue(base::Instant now) const {
  return now - m_shownAt >= feasibility::kDisplayIntervalMax;
}

void MonitorReads::asked(Kind kind, base::Instant now) {
  m_next[index(kind)] = now + (kind == Kind::Display  ? kDisplayInterval
                               : kind == Kind::Status ? kStatusInterval
                                                      : EquipmentWatch::kInterval);
}

void MonitorReads::statusAnswered(const opcua::Event& event) {
  const base::Instant next = event.at + (kStatusShare - 1) * (event.at - event.sent);
  askStatusAt(std::max(this->next(Kind::Status), next));
}

trace::LiveSample MonitorReads::takeDisplay(const opcua::Event& event) {
  m_shownAt = event.at;
  const std::vector<opcua::Reading>& readings = event.readings;
  trace::LiveSample sample{
      event.at, std::nullopt, base::mmPerSFromMmPerMin(readings.back().number), {}};
  if (readings.size() > base::kAxisCount) {
    sample.positionMm = base::Vec3{readings[0].number, readings[1].number, readings[2].number};
    if (!m_rotary.empty()) {
      sample.rotaryDeg.emplace();
      for (std::size_t i = 0; i < m_rotary.size(); ++i) {
        (*sample.rotaryDeg)[m_rotary[i]] = readings[base::kAxisCount + i].number;
      }
    }
  }
  return sample;
}

}  // namespace rivulet::streaming
