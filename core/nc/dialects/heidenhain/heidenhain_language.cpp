// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/heidenhain.h"

#include <array>

#include "nc/syntax/parser.h"

namespace rivulet::nc::heidenhain {

namespace {

constexpr std::array kKlartextOthers{OtherStatement{"CALL", OtherStatement::Meaning::CallsProgram}};

}  // namespace

Language language() {
  return {.dialect = Dialect::Heidenhain,
          .notation = hashNotation(),
          .comparison = hashSemantics(),
          .blockParser = hashParser,
          .steering = {},
          .otherStatements = kKlartextOthers,
          .isKlartext = true,
          .hasOWords = false,
          .variablesAreOfCycles = true,
          .toolChangesZ = true,
          .turnsAboutPole = true};
}

}  // namespace rivulet::nc::heidenhain
