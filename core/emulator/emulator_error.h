// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Why an emulator cannot be learned, read or used.
#pragma once

#include <system_error>

namespace rivulet::emulator {

enum class EmulatorError {
  BadTimes = 1,  ///< times that do not ascend, or do not fit the positions
  BadNumbers,    ///< a number that is none (NaN), or is infinite
  NoMotion,      ///< nothing to learn from: an axis stands still
  TooShort,      ///< fewer observations than a model needs
  BadUnits,      ///< set points and positions that differ by a factor
  WrongProgram,  ///< the trace departs from the path of the program
  Diverged,      ///< no model that is stable and follows the trace
  Cancelled,     ///< the user did not want to wait
  BadFile,       ///< not an emulator's file, or one of a later version
};

[[nodiscard]] std::error_code make_error_code(EmulatorError code);

}  // namespace rivulet::emulator

template <>
struct std::is_error_code_enum<rivulet::emulator::EmulatorError> : std::true_type {};
