// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/error.h"

#include "base/error.h"

namespace rivulet::gcode {

std::error_code make_error_code(GcodeError code) {
  static const base::NamedCategory category("gcode");
  return {static_cast<int>(code), category};
}

}  // namespace rivulet::gcode
