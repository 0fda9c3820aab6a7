// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Text for HTML and SVG. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>

namespace rivulet::report {

/// `text` as it stands between tags or in the value of an attribute.
[[nodiscard]] std::string markupText(std::string_view text);

}  // namespace rivulet::report
