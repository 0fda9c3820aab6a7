// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Failures in the language of the operator: what happened and what to do. Codes without their own
/// sentence show the English message of the error.
/// @threadsafety GUI thread.
#pragma once

#include <QString>
#include <string_view>
#include <system_error>

#include "base/error.h"

namespace rivulet::widgets {

/// The sentence for a code alone; empty if there is none.
[[nodiscard]] QString errorCodeText(const std::error_code& code);

/// The code of a kind (the name of its category) and value, as files keep it; clear if it is none.
[[nodiscard]] std::error_code errorCodeOf(std::string_view kind, int value);

/// Context and sentence, as the message area shows them.
[[nodiscard]] QString errorText(const base::Error& error);

}  // namespace rivulet::widgets
