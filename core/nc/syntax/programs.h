// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The programs of one text. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "nc/syntax/dialect.h"
#include "nc/syntax/language.h"
#include "nc/syntax/parser.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

struct Programs {
  std::shared_ptr<const Tree> first;  ///< begins with the text
  /// Those that others call: %_N_NAME_SPF, PROC NAME, O1234, O<NAME> SUB. Upper case.
  std::map<std::string, std::shared_ptr<const Tree>, std::less<>> named;
  std::size_t lines = 0;
};

/// Never fails: see tree.h. @param text  outlives the trees @param file  its number, for the places
/// in it
[[nodiscard]] Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file,
                                    Detail detail = Detail::Blocks);
/// The first program of a SINUMERIK's text, in all detail. The tree owns the text.
[[nodiscard]] std::shared_ptr<const Tree> parseSinumerik(std::string text);

/// True if a `TokenKind::Statement` jumps, decides, repeats, defines or calls. Others are messages
/// to the control: modal calls, synchronized actions.
[[nodiscard]] bool isSteering(std::string_view statement, const Language& language);

/// "O100" and "O<NAME>" at the beginning, without blanks and leading zeros; taken off.
/// @return nothing if there is neither number nor name
[[nodiscard]] std::optional<std::string> takeOName(std::string_view& text);

}  // namespace rivulet::nc
