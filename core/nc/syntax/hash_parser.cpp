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
  using BlockParser::BlockParser;

  std::string_view steer(std::string_view text, Place place) override {
    m_place = place;
    const std::size_t comment = text.find_first_of(";(");
    std::string_view rest = text.substr(0, comment);
    if (text.empty() || (text.front() != 'O' && text.front() != 'o')) {
      Reader reader(rest, hashNotation(), place);
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
    Reader reader(rest, hashNotation(), place);
    m_in = &reader;
    read(kOWords, reader.name());
    return {};
  }

  void finish() override {
    for (Open& open : m_open) {
      open.toEnd.push_back(open.branch);
      patchAll(open.toEnd);
      BlockParser::fault(FaultCode::NotClosed, open.word, open.place);
    }
    m_open.clear();
  }

 private:
  enum class Kind : std::uint8_t { If, While, Do, Times };
  struct Open {
    Kind kind = Kind::If;
    std::string id;
    std::string word;
    Place place;
    std::size_t begin = 0;              ///< where the loop continues
    std::optional<std::size_t> branch;  ///< to be patched where the condition does not hold
    std::vector<std::optional<std::size_t>> toEnd;       ///< of BREAK and of branches that end
    std::vector<std::optional<std::size_t>> toContinue;  ///< of CONTINUE
    bool isFaulty = false;  ///< its condition could not be read: its body is not a loop
  };
  struct Word {
    std::string_view word;
    void (HashParser::*read)();
  };

  static const std::array<Word, 5> kWords;
  static const std::array<Word, 13> kOWords;

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

  void patchAll(const std::vector<std::optional<std::size_t>>& branches) {
    for (const std::optional<std::size_t>& branch : branches) {
      patch(branch);
    }
  }

  // --- ISO ------------------------------------------------------------------------------------

  void goTo() { jump(std::nullopt); }

  void jump(std::optional<Expression> condition) {
    Jump made;
    made.condition = std::move(condition);
    if (const std::optional<int> number = base::parseInteger(m_digits)) {
      made.label = fmt::format("N{}", *number);
    } else {
      made.number = expression();
      if (!made.number) {
        return;
      }
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
    openWhile(std::move(condition));
  }

  void doAlone() {
    m_digits = m_digits.empty() ? digits() : m_digits;
    m_id = "DO" + m_digits;
    open(Kind::While, here(), std::nullopt);
  }

  void end() {
    m_digits = m_digits.empty() ? digits() : m_digits;
    m_id = "DO" + m_digits;
    m_word = "END" + m_digits;
    if (std::optional<Open> ended = close(Kind::While, m_word)) {
      closeWhile(*ended);
    }
  }

  // --- structures -----------------------------------------------------------------------------

  void open(Kind kind, std::size_t begin, std::optional<std::size_t> branch,
            bool isFaulty = false) {
    m_open.push_back({kind, m_id, m_word, m_place, begin, branch, {}, {}, isFaulty});
  }

  [[nodiscard]] Open* innermost(Kind kind) {
    const auto found = std::find_if(m_open.rbegin(), m_open.rend(), [&](const Open& each) {
      return each.kind == kind && each.id == m_id;
    });
    return found == m_open.rend() ? nullptr : &*found;
  }

  /// What is still open inside was never closed, and closes with it.
  std::optional<Open> close(Kind kind, std::string word) {
    const Open* const found = innermost(kind);
    if (found == nullptr) {
      fault(FaultCode::NoBeginning, std::move(word));
      return std::nullopt;
    }
    Open closed = *found;
    while (m_open.back().id != closed.id || m_open.back().kind != kind) {
      patch(m_open.back().branch);
      patchAll(m_open.back().toEnd);
      m_open.pop_back();
    }
    m_open.pop_back();
    return closed;
  }

  void openWhile(std::optional<Expression> condition) {
    if (!condition) {
      open(Kind::While, here(), std::nullopt, true);
      return;
    }
    const std::size_t begin = append(Branch{std::move(condition), 0});
    open(Kind::While, begin, begin);
  }

  void closeWhile(Open& ended) {
    if (!ended.isFaulty) {
      append(Branch{std::nullopt, ended.begin});
    }
    ended.toEnd.push_back(ended.branch);
    patchAll(ended.toEnd);
  }

  // --- O words of RS-274/NGC --------------------------------------------------------------------

  void oIf() {
    std::optional<Expression> condition = expression();
    const bool isFaulty = !condition;
    const std::optional<std::size_t> branch =
        isFaulty ? std::nullopt : std::optional(append(Branch{std::move(condition), 0}));
    open(Kind::If, 0, branch, isFaulty);
  }

  /// The branch before it ends here; the next one begins.
  bool divide() {
    Open* const open = innermost(Kind::If);
    if (open == nullptr) {
      fault(FaultCode::NoBeginning, named());
      return false;
    }
    open->toEnd.emplace_back(append(Branch{}));
    patch(std::exchange(open->branch, std::nullopt));
    return true;
  }

  void oElseIf() {
    if (!divide()) {
      return;
    }
    std::optional<Expression> condition = expression();
    if (condition) {
      innermost(Kind::If)->branch = append(Branch{std::move(condition), 0});
    }
  }

  void oElse() { divide(); }

  void oEndIf() {
    if (std::optional<Open> ended = close(Kind::If, named())) {
      ended->toEnd.push_back(ended->branch);
      patchAll(ended->toEnd);
    }
  }

  void oDo() { open(Kind::Do, here(), std::nullopt); }

  void oWhile() {
    std::optional<Expression> condition = expression();
    const bool closesDo =
        !m_open.empty() && m_open.back().kind == Kind::Do && m_open.back().id == m_id;
    if (!closesDo) {
      openWhile(std::move(condition));
      return;
    }
    const std::optional<Open> ended = close(Kind::Do, named());
    patchAll(ended->toContinue);
    if (condition) {
      Expression leaves;
      leaves.op = Op::Not;
      leaves.operands.push_back(std::move(*condition));
      append(Branch{std::move(leaves), ended->begin});
    }
    patchAll(ended->toEnd);
  }

  void oEndWhile() {
    if (std::optional<Open> ended = close(Kind::While, named())) {
      closeWhile(*ended);
    }
  }

  /// Its rounds are counted in a variable no program can name.
  void oRepeat() {
    std::optional<Expression> times = expression();
    Definition left;
    left.name = fmt::format("REPEAT {}", here());
    const Expression counter = variableNamed(left.name);
    if (times) {
      // What is left of a whole number by rounding still counts as one.
      constexpr double kRounding = 1e-9;
      Expression whole;
      whole.op = Op::RoundDown;
      whole.operands.push_back(
          applied(Op::Add, std::move(*times), Expression::constant(kRounding)));
      left.initial = only(std::move(whole));
      append(std::move(left));
    }
    const bool isFaulty = !times;
    const std::size_t begin = here();
    const std::optional<std::size_t> branch =
        isFaulty ? std::nullopt
                 : std::optional(
                       append(Branch{applied(Op::Greater, counter, Expression::constant(0.0)), 0}));
    open(Kind::Times, begin, branch, isFaulty);
    m_open.back().word = counter.name;
  }

  void oEndRepeat() {
    std::optional<Open> ended = close(Kind::Times, named());
    if (!ended) {
      return;
    }
    patchAll(ended->toContinue);
    if (!ended->isFaulty) {
      const Expression counter = variableNamed(ended->word);
      append(Assignment{counter, only(applied(Op::Subtract, counter, Expression::constant(1.0)))});
    }
    closeWhile(*ended);
  }

  [[nodiscard]] Open* loop() {
    const auto found = std::find_if(m_open.rbegin(), m_open.rend(), [&](const Open& each) {
      return each.kind != Kind::If && each.id == m_id;
    });
    if (found == m_open.rend()) {
      fault(FaultCode::NotInLoop, named());
      return nullptr;
    }
    return &*found;
  }

  void oBreak() {
    if (Open* const left = loop()) {
      left->toEnd.emplace_back(append(Branch{}));
    }
  }

  void oContinue() {
    Open* const again = loop();
    if (again != nullptr && again->kind == Kind::While) {
      append(Branch{std::nullopt, again->begin});
    } else if (again != nullptr) {
      again->toContinue.emplace_back(append(Branch{}));
    }
  }

  void oReturn() { append(Return{}); }

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

  std::string m_id;  ///< "O100", "O<NAME>", "DO1"
  std::string m_word;
  std::string m_digits;  ///< after the word: DO1, GOTO100
  std::vector<Open> m_open;
};

const std::array<HashParser::Word, 5> HashParser::kWords{{
    {"GOTO", &HashParser::goTo},
    {"IF", &HashParser::ifWord},
    {"WHILE", &HashParser::whileDo},
    {"DO", &HashParser::doAlone},
    {"END", &HashParser::end},
}};

const std::array<HashParser::Word, 13> HashParser::kOWords{{
    {"CALL", &HashParser::oCall},
    {"RETURN", &HashParser::oReturn},
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

std::unique_ptr<BlockParser> hashParser(Tree& tree, Detail /*detail*/) {
  return std::make_unique<HashParser>(tree);
}

}  // namespace rivulet::nc
