// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Blocks → trajectory, findings, figures and facts: keeps the modal state of the control (G
/// functions, feed, position, frame) from block to block. @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gcode/program.h"

namespace rivulet::gcode {

/// Largest coordinate, centre offset or radius accepted, mm: a kilometre is no machine tool.
inline constexpr double kCoordinateMmMax = 1.0e6;

struct Interpretation {
  Trajectory trajectory;
  std::vector<Diagnostic> diagnostics;
  Statistics statistics;
  ProgramFacts facts;
  Dialect dialect = Dialect::Iso;
  std::string dialectEvidence;
  std::size_t blocks = 0;  ///< lines that hold more than a number and a comment
  bool cancelled = false;  ///< `LoadOptions::progress` said so: the rest is not there
};

/// @param options chordToleranceMm > 0  @param fileName  its ending helps to find the dialect
/// @threadsafety pure; O(text + points), and what the program repeats.
[[nodiscard]] Interpretation interpret(std::string_view text, const LoadOptions& options,
                                       std::string_view fileName = {});

}  // namespace rivulet::gcode
