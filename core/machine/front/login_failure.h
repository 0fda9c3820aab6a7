// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A login with a wrong name or password. @threadsafety a value.
#pragma once

#include <string>

#include "base/instant.h"

namespace rivulet::machine {

struct LoginFailure {
  std::string user;            ///< empty: nobody has the name; it may be a password
  std::string network;         ///< where from, see `networkOf`
  int wrong = 0;               ///< so many in a row
  base::Duration lockedFor{};  ///< 0: not locked
};

}  // namespace rivulet::machine
