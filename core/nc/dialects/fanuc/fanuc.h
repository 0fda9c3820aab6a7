// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Fanuc, and controls that follow it: Mitsubishi, Mazak EIA, Mach3. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::fanuc {

[[nodiscard]] Language language();
/// What controls that follow Fanuc have in common with it.
[[nodiscard]] Language languageLike(Dialect dialect, const Notation& notation,
                                    const Semantics& semantics);
[[nodiscard]] DialectWords words();

// Custom macro B.
[[nodiscard]] const Notation& macroNotation();
[[nodiscard]] const Semantics& macroSemantics();
/// #4001 to #4003 of the modal functions, #5001 to #5003 of the position.
[[nodiscard]] std::optional<double> knownNumber(int number, const ModalState& state,
                                                const PositionOf& position);

}  // namespace rivulet::nc::fanuc
