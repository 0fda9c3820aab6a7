// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/grbl/grbl.h"

#include "nc/dialects/sinumerik/sinumerik.h"

namespace rivulet::nc::grbl {

DialectWords words() {
  DialectWords made{{}, {}, sinumerik::words().names};
  markCommon(GMarks(made.g));
  return made;
}

}  // namespace rivulet::nc::grbl
