// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/secret.h"

#include <cstring>

namespace rivulet::base {

void wipe(std::string& secret) {
  explicit_bzero(secret.data(), secret.size());
}

}  // namespace rivulet::base
