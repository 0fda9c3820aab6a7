// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/heidenhain.h"

#include "nc/syntax/parser.h"

namespace rivulet::nc::heidenhain {

Language language() {
  return {.dialect = Dialect::Heidenhain,
          .notation = hashNotation(),
          .comparison = hashSemantics(),
          .blockParser = hashParser,
          .steering = {},
          .otherStatements = {},
          .isKlartext = true,
          .hasOWords = false,
          .toolChangesZ = true,
          .lengthComesWithTool = true};
}

}  // namespace rivulet::nc::heidenhain
