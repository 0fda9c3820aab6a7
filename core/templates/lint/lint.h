// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads a flexible program, generated or written by hand, as the control does, and reports where
/// it breaks the contract of its method: on every path, without running it. The values of
/// R-parameters are taken as unknown; a variable from which R numbers are computed is followed
/// through all its possible values. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/id.h"
#include "base/result.h"
#include "templates/flexible_program.h"

namespace rivulet::templates {

enum class LintRule {
  Syntax = 1,             ///< the control would complain about the block
  UnknownName,            ///< not a word of the control, not a variable, not a jump to a label
  MissingLabel,           ///< a jump to a label that does not exist in its direction
  RParameterOutOfRange,   ///< R number below 0 or beyond MD28050
  RParameterUnbounded,    ///< R number computed from values not known before the run
  WrongLayoutNumber,      ///< another number in the layout cell than the client expects
  LayoutNumberMissing,    ///< motion on a path that has not written the layout number
  HandshakeMissing,       ///< coordinates are read without waiting for the client
  StopreMissing,          ///< values of the client are read again without a STOPRE in between
  SignalAhead,            ///< the signal is set before the axes have passed its points
  StopCheckMissing,       ///< a loop that does not check for a stop of the client
  FeedMissing,            ///< motion on a path that has set no feed
  FeedNotFromClient,      ///< the client's feed is never used
  SlotNotRead,            ///< a coordinate of the client that no block moves to
  ClientCellOverwritten,  ///< a cell of the client is written when the client may already use it
  MotionFromCells,      ///< methods window and credit: motion from the cells instead of the checked
                        ///< copy
  RelativeMotion,       ///< coordinates taken as increments
  RapidMotion,          ///< G0: the feed has no effect
  NotChecked,           ///< another program is called, which is not checked
  NoEnd,                ///< the program has no end after its last line
  FeedRaised,           ///< an override above that of the client, or above 200 %
  CorrectionUnbounded,  ///< online correction: applied to an axis beyond the limit, or from the
                        ///< wrong cell
  CorrectionIgnored,    ///< online correction: a cell of the client is not applied to its axis
  FeedCellIgnored,      ///< the override does not follow the feed cell in every cycle
  ClientNotWatched,     ///< the axes would move on without a sign of the client
};

/// "stopre-missing", ...
[[nodiscard]] std::string_view lintRuleName(LintRule rule);

enum class LintError { Rejected = 1 };

[[nodiscard]] std::error_code make_error_code(LintError code);

enum class LintSeverity { Warning, Error };

struct LintFinding {
  LintRule rule = LintRule::Syntax;
  LintSeverity severity = LintSeverity::Error;
  base::LineNumber line;
  std::string message;  ///< what is wrong, and what to do
};

/// @param text   the NC program
/// @param meant  the program for which the client takes it
/// @return findings by line
[[nodiscard]] std::vector<LintFinding> lintProgram(std::string_view text,
                                                   const FlexibleProgram& meant);

/// The first finding that is an error; null: none.
[[nodiscard]] const LintFinding* firstError(const std::vector<LintFinding>& findings);

/// For use before a program is written to a control. @return Rejected with the first error
[[nodiscard]] base::Result<void> requireSound(const FlexibleProgram& program);

}  // namespace rivulet::templates

template <>
struct std::is_error_code_enum<rivulet::templates::LintError> : std::true_type {};
