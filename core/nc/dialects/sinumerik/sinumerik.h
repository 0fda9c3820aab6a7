// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// SINUMERIK 840D, 828D, ONE. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::sinumerik {

[[nodiscard]] Language language();
[[nodiscard]] DialectWords words();

}  // namespace rivulet::nc::sinumerik
