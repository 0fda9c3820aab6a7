// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads a flexible program, generated or written by hand, as the control will, and says where it
/// breaks the contract of its method: on every path, without running it. What an R-parameter holds
/// is taken as unknown; a variable of the program from which R numbers are computed is followed
/// through all values it can have. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/id.h"
#include "base/result.h"
#include "templates/cells.h"

namespace rivulet::templates {

enum class LintRule {
  Syntax = 1,             ///< the control would complain about the block
  UnknownName,            ///< no word of the control, no variable, no label's jump
  MissingLabel,           ///< a jump to a label that does not exist in its direction
  RParameterOutOfRange,   ///< R number below 0 or beyond MD28050
  RParameterUnbounded,    ///< R number computed from what is not known before it runs
  WrongLayoutNumber,      ///< another number in the layout cell than the client expects
  LayoutNumberMissing,    ///< motion on a path that has not written the layout number
  HandshakeMissing,       ///< coordinates are read though the client was not waited for
  StopreMissing,          ///< values of the client are read again without a STOPRE in between
  SignalAhead,            ///< the signal is set before the axes have passed its points
  StopCheckMissing,       ///< a loop that does not ask whether the client wants a stop
  FeedMissing,            ///< motion on a path that has set no feed
  FeedNotFromClient,      ///< the feed the client writes is never used
  SlotNotRead,            ///< a coordinate of the client that no block moves to
  ClientCellOverwritten,  ///< a cell of the client written once the client may use it
  MotionFromCells,      ///< methods window and credit: motion from the cells instead of the checked
                        ///< copy
  RelativeMotion,       ///< coordinates taken as increments
  RapidMotion,          ///< G0: the feed has no effect
  NotChecked,           ///< what lies in another program is not seen from here
  NoEnd,                ///< the program runs off its last line
  FeedRaised,           ///< method credit: an override above 100 %
  CorrectionUnbounded,  ///< online correction: laid over an axis beyond the limit, or the wrong
                        ///< cell
  CorrectionIgnored,    ///< online correction: nothing lays a cell of the client over its axis
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

/// @param text        the NC program
/// @param parameters  what the client will drive it with
/// @return findings by line, or the errors of `planCells`
[[nodiscard]] base::Result<std::vector<LintFinding>> lintProgram(
    std::string_view text, const TemplateParameters& parameters);

/// The first finding that is an error; null: none.
[[nodiscard]] const LintFinding* firstError(const std::vector<LintFinding>& findings);

/// For use before a program is written to a control. @return Rejected with the first error, or the
/// errors of `planCells`
[[nodiscard]] base::Result<void> requireSound(std::string_view text,
                                              const TemplateParameters& parameters);

}  // namespace rivulet::templates

template <>
struct std::is_error_code_enum<rivulet::templates::LintError> : std::true_type {};
