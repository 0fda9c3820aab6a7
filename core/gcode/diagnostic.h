// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One finding in an NC program. What Rivulet does not understand becomes a finding, never silence.
/// @threadsafety plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/id.h"
#include "nc/fault.h"

namespace rivulet::gcode {

using DiagnosticCode = nc::FaultCode;
using nc::Severity;

struct Diagnostic {
  Severity severity = Severity::Error;
  base::LineNumber line;  ///< of `file`
  int column = 1;         ///< from 1, in bytes
  DiagnosticCode code = DiagnosticCode::UnknownWord;
  std::string argument;
  std::string file = {};  ///< the called file it stands in; empty: the program itself
  /// Of a calculation or of the sequence of blocks: what is wrong with it; the argument is its own.
  std::optional<nc::FaultCode> cause = {};
  /// How often it was found, if more often than it is listed (`kRepeatsListed`); else 1.
  std::size_t count = 1;
};

/// Stable name for files and `--json`, e.g. "unknown-g-code".
[[nodiscard]] std::string_view diagnosticName(DiagnosticCode code);

/// "note", "warning", "error".
[[nodiscard]] std::string_view severityName(Severity severity);

/// The name under which the user may accept a finding that stops the load, e.g. "G41" or
/// "CYCLE83"; empty if it cannot be accepted. See `LoadOptions::accepted`.
[[nodiscard]] std::string acceptableName(const Diagnostic& diagnostic);

/// The English sentence with "%1" in place of the argument: the source of its translation, context
/// "DiagnosticTexts".
[[nodiscard]] const char* sentencePattern(const Diagnostic& diagnostic);

/// What stands for "%1" in the sentence, in English.
[[nodiscard]] std::string parameterOf(const Diagnostic& diagnostic);

/// One English sentence: what was found and what Rivulet does about it.
[[nodiscard]] std::string describe(const Diagnostic& diagnostic);

}  // namespace rivulet::gcode
