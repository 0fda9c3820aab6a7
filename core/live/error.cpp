// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/error.h"

namespace rivulet::live {

std::error_code make_error_code(LiveError code) {
  static const base::NamedCategory category("live");
  return {static_cast<int>(code), category};
}

}  // namespace rivulet::live
