// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Moments of the calendar as values. The functions read no clock. @threadsafety pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rivulet::base {

/// UTC, milliseconds since 1970.
using UtcMs = std::int64_t;

/// ISO 8601: "2026-11-22T08:30:05.123Z".
[[nodiscard]] std::string utcText(UtcMs at);
/// Inverse of `utcText`, which may lack the milliseconds; nothing if the text has another form.
[[nodiscard]] std::optional<UtcMs> utcOfText(std::string_view text);

}  // namespace rivulet::base
