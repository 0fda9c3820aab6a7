// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/connection.h"

#include "base/error.h"

namespace rivulet::opcua {

std::error_code make_error_code(LinkKindError code) {
  static const base::NamedCategory category("opcua library");
  return {static_cast<int>(code), category};
}

}  // namespace rivulet::opcua
