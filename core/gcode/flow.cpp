// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"

namespace rivulet::gcode {

namespace {

constexpr std::size_t kLevelsMax = 32;
constexpr int kTimesMax = 1'000'000;

using base::isBlank;
using base::isDigit;
using base::isNameLetter;

void skipBlanks(std::string_view& text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
}

/// The name at the front, in upper case; taken off.
std::string takeName(std::string_view& text) {
  skipBlanks(text);
  std::size_t end = 0;
  while (end < text.size() && (isNameLetter(text[end]) || (end > 0 && isDigit(text[end])))) {
    ++end;
  }
  std::string name = base::toUpper(text.substr(0, end));
  text.remove_prefix(end);
  return name;
}

std::string_view takeDigits(std::string_view& text) {
  skipBlanks(text);
  std::size_t end = 0;
  while (end < text.size() && isDigit(text[end])) {
    ++end;
  }
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

/// What a line begins with, behind block skip and block number.
struct LineHead {
  std::optional<int> number;
  std::string label;
  std::string word;       ///< first name behind the label
  std::string_view rest;  ///< behind `word`
};

LineHead headOf(std::string_view line) {
  LineHead head;
  skipBlanks(line);
  if (!line.empty() && line.front() == '/') {
    line.remove_prefix(1);
    skipBlanks(line);
  }
  if (line.size() > 1 && (line[0] == 'N' || line[0] == 'n' || line[0] == ':') && isDigit(line[1])) {
    line.remove_prefix(1);
    head.number = base::parseInteger(takeDigits(line));
  }
  head.rest = line;
  head.word = takeName(head.rest);
  if (!head.word.empty() && !head.rest.empty() && head.rest.front() == ':') {
    head.label = std::move(head.word);
    head.rest.remove_prefix(1);
    head.word = takeName(head.rest);
  }
  return head;
}

/// "O100 while [..]": number or name, word, rest.
struct OHead {
  std::string id;
  std::string word;
  std::string_view rest;
};

std::optional<OHead> oHeadOf(std::string_view line) {
  skipBlanks(line);
  if (line.size() > 1 && (line[0] == 'N' || line[0] == 'n') && isDigit(line[1])) {
    line.remove_prefix(1);
    takeDigits(line);
    skipBlanks(line);
  }
  if (line.empty() || (line[0] != 'O' && line[0] != 'o')) {
    return std::nullopt;
  }
  line.remove_prefix(1);
  skipBlanks(line);
  OHead head;
  if (!line.empty() && line.front() == '<') {
    const std::size_t end = line.find('>');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    for (const char c : line.substr(0, end + 1)) {
      if (!isBlank(c)) {
        head.id += c;
      }
    }
    head.id = base::toUpper(head.id);
    line.remove_prefix(end + 1);
  } else {
    const std::string_view digits = takeDigits(line);
    if (digits.empty()) {
      return std::nullopt;
    }
    head.id = std::to_string(base::parseInteger(digits).value_or(-1));
  }
  head.word = takeName(line);
  head.rest = line;
  return head;
}

std::string_view withoutComment(std::string_view text, bool bracketComments) {
  std::size_t end = text.find(';');
  if (bracketComments) {
    end = std::min(end, text.find('('));
  }
  return base::trim(text.substr(0, end));
}

}  // namespace

Flow::Flow(std::string_view text, Dialect dialect, Calculator& calculator,
           const LoadOptions& options)
    : m_dialect(dialect), m_calculator(calculator), m_options(options), m_lexer(text, dialect) {
  m_sources.push_back({});
  m_sources.back().text = text;
  m_sources.back().isFile = true;
  m_levels.push_back({});
  m_levels.back().source = &m_sources.back();
  m_levels.back().entry = m_lexer.place();
}

bool Flow::isElsewhere() const {
  return !m_levels.back().source->isFile;
}

std::size_t Flow::fileLines() {
  if (!m_hasJumped) {
    // Nothing was left out up to here; what stands behind the end was not read.
    while (m_lexer.nextLine()) {
    }
    return m_lexer.place().line;
  }
  Lexer lexer(m_sources.front().text, m_dialect);
  while (lexer.nextLine()) {
  }
  return lexer.place().line;
}

bool Flow::next(Block& block) {
  for (;;) {
    if (m_stopped) {
      return false;
    }
    m_current = m_lexer.place();
    if (m_lexer.next(block)) {
      break;
    }
    if (!leaveSubprogram()) {
      return false;
    }
  }
  ++m_executed;
  if (!isElsewhere()) {
    m_line = block.line;
  } else {
    block.line = m_line;
  }
  if (m_hasJumped && m_executed > m_fileLines + m_options.repeatedLinesMax) {
    m_stopped = fault(DiagnosticCode::EndlessLoop, fmt::format("{}", m_options.repeatedLinesMax));
    m_stoppedLine = m_jumpedFrom;
    return false;
  }
  return true;
}

std::optional<std::string_view> Flow::passLine() {
  ++m_executed;
  return m_lexer.nextLine();
}

void Flow::jump(Place target) {
  if (!m_hasJumped) {
    m_hasJumped = true;
    m_fileLines = static_cast<std::size_t>(
        std::count(m_sources.front().text.begin(), m_sources.front().text.end(), '\n'));
  }
  if (target.line <= m_current.line) {
    m_jumpedFrom = m_line;
  }
  m_lexer.seek(target);
}

Flow::Outcome Flow::fault(DiagnosticCode code, std::string argument) {
  return {Outcome::Kind::Fault, code, std::move(argument)};
}

Flow::Outcome Flow::calculationFault() {
  return fault(DiagnosticCode::ExpressionFault, m_calculator.problem());
}

// --- places ---------------------------------------------------------------------------------

void Flow::index(Source& source) {
  if (source.indexed) {
    return;
  }
  source.indexed = true;
  Lexer lexer(source.text, m_dialect);
  for (Place place = lexer.place(); const auto line = lexer.nextLine(); place = lexer.place()) {
    if (line->rfind("%_N_", 0) == 0) {
      // The header of a program in an archive: %_N_NAME_SPF.
      const std::string name = base::toUpper(base::trim(line->substr(4)));
      const std::size_t end = name.rfind('_');
      source.subprograms.emplace(name.substr(0, end), lexer.place());
      continue;
    }
    if (m_dialect == Dialect::Sinumerik) {
      LineHead head = headOf(*line);
      if (!head.label.empty()) {
        source.labels.emplace(std::move(head.label), place);
      }
      if (head.number) {
        source.numbers.emplace(*head.number, place);
      }
      if (head.word == "PROC") {
        source.subprograms.emplace(takeName(head.rest), place);
      }
      continue;
    }
    if (const std::optional<OHead> head = oHeadOf(*line)) {
      if (head->word == "SUB") {
        source.subprograms.emplace("O" + head->id, lexer.place());
      } else if (head->word.empty()) {
        source.subprograms.emplace("O" + head->id, lexer.place());
      }
      continue;
    }
    std::string_view text = base::trim(*line);
    if (text.size() > 1 && text[0] == ':' && isDigit(text[1])) {
      text.remove_prefix(1);
      const std::optional<int> number = base::parseInteger(takeDigits(text));
      source.subprograms.emplace(fmt::format("O{}", number.value_or(-1)), lexer.place());
      continue;
    }
    if (const LineHead head = headOf(*line); head.number) {
      source.numbers.emplace(*head.number, place);
    }
  }
}

std::optional<std::pair<Flow::Source*, Place>> Flow::findSubprogram(const std::string& name) {
  for (Source* const source : {level().source, &m_sources.front()}) {
    index(*source);
    if (const auto found = source->subprograms.find(name); found != source->subprograms.end()) {
      return std::pair(source, found->second);
    }
  }
  for (Source& source : m_sources) {
    if (!source.isFile && source.subprograms.count("=" + name) > 0) {
      return std::pair(&source, source.subprograms.at("=" + name));
    }
  }
  if (!m_options.subprogram) {
    return std::nullopt;
  }
  std::optional<std::string> text = m_options.subprogram(name);
  if (!text) {
    return std::nullopt;
  }
  m_sources.push_back({});
  Source& source = m_sources.back();
  source.own = std::move(*text);
  source.text = source.own;
  index(source);
  // A file of its own begins with the subprogram of its name, or is all of it.
  const auto own = source.subprograms.find(name);
  const Place entry =
      own != source.subprograms.end() ? own->second : Lexer(source.text, m_dialect).place();
  source.subprograms.emplace("=" + name, entry);
  return std::pair(&source, entry);
}

void Flow::enter(Source& source, Place entry, int times, Scope scope,
                 std::optional<std::string> arguments) {
  Level entered;
  entered.source = &source;
  entered.back = m_lexer.place();
  entered.entry = entry;
  entered.left = times;
  entered.arguments = std::move(arguments);
  entered.scope = scope;
  m_calculator.enter(std::move(scope));
  m_levels.push_back(std::move(entered));
  if (source.text.data() == m_levels[m_levels.size() - 2].source->text.data()) {
    jump(entry);
  } else {
    jump(m_lexer.place());
    m_lexer = Lexer(source.text, m_dialect);
    m_lexer.seek(entry);
  }
}

bool Flow::leaveSubprogram() {
  if (m_levels.size() < 2) {
    return false;
  }
  Level& left = level();
  if (--left.left > 0) {
    m_calculator.leave();
    m_calculator.enter(left.scope);
    left.controls.clear();
    left.repeats.clear();
    jump(left.entry);
    return true;
  }
  const Place back = left.back;
  const bool same = left.source == m_levels[m_levels.size() - 2].source;
  m_calculator.leave();
  m_levels.pop_back();
  if (!same) {
    m_lexer = Lexer(level().source->text, m_dialect);
  }
  m_lexer.seek(back);
  return true;
}

// --- calls ----------------------------------------------------------------------------------

Flow::Outcome Flow::call(const std::string& name, std::string_view arguments, int times) {
  if (m_levels.size() >= kLevelsMax) {
    return fault(DiagnosticCode::FlowFault, "subprograms call each other too deeply");
  }
  const auto found = findSubprogram(name);
  if (!found) {
    return fault(DiagnosticCode::SubprogramMissing, name);
  }
  if (times < 1) {
    return {};
  }
  enter(*found->first, found->second, std::min(times, kTimesMax), {}, std::string(arguments));
  return {};
}

Flow::Outcome Flow::callNumber(int number, int times, std::map<int, double> numbers) {
  if (m_levels.size() >= kLevelsMax) {
    return fault(DiagnosticCode::FlowFault, "subprograms call each other too deeply");
  }
  const std::string name = fmt::format("O{}", number);
  const auto found = findSubprogram(name);
  if (!found) {
    return fault(DiagnosticCode::SubprogramMissing, name);
  }
  if (times < 1) {
    return {};
  }
  // M98 shares the variables of the caller, G65 has its own.
  Scope scope = m_calculator.scope();
  if (!numbers.empty()) {
    scope = {};
    scope.numbers = std::move(numbers);
  }
  enter(*found->first, found->second, std::min(times, kTimesMax), std::move(scope), std::nullopt);
  return {};
}

Flow::Outcome Flow::procedure(std::string_view rest) {
  takeName(rest);
  skipBlanks(rest);
  const std::size_t close = rest.rfind(')');
  if (rest.empty() || rest.front() != '(' || close == std::string_view::npos) {
    level().arguments.reset();
    return {};
  }
  if (!level().arguments) {
    return {};  // started as the main program: what it would be given is not known
  }
  std::string_view parameters = rest.substr(1, close - 1);
  const std::string givenText = *std::exchange(level().arguments, std::nullopt);
  std::string_view given = givenText;
  // The arguments are the caller's: they are computed with its variables.
  Scope own = m_calculator.scope();
  m_calculator.leave();
  std::vector<std::pair<std::string, std::string>> definitions;
  Outcome outcome;
  while (!base::trim(parameters).empty()) {
    const std::size_t comma = parameters.find(',');
    std::string_view parameter = base::trim(parameters.substr(0, comma));
    parameters.remove_prefix(comma == std::string_view::npos ? parameters.size() : comma + 1);
    std::string type = takeName(parameter);
    if (type == "VAR") {
      type = takeName(parameter);
    }
    if (type == "STRING" && !parameter.empty() && parameter.front() == '[') {
      parameter.remove_prefix(std::min(parameter.size(), parameter.find(']') + 1));
      type = "STRING[200]";
    }
    const std::string name = takeName(parameter);
    std::string definition = type + " " + name + std::string(parameter);
    skipBlanks(given);
    if (!given.empty() && given.front() != ',') {
      if (given.front() == '"') {
        const std::size_t end = given.find('"', 1);
        definition = type + " " + name + "=" + std::string(given.substr(0, end + 1));
        given.remove_prefix(end == std::string_view::npos ? given.size() : end + 1);
      } else {
        const std::optional<double> value = m_calculator.take(given);
        if (!value) {
          outcome = calculationFault();
          break;
        }
        definition = type + " " + name + "=" + base::formatNumber(*value);
      }
      skipBlanks(given);
    }
    if (!given.empty() && given.front() == ',') {
      given.remove_prefix(1);
    }
    definitions.emplace_back(name, definition);
  }
  m_calculator.enter(std::move(own));
  for (const auto& [name, definition] : definitions) {
    if (!m_calculator.define(definition)) {
      return calculationFault();
    }
  }
  return outcome;
}

// --- statements -----------------------------------------------------------------------------

Flow::Outcome Flow::execute(std::string_view statement) {
  if (m_dialect != Dialect::Sinumerik && !statement.empty() &&
      (statement.front() == 'O' || statement.front() == 'o')) {
    return oWord(statement);
  }
  std::string_view rest = statement;
  std::string word = takeName(rest);
  if (m_dialect == Dialect::Heidenhain) {
    std::string_view behind = rest;
    if (word == "CALL" && takeName(behind) == "PGM") {
      return fault(DiagnosticCode::SubprogramMissing, std::string(base::trim(behind)));
    }
    return fault(DiagnosticCode::UnsupportedExpression, word);
  }
  return m_dialect == Dialect::Sinumerik ? sinumerik(word, rest) : iso(word, rest);
}

std::string Flow::skipStructure(std::string_view open, std::string_view close,
                                std::string_view alternative) {
  int depth = 0;
  while (const auto line = passLine()) {
    const LineHead head = headOf(*line);
    const bool jumps =
        open == "IF" &&
        base::toUpper(withoutComment(head.rest, false)).find("GOTO") != std::string::npos;
    const bool repeatsLabel = open == "REPEAT" && !withoutComment(head.rest, false).empty();
    if (head.word == open && !jumps && !repeatsLabel) {
      ++depth;
    } else if (head.word == close) {
      if (depth-- == 0) {
        return head.word;
      }
    } else if (depth == 0 && !alternative.empty() && head.word == alternative) {
      return head.word;
    }
  }
  return {};
}

Flow::Outcome Flow::goTo(std::string_view kind, std::string_view& rest) {
  skipBlanks(rest);
  Source& source = *level().source;
  index(source);
  if (kind == "GOTOS") {
    jump(level().entry);
    return {};
  }
  std::vector<Place> places;
  std::string target;
  if (!rest.empty() && isDigit(rest.front())) {
    target = std::string(takeDigits(rest));
  } else {
    target = takeName(rest);
    if (!rest.empty() && rest.front() == ':') {
      rest.remove_prefix(1);
    }
  }
  const auto [from, to] = source.labels.equal_range(target);
  for (auto label = from; label != to; ++label) {
    places.push_back(label->second);
  }
  std::string_view digits = target;
  if (places.empty() && !digits.empty()) {
    if (digits.front() == 'N') {
      digits.remove_prefix(1);
    }
    if (const std::optional<int> number = base::parseInteger(digits)) {
      const auto [first, last] = source.numbers.equal_range(*number);
      for (auto place = first; place != last; ++place) {
        places.push_back(place->second);
      }
    }
  }
  std::sort(places.begin(), places.end(), [](Place a, Place b) { return a.line < b.line; });
  const auto ahead = std::find_if(places.begin(), places.end(),
                                  [this](Place place) { return place.line > m_current.line; });
  std::optional<Place> forward = ahead == places.end() ? std::nullopt : std::optional(*ahead);
  std::optional<Place> backward =
      ahead == places.begin() ? std::nullopt : std::optional(*std::prev(ahead));
  std::optional<Place> chosen = kind == "GOTOB"   ? backward
                                : kind == "GOTOF" ? forward
                                                  : (forward ? forward : backward);
  if (!chosen) {
    return kind == "GOTOC"
               ? Outcome{}
               : fault(DiagnosticCode::FlowFault, fmt::format("the target {} is missing", target));
  }
  // Loops that the jump leaves are forgotten; a loop around its target goes on.
  std::vector<Control>& controls = level().controls;
  const Place before = m_lexer.place();
  while (!controls.empty()) {
    const bool behindHead = chosen->line >= controls.back().head.line;
    bool beforeEnd = true;
    if (chosen->line > m_current.line) {
      // Forward: out of the loop if its end lies in between.
      static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPairs{
          {{"WHILE", "ENDWHILE"}, {"FOR", "ENDFOR"}, {"LOOP", "ENDLOOP"}, {"REPEAT", "UNTIL"}}};
      const auto which = static_cast<std::size_t>(controls.back().kind);
      if (which < kPairs.size()) {
        m_lexer.seek(before);
        beforeEnd = skipStructure(kPairs[which].first, kPairs[which].second, {}).empty() ||
                    m_lexer.place().line > chosen->line;
      }
    }
    if (behindHead && beforeEnd) {
      break;
    }
    controls.pop_back();
  }
  m_lexer.seek(before);
  jump(*chosen);
  return {};
}

Flow::Outcome Flow::sinumerik(const std::string& word, std::string_view rest) {
  if (word.rfind("GOTO", 0) == 0) {
    return goTo(word, rest);
  }
  if (word == "IF") {
    return condition(rest);
  }
  if (word == "ELSE") {
    return skipStructure("IF", "ENDIF", {}).empty()
               ? fault(DiagnosticCode::FlowFault, "ENDIF is missing")
               : Outcome{};
  }
  if (word == "ENDIF" || word == "EXTERN" || word == "DEFAULT") {
    return {};
  }
  if (word == "DEF") {
    return m_calculator.define(rest) ? Outcome{} : calculationFault();
  }
  if (word == "PROC") {
    return procedure(rest);
  }
  if (word == "CASE") {
    return caseOf(rest);
  }
  if (word == "WHILE") {
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    if (*value == 0.0) {
      return skipStructure("WHILE", "ENDWHILE", {}).empty()
                 ? fault(DiagnosticCode::FlowFault, "ENDWHILE is missing")
                 : Outcome{};
    }
    level().controls.push_back({Control::Kind::While, {}, m_current, {}, 0.0, 0});
    return {};
  }
  if (word == "FOR") {
    const std::string name = takeName(rest);
    skipBlanks(rest);
    // FOR i = a TO b
    const std::string upper = base::toUpper(rest);
    const std::size_t to = upper.rfind(" TO ");
    if (m_calculator.find(name) == nullptr && name[0] != 'R') {
      return fault(DiagnosticCode::ExpressionFault, fmt::format("{} is not defined", name));
    }
    if (to == std::string::npos) {
      return fault(DiagnosticCode::FlowFault, "FOR is written FOR i = a TO b");
    }
    if (!m_calculator.assign(name + std::string(rest.substr(0, to)))) {
      return calculationFault();
    }
    const std::optional<double> limit = m_calculator.evaluate(rest.substr(to + 4));
    const std::optional<double> first = limit ? m_calculator.evaluate(name) : std::nullopt;
    if (!first) {
      return calculationFault();
    }
    if (*first > *limit) {
      return skipStructure("FOR", "ENDFOR", {}).empty()
                 ? fault(DiagnosticCode::FlowFault, "ENDFOR is missing")
                 : Outcome{};
    }
    level().controls.push_back({Control::Kind::For, {}, m_lexer.place(), name, *limit, 0});
    return {};
  }
  if (word == "LOOP") {
    level().controls.push_back({Control::Kind::Loop, {}, m_lexer.place(), {}, 0.0, 0});
    return {};
  }
  if (word == "REPEAT") {
    return repeat(rest);
  }
  if (word == "ENDWHILE" || word == "ENDFOR" || word == "ENDLOOP" || word == "UNTIL") {
    return loopEnd(word, rest);
  }
  if (word == "SETINT") {
    return {Outcome::Kind::Ignored, DiagnosticCode::IgnoredCode, word};  // runs on an input only
  }
  if (word == "MCALL") {
    return {Outcome::Kind::ModalCall, DiagnosticCode::CycleNotRun, takeName(rest)};
  }
  if (word == "CALL" || word == "EXTCALL" || word == "PCALL") {
    // CALL "NAME", EXTCALL("/folder/NAME.SPF"), PCALL name(arguments)
    std::string_view name = base::trim(rest);
    std::string_view arguments;
    if (word == "PCALL") {
      const std::size_t open = name.find('(');
      arguments = open == std::string_view::npos ? "" : name.substr(open + 1);
      arguments = arguments.substr(0, arguments.rfind(')'));
      name = base::trim(name.substr(0, open));
    }
    if (const std::size_t open = name.find('"'); open != std::string_view::npos) {
      name = name.substr(open + 1);
      name = name.substr(0, name.find('"'));
    }
    name = name.substr(name.find_last_of("/\\:") + 1);
    std::string upper = base::toUpper(name);
    if (upper.size() > 4 &&
        (upper.rfind(".SPF") == upper.size() - 4 || upper.rfind(".MPF") == upper.size() - 4)) {
      upper.resize(upper.size() - 4);
    }
    return call(upper, arguments, 1);
  }
  return fault(DiagnosticCode::UnsupportedExpression, word);
}

Flow::Outcome Flow::condition(std::string_view rest) {
  // Several "IF condition GOTO target" may stand in one block.
  for (;;) {
    const std::optional<double> value = m_calculator.take(rest);
    if (!value) {
      return calculationFault();
    }
    skipBlanks(rest);
    if (rest.empty()) {
      if (*value != 0.0) {
        return {};
      }
      return skipStructure("IF", "ENDIF", "ELSE").empty()
                 ? fault(DiagnosticCode::FlowFault, "ENDIF is missing")
                 : Outcome{};
    }
    const std::string kind = takeName(rest);
    if (kind.rfind("GOTO", 0) != 0) {
      return fault(DiagnosticCode::FlowFault, "behind a condition stands GOTO or nothing");
    }
    if (*value != 0.0) {
      return goTo(kind, rest);
    }
    takeName(rest);
    skipBlanks(rest);
    takeDigits(rest);
    std::string_view ahead = rest;
    if (takeName(ahead) != "IF") {
      return {};
    }
    rest = ahead;
  }
}

Flow::Outcome Flow::loopEnd(const std::string& word, std::string_view rest) {
  const Control::Kind kind = word == "ENDWHILE"  ? Control::Kind::While
                             : word == "ENDFOR"  ? Control::Kind::For
                             : word == "ENDLOOP" ? Control::Kind::Loop
                                                 : Control::Kind::Repeat;
  std::vector<Control>& controls = level().controls;
  if (controls.empty() || controls.back().kind != kind) {
    return fault(DiagnosticCode::FlowFault, fmt::format("{} has no beginning", word));
  }
  Control control = controls.back();
  if (kind == Control::Kind::While) {
    controls.pop_back();
    jump(control.head);
    return {};
  }
  bool again = true;
  if (kind == Control::Kind::For) {
    const bool counted = m_calculator.assign(fmt::format("{0}={0}+1", control.variable));
    const std::optional<double> value =
        counted ? m_calculator.evaluate(control.variable) : std::nullopt;
    if (!value) {
      return calculationFault();
    }
    again = *value <= control.limit;
  } else if (kind == Control::Kind::Repeat) {
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    again = *value == 0.0;
  }
  if (again) {
    jump(control.head);
  } else {
    controls.pop_back();
  }
  return {};
}

Flow::Outcome Flow::repeat(std::string_view rest) {
  rest = withoutComment(rest, false);
  if (rest.empty()) {
    level().controls.push_back({Control::Kind::Repeat, {}, m_lexer.place(), {}, 0.0, 0});
    return {};
  }
  // REPEAT LABEL P=3: from the label to here, so many times.
  const std::string label = takeName(rest);
  int times = 1;
  skipBlanks(rest);
  if (!rest.empty() && (rest.front() == 'P' || rest.front() == 'p')) {
    rest.remove_prefix(1);
    skipBlanks(rest);
    if (!rest.empty() && rest.front() == '=') {
      rest.remove_prefix(1);
    }
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    times = static_cast<int>(std::clamp(*value, 0.0, static_cast<double>(kTimesMax)));
  } else if (!rest.empty()) {
    return fault(DiagnosticCode::UnsupportedExpression, "REPEAT");
  }
  int& left = level().repeats.try_emplace(m_current.at, times).first->second;
  if (left == 0) {
    level().repeats.erase(m_current.at);
    return {};
  }
  --left;
  index(*level().source);
  const auto found = level().source->labels.find(label);
  if (found == level().source->labels.end()) {
    return fault(DiagnosticCode::FlowFault, fmt::format("the target {} is missing", label));
  }
  jump(found->second);
  return {};
}

Flow::Outcome Flow::caseOf(std::string_view rest) {
  const std::optional<double> value = m_calculator.take(rest);
  if (!value) {
    return calculationFault();
  }
  if (takeName(rest) != "OF") {
    return fault(DiagnosticCode::FlowFault, "CASE is written CASE(value) OF constant GOTOF target");
  }
  for (;;) {
    skipBlanks(rest);
    if (rest.empty()) {
      return {};
    }
    bool matches = true;
    std::string_view ahead = rest;
    if (takeName(ahead) == "DEFAULT") {
      rest = ahead;
    } else {
      const std::optional<double> constant = m_calculator.take(rest);
      if (!constant) {
        return calculationFault();
      }
      matches = *constant == *value;
    }
    const std::string kind = takeName(rest);
    if (kind.rfind("GOTO", 0) != 0) {
      return fault(DiagnosticCode::FlowFault, "behind the constant of CASE stands GOTO");
    }
    if (matches) {
      return goTo(kind, rest);
    }
    skipBlanks(rest);
    if (!rest.empty() && isDigit(rest.front())) {
      takeDigits(rest);
    } else {
      takeName(rest);
    }
  }
}

// --- ISO --------------------------------------------------------------------------------------

Flow::Outcome Flow::iso(const std::string& word, std::string_view rest) {
  rest = withoutComment(rest, true);
  // GOTO100, END1, DO1 are written with and without a blank.
  std::string key = word;
  std::string digits;
  while (!key.empty() && isDigit(key.back())) {
    digits.insert(digits.begin(), key.back());
    key.pop_back();
  }
  if (key == "GOTO") {
    const std::optional<double> target =
        digits.empty() ? m_calculator.evaluate(rest) : base::parseNumber(digits);
    if (!target) {
      return calculationFault();
    }
    const std::string text = fmt::format("{:.0f}", *target);
    std::string_view view = text;
    return goTo("GOTO", view);
  }
  if (key == "IF") {
    const std::optional<double> value = m_calculator.take(rest);
    if (!value) {
      return calculationFault();
    }
    std::string_view then = rest;
    const std::string kind = takeName(then);
    if (kind.rfind("GOTO", 0) == 0) {
      return *value != 0.0 ? iso(kind, then) : Outcome{};
    }
    if (kind == "THEN") {
      if (*value == 0.0) {
        return {};
      }
      return m_calculator.assign(base::trim(then)) ? Outcome{} : calculationFault();
    }
    return fault(DiagnosticCode::FlowFault, "behind a condition stands GOTO or THEN");
  }
  if (key == "WHILE" || key == "DO") {
    double value = 1.0;
    if (key == "WHILE") {
      const std::optional<double> taken = m_calculator.take(rest);
      if (!taken) {
        return calculationFault();
      }
      value = *taken;
      std::string_view behind = rest;
      const std::string name = takeName(behind);
      if (name.rfind("DO", 0) != 0) {
        return fault(DiagnosticCode::FlowFault, "WHILE is written WHILE [condition] DO1");
      }
      digits = name.size() > 2 ? name.substr(2) : std::string(takeDigits(behind));
    } else if (digits.empty()) {
      digits = std::string(takeDigits(rest));
    }
    if (value != 0.0) {
      level().controls.push_back({Control::Kind::While, digits, m_current, {}, 0.0, 0});
      return {};
    }
    while (const auto line = passLine()) {
      LineHead head = headOf(*line);
      if (head.word == "END" + digits || (head.word == "END" && takeDigits(head.rest) == digits)) {
        return {};
      }
    }
    return fault(DiagnosticCode::FlowFault, fmt::format("END{} is missing", digits));
  }
  if (key == "END") {
    if (digits.empty()) {
      digits = std::string(takeDigits(rest));
    }
    std::vector<Control>& controls = level().controls;
    while (!controls.empty() && controls.back().id != digits) {
      controls.pop_back();
    }
    if (controls.empty()) {
      return fault(DiagnosticCode::FlowFault, fmt::format("END{} has no beginning", digits));
    }
    const Place head = controls.back().head;
    controls.pop_back();
    jump(head);
    return {};
  }
  return fault(DiagnosticCode::UnsupportedExpression, word);
}

// --- O words of RS-274/NGC --------------------------------------------------------------------

std::string Flow::skipNumbered(const std::string& id, const std::vector<std::string_view>& words) {
  while (true) {
    const Place place = m_lexer.place();
    const auto line = passLine();
    if (!line) {
      return {};
    }
    const std::optional<OHead> head = oHeadOf(*line);
    if (!head) {
      continue;
    }
    if (head->id != id) {
      if (head->word == "SUB" && std::find(words.begin(), words.end(), "ENDSUB") != words.end()) {
        return "SUB";  // a definition inside a definition
      }
      continue;
    }
    if (std::find(words.begin(), words.end(), head->word) != words.end()) {
      if (head->word == "ELSEIF") {
        m_lexer.seek(place);
      }
      return head->word;
    }
  }
}

Flow::Outcome Flow::oWord(std::string_view statement) {
  const std::optional<OHead> head = oHeadOf(withoutComment(statement, true));
  if (!head) {
    return fault(DiagnosticCode::FlowFault, "an O word needs a number or <name>");
  }
  const std::string& id = head->id;
  const std::string& word = head->word;
  std::string_view rest = base::trim(head->rest);
  std::vector<Control>& controls = level().controls;
  const auto missing = [&](std::string_view what) {
    return fault(DiagnosticCode::FlowFault, fmt::format("O{} {} is missing", id, what));
  };
  const auto innermost = [&] { return !controls.empty() && controls.back().id == id; };
  if (word == "SUB") {
    const std::string found = skipNumbered(id, {"ENDSUB"});
    if (found == "SUB") {
      return fault(DiagnosticCode::FlowFault,
                   fmt::format("a subprogram is defined inside O{}", id));
    }
    if (!found.empty()) {
      jump(m_lexer.place());
    }
    return found.empty() ? missing("endsub") : Outcome{};
  }
  if (word == "ENDSUB" || word == "RETURN") {
    return leaveSubprogram()
               ? Outcome{}
               : fault(DiagnosticCode::FlowFault, fmt::format("O{} {} has no call", id, word));
  }
  if (word == "CALL") {
    return oCall(id, rest);
  }
  if (word == "IF" || word == "ELSEIF") {
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    // An ELSEIF that is met from above ends the branch before it.
    const bool fromBranch = word == "ELSEIF" && !(innermost() && controls.back().left == -1);
    if (innermost() && controls.back().left == -1) {
      controls.pop_back();
    }
    if (fromBranch) {
      while (true) {
        const std::string found = skipNumbered(id, {"ELSEIF", "ENDIF"});
        if (found.empty()) {
          return missing("endif");
        }
        if (found == "ENDIF") {
          return {};
        }
        (void)passLine();
      }
    }
    if (*value != 0.0) {
      return {};
    }
    const std::string found = skipNumbered(id, {"ELSEIF", "ELSE", "ENDIF"});
    if (found == "ELSEIF") {
      controls.push_back({Control::Kind::Times, id, m_current, {}, 0.0, -1});
    }
    return found.empty() ? missing("endif") : Outcome{};
  }
  if (word == "ELSE") {
    return skipNumbered(id, {"ENDIF"}).empty() ? missing("endif") : Outcome{};
  }
  if (word == "ENDIF") {
    return {};
  }
  if (word == "DO") {
    controls.push_back({Control::Kind::Do, id, m_lexer.place(), {}, 0.0, 0});
    return {};
  }
  if (word == "WHILE") {
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    if (innermost() && controls.back().kind == Control::Kind::Do) {
      if (*value != 0.0) {
        jump(controls.back().head);
      } else {
        controls.pop_back();
      }
      return {};
    }
    if (*value == 0.0) {
      return skipNumbered(id, {"ENDWHILE"}).empty() ? missing("endwhile") : Outcome{};
    }
    controls.push_back({Control::Kind::While, id, m_current, {}, 0.0, 0});
    return {};
  }
  if (word == "REPEAT") {
    const std::optional<double> value = m_calculator.evaluate(rest);
    if (!value) {
      return calculationFault();
    }
    const int times = static_cast<int>(
        std::clamp(std::floor(*value + 1e-9), 0.0, static_cast<double>(kTimesMax)));
    if (times == 0) {
      return skipNumbered(id, {"ENDREPEAT"}).empty() ? missing("endrepeat") : Outcome{};
    }
    controls.push_back({Control::Kind::Times, id, m_lexer.place(), {}, 0.0, times});
    return {};
  }
  if (word == "ENDWHILE" || word == "ENDREPEAT") {
    while (!controls.empty() && controls.back().id != id) {
      controls.pop_back();
    }
    if (controls.empty()) {
      return fault(DiagnosticCode::FlowFault, fmt::format("O{} {} has no beginning", id, word));
    }
    Control& control = controls.back();
    if (control.kind == Control::Kind::Times) {
      if (--control.left > 0) {
        jump(control.head);
      } else {
        controls.pop_back();
      }
      return {};
    }
    const Place back = control.head;
    controls.pop_back();
    jump(back);
    return {};
  }
  if (word == "BREAK" || word == "CONTINUE") {
    while (!controls.empty() && controls.back().id != id) {
      controls.pop_back();
    }
    if (controls.empty()) {
      return fault(DiagnosticCode::FlowFault, fmt::format("O{} {} is in no loop", id, word));
    }
    const Control control = controls.back();
    const bool isDo = control.kind == Control::Kind::Do;
    const std::string_view end = isDo                                   ? "WHILE"
                                 : control.kind == Control::Kind::Times ? "ENDREPEAT"
                                                                        : "ENDWHILE";
    if (word == "BREAK") {
      controls.pop_back();
      return skipNumbered(id, {end}).empty() ? missing(end) : Outcome{};
    }
    if (control.kind == Control::Kind::While) {
      controls.pop_back();
      jump(control.head);
      return {};
    }
    // Go on with the line that closes the loop.
    for (;;) {
      const Place place = m_lexer.place();
      const auto line = passLine();
      if (!line) {
        return missing(end);
      }
      const std::optional<OHead> closing = oHeadOf(*line);
      if (closing && closing->id == id && closing->word == end) {
        jump(place);
        return {};
      }
    }
  }
  return fault(DiagnosticCode::FlowFault, fmt::format("O{} {} is not known", id, word));
}

Flow::Outcome Flow::oCall(const std::string& id, std::string_view rest) {
  if (m_levels.size() >= kLevelsMax) {
    return fault(DiagnosticCode::FlowFault, "subprograms call each other too deeply");
  }
  Scope scope;
  int number = 1;
  while (!base::trim(rest).empty()) {
    const std::optional<double> value = m_calculator.take(rest);
    if (!value) {
      return calculationFault();
    }
    scope.numbers[number++] = *value;
    rest = base::trim(rest);
  }
  const auto found = findSubprogram("O" + id);
  if (!found) {
    return fault(DiagnosticCode::SubprogramMissing, "O" + id);
  }
  enter(*found->first, found->second, 1, std::move(scope), std::nullopt);
  return {};
}

}  // namespace rivulet::gcode
