// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/error.h"

#include "base/error.h"

namespace rivulet::opcua {

std::error_code make_error_code(LinkError code) {
  static const base::NamedCategory category("opcua");
  return {static_cast<int>(code), category};
}

}  // namespace rivulet::opcua
