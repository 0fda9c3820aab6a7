// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/dialect.h"

namespace rivulet::gcode {

std::string_view dialectName(Dialect dialect) {
  switch (dialect) {
    case Dialect::Sinumerik:
      return "sinumerik";
    case Dialect::Iso:
      return "iso";
    case Dialect::LinuxCnc:
      return "linuxcnc";
    case Dialect::Grbl:
      return "grbl";
    case Dialect::Heidenhain:
      break;
  }
  return "heidenhain";
}

std::optional<Dialect> dialectOfName(std::string_view name) {
  for (const Dialect dialect : kDialects) {
    if (dialectName(dialect) == name) {
      return dialect;
    }
  }
  return std::nullopt;
}

}  // namespace rivulet::gcode
