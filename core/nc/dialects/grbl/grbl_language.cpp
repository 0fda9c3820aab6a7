// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

namespace rivulet::nc::grbl {

Language language() {
  return rs274Language(Dialect::Grbl);
}

}  // namespace rivulet::nc::grbl
