// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Failures of loading an NC program as a whole. Findings inside it are `Diagnostic`s.
#pragma once

#include <system_error>

namespace rivulet::gcode {

enum class GcodeError {
  FileUnreadable = 1,  ///< missing, a folder, or no permission
  EmptyProgram,        ///< no block at all
  NoMotion,            ///< blocks, but none moves an axis
  NotUnderstood,       ///< a finding of severity Error: the path cannot be trusted
  Cancelled,           ///< `LoadOptions::progress` said so
  Ambiguous,           ///< the text leaves open what it means: an option says it
  BadTolerance,        ///< the moves of the program cannot be merged within it
};

[[nodiscard]] std::error_code make_error_code(GcodeError code);

}  // namespace rivulet::gcode

template <>
struct std::is_error_code_enum<rivulet::gcode::GcodeError> : std::true_type {};
