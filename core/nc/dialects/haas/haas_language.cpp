// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/haas/haas.h"

#include <array>
#include <string_view>

#include "nc/dialects/fanuc/fanuc.h"

namespace rivulet::nc::haas {

Language language() {
  // Mill Operator's Manual, chapter "Macros (Optional)": WH is WHILE.
  static constexpr std::array<std::string_view, 6> kSteering{"IF", "WHILE", "WH",
                                                             "DO", "END",   "GOTO"};
  Language made = fanuc::languageLike(Dialect::Haas, macroNotation(), macroSemantics());
  made.steering = kSteering;
  made.keepsArguments = true;
  made.returnTo = ReturnTo::Itself;
  return made;
}

}  // namespace rivulet::nc::haas
