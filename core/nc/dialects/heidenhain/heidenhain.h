// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Plain text (Klartext) of Heidenhain. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::heidenhain {

[[nodiscard]] Language language();
[[nodiscard]] DialectWords words();

}  // namespace rivulet::nc::heidenhain
