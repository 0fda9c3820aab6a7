// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What sets the dialects apart, as data: readers and executor ask a `Language`, never which
/// dialect it is. What single words do is in nc/modal/vocabulary,
/// and what belongs to one dialect in its folder of nc/dialects. @threadsafety pure.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "nc/eval/evaluate.h"
#include "nc/syntax/dialect.h"
#include "nc/syntax/expression.h"

namespace rivulet::nc {

class BlockParser;
enum class Detail : std::uint8_t;
struct Tree;
struct ModalState;

/// A statement that neither steers nor moves.
struct OtherStatement {
  enum class Meaning : unsigned char { ModalCall, Ignored };
  std::string_view word;
  Meaning meaning = Meaning::Ignored;
};

/// Which program has the block N50 of M99 P50.
enum class ReturnTo : std::uint8_t { Nowhere, Caller, Itself };

/// In the unit of the program; nothing: no motion has said it yet.
using PositionOf = std::function<std::optional<double>(char axis)>;

struct Language {
  Dialect dialect = Dialect::Fanuc;
  const Notation& notation;
  const Semantics& comparison;
  std::unique_ptr<BlockParser> (*blockParser)(Tree& tree, const Language& language, Detail detail);
  /// Words that jump, decide, repeat, define or call.
  std::span<const std::string_view> steering;
  std::span<const OtherStatement> otherStatements;

  // How it is written.
  bool isKlartext = false;
  bool hasBracketComments = true;
  bool hasIndexedWords = false;          ///< M[1]=3, G[6]=2, AX[1]=5
  bool hasOWords = true;                 ///< O100 begins a program
  bool hasOStatements = false;           ///< O100 IF, O100 CALL
  bool hasCommentsBehindOWords = false;  ///< O100 (why) IF
  bool comparesNumbersAsText = false;    ///< N010 and N10 are two labels
  /// Blanks mean nothing, within a number too: X1 0 is X10. Else such a number is refused.
  bool ignoresBlanksInNumbers = false;
  bool hasRepeatedSigns = false;  ///< X--5 is X5
  /// ";" is the end of a block, so that words after it are the next one: see `semicolonOf`. Else it
  /// begins a comment.
  bool semicolonEndsBlock = false;
  bool hasPolarSigns = false;      ///< @ and ^: radius and angle about the origin
  bool hasCommaWords = false;      ///< ,R and ,C: a rounded or chamfered corner
  bool skipsWithinBlocks = false;  ///< X5 /Y6: what stands behind "/" may be left out

  // Macros and calls.
  bool hasCalculations = true;      ///< #1=5, X[1+2]
  bool assignsBehindBlock = false;  ///< #3=6 G1 X#3: X has the #3 from before the block
  bool hasArgumentSets = false;     ///< G65 with several I J K: #4 #5 #6, #7 #8 #9 and on
  bool returnsValues = false;       ///< O100 ENDSUB [1] sets #<_value>
  bool packsRounds = false;         ///< M98 P30100: three times O100
  bool keepsArguments = false;      ///< G65 L3: only the first round begins with the arguments
  ReturnTo returnTo = ReturnTo::Nowhere;
  /// What is known of a # variable of the control; null: nothing.
  std::optional<double> (*knownNumber)(int number, const ModalState& state,
                                       const PositionOf& position) = nullptr;

  // What words mean.
  bool unitIsOfMachine = false;        ///< mm or inch is the control's setting until G20 or G21
  bool feedComesBeforeUnits = false;   ///< F and S beside G20 count in the unit that held before
  bool keepsFeedOverUnits = false;     ///< else the number of F means another feed behind G20
  bool mayCountIncrements = false;     ///< X10 is 0.01 mm if the control is set so
  bool lettersMayBeVariables = false;  ///< DEF INT I: then I=5 is no centre
  bool namesAreCalls = false;          ///< PART, L123 and M17; M30 of a subprogram returns
  bool hasTurningCycles = false;       ///< G70 to G73 with P and Q show a lathe
  bool dwellInMilliseconds = false;    ///< G4 P without a point
  bool toolChangesZ = false;           ///< T: Z is somewhere else afterwards
  bool dwellsBesideMove = false;       ///< G4 takes P alone, the other words of its block move
  bool hasCannedCycles = false;        ///< of RS-274, with its clearance
  bool needsMotion = false;            ///< no motion is assumed where a program names none
  bool cycleOffEndsMotion = false;     ///< G80: axes may not move before the next G0 to G3
  bool arcsNameEnd = false;            ///< a full circle too names an axis of its plane
  bool dwellNeedsP = false;            ///< G4 alone is an error
  bool hasParameterE = false;          ///< E of M66 to M68
  bool leavesSplines = false;          ///< G5 and G5.1 are of their block, G5.2 ends with G5.3
  bool arcMayBeLine = false;           ///< G2 without a centre, by a setting of the control
  bool ignoresCentreAcross = false;    ///< of a helix, with a warning
  bool lengthComesWithTool = false;    ///< a tool change switches the tool's length on
  bool lengthIsOfTool = false;         ///< G43 without H takes that of the tool in the spindle
  bool hasTurnsInP = false;            ///< P of an arc: how often it goes round
  bool sharesOffset = false;           ///< G52 sets that of G92
  /// G10 L2: P0 is an offset of its own, G91 adds, and R turns nothing.
  bool setsListedOffsets = false;
  bool speedLimitIsD = false;      ///< G96 D: the largest speed of the spindle
  bool refusesLargeFeeds = false;  ///< others move as fast as the machine can
  bool savesFeedAndSpeed = false;  ///< a saved state: F and S, and no motion
  /// Share of the radius by which start and end of an arc may differ: a spiral.
  double spiralShare = 0.0;
};

[[nodiscard]] const Language& languageOf(Dialect dialect);

/// What the dialects that follow RS-274/NGC have in common; each changes what it reads differently.
[[nodiscard]] Language rs274Language(Dialect dialect, const Notation& notation = hashNotation(),
                                     const Semantics& comparison = hashSemantics());

}  // namespace rivulet::nc
