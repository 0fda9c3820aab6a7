// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the ring buffers B1 to B5 between the six tasks hold, one type each. All are plain bytes,
/// so that a ring may lie in memory shared by processes. Machine coordinates. @threadsafety plain
/// values.
/// @source [P3] Fig. 4 and 5
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/axes.h"
#include "base/id.h"
#include "base/instant.h"
#include "base/vec3.h"
#include "machine/path_place.h"
#include "machine/prepared.h"
#include "machine/rough_motion.h"

namespace rivulet::pipeline {

/// A text of bounded length; what is longer is cut.
template <std::size_t Size>
struct BoundedText {
  std::uint16_t bytes = 0;
  std::array<char, Size> text{};

  BoundedText() = default;
  explicit BoundedText(std::string_view from)
      : bytes(static_cast<std::uint16_t>(std::min(from.size(), Size))) {
    std::copy_n(from.begin(), bytes, text.begin());
  }
  [[nodiscard]] std::string_view view() const { return {text.data(), bytes}; }
};

/// B1: a line of the program, or a part of a long one.
struct ProgramText {
  static constexpr std::string_view kLayout = "B1 text 1";
  static constexpr std::size_t kBytes = 244;
  BoundedText<kBytes> text{};  ///< with the line's end
  bool endsProgram = false;    ///< nothing follows; the text is empty
};

enum class BlockKind : std::uint8_t {
  Motion,
  Dwell,
  Action,  ///< an auxiliary function, or several one after another
  Stop,    ///< STOPRE: what follows is not planned before the axes stand
  End,
  Alarm,  ///< the program ends here, after everything before has been executed
};

struct AlarmText {
  int number = 0;  ///< as on the control; 0: one of the pipeline
  BoundedText<200> text{};
};

/// An auxiliary function.
struct Auxiliary {
  machine::MachineAction::Kind kind = machine::MachineAction::Kind::Stop;
  double value = 0.0;
  int tool = 0;
  BoundedText<30> toolName{};
  base::LineNumber line{};
};

/// What a block has that is no motion.
struct BlockHead {
  BlockKind kind = BlockKind::End;
  base::LineNumber line{};
  base::Duration dwell{};
  bool hasAuxiliary = false;
  Auxiliary auxiliary{};
  bool continues = false;  ///< the next one belongs to the same block
  base::Vec3 zeroMm;       ///< of the workpiece frame from here on
  AlarmText alarm{};
};

/// B2: a block as the interpreter has prepared it.
struct NcBlock {
  static constexpr std::string_view kLayout = "B2 block 1";
  BlockHead head{};
  machine::PreparedMotion motion{};
};

/// B3: a block with its geometry.
struct RoughBlock {
  static constexpr std::string_view kLayout = "B3 rough block 1";
  BlockHead head{};
  machine::RoughMotion motion{};
};

enum class CycleKind : std::uint8_t { Motion, End, Alarm };

inline constexpr std::size_t kAuxiliariesPerCycle = 4;

/// What one interpolation cycle has besides its place.
struct CycleHead {
  std::uint64_t cycle = 0;  ///< from 1, without a gap
  CycleKind kind = CycleKind::Motion;
  base::LineNumber line{};
  double speedMmPerS = 0.0;  ///< of the path; deg/s in a block that only turns
  base::Vec3 zeroMm;         ///< of the workpiece frame
  std::uint8_t auxiliaryCount = 0;
  /// Begin in this cycle, in their order; goes to the execution system past all other tasks.
  std::array<Auxiliary, kAuxiliariesPerCycle> auxiliaries{};
  AlarmText alarm{};
};

/// B4: where on the path the axes are at the end of an interpolation cycle.
struct CyclePlace {
  static constexpr std::string_view kLayout = "B4 place 1";
  CycleHead head{};
  machine::PathPlace place{};
};

/// B5: where the axes are to be at the end of an interpolation cycle.
struct SetPoint {
  static constexpr std::string_view kLayout = "B5 set point 1";
  CycleHead head{};
  base::Vec3 positionMm;
  base::RotaryDeg positionDeg{};
};

}  // namespace rivulet::pipeline
