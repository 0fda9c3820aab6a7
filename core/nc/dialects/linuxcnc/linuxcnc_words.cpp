// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/linuxcnc/linuxcnc.h"

#include "nc/dialects/sinumerik/sinumerik.h"

namespace rivulet::nc::linuxcnc {

DialectWords words() {
  DialectWords made{{}, {}, sinumerik::words().names};
  const GMarks mark(made.g);
  markCommon(mark);
  mark(GEffect::Spline, {50, 51, 52, 53, 62});
  mark(GEffect::SuspendPosition, {922});
  mark(GEffect::RestorePosition, {923});
  mark(GEffect::SetWorkOffset, {100});
  mark(GEffect::Cycle, {740});
  mark(GEffect::Mode, {411, 421});
  mark(GEffect::None, {610});
  return made;
}

}  // namespace rivulet::nc::linuxcnc
