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
      sinumerik::words(), fanuc::words(),      haas::words(), linuxcnc::words(),
      grbl::words(),      heidenhain::words(), grbl::words()};
  return words[indexOf(dialect)];
}

}  // namespace

const Language& languageOf(Dialect dialect) {
  static const std::array<Language, kDialects.size()> languages{
      sinumerik::language(), fanuc::language(),      haas::language(),       linuxcnc::language(),
      grbl::language(),      heidenhain::language(), grbl::fluidNcLanguage()};
  return languages[indexOf(dialect)];
}

const GTable& gTable(Dialect dialect) {
  return wordsOf(dialect).g;
}

std::span<const MRow> mFunctions(Dialect dialect) {
  return wordsOf(dialect).m;
}

const MRow* mFunction(Dialect dialect, int number) {
  const std::span<const MRow> rows = mFunctions(dialect);
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [number](const MRow& row) { return row.number == number; });
  return found == rows.end() ? nullptr : &*found;
}

MEffect mEffect(Dialect dialect, int number) {
  const MRow* const row = mFunction(dialect, number);
  return row == nullptr ? MEffect::None : row->effect;
}

NameEffect nameEffect(Dialect dialect, std::string_view name) {
  return wordsOf(dialect).names.effect(name);
}

}  // namespace rivulet::nc
