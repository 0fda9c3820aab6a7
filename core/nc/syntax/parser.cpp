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
#include "nc/modal/vocabulary.h"

namespace rivulet::nc {

namespace {

using base::isDigit;
using base::isNameLetter;

/// Control structures within each other.
constexpr std::size_t kNestingMax = 16;

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

Expression variable(std::string name) {
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

/// Reads one line after another; control structures are closed by back-patching. A function that
/// returns false has added a `Faulty` statement, or the rest of the line is not to be read.
class Parser final : public SteeringParser {
 public:
  Parser(Tree& tree, std::uint16_t file) : m_tree(tree), m_file(file) {}

  void steer(std::string_view text, Place place) override {
    m_line = place.line;
    m_file = place.file;
    m_firstOfBlock = true;
    m_words.words.clear();
    m_text = withoutComment(text);
    Reader reader(m_text, sinumerikNotation(), place);
    m_in = &reader;
    m_readsMainRun = false;
    while (!reader.isAtEnd() && word()) {
    }
  }

  void line(std::string_view raw) {
    ++m_line;
    m_firstOfBlock = true;
    m_ends = false;
    m_returns = false;
    m_dwells = false;
    m_words.words.clear();
    m_text = withoutComment(raw);
    Reader reader(m_text, sinumerikNotation(), {m_line, m_file, 1});
    m_in = &reader;
    reader.skipBlanks();
    if (reader.peek() == '%') {
      return;  // the header of a program in an archive
    }
    prefix();
    m_readsMainRun = false;
    while (!reader.isAtEnd()) {
      if (!word()) {
        return;
      }
    }
    if (!m_words.words.empty()) {
      emit(std::move(m_words));
      m_words = {};
    }
    if (m_ends) {
      emit(End{});
    } else if (m_returns) {
      emit(Return{});
    }
  }

  void finish() override {
    for (const Open& open : m_open) {
      m_line = open.line;
      m_firstOfBlock = true;
      m_readsMainRun = false;
      if (open.branch) {
        patch(*open.branch);
      }
      emit(Faulty{{FaultCode::NotClosed, std::string(nameOf(open.kind)), {open.line, m_file, 1}}});
    }
  }

 private:
  enum class Structure : std::uint8_t { If, While, For, Loop, Repeat };
  struct Open {
    Structure kind = Structure::If;
    std::optional<std::size_t> branch;  ///< to be patched at the end
    std::size_t begin = 0;              ///< where the loop continues
    std::optional<Expression> counter;  ///< For
    base::LineNumber line;
    bool isFaulty = false;  ///< its condition could not be read: its body is not a loop
  };

  static std::string_view nameOf(Structure kind) {
    static constexpr std::array<std::string_view, 5> kNames{"IF", "WHILE", "FOR", "LOOP", "REPEAT"};
    return kNames[static_cast<std::size_t>(kind)];
  }

  static std::string_view withoutComment(std::string_view raw) {
    bool inString = false;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      inString ^= raw[i] == '"';
      if (raw[i] == ';' && !inString) {
        return base::trim(raw.substr(0, i)).empty() ? std::string_view{} : raw.substr(0, i);
      }
    }
    while (!raw.empty() && raw.back() == '\r') {
      raw.remove_suffix(1);
    }
    return raw;
  }

  [[nodiscard]] char ahead(std::size_t by = 1) const {
    const std::string_view rest = m_in->rest();
    return by < rest.size() ? rest[by] : '\0';
  }

  std::string digits() {
    std::string found;
    while (isDigit(m_in->peek())) {
      found += m_in->peek();
      m_in->take(m_in->peek());
    }
    return found;
  }

  /// Block skip, block number and label before a block, in the orders that occur.
  void prefix() {
    for (int i = 0; i < 2; ++i) {
      m_in->skipBlanks();
      if (m_in->take('/')) {
        digits();
        m_in->skipBlanks();
      }
      const char c = m_in->peek();
      if ((c == 'N' || c == 'n' || c == ':') && isDigit(ahead())) {
        m_in->take(c);
        m_tree.labels.push_back({"N" + digits(), m_tree.statements.size()});
      }
    }
    const Reader before = *m_in;
    std::string label = m_in->name();
    if (label.size() >= 2 && isNameLetter(label[1]) && m_in->peek() == ':') {
      m_in->take(':');
      m_tree.labels.push_back({std::move(label), m_tree.statements.size()});
    } else {
      m_in->restore(before);
    }
  }

  template <class What>
  std::size_t emit(What what) {
    Statement& made = m_tree.statements.emplace_back();
    made.place = {m_line, m_file, m_wordColumn};
    made.beginsBlock = std::exchange(m_firstOfBlock, false);
    made.readsMainRun = std::exchange(m_readsMainRun, false);
    made.what = std::move(what);
    return m_tree.statements.size() - 1;
  }

  bool fault(Fault fault) {
    emit(Faulty{std::move(fault)});
    return false;
  }
  bool fault(FaultCode code, std::string argument = {}) {
    return fault(Fault{code, std::move(argument), m_in->place()});
  }

  void patch(std::size_t branch) {
    std::get<Branch>(m_tree.statements[branch].what).target = m_tree.statements.size();
  }

  /// Takes the value out, or adds the fault.
  template <class T>
  std::optional<T> got(Expected<T> read) {
    if (!read) {
      fault(std::move(read.error()));
      return std::nullopt;
    }
    return std::move(*read);
  }

  std::optional<Expression> noted(std::optional<Expression> expression) {
    m_readsMainRun = m_readsMainRun || (expression && asksMainRun(*expression));
    return expression;
  }
  std::optional<Expression> expression() { return noted(got(m_in->expression())); }

  bool expect(char c) {
    return m_in->take(c) || fault(c == '=' ? FaultCode::EqualsMissing : FaultCode::SyntaxCharacter,
                                  std::string(1, c));
  }

  // --- words --------------------------------------------------------------------------------

  /// @return false if the rest of the line is not to be read
  bool word() {
    m_wordColumn = m_in->place().column;
    const Reader before = *m_in;
    const char c = m_in->peek();
    if (c == '$') {
      return assignment();
    }
    std::string name = m_in->name();
    if (name.empty()) {
      return fault(FaultCode::SyntaxCharacter, std::string(1, c));
    }
    const bool isR = name[0] == 'R' && std::all_of(name.begin() + 1, name.end(), isDigit);
    if (isR || m_defined.contains(name)) {
      m_in->restore(before);
      return assignment();
    }
    if (name.size() > 1 && !isDigit(name[1])) {
      return keyword(std::move(name), before);
    }
    m_in->restore(before);
    m_in->take(c);
    return address(base::toUpper(std::string_view(&c, 1)));
  }

  /// A letter with its value. The reader is after the letter.
  bool address(std::string letter) {
    Word made;
    made.address = std::move(letter);
    made.place = {m_line, m_file, m_wordColumn};
    const char c = made.address[0];
    if (c == 'L') {
      return call("L" + digits(), false);
    }
    // M1=3, M[n]=3 and I1=5: a number before '='.
    const Reader before = *m_in;
    const std::string number = digits();
    m_in->skipBlanks();
    const bool hasExtension = std::string_view("GMSHTDF").find(c) != std::string_view::npos;
    if (!number.empty() && m_in->peek() == '=') {
      if (hasExtension) {
        made.extension = Expression::constant(base::parseNumber(number).value_or(0.0));
      } else {
        made.address += number;
      }
    } else {
      m_in->restore(before);
      if (hasExtension && m_in->take('[')) {
        made.extension = expression();
        if (!made.extension || !expect(']')) {
          return false;
        }
      }
    }
    if (!wordValue(made)) {
      return false;
    }
    return add(std::move(made));
  }

  bool wordValue(Word& made) {
    m_in->skipBlanks();
    if (!m_in->take('=')) {
      made.value = got(m_in->literal());
      return made.value.has_value();
    }
    const Reader before = *m_in;
    static constexpr std::array<std::pair<std::string_view, Word::Reference>, 5> kReferences{
        {{"AC", Word::Reference::Absolute},
         {"IC", Word::Reference::Incremental},
         {"DC", Word::Reference::Absolute},
         {"ACP", Word::Reference::Absolute},
         {"ACN", Word::Reference::Absolute}}};
    const std::string name = m_in->name();
    for (const auto& [word, reference] : kReferences) {
      if (name == word) {
        if (m_in->peek() != '(') {
          return fault(FaultCode::ArgumentsMissing, name);
        }
        made.reference = reference;
        made.value = expression();
        return made.value.has_value();
      }
    }
    m_in->restore(before);
    made.value = expression();
    return made.value.has_value();
  }

  bool add(Word made) {
    const bool isNumber = made.value && made.value->op == Op::Number;
    if (made.address == "G" && isNumber && made.value->number == 4.0) {
      m_dwells = true;
      return true;
    }
    if (made.address == "F" && m_dwells) {
      m_dwells = false;
      emit(Dwell{std::move(*made.value)});
      return true;
    }
    if (made.address == "M" && isNumber && !made.extension) {
      // The end comes after whatever else is in the block.
      const double number = made.value->number;
      m_ends = m_ends || number == 2.0 || number == 30.0;
      m_returns = m_returns || number == 17.0;
    }
    m_words.words.push_back(std::move(made));
    return true;
  }

  bool assignment() {
    std::optional<Assignment> made = got(m_in->assignment());
    if (!made) {
      return false;
    }
    m_readsMainRun = m_readsMainRun || made->target.op == Op::MainR;
    for (const Expression& index : made->target.operands) {
      m_readsMainRun = m_readsMainRun || asksMainRun(index);
    }
    for (const std::optional<Expression>& value : made->initial.values) {
      m_readsMainRun = m_readsMainRun || (value && asksMainRun(*value));
    }
    emit(std::move(*made));
    return true;
  }

  /// A name of two letters or more. @param before  what precedes it
  bool keyword(std::string name, const Reader& before) {
    if (const std::optional<bool> done = structure(name)) {
      return *done;
    }
    if (const std::optional<bool> done = statement(name)) {
      return *done;
    }
    Word made;
    made.address = name;
    made.place = {m_line, m_file, m_wordColumn};
    const NameEffect effect = nameEffect(Dialect::Sinumerik, name);
    m_in->skipBlanks();
    if (effect != NameEffect::Unknown && effect != NameEffect::Cycle && m_in->peek() != '[') {
      // A mode, an address, or what says something of the program: FGROUP(X,Y).
      if (effect == NameEffect::Address || m_in->peek() == '=') {
        return wordValue(made) && add(std::move(made));
      }
      return got(m_in->arguments()) && add(std::move(made));
    }
    if (m_in->peek() == '=' || m_in->peek() == '[') {
      m_in->restore(before);
      return assignment();  // of what is not defined in this text
    }
    // What is none of the language's own words is the name of a program.
    if (m_in->peek() == '(' || (m_firstOfBlock && m_words.words.empty())) {
      return call(std::move(name), true);
    }
    return fault(FaultCode::NotDefined, std::move(name));
  }

  std::optional<bool> statement(const std::string& name) {
    if (const std::optional<JumpDirection> direction = jumpDirection(name)) {
      return jump(std::nullopt, *direction);
    }
    if (name == "STOPRE") {
      emit(PreprocessingStop{});
      return true;
    }
    if (name == "MSG") {
      return message();
    }
    if (name == "DEF") {
      return definition();
    }
    if (name == "RET") {
      m_returns = true;
      return restIsIgnored();
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
      return program.empty() ? fault(FaultCode::NameMissing) : call(std::move(program), false);
    }
    if (name == "CANCEL") {
      std::optional<Expression> id;
      return expect('(') && (id = expression()) && expect(')') &&
             (emit(Cancel{std::move(*id)}), true);
    }
    if (nameEffect(Dialect::Sinumerik, name) == NameEffect::Frame) {
      return frame(name);
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

  bool open(Structure kind, std::optional<std::size_t> branch, std::size_t begin,
            std::optional<Expression> counter = std::nullopt) {
    if (m_open.size() == kNestingMax) {
      return fault(FaultCode::StructuresTooDeep);
    }
    m_open.push_back({kind, branch, begin, std::move(counter), m_line, false});
    return true;
  }

  /// What closes a structure must find it, also where its condition cannot be read.
  bool openFaulty(Structure kind) {
    m_open.push_back({kind, std::nullopt, 0, std::nullopt, m_line, true});
    return false;
  }

  /// Closes the innermost structure, which must be of this kind.
  std::optional<Open> close(Structure kind, std::string_view word) {
    if (m_open.empty() || m_open.back().kind != kind) {
      fault(FaultCode::NoBeginning, std::string(word));
      return std::nullopt;
    }
    Open open = std::move(m_open.back());
    m_open.pop_back();
    return open;
  }

  [[nodiscard]] std::size_t here() const { return m_tree.statements.size(); }

  std::optional<bool> structure(const std::string& word) {
    if (word == "IF") {
      return ifWord();
    }
    if (word == "ELSE") {
      const std::optional<Open> ended = close(Structure::If, word);
      if (!ended) {
        return false;
      }
      const std::size_t jump = emit(Branch{});
      if (ended->branch) {
        patch(*ended->branch);
      }
      return open(Structure::If, jump, 0);
    }
    if (word == "ENDIF") {
      const std::optional<Open> ended = close(Structure::If, word);
      if (ended && ended->branch) {
        patch(*ended->branch);
      }
      return ended.has_value();
    }
    if (word == "WHILE") {
      std::optional<Expression> condition = expression();
      if (!condition) {
        return openFaulty(Structure::While);
      }
      const std::size_t begin = emit(Branch{std::move(condition), 0});
      return open(Structure::While, begin, begin);
    }
    if (word == "LOOP") {
      return open(Structure::Loop, std::nullopt, here());
    }
    if (word == "FOR") {
      return forWord();
    }
    if (word == "ENDWHILE" || word == "ENDLOOP" || word == "ENDFOR") {
      const Structure kind = word == "ENDWHILE"  ? Structure::While
                             : word == "ENDLOOP" ? Structure::Loop
                                                 : Structure::For;
      const std::optional<Open> ended = close(kind, word);
      if (!ended) {
        return false;
      }
      if (ended->isFaulty) {
        return true;
      }
      if (ended->counter) {
        emit(Assignment{*ended->counter,
                        only(applied(Op::Add, *ended->counter, Expression::constant(1.0)))});
      }
      emit(Branch{std::nullopt, ended->begin});
      if (ended->branch) {
        patch(*ended->branch);
      }
      return true;
    }
    if (word == "REPEAT" || word == "REPEATB") {
      return repeat(word == "REPEATB");
    }
    if (word == "UNTIL") {
      const std::optional<Open> ended = close(Structure::Repeat, word);
      std::optional<Expression> condition = ended ? expression() : std::nullopt;
      return condition && (emit(Branch{std::move(condition), ended->begin}), true);
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
      return text.find("GOTO") == std::string::npos && openFaulty(Structure::If);
    }
    const std::string word = m_in->name();
    if (const std::optional<JumpDirection> direction = jumpDirection(word)) {
      return jump(std::move(condition), *direction);
    }
    if (!word.empty() || !m_in->isAtEnd()) {
      return fault(FaultCode::IfMalformed);
    }
    const std::size_t branch = emit(Branch{std::move(condition), 0});
    return open(Structure::If, branch, 0);
  }

  /// The limit is computed once, into a variable no program can name.
  bool forWord() {
    std::optional<Expression> counter = got(m_in->target());
    if (!counter) {
      return openFaulty(Structure::For);
    }
    std::optional<Expression> first = expect('=') ? expression() : std::nullopt;
    if (!first) {
      return openFaulty(Structure::For);
    }
    if (!m_in->takeWord("TO")) {
      fault(FaultCode::ForMalformed);
      return openFaulty(Structure::For);
    }
    std::optional<Expression> last = expression();
    if (!last) {
      return openFaulty(Structure::For);
    }
    Definition limit;
    limit.name = fmt::format("FOR {}", here());
    limit.initial = only(std::move(*last));
    const Expression hidden = variable(limit.name);
    emit(Assignment{*counter, only(std::move(*first))});
    emit(std::move(limit));
    const std::size_t begin = emit(Branch{applied(Op::LessEqual, *counter, hidden), 0});
    return open(Structure::For, begin, begin, std::move(counter));
  }

  /// REPEAT alone begins a loop; with a label it repeats what stands there.
  bool repeat(bool isBlockOnly) {
    if (m_in->isAtEnd() && !isBlockOnly) {
      return open(Structure::Repeat, std::nullopt, here());
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
        return times(made.times) && (emit(std::move(made)), true);
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
    emit(std::move(made));
    return true;
  }

  /// P5, P=R1. The reader is before P.
  bool times(std::optional<Expression>& made) {
    m_in->take(m_in->peek());
    made = m_in->take('=') ? expression() : got(m_in->literal());
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
    while (!m_in->isAtEnd()) {
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
    emit(Jump{std::move(condition), direction, std::move(label), std::nullopt});
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
      if (made.initial) {
        for (const std::optional<Expression>& value : made.initial->values) {
          m_readsMainRun = m_readsMainRun || (value && asksMainRun(*value));
        }
      }
      emit(std::move(made));
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
    return restIsIgnored();
  }

  /// Behind the name: arguments, then how often.
  bool call(std::string name, bool isPlainName) {
    Call made;
    made.name = std::move(name);
    made.isPlainName = isPlainName;
    return finish(std::move(made));
  }

  bool finish(Call made) {
    auto arguments = got(m_in->arguments());
    if (!arguments) {
      return false;
    }
    made.arguments = std::move(*arguments);
    for (const std::optional<Expression>& argument : made.arguments) {
      noted(argument);
    }
    m_in->skipBlanks();
    const char c = m_in->peek();
    if ((c == 'P' || c == 'p') && (isDigit(ahead()) || ahead() == '=') && !times(made.times)) {
      return false;
    }
    emit(std::move(made));
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

  // --- frames, messages, synchronized actions -----------------------------------------------

  bool frame(const std::string& name) {
    FrameStatement made;
    made.name = name;
    while (!m_in->isAtEnd()) {
      Word word;
      word.place = m_in->place();
      if (m_in->takeWord("RPL")) {
        word.address = "RPL";
      } else {
        const char c = m_in->peek();
        if (!isNameLetter(c)) {
          return fault(FaultCode::SyntaxCharacter, std::string(1, c));
        }
        m_in->take(c);
        word.address = base::toUpper(std::string_view(&c, 1));
        if (std::string_view("XYZABCUVW").find(word.address) == std::string_view::npos) {
          return fault(FaultCode::UnknownWord, word.address);
        }
      }
      if (!wordValue(word)) {
        return false;
      }
      made.words.push_back(std::move(word));
    }
    emit(std::move(made));
    return true;
  }

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
    emit(std::move(made));
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
    emit(std::move(made));
    return true;
  }

  Tree& m_tree;
  std::uint16_t m_file;
  base::LineNumber m_line;
  std::string_view m_text;
  Reader* m_in = nullptr;
  int m_wordColumn = 1;
  bool m_firstOfBlock = true;
  bool m_readsMainRun = false;
  bool m_dwells = false;
  bool m_ends = false;
  bool m_returns = false;
  Words m_words;
  std::vector<Open> m_open;
  std::set<std::string, std::less<>> m_defined;
};

}  // namespace

Tree parseSinumerik(std::string_view text, std::uint16_t file) {
  Tree tree;
  Parser parser(tree, file);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    parser.line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  parser.finish();
  return tree;
}

std::unique_ptr<SteeringParser> sinumerikSteering(Tree& tree) {
  return std::make_unique<Parser>(tree, std::uint16_t{0});
}

}  // namespace rivulet::nc
