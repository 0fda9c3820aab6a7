// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Haas: Fanuc's rules, as far as nothing else is said here. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::haas {

[[nodiscard]] Language language();
[[nodiscard]] DialectWords words();

[[nodiscard]] const Notation& macroNotation();
[[nodiscard]] const Semantics& macroSemantics();

}  // namespace rivulet::nc::haas
