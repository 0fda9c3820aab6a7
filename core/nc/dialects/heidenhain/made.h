// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the control of plain text makes of a block, for those who take it. @threadsafety plain
/// values.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "nc/fault.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc::heidenhain {

/// A block for the executor, or what is wrong.
struct Made {
  Place place;
  base::LineNumber line;  ///< of the program file; of a file that is called, that of the call
  Words words;
  std::optional<Fault> fault;
  std::string ignored;  ///< a word without effect on the path
  bool isMade = false;  ///< a move of a cycle or a corner: no word of the program says it
};

/// CALL LBL without REP.
struct LabelCall {
  std::string label;
};
struct LabelEnd {};    ///< LBL 0
struct ProgramEnd {};  ///< END PGM of a called program
/// What a block does to the order of the blocks.
using Steering =
    std::variant<std::monostate, Jump, RepeatLabel, LabelCall, LabelEnd, Call, ProgramEnd>;

/// The radius of a tool of the machine, mm; by its number, or its name where it has one. Nothing:
/// it is not known. May be empty.
using ToolRadius = std::function<std::optional<double>(int number, std::string_view name)>;

}  // namespace rivulet::nc::heidenhain
