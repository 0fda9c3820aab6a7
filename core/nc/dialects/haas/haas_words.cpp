// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/haas/haas.h"

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::haas {

DialectWords words() {
  return fanuc::words();
}

}  // namespace rivulet::nc::haas
