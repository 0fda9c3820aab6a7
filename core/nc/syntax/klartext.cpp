// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/klartext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/text.h"

namespace rivulet::nc {

namespace {

using base::isDigit;
using base::toUpper;

class KlartextLine {
 public:
  KlartextLine(std::string_view line, std::vector<Token>& tokens)
      : m_line(line), m_tokens(tokens) {}

  void read() {
    skipBlanks();
    const std::size_t number = m_at;
    while (m_at < m_line.size() && isDigit(m_line[m_at])) {
      ++m_at;
    }
    if (m_at > number) {
      skipBlanks();
    }
    if (m_at == m_line.size() || m_line[m_at] == ';' || m_line[m_at] == '*') {
      return;
    }
    // A lone end mark of old systems.
    if (static_cast<unsigned char>(m_line[m_at]) < 0x20) {
      return;
    }
    if (m_line[m_at] == '/') {
      add(TokenKind::BlockSkip, m_at, m_at + 1);
      ++m_at;
      skipBlanks();
    }
    m_end = std::min(m_line.find(';'), m_line.size());
    command();
  }

 private:
  void skipBlanks() {
    while (m_at < m_line.size() && (m_line[m_at] == ' ' || m_line[m_at] == '\t')) {
      ++m_at;
    }
  }

  Token& add(TokenKind kind, std::size_t from, std::size_t to, char address = 0,
             double value = 0.0) {
    Token token;
    token.kind = kind;
    token.address = address;
    token.column = static_cast<int>(from) + 1;
    token.value = value;
    token.text = m_line.substr(from, to - from);
    m_tokens.push_back(token);
    return m_tokens.back();
  }

  void addG(double value, std::size_t from) { add(TokenKind::Word, from, from + 1, 'G', value); }

  std::string takeWord() {
    skipBlanks();
    const std::size_t from = m_at;
    while (m_at < m_end && toUpper(m_line[m_at]) >= 'A' && toUpper(m_line[m_at]) <= 'Z') {
      ++m_at;
    }
    return base::toUpper(m_line.substr(from, m_at - from));
  }

  void statement(std::size_t from) {
    std::size_t end = m_end;
    while (end > from && (m_line[end - 1] == ' ' || m_line[end - 1] == '~')) {
      --end;
    }
    add(TokenKind::Statement, from, end);
    m_at = m_end;
  }

  void command() {
    const std::size_t from = m_at;
    const std::string word = takeWord();
    const std::size_t behind = m_at;
    const std::string second = takeWord();
    if (programOrTool(word, second, from)) {
      return;
    }
    m_at = behind;
    if (motion(word, from, behind)) {
      return;
    }
    if (word == "Q" || word == "QL" || word == "QR" || word == "QS") {
      add(TokenKind::Assignment, from, m_end);
      m_at = m_end;
    } else if (word == "LBL") {
      add(TokenKind::Label, from, m_end);
      m_at = m_end;
    } else if (word == "STOP") {
      add(TokenKind::Word, from, behind, 'M', 0.0);
      words();
    } else if (word == "F" || word == "M" || word == "S" || word == "FMAX") {
      m_at = from;
      words();
    } else {
      statement(from);
    }
  }

  /// BEGIN PGM and END PGM, the blank, tools and cycles. @return true if it was one of them
  bool programOrTool(const std::string& word, const std::string& second, std::size_t from) {
    if (word == "BEGIN" && second == "PGM") {
      const std::string text = base::toUpper(base::trim(m_line.substr(m_at, m_end - m_at)));
      const bool inches = text.size() >= 4 && text.substr(text.size() - 4) == "INCH";
      addG(inches ? 20.0 : 21.0, from);
    } else if (word == "END" && second == "PGM") {
      add(TokenKind::Word, from, m_at, 'M', 30.0);
    } else if (word == "TOOL" && second == "CALL") {
      if (const std::optional<double> tool = number()) {
        add(TokenKind::Word, from, m_at, 'T', *tool);
      }
      spindleOfToolCall();
    } else if (word == "BLK" || word == "TOOL" || (word == "CYCL" && second == "CALL")) {
      add(TokenKind::Name, from, m_at);
    } else if (word == "CYCL") {
      // CYCL DEF 19.1 A+0: its number belongs to the name.
      skipBlanks();
      while (m_at < m_end && isDigit(m_line[m_at])) {
        ++m_at;
      }
      add(TokenKind::Name, from, m_at);
    } else {
      return false;
    }
    return true;
  }

  /// Lines, arcs and the centre of a circle. @return true if it was one of them
  bool motion(const std::string& word, std::size_t from, std::size_t behind) {
    if (word == "CTP") {
      statement(from);
      return true;
    }
    if (word == "L" || word == "LN" || word == "LP") {
      const bool rapid = hasRapid();
      addG(rapid ? 0.0 : 1.0, from);
    } else if (word == "CC") {
      skipBlanks();
      addG(m_at >= m_end ? 110.0 : 111.0, from);
    } else if (word == "C" || word == "CR" || word == "CP") {
      addG(turnsClockwise() ? 2.0 : 3.0, from);
    } else if (word == "CT") {
      add(TokenKind::Name, from, behind);
    } else {
      return false;
    }
    words();
    return true;
  }

  /// "Z S3000 DL+0.1": only the speed belongs to a word of its own.
  void spindleOfToolCall() {
    for (skipBlanks(); m_at < m_end; skipBlanks()) {
      const std::size_t from = m_at;
      if (takeWord() != "S") {
        m_at = std::max(m_at, from + 1);
      } else if (const std::optional<double> speed = number()) {
        add(TokenKind::Word, from, m_at, 'S', *speed);
      }
    }
  }

  [[nodiscard]] std::string upperRest() const {
    return base::toUpper(m_line.substr(m_at, m_end - m_at));
  }

  [[nodiscard]] bool hasRapid() const {
    const std::string rest = upperRest();
    return rest.find("FMAX") != std::string::npos || rest.find("F MAX") != std::string::npos;
  }

  [[nodiscard]] bool turnsClockwise() const { return upperRest().find("DR-") != std::string::npos; }

  std::optional<double> number() {
    skipBlanks();
    std::size_t end = m_at;
    if (end < m_end && (m_line[end] == '+' || m_line[end] == '-')) {
      ++end;
    }
    const std::size_t digits = end;
    while (end < m_end && (isDigit(m_line[end]) || m_line[end] == '.')) {
      ++end;
    }
    if (end == digits) {
      return std::nullopt;
    }
    const std::optional<double> value = base::parseNumber(m_line.substr(m_at, end - m_at));
    m_at = end;
    return value;
  }

  void words() {
    for (skipBlanks(); m_at < m_end; skipBlanks()) {
      const std::size_t from = m_at;
      if (m_line[m_at] == '~') {
        return;
      }
      const std::string word = takeWord();
      if (word.empty()) {
        ++m_at;
        add(TokenKind::UnexpectedCharacter, from, m_at);
        continue;
      }
      if (word == "FMAX" || word == "MAX" || word == "FAUTO" || word == "AUTO") {
        continue;
      }
      if (word == "F" && upperRest().find_first_not_of(' ') != std::string::npos &&
          (upperRest().rfind(" MAX", 0) == 0 || upperRest().rfind(" AUTO", 0) == 0)) {
        continue;
      }
      if (word == "DR") {
        number();
        m_at += m_at < m_end && (m_line[m_at] == '+' || m_line[m_at] == '-') ? 1U : 0U;
        continue;
      }
      if (word == "RL" || word == "RR") {
        addG(word == "RL" ? 41.0 : 42.0, from);
        continue;
      }
      const std::optional<double> value = number();
      if (word == "MB") {
        skipBlanks();
        m_at += upperRest().rfind("MAX", 0) == 0 ? 3U : 0U;
        continue;  // how far M140 goes: nothing here knows where that is
      }
      if (!value) {
        // X+Q5: a parameter.
        while (m_at < m_end && m_line[m_at] != ' ') {
          ++m_at;
        }
        add(TokenKind::Statement, from, m_at);
        continue;
      }
      word1(word, from, *value);
    }
  }

  void word1(const std::string& word, std::size_t from, double value) {
    const bool increment = word.size() > 1 && word[0] == 'I';
    const Reference reference = increment ? Reference::Incremental : Reference::Modal;
    const std::string name = increment ? word.substr(1) : word;
    if (name == "R" && value == 0.0) {
      addG(40.0, from);
      return;
    }
    if (name.size() == 1) {
      add(TokenKind::Word, from, m_at, name[0], value).reference = reference;
      return;
    }
    struct Polar {
      std::string_view klartext;
      std::string_view shared;
    };
    // The angle of CP counts from the start, that of LP from the first axis.
    static constexpr std::array<Polar, 5> kNames{
        {{"PR", "RP"}, {"PA", "AP"}, {"TX", "A3"}, {"TY", "B3"}, {"TZ", "C3"}}};
    const auto* const found = std::find_if(kNames.begin(), kNames.end(),
                                           [&name](const Polar& p) { return p.klartext == name; });
    if (found == kNames.end()) {
      add(TokenKind::Statement, from, m_at);
      return;
    }
    Token& token = add(TokenKind::NamedValue, from, m_at, 0, value);
    token.reference = reference;
    token.text = found->shared;
  }

  std::string_view m_line;
  std::size_t m_at = 0;
  std::size_t m_end = 0;
  std::vector<Token>& m_tokens;
};

}  // namespace

void readKlartext(std::string_view line, bool& continues, std::vector<Token>& tokens) {
  const std::string_view shown = base::trim(line.substr(0, line.find(';')));
  const bool belongs = continues;
  const std::string_view all = base::trim(line);
  continues = (!shown.empty() && shown.back() == '~') || (!all.empty() && all.back() == '~');
  // The parameters of a cycle: "Q200=2 ;SET-UP CLEARANCE ~".
  const bool isParameter = shown.size() > 1 && toUpper(shown[0]) == 'Q' && isDigit(shown[1]);
  if (belongs || isParameter) {
    return;
  }
  KlartextLine(line, tokens).read();
}

}  // namespace rivulet::nc
