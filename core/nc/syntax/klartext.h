// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Heidenhain's plain text, block by block: what is a block, its number, and its label. What its
/// words mean is for nc/dialects/heidenhain. @threadsafety pure.
#pragma once

#include <string_view>
#include <vector>

#include "nc/syntax/lexer.h"

namespace rivulet::nc {

/// True if the next line belongs to the block: this one ends with "~", in its comment too.
[[nodiscard]] bool klartextContinues(std::string_view line);

/// Appends the tokens of one block of one or more lines: a skip mark, a label, or a statement that
/// is the whole rest of the block with its comments.
void readKlartext(std::string_view block, std::vector<Token>& tokens);

}  // namespace rivulet::nc
