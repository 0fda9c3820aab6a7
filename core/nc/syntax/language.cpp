// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/language.h"

#include <array>

#include "nc/syntax/parser.h"

namespace rivulet::nc {

Language rs274Language(Dialect dialect, const Notation& notation, const Semantics& comparison) {
  return {.dialect = dialect,
          .notation = notation,
          .comparison = comparison,
          .blockParser = hashParser,
          .steering = {},
          .otherStatements = {},
          .ignoresBlanksInNumbers = true,
          .spiralShare = 1e-3};
}

}  // namespace rivulet::nc
