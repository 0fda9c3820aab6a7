// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/tree_words.h"

#include <algorithm>
#include <optional>

#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

namespace {

bool isLetterOf(std::string_view address, std::string_view letters) {
  return address.size() == 1 && letters.find(address) != std::string_view::npos;
}

bool isNameWithoutEffect(std::string_view address) {
  return address.size() > 1 && nameEffect(Dialect::Sinumerik, address) == NameEffect::None;
}

/// G[group]=number.
Expected<double> functionOfGroup(const Word& word, double number, const ValueOf& valueOf) {
  const Expected<double> group = valueOf(*word.extension);
  if (!group) {
    return group;
  }
  const std::optional<int> key = gOfGroup(static_cast<int>(std::clamp(*group, 0.0, 1000.0)),
                                          static_cast<int>(std::clamp(number, 0.0, 1000.0)));
  return key ? Expected<double>(*key / 10.0)
             : fail(FaultCode::UnsupportedGCode, word.address, word.place);
}

Expected<Token> tokenOf(const Word& word, const ValueOf& valueOf) {
  const bool isLetter = word.address.size() == 1;
  Token token;
  token.text = word.address;
  token.column = word.place.column;
  token.reference = word.reference;
  token.hasPoint = true;
  if (!word.value) {
    // What a query writes to its variables, and where a transformation moves the axes, only a
    // control knows.
    const NameEffect effect = nameEffect(Dialect::Sinumerik, word.address);
    if (effect == NameEffect::Query || effect == NameEffect::Transformation) {
      return fail(FaultCode::NotDefined, word.address, word.place);
    }
    token.kind = isLetter ? TokenKind::NumberMissing : TokenKind::Name;
    return token;
  }
  Expected<double> value = valueOf(*word.value);
  if (value && word.extension) {
    value = functionOfGroup(word, *value, valueOf);
  }
  if (!value) {
    return fail(value.error());
  }
  token.kind = isLetter ? TokenKind::Word : TokenKind::NamedValue;
  token.address = isLetter ? word.address[0] : '\0';
  token.value = *value;
  return token;
}

}  // namespace

Expected<std::vector<Token>> tokensOf(const std::vector<Word>& words, const ValueOf& valueOf) {
  std::vector<Token> tokens;
  tokens.reserve(words.size());
  for (const Word& word : words) {
    // M1=3 and S2=500 are of other spindles.
    const bool isOthers = word.extension && word.address != "G";
    if (isOthers || isLetterOf(word.address, "TDH") || isNameWithoutEffect(word.address)) {
      continue;
    }
    Expected<Token> token = tokenOf(word, valueOf);
    if (!token) {
      return fail(std::move(token.error()));
    }
    tokens.push_back(*token);
  }
  return tokens;
}

bool isWithoutEffect(const Words& words) {
  return std::all_of(words.words.begin(), words.words.end(), [](const Word& word) {
    return isLetterOf(word.address, "MSTDHUVW") || isNameWithoutEffect(word.address);
  });
}

}  // namespace rivulet::nc
