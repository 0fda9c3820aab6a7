// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words of a syntax tree as tokens with their values, for the executor. @threadsafety pure.
#pragma once

#include <functional>
#include <vector>

#include "nc/exec/block_words.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

using ValueOf = std::function<Expected<double>(const Expression&)>;

/// The values of tools and of names without effect are not asked for: they get no token.
/// @param words  outlives the tokens
/// @return the fault of the first word whose value cannot be computed
[[nodiscard]] Expected<std::vector<Token>> tokensOf(const std::vector<Word>& words,
                                                    const ValueOf& valueOf);

/// True if the words move nothing and change no mode of the path: spindle, tool, coolant, and what
/// says something of the program.
[[nodiscard]] bool isWithoutEffect(const Words& words);

}  // namespace rivulet::nc
