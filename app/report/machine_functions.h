// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a machine does for M functions of other machines: asked for once, and kept in the file of
/// the machine. @threadsafety pure.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "job/plan.h"

namespace rivulet::report {

/// As `job::Profile::functions`.
using MachineFunctions = std::map<int, std::string>;

/// "163=ignore", "M163=pass", "163=M50 M51". @return error FunctionMalformed
[[nodiscard]] base::Result<MachineFunctions> functionsOf(const std::vector<std::string>& texts);
enum class FunctionError {
  Malformed = 1,  ///< no number, or nothing after '='
};
[[nodiscard]] std::error_code make_error_code(FunctionError code);

/// {"163": "", "164": "M50"}; what is no such member is passed over.
[[nodiscard]] MachineFunctions functionsOfJson(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json functionsJson(const MachineFunctions& functions);

/// For the list before a start: "M163 (line 15, 2 times): left out".
[[nodiscard]] std::string describe(const job::FunctionUse& use);
[[nodiscard]] nlohmann::ordered_json functionsJson(const std::vector<job::FunctionUse>& uses);

}  // namespace rivulet::report

template <>
struct std::is_error_code_enum<rivulet::report::FunctionError> : std::true_type {};
