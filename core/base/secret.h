// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Keys and passwords that are needed no longer. @threadsafety the function shares nothing.
#pragma once

#include <string>

namespace rivulet::base {

/// Overwrites the text, whatever the compiler thinks of it.
void wipe(std::string& secret);

}  // namespace rivulet::base
