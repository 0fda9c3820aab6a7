// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// GRBL and FluidNC. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::grbl {

[[nodiscard]] Language language();
[[nodiscard]] Language fluidNcLanguage();
[[nodiscard]] DialectWords words();

}  // namespace rivulet::nc::grbl
