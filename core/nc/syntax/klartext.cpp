// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/klartext.h"

#include <algorithm>

#include "base/text.h"

namespace rivulet::nc {

namespace {

/// LBL 5 and LBL "NAME" are labels, LBL 0 ends a subprogram. @return empty: no label
std::string_view labelOf(std::string_view text) {
  if (base::toUpper(text.substr(0, 3)) != "LBL") {
    return {};
  }
  text = base::trim(text.substr(3, std::min(text.find(';'), text.size()) - 3));
  if (text.size() > 2 && text.front() == '"' && text.back() == '"') {
    return text.substr(1, text.size() - 2);
  }
  const bool isNumber = !text.empty() && std::all_of(text.begin(), text.end(),
                                                     [](char c) { return base::isDigit(c); });
  while (isNumber && text.size() > 1 && text.front() == '0') {
    text.remove_prefix(1);
  }
  return isNumber && text != "0" ? text : std::string_view();
}

}  // namespace

bool klartextContinues(std::string_view line) {
  // The mark ends the line, or what stands before its comment.
  const auto isMarked = [](std::string_view text) {
    text = base::trim(text);
    return !text.empty() && text.back() == '~';
  };
  return isMarked(line) || isMarked(line.substr(0, line.find(';')));
}

void readKlartext(std::string_view block, std::vector<Token>& tokens) {
  std::size_t at = 0;
  const auto skipBlanks = [&] {
    while (at < block.size() && base::isBlank(block[at])) {
      ++at;
    }
  };
  const auto add = [&](TokenKind kind, std::size_t size) {
    Token token;
    token.kind = kind;
    token.column = static_cast<int>(at) + 1;
    token.text = block.substr(at, size);
    tokens.push_back(token);
  };
  // A skip mark stands before or behind the number.
  const auto takeSkip = [&] {
    skipBlanks();
    if (at < block.size() && block[at] == '/') {
      add(TokenKind::BlockSkip, 1);
      ++at;
      skipBlanks();
    }
  };
  takeSkip();
  if (at + 1 < block.size() && base::toUpper(block[at]) == 'N' && base::isDigit(block[at + 1])) {
    ++at;  // N10 instead of 10
  }
  while (at < block.size() && base::isDigit(block[at])) {
    ++at;
  }
  takeSkip();
  // A comment, a heading of the structure, a line that a sender has put before the program, or a
  // lone end mark of old systems.
  const bool isEmpty = at >= block.size() || block[at] == ';' || block[at] == '*' ||
                       block[at] == '(' || static_cast<unsigned char>(block[at]) < 0x20;
  if (isEmpty) {
    tokens.clear();
    return;
  }
  if (const std::string_view label = labelOf(block.substr(at)); !label.empty()) {
    add(TokenKind::Label, 0);
    tokens.back().text = label;
    return;
  }
  add(TokenKind::Statement, std::string_view::npos);
}

}  // namespace rivulet::nc
