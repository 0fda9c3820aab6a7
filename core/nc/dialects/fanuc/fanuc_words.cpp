// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/fanuc/fanuc.h"

#include "nc/dialects/sinumerik/sinumerik.h"

namespace rivulet::nc::fanuc {

DialectWords words() {
  DialectWords made{{}, {}, sinumerik::words().names};
  const GMarks mark(made.g);
  markCommon(mark);
  // Operator's Manual of the 30i, B-63944EN/03 and Programming, chapters Scaling (G50, G51),
  // Programmable mirror image (G50.1, G51.1), Coordinate system rotation (G68, G69) and Workpiece
  // coordinate system (G10 L2).
  mark(GEffect::Turn, {680});
  mark(GEffect::TurnOff, {690});
  mark(GEffect::Scale, {510});
  mark(GEffect::Mirror, {511});
  mark(GEffect::MirrorOff, {501});
  mark(GEffect::SetWorkOffset, {100});
  // Optional chamfering and corner R, the same manual.
  made.names.emplace(",R", NameEffect::Mode);
  made.names.emplace(",C", NameEffect::Mode);
  return made;
}

}  // namespace rivulet::nc::fanuc
