// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/language.h"

#include <array>

#include "nc/syntax/parser.h"

namespace rivulet::nc {

Language rs274Language(Dialect dialect, const Notation& notation, const Semantics& comparison) {
  static constexpr std::array<std::string_view, 5> kSteering{"IF", "WHILE", "DO", "END", "GOTO"};
  return {.dialect = dialect,
          .notation = notation,
          .comparison = comparison,
          .blockParser = hashParser,
          .steering = kSteering,
          .otherStatements = {},
          .ignoresBlanksInNumbers = true,
          .spiralShare = 1e-3};
}

}  // namespace rivulet::nc
