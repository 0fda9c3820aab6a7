// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Forms of access as text for people. @threadsafety pure.
#pragma once

#include <optional>
#include <string>

#include "streaming/control/access_forms.h"

namespace rivulet::cli {

/// "array-count (proved; also array-range, list, single)", and why others do not work.
/// @param forms  the forms that were tried; nothing: none were
[[nodiscard]] std::string accessText(opcua::Grouping used,
                                     const std::optional<streaming::AccessForms>& forms);

}  // namespace rivulet::cli
