// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/language.h"

#include <array>

#include "nc/syntax/parser.h"

namespace rivulet::nc {

namespace {

constexpr std::array<std::string_view, 24> kSinumerikSteering{
    "IF",      "ELSE",  "ENDIF",  "WHILE",   "ENDWHILE", "FOR",  "ENDFOR",  "LOOP",
    "ENDLOOP", "UNTIL", "REPEAT", "REPEATB", "CASE",     "GOTO", "GOTOF",   "GOTOB",
    "GOTOC",   "GOTOS", "DEF",    "PROC",    "EXTERN",   "CALL", "EXTCALL", "PCALL"};
constexpr std::array<std::string_view, 5> kHashSteering{"IF", "WHILE", "DO", "END", "GOTO"};

using Meaning = OtherStatement::Meaning;
constexpr std::array kSinumerikOthers{OtherStatement{"MCALL", Meaning::ModalCall},
                                      OtherStatement{"SETINT", Meaning::Ignored},
                                      OtherStatement{"DEFAULT", Meaning::Ignored}};
constexpr std::array kKlartextOthers{OtherStatement{"CALL", Meaning::CallsProgram}};

Language sinumerik() {
  return {.dialect = Dialect::Sinumerik,
          .notation = sinumerikNotation(),
          .comparison = sinumerikSemantics(),
          .blockParser = sinumerikParser,
          .steering = kSinumerikSteering,
          .otherStatements = kSinumerikOthers,
          .hasBracketComments = false,
          .hasIndexedWords = true,
          .hasOWords = false,
          .comparesNumbersAsText = true,
          .lettersMayBeVariables = true,
          .namesAreCalls = true,
          .inchesOfLengthsOnly = true,
          .ignoresCentreAcross = true};
}

/// What follows RS-274/NGC.
Language hash(Dialect dialect) {
  return {.dialect = dialect,
          .notation = hashNotation(),
          .comparison = hashSemantics(),
          .blockParser = hashParser,
          .steering = kHashSteering,
          .otherStatements = {},
          .spiralShare = 1e-3};
}

Language iso() {
  Language made = hash(Dialect::Iso);
  made.hasTurningCycles = true;
  made.dwellInMilliseconds = true;
  return made;
}

Language linuxCnc() {
  Language made = hash(Dialect::LinuxCnc);
  made.hasPolarSigns = true;
  made.sharesOffset = true;
  return made;
}

Language heidenhain() {
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

}  // namespace

const Language& languageOf(Dialect dialect) {
  static const std::array<Language, kDialects.size()> languages{sinumerik(), iso(), linuxCnc(),
                                                                hash(Dialect::Grbl), heidenhain()};
  return languages[static_cast<std::size_t>(dialect)];
}

}  // namespace rivulet::nc
