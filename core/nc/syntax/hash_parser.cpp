// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "nc/syntax/parser.h"
#include "nc/syntax/programs.h"

namespace rivulet::nc {

namespace {

using base::isDigit;

/// "DO1" → "1"; the digits are taken off.
std::string takeTrailingDigits(std::string& word) {
  std::size_t end = word.size();
  while (end > 0 && isDigit(word[end - 1])) {
    --end;
  }
  std::string digits = word.substr(end);
  word.resize(end);
  return digits;
}

/// Structures become branches; those with a number or name close by it.
class HashParser final : public BlockParser {
 public:
  HashParser(Tree& tree, const Language& language)
      : BlockParser(tree), m_language(language), m_notation(language.notation) {}

  std::string_view steer(std::string_view text, Place place) override {
    m_place = place;
    const bool isO = text.starts_with('O') || text.starts_with('o');
    std::string_view rest = text;
    if (!isO) {
      rest = text.substr(0, text.find(';'));  // the text of an alarm stands behind its value
      Reader reader(rest, m_notation, place);
      m_in = &reader;
      read(kWords, reader.name());
      return {};
    }
    const std::optional<std::string> id = takeOName(rest);
    if (!id) {
      fault(FaultCode::ONameMissing);
      return {};
    }
    m_id = *id;
    for (std::string_view behind = base::trim(rest);
         m_language.hasCommentsBehindOWords && behind.starts_with('('); behind = base::trim(rest)) {
      rest = behind.substr(std::min(behind.find(')'), behind.size() - 1) + 1);
    }
    rest = rest.substr(0, rest.find_first_of(";("));
    Reader reader(rest, m_notation, place);
    m_in = &reader;
    read(kOWords, reader.name());
    return {};
  }

 private:
  struct Word {
    std::string_view word;
    void (HashParser::*read)();
  };

  static const std::array<Word, 6> kWords;
  static const std::array<Word, 14> kOWords;

  template <std::size_t Count>
  void read(const std::array<Word, Count>& words, const std::string& word) {
    const auto find = [&words](std::string_view name) {
      return std::find_if(words.begin(), words.end(),
                          [name](const Word& each) { return each.word == name; });
    };
    m_word = word;
    m_digits.clear();
    auto found = find(word);
    if (found == words.end()) {
      // DO1, END1 and GOTO100 are written with and without a blank.
      std::string key = word;
      m_digits = takeTrailingDigits(key);
      found = find(key);
    }
    if (found != words.end()) {
      (this->*found->read)();
    } else {
      fault(FaultCode::OWordUnknown, named());
    }
  }

  /// As a message names the word: "O1 ENDIF".
  [[nodiscard]] std::string named() const { return fmt::format("{} {}", m_id, m_word); }

  using BlockParser::fault;
  void fault(FaultCode code, std::string argument = {}) {
    fault(code, std::move(argument), m_place);
  }

  // --- ISO ------------------------------------------------------------------------------------

  void goTo() { jump(std::nullopt); }

  void jump(std::optional<Expression> condition) {
    Jump made;
    made.condition = std::move(condition);
    if (m_digits.empty()) {
      made.number = expression();
      if (!made.number) {
        return;
      }
      if (made.number->op == Op::Number) {
        made.label = fmt::format("N{:.0f}", made.number->number);
        made.number.reset();
      }
    } else {
      made.label = fmt::format("N{}", base::parseInteger(m_digits).value_or(-1));
    }
    append(std::move(made));
  }

  /// IF [condition] GOTO n, IF [condition] THEN #1=5
  void ifWord() {
    std::optional<Expression> condition = expression();
    if (!condition) {
      return;
    }
    std::string word = m_in->name();
    if (word == "THEN") {
      std::optional<Assignment> assignment = got(m_in->assignment());
      if (!assignment) {
        return;
      }
      const std::size_t branch = append(Branch{std::move(condition), 0});
      append(std::move(*assignment));
      patch(branch);
      return;
    }
    m_digits = takeTrailingDigits(word);
    if (word == "GOTO") {
      jump(std::move(condition));
    } else {
      fault(FaultCode::ThenExpected);
    }
  }

  void whileDo() {
    std::optional<Expression> condition = expression();
    std::string word = condition ? m_in->name() : std::string();
    m_digits = takeTrailingDigits(word);
    if (condition && word != "DO") {
      fault(FaultCode::WhileMalformed);
      return;
    }
    m_digits = m_digits.empty() ? digits() : m_digits;
    m_id = "DO" + m_digits;
    begin(openOn("WHILE", std::move(condition)));
  }

  void doAlone() {
    m_digits = m_digits.empty() ? digits() : m_digits;
    m_id = "DO" + m_digits;
    begin(open("WHILE"));
  }

  void end() {
    m_digits = m_digits.empty() ? digits() : m_digits;
    m_id = "DO" + m_digits;
    m_word = "END" + m_digits;
    if (const std::optional<Open> ended = close("WHILE", m_word)) {
      closeLoop(*ended);
    }
  }

  // --- structures -----------------------------------------------------------------------------

  void begin(Open& opened) const {
    opened.id = m_id;
    opened.name = m_word;
  }

  [[nodiscard]] Open* innermost(std::string_view kind) {
    const auto found = std::find_if(m_open.rbegin(), m_open.rend(), [&](const Open& each) {
      return each.kind == kind && each.id == m_id;
    });
    return found == m_open.rend() ? nullptr : &*found;
  }

  /// What is still open inside was never closed, and closes with it.
  std::optional<Open> close(std::string_view kind, std::string word) {
    const Open* const found = innermost(kind);
    if (found == nullptr) {
      fault(FaultCode::NoBeginning, std::move(word));
      return std::nullopt;
    }
    Open closed = *found;
    while (m_open.back().id != closed.id || m_open.back().kind != kind) {
      patch(m_open.back().branch);
      patch(m_open.back().toEnd);
      m_open.pop_back();
    }
    m_open.pop_back();
    return closed;
  }

  // --- O words of RS-274/NGC --------------------------------------------------------------------

  void oIf() { begin(openOn("IF", expression())); }

  /// The branch before it ends here; the next one begins.
  bool divide() {
    Open* const open = innermost("IF");
    if (open == nullptr) {
      fault(FaultCode::NoBeginning, named());
      return false;
    }
    open->toEnd.push_back(append(Branch{}));
    patch(std::exchange(open->branch, std::nullopt));
    return true;
  }

  void oElseIf() {
    if (!divide()) {
      return;
    }
    std::optional<Expression> condition = expression();
    if (condition) {
      innermost("IF")->branch = append(Branch{std::move(condition), 0});
    }
  }

  void oElse() { divide(); }

  void oEndIf() {
    if (const std::optional<Open> ended = close("IF", named())) {
      patch(ended->branch);
      patch(ended->toEnd);
    }
  }

  void oDo() { begin(open("DO")); }

  void oWhile() {
    std::optional<Expression> condition = expression();
    const bool closesDo = !m_open.empty() && m_open.back().kind == "DO" && m_open.back().id == m_id;
    if (!closesDo) {
      begin(openOn("WHILE", std::move(condition)));
      return;
    }
    const std::optional<Open> ended = close("DO", named());
    patch(ended->toContinue);
    if (condition) {
      Expression leaves;
      leaves.op = Op::Not;
      leaves.operands.push_back(std::move(*condition));
      append(Branch{std::move(leaves), ended->begin});
    }
    patch(ended->toEnd);
  }

  void oEndWhile() {
    if (const std::optional<Open> ended = close("WHILE", named())) {
      closeLoop(*ended);
    }
  }

  /// Its rounds are counted in a variable no program can name.
  void oRepeat() {
    std::optional<Expression> times = expression();
    Definition left;
    left.name = fmt::format("REPEAT {}", here());
    const Expression counter = variableNamed(left.name);
    std::optional<Expression> goesOn;
    if (times) {
      // What is left of a whole number by rounding still counts as one.
      constexpr double kRounding = 1e-9;
      Expression whole;
      whole.op = Op::RoundDown;
      whole.operands.push_back(
          applied(Op::Add, std::move(*times), Expression::constant(kRounding)));
      left.initial = only(std::move(whole));
      append(std::move(left));
      goesOn = applied(Op::Greater, counter, Expression::constant(0.0));
    }
    Open& opened = openOn("REPEAT", std::move(goesOn));
    opened.step =
        Assignment{counter, only(applied(Op::Subtract, counter, Expression::constant(1.0)))};
    begin(opened);
  }

  void oEndRepeat() {
    if (const std::optional<Open> ended = close("REPEAT", named())) {
      closeLoop(*ended);
    }
  }

  [[nodiscard]] Open* loop() {
    const auto found = std::find_if(m_open.rbegin(), m_open.rend(), [&](const Open& each) {
      return each.kind != "IF" && each.id == m_id;
    });
    if (found == m_open.rend()) {
      fault(FaultCode::NotInLoop, named());
      return nullptr;
    }
    return &*found;
  }

  void oBreak() {
    if (Open* const left = loop()) {
      left->toEnd.push_back(append(Branch{}));
    }
  }

  void oContinue() {
    Open* const again = loop();
    if (again != nullptr && again->kind == "WHILE") {
      append(Branch{std::nullopt, again->begin});
    } else if (again != nullptr) {
      again->toContinue.push_back(append(Branch{}));
    }
  }

  void oReturn() {
    Return made;
    if (!m_in->isAtEnd()) {
      made.value = expression();
      if (!made.value) {
        return;
      }
    }
    append(std::move(made));
  }

  /// Without a value the text of the subprogram just ends.
  void oEndSub() {
    if (!m_in->isAtEnd()) {
      oReturn();
    }
  }

  void oCall() {
    Call made;
    made.name = m_id;
    made.isNumbered = true;
    while (!m_in->isAtEnd()) {
      std::optional<Expression> argument = expression();
      if (!argument) {
        return;
      }
      made.arguments.push_back(std::move(argument));
    }
    append(std::move(made));
  }

  const Language& m_language;
  const Notation& m_notation;
  std::string m_id;  ///< "O100", "O<NAME>", "DO1"
  std::string m_word;
  std::string m_digits;  ///< after the word: DO1, GOTO100
};

const std::array<HashParser::Word, 6> HashParser::kWords{{
    {"GOTO", &HashParser::goTo},
    {"IF", &HashParser::ifWord},
    {"WHILE", &HashParser::whileDo},
    {"WH", &HashParser::whileDo},
    {"DO", &HashParser::doAlone},
    {"END", &HashParser::end},
}};

const std::array<HashParser::Word, 14> HashParser::kOWords{{
    {"CALL", &HashParser::oCall},
    {"RETURN", &HashParser::oReturn},
    {"ENDSUB", &HashParser::oEndSub},
    {"IF", &HashParser::oIf},
    {"ELSEIF", &HashParser::oElseIf},
    {"ELSE", &HashParser::oElse},
    {"ENDIF", &HashParser::oEndIf},
    {"DO", &HashParser::oDo},
    {"WHILE", &HashParser::oWhile},
    {"ENDWHILE", &HashParser::oEndWhile},
    {"REPEAT", &HashParser::oRepeat},
    {"ENDREPEAT", &HashParser::oEndRepeat},
    {"BREAK", &HashParser::oBreak},
    {"CONTINUE", &HashParser::oContinue},
}};

}  // namespace

std::unique_ptr<BlockParser> hashParser(Tree& tree, const Language& language, Detail /*detail*/) {
  return std::make_unique<HashParser>(tree, language);
}

}  // namespace rivulet::nc
