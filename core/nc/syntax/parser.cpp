// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/text.h"
#include "nc/limits.h"
#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

namespace {

using base::isBlank;
using base::isDigit;

template <std::size_t Count>
bool isOneOf(std::string_view name, const std::array<std::string_view, Count>& words) {
  return std::find(words.begin(), words.end(), name) != words.end();
}

std::optional<JumpDirection> jumpDirection(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, JumpDirection>, 5> kWords{
      {{"GOTO", JumpDirection::ForwardThenBackward},
       {"GOTOF", JumpDirection::Forward},
       {"GOTOB", JumpDirection::Backward},
       {"GOTOC", JumpDirection::ForwardNoAlarm},
       {"GOTOS", JumpDirection::Start}}};
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [word](const auto& entry) { return entry.first == word; });
  return found == kWords.end() ? std::nullopt : std::optional(found->second);
}

/// True if the value belongs to the moment in which the axes stand. Variables of the programming
/// ($P_...) and the fill level of the buffer are known to the pre-run itself.
bool asksMainRun(const Expression& expression) {
  bool asks = false;
  forEachNode(expression, [&asks](const Expression& node) {
    asks = asks || node.op == Op::MainR ||
           (node.op == Op::System && node.name != "$AC_IPO_BUF" && !node.name.starts_with("$P_"));
  });
  return asks;
}

bool tokenIs(const Token& token, std::string_view upper) {
  return base::toUpper(tokenName(token)) == upper;
}

/// "/DIR/NAME.SPF" and "NAME" are the same program.
std::string programName(std::string_view text) {
  text = base::trim(text);
  text = text.substr(text.find_last_of("/\\:") + 1);
  std::string name = base::toUpper(text);
  for (const std::string_view ending : {".SPF", ".MPF", "_SPF", "_MPF"}) {
    if (name.size() > ending.size() && name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
    }
  }
  return name.starts_with("_N_") ? name.substr(3) : name;
}

/// Control structures are closed by back-patching. A function that returns false has added a
/// `Faulty` statement, or the rest of the block is not to be read.
class SinumerikParser final : public BlockParser {
 public:
  SinumerikParser(Tree& tree, Detail detail)
      : BlockParser(tree), m_splits(detail == Detail::Statements) {}

  void words(Words words, Place place) override {
    if (m_splits) {
      split(std::move(words), place);
    } else {
      BlockParser::words(std::move(words), place);
    }
  }

  std::string_view steer(std::string_view text, Place place) override {
    m_place = place;
    Reader reader(text, sinumerikNotation(), place);
    m_in = &reader;
    const std::string word = reader.name();
    std::optional<bool> goesOn = structure(word);
    goesOn = goesOn ? goesOn : statement(word);
    if (!goesOn) {
      goesOn = fault(FaultCode::NotDefined, word);
    }
    return *goesOn && !reader.isAtEnd() ? reader.rest() : std::string_view();
  }

 private:
  using BlockParser::fault;
  bool fault(FaultCode code, std::string argument = {}) {
    append(Faulty{{code, std::move(argument), m_in->place()}});
    return false;
  }

  [[nodiscard]] char ahead() const {
    const std::string_view rest = m_in->rest();
    return rest.size() > 1 ? rest[1] : '\0';
  }

  bool expect(char c) {
    return m_in->take(c) || fault(c == '=' ? FaultCode::EqualsMissing : FaultCode::SyntaxCharacter,
                                  std::string(1, c));
  }

  // --- words --------------------------------------------------------------------------------

  /// For a control: what a block does besides its words becomes statements, in their order. The
  /// words come after them, and the end of the program after all.
  void split(Words words, Place place) {
    Words left;
    bool ends = false;
    bool returns = false;
    const std::vector<Token>& tokens = words.tokens;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const Token& token = tokens[i];
      m_place = {place.line, place.file, token.column};
      const EndWord end = endWordOf(token);
      ends = ends || end == EndWord::End;
      returns = returns || end == EndWord::Return || end == EndWord::Ret;
      if (end == EndWord::Ret) {
        break;  // what follows is none of the program's
      }
      if (isAssignment(token)) {
        const Expected<Assignment> made =
            token.calculation != nullptr ? *token.calculation : assignmentOf(token);
        if (!made) {
          append(Faulty{made.error()});
          return;
        }
        append(*made);
      } else if (isCall(token, left.tokens.empty())) {
        const bool isRepeated = i + 1 < tokens.size() && tokens[i + 1].address == 'P';
        if (!call(token, isRepeated ? &tokens[++i] : nullptr)) {
          return;
        }
      } else if (!isSilent(token) && !ownStatement(token)) {
        if (const std::optional<Fault> refused = refusal(token)) {
          append(Faulty{*refused});
          return;
        }
        left.tokens.push_back(token);
      }
    }
    if (!left.tokens.empty()) {
      left.calculations = std::move(words.calculations);
      m_place = {place.line, place.file, left.tokens.front().column};
      append(std::move(left));
    }
    if (ends) {
      append(End{});
    } else if (returns) {
      append(Return{});
    }
  }

  static bool isSilent(const Token& token) {
    return token.kind == TokenKind::Label || token.kind == TokenKind::BlockSkip ||
           token.kind == TokenKind::Tape || (token.kind == TokenKind::Word && token.address == 'N');
  }

  static bool isNamed(const Token& token) {
    return token.kind == TokenKind::Name || token.kind == TokenKind::Call;
  }

  static NameEffect effectOf(const Token& token) {
    return nameEffect(Dialect::Sinumerik, base::toUpper(tokenName(token)));
  }

  /// What is none of the language's own words is the name of a program. @param isFirst  alone, it
  /// can only be at the beginning of a block
  static bool isCall(const Token& token, bool isFirst) {
    if (token.kind == TokenKind::Word && token.address == 'L') {
      return true;
    }
    if (!isNamed(token) || (token.kind == TokenKind::Name && !isFirst) ||
        tokenIs(token, "STOPRE") || tokenIs(token, "MSG")) {
      return false;
    }
    const NameEffect effect = effectOf(token);
    return effect == NameEffect::Unknown || effect == NameEffect::Cycle;
  }

  /// A variable, be it one that is not defined: then its assignment is the fault.
  [[nodiscard]] bool isAssignment(const Token& token) const {
    const std::string name = base::toUpper(tokenName(token));
    if (token.kind == TokenKind::Word || token.kind == TokenKind::Expression) {
      const std::size_t equals = token.text.find('=');
      return equals != std::string_view::npos && token.address != 0 &&
             m_defined.contains(std::string_view(&token.address, 1));
    }
    if (token.kind == TokenKind::Assignment) {
      return m_defined.contains(name) ||
             (name != "AX" && token.address != 'T' && effectOf(token) == NameEffect::Unknown);
    }
    const bool hasValue = token.kind == TokenKind::NamedValue ||
                          (token.kind == TokenKind::TextWord && token.address == 0);
    return hasValue && (m_defined.contains(name) || effectOf(token) == NameEffect::Unknown);
  }

  /// STOPRE and MSG("text").
  bool ownStatement(const Token& token) {
    if (isNamed(token) && tokenIs(token, "STOPRE")) {
      append(PreprocessingStop{});
      return true;
    }
    if (!isNamed(token) || !tokenIs(token, "MSG")) {
      return false;
    }
    Reader reader(token.text, sinumerikNotation(), m_place);
    m_in = &reader;
    static_cast<void>(reader.name());
    static_cast<void>(message());
    return true;
  }

  /// What a control refuses in its own language, and what this machine alone does not make.
  [[nodiscard]] std::optional<Fault> refusal(const Token& token) const {
    if (token.kind == TokenKind::Comment) {
      return Fault{FaultCode::SyntaxCharacter, "(", m_place};
    }
    if (token.kind == TokenKind::Word && token.address == 'R') {
      return Fault{FaultCode::EqualsMissing, {}, m_place};
    }
    // Of the ISO dialects: a control knows these after G291 only.
    static constexpr std::array kForeign{20.0, 21.0, 43.0, 44.0, 49.0, 52.0,
                                         65.0, 80.0, 92.0, 92.1, 98.0, 99.0};
    if (token.kind == TokenKind::Word && token.address == 'G' &&
        std::find(kForeign.begin(), kForeign.end(), token.value) != kForeign.end()) {
      return Fault{FaultCode::UnknownGCode, wordText(token), m_place};
    }
    if (!isNamed(token)) {
      return std::nullopt;
    }
    // What a query writes to its variables only a control knows.
    static constexpr std::array kRefused{NameEffect::Query, NameEffect::Spline, NameEffect::Unknown,
                                         NameEffect::Cycle};
    const bool isRefused =
        std::find(kRefused.begin(), kRefused.end(), effectOf(token)) != kRefused.end();
    return isRefused ? std::optional(
                           Fault{FaultCode::NotDefined, base::toUpper(tokenName(token)), m_place})
                     : std::nullopt;
  }

  bool call(const Token& token, const Token* times) {
    std::optional<Call> made = got(callOf(token, sinumerikNotation(), m_place));
    if (!made) {
      return false;
    }
    if (times != nullptr && times->calculated() != nullptr) {
      made->times = *times->calculated();
    } else if (times != nullptr) {
      made->times = Expression::constant(times->value);
    }
    append(std::move(*made));
    return true;
  }

  // --- statements ---------------------------------------------------------------------------

  std::optional<bool> statement(const std::string& name) {
    if (const std::optional<JumpDirection> direction = jumpDirection(name)) {
      return jump(std::nullopt, *direction);
    }
    if (name == "DEF") {
      return definition();
    }
    if (name == "PROC") {
      return procedure();
    }
    if (name == "EXTERN") {
      return restIsIgnored();
    }
    if (name == "CALL" || name == "EXTCALL") {
      return callOfText();
    }
    if (name == "PCALL") {
      std::string program = m_in->name();
      Call made;
      made.name = std::move(program);
      return made.name.empty() ? fault(FaultCode::NameMissing) : finish(std::move(made));
    }
    if (name == "MCALL") {
      return modalCall();
    }
    if (name == "CANCEL") {
      std::optional<Expression> id;
      return expect('(') && (id = expression()) && expect(')') &&
             (append(Cancel{std::move(*id)}), true);
    }
    static constexpr std::array<std::string_view, 7> kActions{"ID",   "IDS",   "WHEN", "WHENEVER",
                                                              "FROM", "EVERY", "DO"};
    if (isOneOf(name, kActions)) {
      return synchronizedAction(name);
    }
    return std::nullopt;
  }

  /// For what follows PROC and the like and changes nothing here.
  bool restIsIgnored() {
    m_in->skipRest();
    return true;
  }

  // --- control structures -------------------------------------------------------------------

  bool isShallow() {
    if (m_open.size() <= kStructuresMax) {
      return true;
    }
    m_open.pop_back();
    return fault(FaultCode::StructuresTooDeep);
  }

  /// What closes a structure must find it, also where its condition cannot be read.
  bool opens(std::string kind, std::optional<Expression> condition) {
    return !openOn(std::move(kind), std::move(condition)).isFaulty && isShallow();
  }

  /// Closes the innermost structure, which must be of this kind.
  std::optional<Open> close(std::string_view kind, const std::string& word) {
    if (m_open.empty() || m_open.back().kind != kind) {
      fault(FaultCode::NoBeginning, word);
      return std::nullopt;
    }
    Open ended = std::move(m_open.back());
    m_open.pop_back();
    return ended;
  }

  std::optional<bool> structure(const std::string& word) {
    if (word == "IF") {
      return ifWord();
    }
    if (word == "ELSE") {
      const std::optional<Open> ended = close("IF", word);
      if (!ended) {
        return false;
      }
      const std::size_t jump = append(Branch{});
      patch(ended->branch);
      open("IF", jump);
      return isShallow();
    }
    if (word == "ENDIF") {
      const std::optional<Open> ended = close("IF", word);
      patch(ended ? ended->branch : std::nullopt);
      return ended.has_value();
    }
    if (word == "WHILE") {
      return opens(word, expression());
    }
    if (word == "LOOP") {
      open(word);
      return isShallow();
    }
    if (word == "FOR") {
      return forWord();
    }
    if (word == "ENDWHILE" || word == "ENDLOOP" || word == "ENDFOR") {
      const std::optional<Open> ended = close(word.substr(3), word);
      if (ended) {
        closeLoop(*ended);
      }
      return ended.has_value();
    }
    if (word == "REPEAT" || word == "REPEATB") {
      return repeat(word == "REPEATB");
    }
    if (word == "UNTIL") {
      const std::optional<Open> ended = close("REPEAT", word);
      std::optional<Expression> condition = ended ? expression() : std::nullopt;
      return condition && (append(Branch{std::move(condition), ended->begin}), true);
    }
    if (word == "CASE") {
      return caseWord();
    }
    return std::nullopt;
  }

  bool ifWord() {
    const std::string text = base::toUpper(m_in->rest());
    std::optional<Expression> condition = expression();
    if (!condition) {
      return text.find("GOTO") == std::string::npos && opens("IF", std::nullopt);
    }
    const std::string word = m_in->name();
    if (const std::optional<JumpDirection> direction = jumpDirection(word)) {
      return jump(std::move(condition), *direction);
    }
    if (!word.empty() || !m_in->isAtEnd()) {
      return fault(FaultCode::IfMalformed);
    }
    return opens("IF", std::move(condition));
  }

  /// The limit is computed once, into a variable no program can name.
  bool forWord() {
    std::optional<Expression> counter = got(m_in->target());
    std::optional<Expression> first =
        counter && expect('=') ? expression() : std::optional<Expression>();
    const bool hasLimit = first && (m_in->takeWord("TO") || fault(FaultCode::ForMalformed));
    std::optional<Expression> last = hasLimit ? expression() : std::optional<Expression>();
    if (!last) {
      return opens("FOR", std::nullopt);
    }
    Definition limit;
    limit.name = fmt::format("FOR {}", here());
    limit.initial = only(std::move(*last));
    const Expression hidden = variableNamed(limit.name);
    append(Assignment{*counter, only(std::move(*first))});
    append(std::move(limit));
    openOn("FOR", applied(Op::LessEqual, *counter, hidden)).step =
        Assignment{*counter, only(applied(Op::Add, *counter, Expression::constant(1.0)))};
    return isShallow();
  }

  /// REPEAT alone begins a loop; with a label it repeats what stands there.
  bool repeat(bool isBlockOnly) {
    if (m_in->isAtEnd() && !isBlockOnly) {
      open("REPEAT");
      return isShallow();
    }
    RepeatLabel made;
    made.isBlockOnly = isBlockOnly;
    made.label = m_in->name();
    for (;;) {
      const Reader before = *m_in;
      std::string word = m_in->name();
      const bool isTimes =
          !word.empty() && word[0] == 'P' && std::all_of(word.begin() + 1, word.end(), isDigit);
      if (isTimes) {
        m_in->restore(before);
        m_in->skipBlanks();
        return times(made.times) && (append(std::move(made)), true);
      }
      if (word.empty() || !made.endLabel.empty() || isBlockOnly) {
        m_in->restore(before);
        break;
      }
      made.endLabel = std::move(word);
    }
    if (made.label.empty()) {
      return fault(FaultCode::NoTarget);
    }
    append(std::move(made));
    return true;
  }

  /// P5, P=R1. The reader is before P.
  bool times(std::optional<Expression>& made) {
    m_in->take(m_in->peek());
    static_cast<void>(m_in->take('='));
    made = expression();
    return made.has_value();
  }

  /// CASE(x) OF c GOTOF l ... DEFAULT GOTOF l: one conditional jump after another.
  bool caseWord() {
    const std::optional<Expression> value = expression();
    if (!value) {
      return false;
    }
    if (!m_in->takeWord("OF")) {
      return fault(FaultCode::CaseMalformed);
    }
    for (bool isFirst = true; !m_in->isAtEnd(); isFirst = false) {
      std::optional<Expression> condition;
      if (!m_in->takeWord("DEFAULT")) {
        std::optional<Expression> constant = expression();
        if (!constant) {
          return false;
        }
        condition = applied(Op::Equal, *value, std::move(*constant));
      }
      const std::optional<JumpDirection> direction = jumpDirection(m_in->name());
      if (!direction) {
        return fault(FaultCode::CaseMalformed);
      }
      if (!jump(std::move(condition), *direction)) {
        return false;
      }
      // One stop before the first comparison is enough for all.
      m_tree.statements.back().readsMainRun &= isFirst;
    }
    return true;
  }

  bool jump(std::optional<Expression> condition, JumpDirection direction) {
    std::string label;
    if (direction != JumpDirection::Start) {
      label = m_in->name();
      m_in->skipBlanks();
      label = label.empty() && isDigit(m_in->peek()) ? "N" + digits() : label;
      if (label.empty()) {
        return fault(FaultCode::NoTarget);
      }
      m_in->take(':');
    }
    append(Jump{std::move(condition), direction, std::move(label), std::nullopt});
    return true;
  }

  // --- definitions and subprograms ----------------------------------------------------------

  bool definition() {
    std::optional<std::vector<Definition>> all = got(m_in->definitions());
    if (!all) {
      return false;
    }
    for (Definition& made : *all) {
      m_defined.insert(made.name);
      append(std::move(made));
    }
    return true;
  }

  bool procedure() {
    static_cast<void>(m_in->name());
    std::optional<std::vector<Definition>> all = got(m_in->parameters());
    if (!all) {
      return false;
    }
    for (const Definition& made : *all) {
      m_defined.insert(made.name);
    }
    m_tree.parameters = std::move(*all);
    while (!m_in->isAtEnd()) {
      const std::string attribute = m_in->name();
      m_tree.saves = m_tree.saves || attribute == "SAVE";
      if (attribute.empty()) {
        return restIsIgnored();
      }
    }
    return true;
  }

  /// Behind the name: arguments, then how often.
  bool finish(Call made) {
    auto arguments = got(m_in->arguments());
    if (!arguments) {
      return false;
    }
    made.arguments = std::move(*arguments);
    m_in->skipBlanks();
    const char c = m_in->peek();
    if ((c == 'P' || c == 'p') && (isDigit(ahead()) || ahead() == '=') && !times(made.times)) {
      return false;
    }
    append(std::move(made));
    return true;
  }

  /// CALL "NAME", EXTCALL("/folder/NAME.SPF").
  bool callOfText() {
    std::optional<Expression> text = expression();
    if (!text) {
      return false;
    }
    Call made;
    if (text->op == Op::Text) {
      made.name = programName(text->name);
    } else {
      made.computed = std::move(text);
    }
    return finish(std::move(made));
  }

  bool modalCall() {
    RepeatedCall made;
    if (!m_in->isAtEnd()) {
      made.call.emplace().name = m_in->name();
      auto arguments = got(m_in->arguments());
      if (made.call->name.empty() || !arguments) {
        return fault(FaultCode::NameMissing);
      }
      made.call->arguments = std::move(*arguments);
    }
    append(std::move(made));
    return true;
  }

  // --- messages, synchronized actions -----------------------------------------------

  bool message() {
    if (!expect('(')) {
      return false;
    }
    Message made;
    if (!m_in->take(')')) {
      made.text = expression();
      if (!made.text) {
        return false;
      }
      if (m_in->take(',') && !expression()) {
        return false;
      }
      if (!expect(')')) {
        return false;
      }
    }
    append(std::move(made));
    return true;
  }

  bool synchronizedAction(std::string word) {
    Synchronized made;
    if (word == "ID" || word == "IDS") {
      made.isStatic = word == "IDS";
      const bool hasNumber = m_in->take('=');
      m_in->skipBlanks();
      const std::optional<int> id = hasNumber ? base::parseInteger(digits()) : std::nullopt;
      if (!id || *id < 1 || *id > 255) {
        return fault(FaultCode::ActionNumber);
      }
      made.id = *id;
      word = m_in->name();
    }
    static constexpr std::array<std::pair<std::string_view, Trigger>, 4> kTriggers{
        {{"WHEN", Trigger::When},
         {"WHENEVER", Trigger::Whenever},
         {"FROM", Trigger::From},
         {"EVERY", Trigger::Every}}};
    for (const auto& [name, trigger] : kTriggers) {
      if (word == name) {
        made.trigger = trigger;
        made.condition = got(m_in->expression());
        if (!made.condition) {
          return false;
        }
        word = m_in->name();
        break;
      }
    }
    if (word != "DO") {
      return fault(FaultCode::ActionMalformed);
    }
    while (!m_in->isAtEnd()) {
      std::optional<Assignment> assignment = got(m_in->assignment());
      if (!assignment) {
        return false;
      }
      const Op op = assignment->target.op;
      if ((op != Op::MainR && op != Op::System) || assignment->initial.kind != Initial::Kind::One) {
        return fault(FaultCode::ActionTarget);
      }
      made.assignments.push_back(std::move(*assignment));
    }
    if (made.assignments.empty()) {
      return fault(FaultCode::ActionMalformed);
    }
    append(std::move(made));
    return true;
  }

  bool m_splits;
  std::set<std::string, std::less<>> m_defined;
};

}  // namespace

void BlockParser::patch(std::optional<std::size_t> branch) {
  if (branch) {
    std::get<Branch>(m_tree.statements[*branch].what).target = here();
  }
}

void BlockParser::patch(const std::vector<std::size_t>& branches) {
  for (const std::size_t branch : branches) {
    patch(std::optional(branch));
  }
}

BlockParser::Open& BlockParser::open(std::string kind, std::optional<std::size_t> branch) {
  Open& made = m_open.emplace_back();
  made.name = kind;
  made.kind = std::move(kind);
  made.place = m_place;
  made.begin = branch.value_or(here());
  made.branch = branch;
  return made;
}

BlockParser::Open& BlockParser::openOn(std::string kind, std::optional<Expression> condition) {
  const bool isFaulty = !condition;
  Open& made =
      open(std::move(kind),
           isFaulty ? std::nullopt : std::optional(append(Branch{std::move(condition), 0})));
  made.isFaulty = isFaulty;
  return made;
}

void BlockParser::closeLoop(const Open& ended) {
  patch(ended.toContinue);
  if (!ended.isFaulty) {
    if (ended.step) {
      append(*ended.step);
    }
    append(Branch{std::nullopt, ended.begin});
  }
  patch(ended.branch);
  patch(ended.toEnd);
}

void BlockParser::finish() {
  for (const Open& open : m_open) {
    patch(open.toEnd);
    if (open.branch) {
      // Where it begins: the end of the text may not be reached.
      m_tree.statements[*open.branch].what = Faulty{{FaultCode::NotClosed, open.name, open.place}};
    } else {
      fault(FaultCode::NotClosed, open.name, open.place);
    }
  }
}

std::string BlockParser::digits() {
  m_in->skipBlanks();
  std::string found;
  while (isDigit(m_in->peek())) {
    found += m_in->peek();
    m_in->take(m_in->peek());
  }
  return found;
}

std::size_t BlockParser::add(Statement made) {
  const Place before = here() == 0 ? Place{} : m_tree.statements.back().place;
  made.beginsBlock = before.line != made.place.line;
  const auto* const assignment = std::get_if<Assignment>(&made.what);
  made.readsMainRun = assignment != nullptr && assignment->target.op == Op::MainR;
  forEachExpression(made, [&made](const Expression& expression) {
    made.readsMainRun = made.readsMainRun || asksMainRun(expression);
  });
  m_tree.statements.push_back(std::move(made));
  return here() - 1;
}

std::unique_ptr<BlockParser> sinumerikParser(Tree& tree, const Language& /*language*/,
                                             Detail detail) {
  return std::make_unique<SinumerikParser>(tree, detail);
}

EndWord endWordOf(const Token& token) {
  if (token.kind == TokenKind::Name && tokenIs(token, "RET")) {
    return EndWord::Ret;
  }
  const double m = token.kind == TokenKind::Word && token.address == 'M' ? token.value : -1.0;
  if (m == 2.0 || m == 30.0) {
    return EndWord::End;
  }
  return m == 17.0 ? EndWord::Return : EndWord::None;
}

Expected<Call> callOf(const Token& token, const Notation& notation, Place place) {
  Call made;
  if (token.address == 'L') {
    for (const char c : token.text) {
      made.name += isBlank(c) ? "" : base::toUpper(std::string_view(&c, 1));
    }
    return made;
  }
  Reader reader(token.text, notation, place);
  made.name = reader.name();
  made.isPlainName = true;
  auto arguments = reader.arguments();
  if (!arguments) {
    return fail(std::move(arguments.error()));
  }
  made.arguments = std::move(*arguments);
  return made;
}

Expression variableNamed(std::string name) {
  Expression made;
  made.op = Op::Variable;
  made.name = std::move(name);
  return made;
}

Expression applied(Op op, Expression left, Expression right) {
  Expression made;
  made.op = op;
  made.place = left.place;
  made.operands.push_back(std::move(left));
  made.operands.push_back(std::move(right));
  return made;
}

Initial only(Expression value) {
  Initial made;
  made.values.emplace_back(std::move(value));
  return made;
}

}  // namespace rivulet::nc
