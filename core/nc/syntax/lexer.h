// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// NC text → blocks of tokens, one text line after another. Knows how words are written, not what
/// they mean. Tokens borrow from the text; a block's buffer is reused, so that a line costs no
/// allocation. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/id.h"
#include "nc/syntax/dialect.h"
#include "nc/syntax/expression.h"

namespace rivulet::nc {

struct Language;

enum class TokenKind : unsigned char {
  Word,         ///< a letter and a number: G1, X-2.5, X 10, X=10
  TextWord,     ///< a letter and a quoted text: T="MILL_10"
  IndexedWord,  ///< a spindle's or tool holder's word, M1=3, S2=R1; G[6]=2
  Name,         ///< two letters or more: SOFT
  NamedValue,   ///< a name and a number: CR=12.5
  Call,         ///< a name and arguments: MSG("roughing")
  Label,        ///< a jump target: START:
  Expression,   ///< a letter whose value is calculated: X=R1+2, X[#1+2], X=AC(5)
  Assignment,   ///< a name whose value is calculated, or a variable: CR=R1, R1=5, #1=[#2+1]
  Statement,    ///< a jump, loop, definition or condition: the rest of the block
  BlockSkip,    ///< "/" at the start of a block, with its level if any
  Tape,         ///< a line that starts with "%"
  Comment,      ///< in round brackets, where the control knows none but ";"
  UnexpectedCharacter,
  NumberMissing,     ///< a letter without its number
  NumberMalformed,   ///< `text` is what stands in the number's place
  CommentNotClosed,  ///< "(" without ")" on the line; the line was read up to it
  CommentNested,     ///< "(" within a comment, where the first ")" ends it at the control
};

struct Token {
  TokenKind kind = TokenKind::Word;
  char address = 0;       ///< upper case letter of a word, else 0
  bool hasPoint = false;  ///< the number was written with a decimal point
  Reference reference = Reference::Modal;
  int column = 1;  ///< from 1, in bytes
  double value = 0.0;
  std::string_view text;  ///< as written, points into the program text
  /// What it calculates, or why that cannot be read; null where the value is a constant.
  const Expected<nc::Assignment>* calculation = nullptr;

  /// The value of a calculation that can be read; null: there is none, or a list.
  [[nodiscard]] const nc::Expression* calculated() const {
    const bool isOne = calculation != nullptr && *calculation &&
                       (*calculation)->initial.kind == Initial::Kind::One;
    return isOne ? &*(*calculation)->initial.values.front() : nullptr;
  }
};

struct Words {
  std::vector<Token> tokens;  ///< empty for blank and comment lines
  std::vector<std::shared_ptr<const Expected<Assignment>>> calculations;  ///< those of the tokens
};

struct Block : Words {
  base::LineNumber line;
  int column = 1;  ///< where it begins: a line may hold several blocks
};

/// What ";" is in a text whose language ends blocks with it.
enum class Semicolon : std::uint8_t {
  EndsLine,       ///< nothing but blanks and comments in brackets follows any
  EndsBlock,      ///< words follow, all of which can be read: blocks of their own
  BeginsComment,  ///< some text that follows is none of the language's words
};
/// @threadsafety pure. O(text up to the first comment)
[[nodiscard]] Semicolon semicolonOf(std::string_view text, const Language& language);

/// The name of a `Name`, `NamedValue`, `Call` or `Label` token: its text up to the first byte that
/// cannot be part of a name.
[[nodiscard]] std::string_view tokenName(const Token& token);

/// The variable of a `Word`, `NamedValue` or `TextWord` token and the constant it gets.
[[nodiscard]] Assignment assignmentOf(const Token& token);

/// "G01" and "g 1" are G1 to the reader of a message.
[[nodiscard]] std::string wordText(const Token& token);

/// The words of a piece of a line. @param place  of its beginning
[[nodiscard]] Words readWords(std::string_view text, const Language& language, Place place);

class Lexer {
 public:
  /// @param text must outlive the lexer and the tokens; LF, CRLF and CR end a line
  /// @param file  number of the text, for the places of faults
  explicit Lexer(std::string_view text, Dialect dialect = Dialect::Fanuc, std::uint16_t file = 0);

  /// Reads the next block, which is the next line in most cases. @return false at the end of the
  /// text
  [[nodiscard]] bool next(Block& block);
  /// Steps over the next line. @return its text without the line end; nothing at the end
  [[nodiscard]] std::optional<std::string_view> nextLine();

  /// Lines read so far. A line end at the very end of the text does not start another line.
  [[nodiscard]] std::size_t lines() const { return m_line; }

 private:
  void keepRest(std::string_view rest, int column);

  const char* m_position;
  const char* m_end;
  const char* m_lineFeed;  ///< the next one at or after m_position, searched once
  const char* m_return;    ///< the next carriage return, likewise
  std::uint32_t m_line = 0;
  const Language& m_language;
  std::uint16_t m_file;
  std::string_view m_text;
  std::optional<Semicolon> m_semicolon;  ///< found out when it matters first
  std::string_view m_rest;               ///< of the line: its further blocks
  int m_restColumn = 1;
};

}  // namespace rivulet::nc
