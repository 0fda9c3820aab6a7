// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/motion_sink.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

constexpr int kCircleError = 14040;
constexpr int kNotDefined = 12550;
/// G0 of rotary axes alone: only their own limits bound it.
constexpr double kRapidDegPerS = 1e6;

}  // namespace

void MotionSink::line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) {
  if (move.toolDirection) {
    m_alarms.raise({kNotDefined, "This machine turns no tool to a direction (A3, B3, C3)."});
  }
  base::Vec3 endMm = from.toMachine(targetMm);
  for (std::size_t axis = 0; axis < base::kAxisCount && from.frame.isAligned(); ++axis) {
    if (targetMm[axis] == from.programmedMm[axis]) {
      endMm.set(axis, m_endMm[axis]);  // to the last bit
    }
  }
  const bool isRapid = move.motion == nc::Motion::Rapid;
  PreparedMotion& motion = m_motion.emplace();
  motion.line = move.line;
  motion.targetMm = endMm;
  motion.targetDeg = move.turns ? move.rotaryDeg : from.rotaryDeg;
  motion.isRapid = isRapid;
  motion.feedMmPerS = isRapid ? m_options.rapidMmPerS : move.feedMmPerS;
  motion.feedDegPerS = isRapid ? kRapidDegPerS : move.feedDegPerS;
  m_stops = move.exactStop;
  m_endMm = endMm;
}

void MotionSink::arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) {
  spaceArc(from, nc::inSpace(arc), arc.endMm, move);
}

void MotionSink::spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                          const nc::Move& move) {
  const nc::Frame& frame = from.frame;
  if (!frame.keepsCircles()) {
    m_alarms.raise({kCircleError, "A circle is no circle any more in a frame scaled unevenly."});
    return;
  }
  line(from, targetMm, move);
  const base::Vec3 axis = frame.turned(arc.axis);
  m_motion->arc = ArcPath{from.toMachine(arc.centreMm),
                          ((frame.mirrors() ? -1.0 : 1.0) / base::norm(axis)) * axis, arc.sweepRad};
}

void MotionSink::spline(const nc::Position& /*from*/, const nc::Spline& /*spline*/,
                        const nc::Move& /*move*/) {
  RIVULET_ASSERT(false && "no word of this machine begins a spline");
}

void MotionSink::machineWord(nc::MachineWord kind, double value, base::LineNumber line) {
  if (kind == nc::MachineWord::Dwell && !std::isnan(value)) {
    m_dwell = PreparedDwell{line, base::fromSeconds(std::clamp(value, 0.0, 1e6))};
  }
  m_words.line = line;
  switch (kind) {
    case nc::MachineWord::Spindle:
      m_words.speedPerMin = value;
      break;
    case nc::MachineWord::Tool:
      m_words.tool = value;
      break;
    case nc::MachineWord::Edge:
      m_words.edge = value;
      break;
    case nc::MachineWord::M:
      m_words.functions.push_back(static_cast<int>(value));
      break;
    case nc::MachineWord::Dwell:
      m_words.speedPerMin.reset();  // turns of the spindle
      break;
    case nc::MachineWord::NamedTool:
      break;
  }
}

void MotionSink::toolName(std::string_view name, base::LineNumber line) {
  m_words.line = line;
  m_words.toolName = name;
}

void MotionSink::firstSpindle(char address, double value) {
  if (address == 'S') {
    m_words.speedPerMin = value;
  } else if (address == 'M') {
    m_words.functions.push_back(static_cast<int>(value));
  }
}

Prepared MotionSink::take(const nc::ModalState& state) {
  if (const std::optional<PreparedDwell> dwell = std::exchange(m_dwell, std::nullopt)) {
    return *dwell;
  }
  std::optional<PreparedMotion> motion = std::exchange(m_motion, std::nullopt);
  if (!motion) {
    return PreparedNothing{};
  }
  motion->end = m_stops ? BlockEnd::ExactStop : state.blockEnd;
  motion->rounding = state.rounding;
  motion->roundingMm =
      state.rounding == RoundingKind::Distance ? state.roundingMm : m_options.roundingMm;
  motion->dynamics = state.dynamics;
  motion->zeroMm = state.zeroMm();
  return *std::move(motion);
}

}  // namespace rivulet::machine
