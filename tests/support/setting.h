// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How much a test tries, from the environment: scripts/soak asks for more than CI does.
/// @threadsafety as the environment: nobody changes it meanwhile.
#pragma once

#include <QtGlobal>

namespace rivulet::tests {

/// The whole number of a variable such as RIVULET_SCENARIOS; `otherwise` if it is not set.
[[nodiscard]] inline int setting(const char* name, int otherwise) {
  return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

}  // namespace rivulet::tests
