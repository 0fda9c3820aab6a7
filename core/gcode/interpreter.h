// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A program from its first block to its end → trajectory, findings, figures and facts.
/// @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gcode/program.h"

namespace rivulet::gcode {

class BlockObserver;

struct Interpretation {
  Trajectory trajectory;
  std::vector<Diagnostic> diagnostics;
  Statistics statistics;
  ProgramFacts facts;
  Dialect dialect = Dialect::Fanuc;
  std::string dialectEvidence;
  std::vector<Dialect> otherDialects;  ///< what the text may be as well
  std::size_t blocks = 0;              ///< lines that hold more than a number and a comment
  std::optional<base::Error> refused;  ///< BudgetError::Exceeded: the rest is not there
  bool cancelled = false;              ///< `LoadOptions::progress` said so: the rest is not there
};

/// @param options chordToleranceMm > 0  @param fileName  its ending helps to find the dialect
/// @param observer  follows the blocks; null: nobody does
/// @threadsafety pure; O(text + points), and what the program repeats.
[[nodiscard]] Interpretation interpret(std::string_view text, const LoadOptions& options,
                                       std::string_view fileName = {},
                                       BlockObserver* observer = nullptr);

}  // namespace rivulet::gcode
