// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a machine does for M functions and axes of other machines, as people write it.
/// @threadsafety pure.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "job/plan.h"

namespace rivulet::job {

/// As `Profile::functions`.
using Functions = std::map<FunctionName, std::string>;

/// "M163", "163", "W". @return nothing: no such word
[[nodiscard]] std::optional<FunctionName> functionNameOf(std::string_view text);
/// "163=ignore", "M163=pass", "163=M50 M51", "W=pass". @return error FunctionMalformed
[[nodiscard]] base::Result<Functions> functionsOf(const std::vector<std::string>& texts);
/// The same, all in one text with semicolons between them; it may be empty.
[[nodiscard]] base::Result<Functions> functionsOfText(std::string_view text);
/// Inverse of `functionsOfText`.
[[nodiscard]] std::string textOf(const Functions& functions);

/// For the list before a start: "M163 (line 15, 2 times): left out".
[[nodiscard]] std::string describe(const FunctionUse& use);

}  // namespace rivulet::job
