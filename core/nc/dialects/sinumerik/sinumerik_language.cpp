// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/sinumerik/sinumerik.h"

#include <array>
#include <string_view>

#include "nc/syntax/parser.h"

namespace rivulet::nc::sinumerik {

namespace {

constexpr std::array<std::string_view, 24> kSinumerikSteering{
    "IF",      "ELSE",  "ENDIF",  "WHILE",   "ENDWHILE", "FOR",  "ENDFOR",  "LOOP",
    "ENDLOOP", "UNTIL", "REPEAT", "REPEATB", "CASE",     "GOTO", "GOTOF",   "GOTOB",
    "GOTOC",   "GOTOS", "DEF",    "PROC",    "EXTERN",   "CALL", "EXTCALL", "PCALL"};

using Meaning = OtherStatement::Meaning;
constexpr std::array kSinumerikOthers{OtherStatement{"MCALL", Meaning::ModalCall},
                                      OtherStatement{"SETINT", Meaning::Ignored},
                                      OtherStatement{"DEFAULT", Meaning::Ignored}};

}  // namespace

Language language() {
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
          .ignoresCentreAcross = true,
          .refusesLargeFeeds = true};
}

}  // namespace rivulet::nc::sinumerik
