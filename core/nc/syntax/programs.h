// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The programs of one text, for a reader that takes the words of blocks from the lexer: a block of
/// words is a `Words` statement that holds none, and its line says where to read them. What steers
/// is parsed. @threadsafety pure.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nc/syntax/dialect.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

struct Programs {
  std::shared_ptr<const Tree> first;  ///< begins with the text
  /// Those that others call: %_N_NAME_SPF, PROC NAME, O1234, O<NAME> SUB. Upper case.
  std::map<std::string, std::shared_ptr<const Tree>, std::less<>> named;
  std::vector<Lexer::Position> lines;  ///< where each line begins
};

/// @param file  number of the text, for the places in it
[[nodiscard]] Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file);

/// True if a `TokenKind::Statement` jumps, decides, repeats, defines or calls. Others are messages
/// to the control: modal calls, synchronized actions.
[[nodiscard]] bool isSteering(std::string_view statement, const Language& language);

/// "O100" and "O<NAME>" at the beginning, without blanks and leading zeros; taken off.
/// @return nothing if there is neither number nor name
[[nodiscard]] std::optional<std::string> takeOName(std::string_view& text);

}  // namespace rivulet::nc
