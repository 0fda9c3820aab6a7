// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// G and M functions of a block.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nc/exec/block_reader.h"

namespace rivulet::nc {

namespace {

template <std::size_t Count>
bool isOneOf(GEffect effect, const std::array<GEffect, Count>& effects) {
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

/// Without effect on the path by itself.
bool isNoted(GEffect effect) {
  static constexpr std::array kNoted{GEffect::CentreMode, GEffect::FeedMode, GEffect::Diameter,
                                     GEffect::Dwell,      GEffect::PolarOn,  GEffect::PolarOff,
                                     GEffect::None,       GEffect::BlockEnd, GEffect::Tolerance,
                                     GEffect::ToolLength, GEffect::CycleOff};
  return isOneOf(effect, kNoted);
}

/// The axis words of the block are its own.
bool takesBlock(GEffect effect) {
  static constexpr std::array kTaking{
      GEffect::Pole,        GEffect::SetPosition,     GEffect::ResetPosition,
      GEffect::LocalOffset, GEffect::SuspendPosition, GEffect::RestorePosition,
      GEffect::ScaleOff,    GEffect::SetWorkOffset,   GEffect::MacroCall,
      GEffect::Turn,        GEffect::Scale,           GEffect::Mirror,
      GEffect::MirrorOff,   GEffect::FixedPoint,      GEffect::TakesBlock};
  return isOneOf(effect, kTaking);
}

FeedMode feedModeOf(int key) {
  struct Mode {
    int key;
    FeedMode mode;
  };
  static constexpr std::array kModes{
      Mode{930, FeedMode::InverseTime}, Mode{940, FeedMode::PerMinute},
      Mode{9610, FeedMode::PerMinute}, Mode{950, FeedMode::PerRevolution},
      Mode{9510, FeedMode::PerRevolution}};
  const auto* const found = std::find_if(kModes.begin(), kModes.end(),
                                         [key](const Mode& mode) { return mode.key == key; });
  return found == kModes.end() ? FeedMode::Unknown : found->mode;
}

}  // namespace

void BlockReader::readG(const Token& token, BlockWords& words) {
  const double scaled = token.value * 10.0;
  const int key =
      token.value >= 0.0 && token.value < 1000.0 ? static_cast<int>(std::lround(scaled)) : -1;
  if (key < 0 || std::abs(scaled - key) > 1e-6) {
    m_to.faults.error(token, FaultCode::UnknownGCode, wordText(token));
    return;
  }
  if (m_state.isLathe && key >= 700 && key <= 730) {
    readTurningCycle(token, words);
    return;
  }
  const GEffect effect = m_g[static_cast<std::size_t>(key)];
  if (m_state.isLathe && (key == 980 || key == 990)) {
    // Fanuc, operator's manual for lathe systems, G codes of system A: feed per minute and per
    // revolution.
    setFeedMode(key == 990 ? FeedMode::PerRevolution : FeedMode::PerMinute);
    return;
  }
  if (m_state.isLathe && key == 960 && effect == GEffect::None) {
    // S is m/min: the speed, and with it a feed per revolution, depends on X.
    m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
    return;
  }
  readG(effect, key, token, words);
  words.taken |= takesBlock(effect);
  if (isNoted(effect)) {
    m_to.faults.ignoreG(key, token);
  }
}

void BlockReader::readG(GEffect effect, int key, const Token& token, BlockWords& words) {
  switch (effect) {
    case GEffect::Motion:
      setModal(words.motionKey, key, token);
      break;
    case GEffect::Plane:
      setModal(words.planeKey, key, token);
      break;
    case GEffect::Units:
      setModal(words.unitsKey, key, token);
      break;
    case GEffect::Distance:
      readDistance(key, token, words);
      break;
    case GEffect::CentreMode:
      m_state.centreIsAbsolute = key == 901;
      words.centreIsAbsolute.fill(m_state.centreIsAbsolute);
      break;
    case GEffect::FeedMode:
      words.latheKey = m_state.isLathe && key == 940 ? key : words.latheKey;
      setFeedMode(feedModeOf(key));
      break;
    case GEffect::Diameter:
      m_state.diameter = key == 70;
      m_state.diameterIncrements = m_state.diameter;
      break;
    case GEffect::PolarOn:
    case GEffect::PolarOff:
      m_state.polar = effect == GEffect::PolarOn;
      break;
    case GEffect::None:
      if (key == 434) {
        m_state.tipWord = "G43.4";
      } else if (key == 4500 || key == 4510) {
        m_state.cornersIntersect = key == 4510;
      }
      break;
    case GEffect::Compensation:
      setModal(words.compensationKey, key, token);
      words.compensation = &token;
      if (key == 400) {
        m_to.faults.ignoreG(key, token);
      }
      break;
    case GEffect::BlockEnd:
    case GEffect::Tolerance:
      readBlockEnd(key, token, words);
      break;
    case GEffect::ToolLength:
      m_state.tipWord.clear();
      m_to.words.forget(2);
      words.taken |= key == 431;  // G43.1 gives the offset itself, it is not a move
      break;
    case GEffect::CycleOff:
      if (m_state.motion == Motion::Unsupported) {
        m_state.motion = m_state.motionBeforeUnsupported;
      }
      break;
    case GEffect::WorkOffset:
      selectWorkOffset(key, token);
      break;
    default:
      readBlockG(effect, key, token, words);
      break;
  }
}

/// Functions of one block, and those that are not made here.
void BlockReader::readBlockG(GEffect effect, int key, const Token& token, BlockWords& words) {
  switch (effect) {
    case GEffect::Dwell:
      words.dwell = true;
      break;
    case GEffect::Pole:
      words.rareWords().poleKey = key;
      break;
    case GEffect::Spline:
      words.rareWords().splineKey = key;
      break;
    case GEffect::WorkOffsetP:
      words.rareWords().workOffsetKey = key;
      words.rare->workOffsetToken = &token;
      break;
    case GEffect::MachineMove:
      words.machineToken = &token;
      break;
    case GEffect::FixedPoint:
      words.rareWords().fixedPoint = &token;
      break;
    case GEffect::SetPosition:
    case GEffect::ResetPosition:
    case GEffect::SuspendPosition:
    case GEffect::RestorePosition:
    case GEffect::LocalOffset:
    case GEffect::ScaleOff:
    case GEffect::SetWorkOffset:
    case GEffect::Turn:
    case GEffect::TurnOff:
    case GEffect::Scale:
    case GEffect::Mirror:
    case GEffect::MirrorOff:
      words.rareWords().offset = effect;
      break;
    case GEffect::MacroCall:
      words.rareWords().macroCall = true;
      break;
    case GEffect::MotionMode:
    case GEffect::Cycle:
      readForeignMotion(effect, token, words);
      break;
    case GEffect::TakesBlock:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      m_to.words.foreignMotion();
      break;
    default:
      m_to.faults.error(
          token, effect == GEffect::Unknown ? FaultCode::UnknownGCode : FaultCode::UnsupportedGCode,
          wordText(token));
      break;
  }
}

/// The number of F means something else afterwards.
void BlockReader::setFeedMode(FeedMode mode) {
  if (mode != m_state.feedMode) {
    m_state.feedMode = mode;
    m_state.feedIsDefault = false;
    m_state.feedMmPerS = 0.0;
    m_state.feedMmPerRev = 0.0;
    m_state.feedDegPerRev = 0.0;
  }
}

/// Two different functions of one group in a block contradict each other.
void BlockReader::setModal(int& slot, int key, const Token& token) {
  if (slot >= 0 && slot != key) {
    m_to.faults.error(token, FaultCode::ConflictingGCodes,
                      fmt::format("G{} {}", slot / 10, wordText(token)));
  }
  slot = key;
}

/// G90 and G91 hold for the whole block, also for the words before them.
void BlockReader::readDistance(int key, const Token& token, BlockWords& words) {
  words.latheKey = m_state.isLathe ? key : words.latheKey;
  setModal(words.distanceKey, key, token);
  const bool relative = key == 910;
  if (relative == m_state.relative) {
    return;
  }
  m_state.relative = relative;
  for (std::size_t axis = 0; axis < kProgrammedAxisCount; ++axis) {
    if (!words.hasOwnMode[axis]) {
      words.axes.isIncrement[axis] = words.axes.given[axis] && relative;
    }
  }
}

void BlockReader::readBlockEnd(int key, const Token& token, BlockWords& words) {
  constexpr int kExactStopOnce = 90;
  if (key == kExactStopOnce) {
    words.exactStop = true;
  } else {
    setModal(words.blockEndKey, key, token);
    words.tolerance = words.tolerance || m_g[static_cast<std::size_t>(key)] == GEffect::Tolerance;
  }
}

/// The streamed points carry no work offset: the one active at the control holds for all of them.
/// So the program's first choice is a note; another one once the tool has moved would send it to a
/// wrong place.
void BlockReader::selectWorkOffset(int key, const Token& token, double number) {
  const bool isOther = key != m_state.workOffset || number != m_state.workOffsetNumber;
  if (m_moved && isOther) {
    m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
  } else {
    m_to.faults.ignoreG(key, token);
  }
  if (isOther) {
    m_to.words.forget(std::nullopt);
  }
  m_state.workOffset = key;
  m_state.workOffsetNumber = number;
}

/// A motion or cycle that is not made here; it stays until another motion is named.
void BlockReader::readForeignMotion(GEffect effect, const Token& token, BlockWords& words) {
  m_to.faults.error(token,
                    effect == GEffect::Cycle ? FaultCode::CycleNotRun : FaultCode::UnsupportedGCode,
                    wordText(token));
  if (m_state.motion != Motion::Unsupported) {
    m_state.motionBeforeUnsupported = m_state.motion;
  }
  words.foreignMotion = true;
  m_state.motion = Motion::Unsupported;
  m_to.words.forget(std::nullopt);
}

/// G70 to G73 of a lathe: the words of the block are the cycle's, and no state is changed.
void BlockReader::readTurningCycle(const Token& token, BlockWords& words) {
  m_to.faults.error(token, FaultCode::CycleNotRun, wordText(token));
  words.taken = true;
  m_to.words.foreignMotion();
}

void BlockReader::readM(const Token& token, BlockWords& words) {
  const double value = token.value;
  if (!(value >= 0.0 && value < 10000.0) || value != std::floor(value)) {
    m_to.faults.error(token, FaultCode::ValueOutOfRange);
    return;
  }
  const auto number = static_cast<int>(value);
  switch (mEffect(m_language.dialect, number)) {
    case MEffect::End:
      words.ends = true;
      return;
    case MEffect::Return:
      words.rareWords().returns = true;
      return;
    case MEffect::Call:
      words.rareWords().call98 = true;
      return;
    case MEffect::Refused:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      return;
    case MEffect::CycleCall:
      m_to.faults.error(token, FaultCode::CycleNotRun, "CYCL CALL");
      return;
    case MEffect::MachineMove:
      words.machineToken = &token;
      return;
    case MEffect::Retract:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      m_to.words.foreignMotion();
      return;
    case MEffect::None:
      break;
  }
  m_to.path.machineWord(MachineWord::M, value, words.line);
  // If the program makes the machine wait for a person or a tool, a stream does not wait.
  const bool waits = number == 0 || number == 1 || (number == 6 && m_moved);
  m_to.faults.ignoreM(waits ? Severity::Warning : Severity::Note, number, token);
}

}  // namespace rivulet::nc
