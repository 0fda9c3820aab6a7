// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which folder speaks for a dialect; nothing else chooses by it.

#include <algorithm>
#include <array>

#include "nc/dialects/dialect_words.h"
#include "nc/dialects/fanuc/fanuc.h"
#include "nc/dialects/grbl/grbl.h"
#include "nc/dialects/haas/haas.h"
#include "nc/dialects/heidenhain/heidenhain.h"
#include "nc/dialects/linuxcnc/linuxcnc.h"
#include "nc/dialects/sinumerik/sinumerik.h"

namespace rivulet::nc {

namespace {

std::size_t indexOf(Dialect dialect) {
  return static_cast<std::size_t>(dialect);
}

const DialectWords& wordsOf(Dialect dialect) {
  static const std::array<DialectWords, kDialects.size()> words{
      sinumerik::words(), fanuc::words(), haas::words(),
      linuxcnc::words(),  grbl::words(),  heidenhain::words()};
  return words[indexOf(dialect)];
}

}  // namespace

const Language& languageOf(Dialect dialect) {
  static const std::array<Language, kDialects.size()> languages{
      sinumerik::language(), fanuc::language(), haas::language(),
      linuxcnc::language(),  grbl::language(),  heidenhain::language()};
  return languages[indexOf(dialect)];
}

const GTable& gTable(Dialect dialect) {
  return wordsOf(dialect).g;
}

MEffect mEffect(Dialect dialect, int number) {
  for (const std::span<const MFunction> functions : {wordsOf(dialect).m, commonMFunctions()}) {
    const auto found =
        std::find_if(functions.begin(), functions.end(),
                     [number](const MFunction& each) { return each.number == number; });
    if (found != functions.end()) {
      return found->effect;
    }
  }
  return MEffect::None;
}

NameEffect nameEffect(Dialect dialect, std::string_view name) {
  const NameTable& names = wordsOf(dialect).names;
  const auto found = names.find(name);
  return found == names.end() ? NameEffect::Unknown : found->second;
}

}  // namespace rivulet::nc
