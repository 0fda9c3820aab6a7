// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A virtual machine that answers as the control of a survey did (`rivulet-cli survey`): what
/// cannot be read there cannot be read here, and access costs as much. @threadsafety pure but for
/// the file.
#pragma once

#include <string>
#include <system_error>
#include <vector>

#include "base/result.h"
#include "machine/config.h"

namespace rivulet::machine {

enum class SurveyError {
  NotASurvey = 1,  ///< another kind of file, or of a later version
  Damaged,         ///< a value is missing or of another type
};
[[nodiscard]] std::error_code make_error_code(SurveyError code);

struct Surveyed {
  MachineConfig config;
  bool hasFileRights = true;         ///< clients may write and select part programs
  std::vector<std::string> assumed;  ///< what the survey does not say, or cannot be answered alike
};

/// @param config  what the survey does not say: limits of the axes, cycles, the cost of writing
/// @param text    of the survey, JSON
/// @return NotASurvey, Damaged
[[nodiscard]] base::Result<Surveyed> asSurveyed(MachineConfig config, const std::string& text);

}  // namespace rivulet::machine

template <>
struct std::is_error_code_enum<rivulet::machine::SurveyError> : std::true_type {};
