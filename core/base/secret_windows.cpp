// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/secret.h"

#include <windows.h>

namespace rivulet::base {

void wipe(std::string& secret) {
  SecureZeroMemory(secret.data(), secret.size());
}

}  // namespace rivulet::base
