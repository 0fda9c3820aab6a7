// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// G and M functions of a block.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nc/exec/block_reader.h"

namespace rivulet::nc {

/// What a G function does when it is read. `isNoted`: without effect on the path by itself;
/// `takesBlock`: the axis words of the block are its own.
struct BlockReader::GRow {
  GEffect effect;
  void (BlockReader::*read)(int key, const Token& token, BlockWords& words) = nullptr;
  bool isNoted = false;
  bool takesBlock = false;
};

const BlockReader::GRow& BlockReader::rowOf(GEffect effect) {
  static constexpr std::array kRows{
      GRow{GEffect::Unknown, &BlockReader::refuseG},
      GRow{GEffect::Motion, &BlockReader::readMotion},
      GRow{GEffect::Distance, &BlockReader::readDistance},
      GRow{GEffect::CentreMode, &BlockReader::readCentreMode, true},
      GRow{GEffect::Plane, &BlockReader::readPlane},
      GRow{GEffect::Units, &BlockReader::readUnits},
      GRow{GEffect::FeedMode, &BlockReader::readFeedMode, true},
      GRow{GEffect::Diameter, &BlockReader::readDiameter, true},
      GRow{GEffect::Dwell, &BlockReader::readDwell, true},
      GRow{GEffect::Pole, &BlockReader::readPole, false, true},
      GRow{GEffect::PolarOn, &BlockReader::readPolar, true},
      GRow{GEffect::PolarOff, &BlockReader::readPolar, true},
      GRow{GEffect::Spline, &BlockReader::readSpline},
      GRow{GEffect::None, &BlockReader::readNone, true},
      GRow{GEffect::BlockEnd, &BlockReader::readBlockEnd, true},
      GRow{GEffect::Tolerance, &BlockReader::readTolerance, true},
      GRow{GEffect::ToolLength, &BlockReader::readToolLength, true},
      GRow{GEffect::CycleOff, &BlockReader::readCycleOff, true},
      GRow{GEffect::WorkOffset, &BlockReader::readWorkOffset},
      GRow{GEffect::WorkOffsetP, &BlockReader::readWorkOffsetP},
      GRow{GEffect::MachineMove, &BlockReader::readMachineMove},
      GRow{GEffect::SetPosition, &BlockReader::readOffset, false, true},
      GRow{GEffect::ResetPosition, &BlockReader::readOffset, false, true},
      GRow{GEffect::LocalOffset, &BlockReader::readOffset, false, true},
      GRow{GEffect::MacroCall, &BlockReader::readMacroCall, false, true},
      GRow{GEffect::Mode, &BlockReader::refuseG},
      GRow{GEffect::MotionMode, &BlockReader::readForeignMotion},
      GRow{GEffect::Cycle, &BlockReader::readForeignMotion},
      GRow{GEffect::TakesBlock, &BlockReader::readForeignBlock, false, true},
  };
  static_assert(
      [] {
        for (std::size_t i = 0; i < kRows.size(); ++i) {
          if (static_cast<std::size_t>(kRows[i].effect) != i) {
            return false;
          }
        }
        return true;
      }(),
      "a row is found by its effect");
  return kRows[static_cast<std::size_t>(effect)];
}

void BlockReader::readG(const Token& token, BlockWords& words) {
  const double scaled = token.value * 10.0;
  const int key =
      token.value >= 0.0 && token.value < 1000.0 ? static_cast<int>(std::lround(scaled)) : -1;
  if (key < 0 || std::abs(scaled - key) > 1e-6) {
    m_sink.error(token, FaultCode::UnknownGCode, wordText(token));
    return;
  }
  if (m_state.isLathe && key >= 700 && key <= 730) {
    readTurningCycle(token, words);
    return;
  }
  const GRow& row = rowOf(effectOf(key));
  (this->*row.read)(key, token, words);
  words.taken |= row.takesBlock;
  if (row.isNoted) {
    m_sink.ignoreG(key, token);
  }
}

void BlockReader::refuseG(int key, const Token& token, BlockWords& /*words*/) {
  m_sink.error(
      token,
      effectOf(key) == GEffect::Unknown ? FaultCode::UnknownGCode : FaultCode::UnsupportedGCode,
      wordText(token));
}

/// Two different functions of one group in a block contradict each other.
void BlockReader::setModal(int& slot, int key, const Token& token) {
  if (slot >= 0 && slot != key) {
    m_sink.error(token, FaultCode::ConflictingGCodes,
                 fmt::format("G{} {}", slot / 10, wordText(token)));
  }
  slot = key;
}

void BlockReader::readMotion(int key, const Token& token, BlockWords& words) {
  setModal(words.motionKey, key, token);
}

void BlockReader::readPlane(int key, const Token& token, BlockWords& words) {
  setModal(words.planeKey, key, token);
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

void BlockReader::readCentreMode(int key, const Token& /*token*/, BlockWords& words) {
  m_state.centreIsAbsolute = key == 901;
  words.centreIsAbsolute.fill(m_state.centreIsAbsolute);
}

void BlockReader::readUnits(int key, const Token& token, BlockWords& words) {
  setModal(words.unitsKey, key, token);
}

void BlockReader::readFeedMode(int key, const Token& /*token*/, BlockWords& words) {
  struct Mode {
    int key;
    FeedMode mode;
  };
  static constexpr std::array kModes{
      Mode{930, FeedMode::InverseTime}, Mode{940, FeedMode::PerMinute},
      Mode{9610, FeedMode::PerMinute}, Mode{950, FeedMode::PerRevolution},
      Mode{9510, FeedMode::PerRevolution}};
  words.latheKey = m_state.isLathe && key == 940 ? key : words.latheKey;
  const auto* const found = std::find_if(kModes.begin(), kModes.end(),
                                         [key](const Mode& mode) { return mode.key == key; });
  m_state.feedMode = found == kModes.end() ? FeedMode::Unknown : found->mode;
  m_state.feedMmPerS = 0.0;
}

void BlockReader::readDiameter(int key, const Token& /*token*/, BlockWords& /*words*/) {
  m_state.diameter = key == 70;
  m_state.diameterIncrements = m_state.diameter;
}

void BlockReader::readDwell(int /*key*/, const Token& /*token*/, BlockWords& words) {
  words.dwell = true;
}

void BlockReader::readPole(int key, const Token& /*token*/, BlockWords& words) {
  words.rareWords().pole = true;
  words.rare->poleKey = key;
}

void BlockReader::readPolar(int key, const Token& /*token*/, BlockWords& /*words*/) {
  m_state.polar = effectOf(key) == GEffect::PolarOn;
}

void BlockReader::readSpline(int key, const Token& /*token*/, BlockWords& words) {
  words.rareWords().splineKey = key;
}

void BlockReader::readNone(int key, const Token& /*token*/, BlockWords& /*words*/) {
  if (key == 434) {
    m_state.tipWord = "G43.4";
  }
}

void BlockReader::readBlockEnd(int key, const Token& token, BlockWords& words) {
  constexpr int kExactStopOnce = 90;
  if (key == kExactStopOnce) {
    words.exactStop = true;
  } else {
    setModal(words.blockEndKey, key, token);
  }
}

void BlockReader::readTolerance(int key, const Token& token, BlockWords& words) {
  words.tolerance = true;
  readBlockEnd(key, token, words);
}

void BlockReader::readToolLength(int key, const Token& /*token*/, BlockWords& words) {
  m_state.tipWord.clear();
  m_sink.forgetPosition(2);
  words.taken |= key == 431;  // G43.1 gives the offset itself, it is not a move
}

void BlockReader::readCycleOff(int /*key*/, const Token& /*token*/, BlockWords& /*words*/) {
  if (m_state.motion == Motion::Unsupported) {
    m_state.motion = m_state.motionBeforeUnsupported;
  }
}

void BlockReader::readWorkOffset(int key, const Token& token, BlockWords& /*words*/) {
  selectWorkOffset(key, token);
}

/// The streamed points carry no work offset: the one active at the control holds for all of
/// them. So the program's first choice is a note; another one once the tool has moved would
/// send it to a wrong place.
void BlockReader::selectWorkOffset(int key, const Token& token, double number) {
  const bool isOther = key != m_state.workOffset || number != m_state.workOffsetNumber;
  if (m_moved && isOther) {
    m_sink.error(token, FaultCode::UnsupportedGCode, wordText(token));
  } else {
    m_sink.ignoreG(key, token);
  }
  if (isOther) {
    m_sink.forgetPosition();
  }
  m_state.workOffset = key;
  m_state.workOffsetNumber = number;
}

void BlockReader::readWorkOffsetP(int key, const Token& token, BlockWords& words) {
  words.rareWords().workOffsetKey = key;
  words.rare->workOffsetToken = &token;
}

void BlockReader::readMachineMove(int /*key*/, const Token& token, BlockWords& words) {
  words.machineToken = &token;
}

void BlockReader::readOffset(int key, const Token& /*token*/, BlockWords& words) {
  RareWords& rare = words.rareWords();
  rare.setsPosition |= effectOf(key) == GEffect::SetPosition;
  rare.resetsPosition |= effectOf(key) == GEffect::ResetPosition;
  rare.localOffset |= effectOf(key) == GEffect::LocalOffset;
}

void BlockReader::readMacroCall(int /*key*/, const Token& /*token*/, BlockWords& words) {
  words.rareWords().macroCall = true;
}

/// A motion or cycle that is not made here; it stays until another motion is named.
void BlockReader::readForeignMotion(int key, const Token& token, BlockWords& words) {
  m_sink.error(
      token, effectOf(key) == GEffect::Cycle ? FaultCode::CycleNotRun : FaultCode::UnsupportedGCode,
      wordText(token));
  if (m_state.motion != Motion::Unsupported) {
    m_state.motionBeforeUnsupported = m_state.motion;
  }
  words.foreignMotion = true;
  m_state.motion = Motion::Unsupported;
  m_sink.forgetPosition();
}

void BlockReader::readForeignBlock(int key, const Token& token, BlockWords& words) {
  refuseG(key, token, words);
  m_sink.otherMotion();
}

/// G70 to G73 of a lathe: the words of the block are the cycle's, and no state is changed.
void BlockReader::readTurningCycle(const Token& token, BlockWords& words) {
  m_sink.error(token, FaultCode::CycleNotRun, wordText(token));
  words.taken = true;
  m_sink.otherMotion();
}

void BlockReader::readM(const Token& token, BlockWords& words) {
  const double value = token.value;
  if (!(value >= 0.0 && value < 10000.0) || value != std::floor(value)) {
    m_sink.error(token, FaultCode::ValueOutOfRange);
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
      m_sink.error(token, FaultCode::UnsupportedGCode, wordText(token));
      return;
    case MEffect::CycleCall:
      m_sink.error(token, FaultCode::CycleNotRun, "CYCL CALL");
      return;
    case MEffect::MachineMove:
      words.machineToken = &token;
      return;
    case MEffect::Retract:
      m_sink.error(token, FaultCode::UnsupportedGCode, wordText(token));
      m_sink.otherMotion();
      return;
    case MEffect::None:
      break;
  }
  m_sink.machineWord(MachineWord::M, value);
  // If the program makes the machine wait for a person or a tool, a stream does not wait.
  const bool waits = number == 0 || number == 1 || (number == 6 && m_moved);
  m_sink.ignoreM(waits ? Severity::Warning : Severity::Note, number, token);
}

}  // namespace rivulet::nc
