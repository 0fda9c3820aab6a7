// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/haas/haas.h"

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::haas {

Language language() {
  Language made = fanuc::languageLike(Dialect::Haas, macroNotation(), macroSemantics());
  made.keepsArguments = true;
  made.returnTo = ReturnTo::Itself;
  return made;
}

}  // namespace rivulet::nc::haas
