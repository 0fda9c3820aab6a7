// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// LinuxCNC: RS-274/NGC with O words. @threadsafety pure.
#pragma once

#include "nc/dialects/dialect_words.h"
#include "nc/syntax/language.h"

namespace rivulet::nc::linuxcnc {

[[nodiscard]] Language language();
[[nodiscard]] DialectWords words();
[[nodiscard]] std::optional<double> knownNumber(int number, const ModalState& state,
                                                const PositionOf& position);

}  // namespace rivulet::nc::linuxcnc
