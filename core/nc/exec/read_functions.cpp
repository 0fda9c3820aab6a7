// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// G and M functions of a block.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "nc/exec/block_reader.h"
#include "nc/function_number.h"
#include "nc/unknown.h"

namespace rivulet::nc {

namespace {

/// One bit each: it is asked for each G function of a program.
template <std::size_t Count>
constexpr std::uint64_t setOf(const std::array<GEffect, Count>& effects) {
  std::uint64_t bits = 0;
  for (const GEffect effect : effects) {
    bits |= std::uint64_t{1} << static_cast<unsigned>(effect);
  }
  return bits;
}

constexpr bool isOneOf(GEffect effect, std::uint64_t set) {
  return (set >> static_cast<unsigned>(effect) & 1U) != 0;
}

/// Without effect on the path by itself.
bool isNoted(GEffect effect) {
  static constexpr std::array kNoted{GEffect::CentreMode, GEffect::FeedMode, GEffect::SpindleMode,
                                     GEffect::Diameter,   GEffect::Dwell,    GEffect::Polar,
                                     GEffect::None,       GEffect::BlockEnd, GEffect::Tolerance,
                                     GEffect::ToolLength, GEffect::CycleOff};
  constexpr std::uint64_t kSet = setOf(kNoted);
  return isOneOf(effect, kSet);
}

/// The axis words of the block are its own.
bool takesBlock(GEffect effect) {
  static constexpr std::array kTaking{GEffect::Pole,
                                      GEffect::SetPosition,
                                      GEffect::ResetPosition,
                                      GEffect::LocalOffset,
                                      GEffect::SuspendPosition,
                                      GEffect::RestorePosition,
                                      GEffect::ScaleOff,
                                      GEffect::SetWorkOffset,
                                      GEffect::MacroCall,
                                      GEffect::ModalMacro,
                                      GEffect::Turn,
                                      GEffect::Scale,
                                      GEffect::Mirror,
                                      GEffect::MirrorOff,
                                      GEffect::FixedPoint,
                                      GEffect::TakesBlock};
  constexpr std::uint64_t kSet = setOf(kTaking);
  return isOneOf(effect, kSet);
}

FeedMode feedModeOf(G function) {
  switch (function) {
    case G::FeedInverseTime:
      return FeedMode::InverseTime;
    case G::FeedPerMinute:
    case G::FeedPerMinuteOrFacing:
    case G::SurfaceSpeedPerMinute:
    case G::SpindleSpeedPerMinute:
      return FeedMode::PerMinute;
    case G::FeedPerRevolution:
    case G::SurfaceSpeedPerRevolution:
    case G::SpindleSpeedPerRevolution:
      return FeedMode::PerRevolution;
    default:
      return FeedMode::Unknown;
  }
}

/// G70 and G71 of some mills are patterns of holes, where a canned cycle is in force: no unit then.
bool isPatternOfHoles(const GRow& row, const Language& language, const ModalState& state) {
  constexpr int kFirst = 700;
  constexpr int kLast = 710;
  return language.hasTurningCycles && state.motion == Motion::Unsupported && row.key >= kFirst &&
         row.key <= kLast;
}

void setState(G function, ModalState& state) {
  if (function == G::TipLength) {
    state.tipWord = "G43.4";
  } else if (function == G::RetractToStart || function == G::RetractToR) {
    state.retractsToR = function == G::RetractToR;
  } else if (function == G::CornersRound || function == G::CornersIntersect) {
    state.cornersIntersect = function == G::CornersIntersect;
  }
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
  const auto index = static_cast<std::size_t>(key);
  const GRow& row = m_state.isLathe ? m_g.latheRow(index) : m_g.row(index);
  readG(row, token, words);
  // G103 P1, G5.1 Q1: they belong to a function that changes nothing.
  words.takesParameter =
      words.takesParameter || (row.function == G::Harmless && !row.takes.empty());
  const GEffect effect = row.effect;
  words.taken |= takesBlock(effect);
  if (isNoted(effect)) {
    m_to.faults.ignoreG(key, token);
  }
}

void BlockReader::readG(const GRow& row, const Token& token, BlockWords& words) {
  switch (row.effect) {
    case GEffect::Motion:
      setModal(words.g.motion, row, token);
      break;
    case GEffect::Plane:
      setModal(words.g.plane, row, token);
      break;
    case GEffect::Units:
      if (isPatternOfHoles(row, m_language, m_state)) {
        m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
        break;
      }
      setModal(words.g.units, row, token);
      break;
    case GEffect::Distance:
      readDistance(row, token, words);
      break;
    case GEffect::CentreMode:
      m_state.centreIsAbsolute = row.function == G::CentreAbsolute;
      break;
    case GEffect::FeedMode:
      words.g.turning = row.function == G::FeedPerMinuteOrFacing ? &row : words.g.turning;
      setFeedMode(feedModeOf(row.function));
      break;
    case GEffect::SpindleMode:
      readSpindleMode(row, token, words);
      break;
    case GEffect::Diameter:
      m_state.diameter = row.function == G::Diameter;
      m_state.diameterIncrements = m_state.diameter;
      break;
    case GEffect::Polar:
      m_state.polar = row.function == G::PolarOn;
      m_state.poleMm = {};
      m_state.polarRadiusMm = kUnknown;
      m_state.polarDegrees = kUnknown;
      break;
    case GEffect::None:
      setState(row.function, m_state);
      break;
    case GEffect::Compensation:
      setModal(words.g.compensationMode, row, token);
      words.compensation = &token;
      if (row.function == G::CompensationOff) {
        m_to.faults.ignoreG(row.key, token);
      }
      break;
    case GEffect::BlockEnd:
    case GEffect::Tolerance:
      readBlockEnd(row, token, words);
      break;
    case GEffect::ToolLength:
      m_state.tipWord.clear();
      words.changesLength = true;
      m_tool.takesLength = m_tool.isNamed = true;
      m_to.words.forget(2);
      break;
    case GEffect::CycleOff:
      m_state.cycle = {};
      if (m_language.cycleOffEndsMotion) {
        m_state.motion = Motion::None;
        m_state.motionIsOff = true;
      } else if (m_state.motion == Motion::Unsupported) {
        m_state.motion = m_state.motionBeforeUnsupported;
      }
      break;
    case GEffect::WorkOffset:
      selectWorkOffset(row.key, token);
      break;
    default:
      readBlockG(row, token, words);
      break;
  }
}

/// Functions of one block, and those that are not made here.
void BlockReader::readBlockG(const GRow& row, const Token& token, BlockWords& words) {
  const GEffect effect = row.effect;
  switch (effect) {
    case GEffect::Dwell:
      words.dwell = true;
      break;
    case GEffect::Pole:
      words.rareWords().pole = &row;
      break;
    case GEffect::Spline:
      words.rareWords().spline = &row;
      break;
    case GEffect::WorkOffsetP:
      words.rareWords().workOffset = &row;
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
    case GEffect::ModalMacro:
      words.rareWords().macroCall = effect == GEffect::MacroCall;
      words.rare->modalMacro = effect == GEffect::ModalMacro;
      if (words.motionColumn != 0) {
        // Arguments stand behind the call; what stands before it would be lost.
        m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      }
      break;
    case GEffect::ModalMacroOff:
      words.rareWords().modalMacroOff = true;
      break;
    case GEffect::Cycle:
      if (m_runsCannedCycles && isCannedCycle(row.key)) {
        beginCannedCycle(row.key, words);
        break;
      }
      [[fallthrough]];
    case GEffect::MotionMode:
      readForeignMotion(effect, token, words);
      break;
    case GEffect::TakesBlock:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      m_to.words.foreignMotion();
      break;
    case GEffect::TurningCycle:
      readTurningCycle(token, words);
      break;
    default:
      m_to.faults.error(
          token, effect == GEffect::Unknown ? FaultCode::UnknownGCode : FaultCode::UnsupportedGCode,
          m_language.isKlartext && token.text.size() > 1 ? std::string(token.text)
                                                         : wordText(token));
      break;
  }
}

/// The number of F means something else afterwards.
void BlockReader::setFeedMode(FeedMode mode) {
  if (mode != m_state.feedMode) {
    m_state.feedMode = mode;
    m_state.feedIsDefault = false;
    m_state.loseFeed();
  }
}

/// Two different functions of one group in a block contradict each other.
void BlockReader::setModal(const GRow*& slot, const GRow& row, const Token& token) {
  if (slot != nullptr && slot != &row) {
    m_to.faults.error(token, FaultCode::ConflictingGCodes,
                      fmt::format("G{} {}", slot->key / 10, wordText(token)));
  }
  slot = &row;
}

/// G90 and G91 hold for the whole block, also for the words before them.
void BlockReader::readDistance(const GRow& row, const Token& token, BlockWords& words) {
  words.g.turning = row.function == G::AbsoluteOrTurning ? &row : words.g.turning;
  setModal(words.g.distance, row, token);
  m_state.relative = row.function == G::Incremental;
  words.axes.relative = m_state.relative;
}

/// G96 and G97, which on a SINUMERIK say what F means, too.
void BlockReader::readSpindleMode(const GRow& row, const Token& token, BlockWords& words) {
  setModal(words.rareWords().spindleMode, row, token);
  if (row.function != G::SurfaceSpeed && row.function != G::SpindleSpeed) {
    setFeedMode(feedModeOf(row.function));
  }
}

void BlockReader::readBlockEnd(const GRow& row, const Token& token, BlockWords& words) {
  if (row.function == G::ExactStopOnce) {
    words.exactStop = true;
  } else if (row.function == G::Accuracy) {
    words.tolerance = true;
  } else {
    setModal(words.g.blockEnd, row, token);
    words.tolerance = words.tolerance || row.effect == GEffect::Tolerance;
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

void BlockReader::beginCannedCycle(int key, BlockWords& words) {
  CannedCycle& cycle = m_state.cycle;
  if (m_state.motion != Motion::Unsupported) {
    m_state.motionBeforeUnsupported = m_state.motion;
    cycle = {};
  }
  cycle.isFirst = cycle.key != key;
  cycle.key = key;
  words.foreignMotion = true;
  m_state.motion = Motion::Unsupported;
}

/// A motion or cycle that is not made here; it stays until another motion is named.
void BlockReader::readForeignMotion(GEffect effect, const Token& token, BlockWords& words) {
  m_to.faults.error(token,
                    effect == GEffect::Cycle ? FaultCode::CycleNotRun : FaultCode::UnsupportedGCode,
                    wordText(token));
  beginForeignMotion(words);
}

void BlockReader::beginForeignMotion(BlockWords& words) {
  if (m_state.motion != Motion::Unsupported) {
    m_state.motionBeforeUnsupported = m_state.motion;
  }
  words.foreignMotion = true;
  m_state.cycle = {};
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
  const std::optional<int> number = functionNumber(token.value);
  if (!number) {
    m_to.faults.error(token, FaultCode::ValueOutOfRange);
    return;
  }
  const MRow* const row = mFunction(m_language.dialect, *number);
  words.takesParameter = words.takesParameter || (row != nullptr && !row->takes.empty());
  switch (row == nullptr ? MEffect::None : row->effect) {
    case MEffect::End:
      words.ends = true;
      return;
    case MEffect::Return:
      words.rareWords().returns = true;
      return;
    case MEffect::Call:
      words.rareWords().call98 = true;
      return;
    case MEffect::LocalCall:
      words.rareWords().call97 = true;
      return;
    case MEffect::Refused:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      return;
    case MEffect::MachineMove:
      words.machineToken = &token;
      return;
    case MEffect::Retract:
      m_to.faults.error(token, FaultCode::UnsupportedGCode, wordText(token));
      m_to.words.foreignMotion();
      return;
    case MEffect::FeedPerRevolution:
      setFeedMode(FeedMode::PerRevolution);
      return;
    case MEffect::FeedPerMinute:
      setFeedMode(FeedMode::PerMinute);
      return;
    case MEffect::TurnsShortest:
    case MEffect::TurnsAsWritten:
      m_state.turnsShortest = row->effect == MEffect::TurnsShortest;
      break;
    case MEffect::SaveState:
    case MEffect::ForgetState:
    case MEffect::RestoreState:
    case MEffect::SaveUntilReturn:
      words.rareWords().savedState = row->effect;
      words.rare->savedStateToken = &token;
      return;
    case MEffect::None:
      break;
  }
  m_to.path.machineWord(MachineWord::M, token.value, words.line);
  if (number == 6) {
    m_tool.changes = m_tool.isNamed = true;
  }
  // If the program makes the machine wait for a person or a tool, a stream does not wait.
  const bool waits = number == 0 || number == 1 || (number == 6 && m_moved);
  m_to.faults.ignoreM(row == nullptr ? Severity::Error
                      : waits        ? Severity::Warning
                                     : Severity::Note,
                      *number, token);
}

}  // namespace rivulet::nc
