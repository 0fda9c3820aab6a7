// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// NC text → blocks of tokens, one text line after another. Knows how words are written, not what
/// they mean. Tokens borrow from the text; a block's buffer is reused, so that a line costs no
/// allocation. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/id.h"
#include "nc/syntax/dialect.h"

namespace rivulet::nc {

struct Language;

enum class TokenKind : unsigned char {
  Word,         ///< a letter and a number: G1, X-2.5, X 10, X=10
  TextWord,     ///< a letter and a quoted text: T="MILL_10"
  IndexedWord,  ///< a spindle's or tool holder's word: M1=3, S2=500
  Name,         ///< two letters or more: SOFT
  NamedValue,   ///< a name and a number: CR=12.5
  Call,         ///< a name and arguments: MSG("roughing")
  Label,        ///< a jump target: START:
  Expression,   ///< a word whose value is calculated: X=R1+2, X[#1+2], X=AC(5); `text` is all of it
  Assignment,   ///< a variable is set: R1=5, #1=[#2+1], DEPTH=-3; `text` is all of it
  Statement,    ///< a jump, loop, definition or condition: the rest of the block
  BlockSkip,    ///< "/" at the start of a block, with its level if any
  Tape,         ///< a line that starts with "%"
  UnexpectedCharacter,
  NumberMissing,     ///< a letter without its number
  NumberMalformed,   ///< `text` is what stands in the number's place
  CommentNotClosed,  ///< "(" without ")" on the line; the line was read up to it
};

/// What a coordinate counts from: as G90 and G91 say, or AC() and IC().
enum class Reference : std::uint8_t { Modal, Absolute, Incremental };

struct Token {
  TokenKind kind = TokenKind::Word;
  char address = 0;       ///< upper case letter of a word, else 0
  bool hasPoint = false;  ///< the number was written with a decimal point
  Reference reference = Reference::Modal;
  int column = 1;  ///< from 1, in bytes
  double value = 0.0;
  std::string_view text;  ///< as written, points into the program text
};

struct Block {
  base::LineNumber line;
  std::vector<Token> tokens;  ///< empty for blank and comment lines
};

/// The name of a `Name`, `NamedValue`, `Call` or `Label` token: its text up to the first byte that
/// cannot be part of a name.
[[nodiscard]] std::string_view tokenName(const Token& token);

/// "G01" and "g 1" are G1 to the reader of a message.
[[nodiscard]] std::string wordText(const Token& token);

class Lexer {
 public:
  /// @param text must outlive the lexer and the tokens; LF, CRLF and CR end a line
  explicit Lexer(std::string_view text, Dialect dialect = Dialect::Iso);

  /// Reads the next line into `block`. @return false at the end of the text
  [[nodiscard]] bool next(Block& block);
  /// Steps over the next line. @return its text without the line end; nothing at the end
  [[nodiscard]] std::optional<std::string_view> nextLine();

  /// A position between two lines of the text.
  struct Position {
    const char* at = nullptr;
    std::uint32_t line = 0;  ///< lines before it
  };
  /// Where the next line begins.
  [[nodiscard]] Position position() const { return {m_position, m_line}; }
  /// @param position  of this text
  void seek(Position position);

  /// Lines read so far. A line end at the very end of the text does not start another line.
  [[nodiscard]] std::size_t lines() const { return m_line; }

 private:
  const char* m_position;
  const char* m_end;
  const char* m_lineFeed;  ///< the next one at or after m_position, searched once
  std::uint32_t m_line = 0;
  const Language& m_language;
  bool m_continues = false;  ///< Heidenhain: the next line belongs to this one
};

}  // namespace rivulet::nc
