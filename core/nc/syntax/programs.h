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
#include <vector>

#include "base/budget.h"
#include "nc/syntax/dialect.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/parser.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc {

/// What begins a program, where it stands at the front of a block; the later ones outrank the
/// earlier where several stand together.
enum class Heading : std::uint8_t {
  None,
  Tape,       ///< "%": begins and ends what is read from a tape or a file
  Archive,    ///< %_N_NAME_MPF
  Number,     ///< O1234, :1234
  Procedure,  ///< PROC NAME
  PlainText,  ///< BEGIN PGM NAME MM
};

/// One of the programs that stand one after another in a text.
struct TextProgram {
  std::shared_ptr<const Tree> tree;
  std::string name;            ///< "O100", "PART"; empty: none is given
  base::LineNumber firstLine;  ///< of its heading
  Heading heading = Heading::None;
  base::LineNumber firstBlock;  ///< that has words; 0: none has
  base::LineNumber lastBlock;
  bool isMain = false;        ///< its heading says so: %_N_NAME_MPF
  bool isSubprogram = false;  ///< its heading says so: %_N_NAME_SPF, PROC, O100 SUB
  bool isInside = false;      ///< O100 SUB: stands within another one
  bool ends = false;          ///< has M2 or M30
  bool returns = false;       ///< has M99, M17 or RET

  /// Called by others; alone it is no program to run.
  [[nodiscard]] bool isCalled() const { return isSubprogram || (!isMain && returns && !ends); }
};

struct Programs {
  /// In the order of the text; at least one. Of several, each has statements.
  std::vector<TextProgram> all;
  /// Those that others call: %_N_NAME_SPF, PROC NAME, O1234, O<NAME> SUB. Upper case. A name that
  /// stands for two programs leads to a fault.
  std::map<std::string, std::shared_ptr<const Tree>, std::less<>> named;
  std::size_t lines = 0;
  std::uint64_t bytes = 0;  ///< of memory, about: at least what the trees take
  bool isCut = false;       ///< the trees take more than the budget; the rest was not read

  /// Where the control begins: the first one that is not there to be called, or the first one.
  [[nodiscard]] const TextProgram& main() const;
  /// The one that the line belongs to.
  [[nodiscard]] const TextProgram& at(base::LineNumber line) const;
};

/// Never fails: see tree.h. @param text  outlives the trees @param file  its number, for the places
/// in it @param budget  of the trees, without the text
[[nodiscard]] Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file,
                                    Detail detail = Detail::Blocks,
                                    const base::Budget& budget = {});
/// What the lexer has not read yet, with the numbers of its lines; without the statements.
[[nodiscard]] Programs outlineOf(const Lexer& rest, Dialect dialect);

/// False for nearly all blocks, which begin with another word.
[[nodiscard]] inline bool mayBeHeading(const Token& front) {
  return front.kind != TokenKind::Word || front.address == 'O' || front.address == 'N';
}
[[nodiscard]] Heading headingOf(const Words& block, const Language& language);
/// True if the block has more than its number, labels and what begins a program.
[[nodiscard]] bool hasWords(const Words& block, const Language& language);
/// True if the text may hold another program behind its first heading: a search for characters,
/// quick on a text that has none.
[[nodiscard]] bool mayHoldSeveral(std::string_view text, const Language& language);

/// The first program of a SINUMERIK's text, in all detail. The tree owns the text. One that takes
/// more than the budget is a fault and nothing else. @param budget  without the text
[[nodiscard]] std::shared_ptr<const Tree> parseSinumerik(std::string text,
                                                         const base::Budget& budget = {});

/// True if a `TokenKind::Statement` jumps, decides, repeats, defines or calls. Others are messages
/// to the control: modal calls, synchronized actions.
[[nodiscard]] bool isSteering(std::string_view statement, const Language& language);

/// "O100" and "O<NAME>" at the beginning, without blanks and leading zeros; taken off.
/// @return nothing if there is neither number nor name
[[nodiscard]] std::optional<std::string> takeOName(std::string_view& text);

}  // namespace rivulet::nc
