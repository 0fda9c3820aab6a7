// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Heidenhain's plain text, line by line, as the tokens all dialects share: `L X+10 F500` becomes
/// G1 X10 F500, `L Z+50 FMAX` G0 Z50, `CC X+0 Y+0` the pole G111 X0 Y0, `C X+5 Y+0 DR-` G2 X5 Y0
/// about that pole. What moves and has no such counterpart becomes a statement that is refused.
/// @threadsafety pure.
#pragma once

#include <string_view>
#include <vector>

#include "nc/syntax/lexer.h"

namespace rivulet::nc {

/// Appends the tokens of one line. @param continues  the line before ended with "~"; set for the
/// next one
void readKlartext(std::string_view line, bool& continues, std::vector<Token>& tokens);

}  // namespace rivulet::nc
