// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Opens every file that holds a trace, and remembers what the columns of other tools' files mean.
/// @threadsafety any thread, one at a time with `columns`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "gcode/program.h"
#include "trace/trace.h"

namespace rivulet::report {

/// A program is read at least this finely to be compared with a trace: chords of arcs must not add
/// to the contour error.
inline constexpr double kComparedChordMm = 0.0002;

/// Remembers what the tables of a layout mean, for this user. @param mapping  as
/// `trace::parseTableMapping` @return error NotWritable
[[nodiscard]] base::Result<void> rememberMapping(const std::string& layout,
                                                 const std::string& mapping);

/// @param columns  as `trace::parseTableMapping`; empty: as remembered for this layout, or guessed
/// @param rateHz   of a table without time; 0: not said
/// @return errors of `trace::parseTrace` and of the file
[[nodiscard]] base::Result<trace::Trace> openTrace(const std::filesystem::path& file,
                                                   const std::string& columns, double rateHz,
                                                   const base::Budget& budget = {});

/// The same of what was read elsewhere. @param name  of errors
[[nodiscard]] base::Result<trace::Trace> openTraceBytes(const std::string& bytes,
                                                        const std::string& name,
                                                        const std::string& columns, double rateHz,
                                                        const base::Budget& budget = {});

/// The program that traces are compared with. @param file  empty: none
[[nodiscard]] base::Result<std::optional<gcode::Program>> loadComparedProgram(
    const std::filesystem::path& file, gcode::LoadOptions loading);

}  // namespace rivulet::report
