// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The text of a SINUMERIK program as a tree. @threadsafety pure.
#pragma once

#include <cstdint>
#include <string_view>

#include "nc/syntax/tree.h"

namespace rivulet::nc {

/// Never fails: see tree.h. @param file  number of the text, for the places in it
[[nodiscard]] Tree parseSinumerik(std::string_view text, std::uint16_t file = 0);

}  // namespace rivulet::nc
