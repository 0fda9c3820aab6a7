// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/flow/cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "nc/dialects/heidenhain/control.h"
#include "nc/unknown.h"

namespace rivulet::nc {

Cursor::Cursor(std::string_view text, Dialect dialect, Variables& variables,
               const CursorOptions& options)
    : m_language(languageOf(dialect)),
      m_variables(variables),
      m_options(options),
      m_lexer(text, dialect) {
  m_sources.emplace_back().text = text;
  setReturned(std::nullopt);
  if (m_language.isKlartext) {
    m_control = std::make_unique<heidenhain::Control>(&options.toolRadiusMm);
  } else if (mayHoldSeveral(text, m_language)) {
    grow();
  }
}

Cursor::~Cursor() = default;

/// The trees are those of the whole file, wherever the present block stands: what comes next is
/// looked for in the program that the block belongs to.
void Cursor::grow() {
  if (m_flow) {
    return;
  }
  Source& file = m_sources.front();
  read(file, 0);
  const bool begins = m_place.line.value == 0;
  const Tree& tree = *(begins ? file.programs.main() : file.programs.at(m_place.line)).tree;
  m_flow.emplace((begins ? file.programs.main() : file.programs.at(m_place.line)).tree, m_variables,
                 [this](const std::string& name) { return find(name); }, m_options.calls);
  // The words of the present block have been read.
  const auto next =
      std::find_if(tree.statements.begin(), tree.statements.end(), [this](const Statement& each) {
        if (each.place.line != m_place.line || m_block.tokens.empty()) {
          return each.place.line > m_place.line;
        }
        // Where a line has several blocks, those before are done, and the words of those after.
        return std::holds_alternative<Words>(each.what)
                   ? each.place.column > m_block.tokens.back().column
                   : each.place.column >= m_block.column;
      });
  m_flow->startAt(static_cast<std::size_t>(next - tree.statements.begin()));
  m_reached.assign(file.programs.lines + 1, false);
  std::fill_n(m_reached.begin(), std::min<std::size_t>(m_place.line.value + 1, m_reached.size()),
              !begins);
}

void Cursor::read(Source& source, std::uint16_t file) {
  m_bytes += source.own.capacity();
  source.programs = readPrograms(source.text, m_language.dialect, file, Detail::Blocks,
                                 m_options.budget.without(m_bytes));
  m_bytes += source.programs.bytes;
  m_isCut = m_isCut || source.programs.isCut;
}

std::shared_ptr<const Tree> Cursor::find(const std::string& name) {
  const auto in = [&name](const Source& source) -> std::shared_ptr<const Tree> {
    const auto found = source.programs.named.find(name);
    return found == source.programs.named.end() ? nullptr : found->second;
  };
  for (const std::size_t file : {std::size_t{m_place.file}, std::size_t{0}}) {
    if (std::shared_ptr<const Tree> found = in(m_sources[file])) {
      return found;
    }
  }
  auto loaded = m_loaded.find(name);
  if (loaded == m_loaded.end()) {
    std::optional<LoadedText> text = m_options.load ? m_options.load(name) : std::nullopt;
    if (!text) {
      return nullptr;
    }
    Source& source = m_sources.emplace_back();
    source.own = std::move(text->text);
    source.text = source.own;
    source.fileName = std::move(text->fileName);
    loaded = m_loaded.emplace(name, m_sources.size() - 1).first;
    read(source, static_cast<std::uint16_t>(loaded->second));
  }
  // A file of its own begins with the subprogram of its name, or is all of it.
  const Source& source = m_sources[loaded->second];
  std::shared_ptr<const Tree> named = in(source);
  return named ? named : source.programs.main().tree;
}

std::size_t Cursor::fileLines() {
  if (m_flow) {
    return m_sources.front().programs.lines;
  }
  while (m_lexer.nextLine()) {
  }
  return m_lexer.lines();
}

void Cursor::setPlace(const Place& place) {
  if (place.file == m_place.file && place.line <= m_place.line) {
    m_jumpedFrom = m_line;
  }
  m_place = place;
  if (place.file == 0) {
    m_line = place.line;
  }
}

namespace {

/// The statement of a block of plain text; empty: it is none.
std::string_view plainText(const Statement& statement) {
  const auto* const words = std::get_if<Words>(&statement.what);
  const bool isPlain = words != nullptr && !words->tokens.empty() &&
                       words->tokens.back().kind == TokenKind::Statement;
  return isPlain ? words->tokens.back().text : std::string_view();
}

/// Blocks of a program that no control would miss are none: what is left of ELSE and ENDIF, ends.
bool isBlock(const Statement& statement) {
  const std::string_view plain = plainText(statement);
  if (plain.starts_with("END PGM") || plain.starts_with("LBL")) {
    return false;
  }
  const auto* const branch = std::get_if<Branch>(&statement.what);
  return !(branch != nullptr && !branch->condition) &&
         !std::holds_alternative<Definition>(statement.what);
}

bool decides(const Tree& tree) {
  return std::any_of(tree.statements.begin(), tree.statements.end(), [](const Statement& each) {
    const auto* const branch = std::get_if<Branch>(&each.what);
    const auto* const jump = std::get_if<Jump>(&each.what);
    return (branch != nullptr && branch->condition) ||
           (jump != nullptr && (jump->condition || jump->number)) ||
           plainText(each).starts_with("FN");
  });
}

/// Of a program that nobody has entered, or whose blocks are all behind its end.
Unreached wholeOf(const TextProgram& program, bool isBehindEnd) {
  const bool isMain = !program.isCalled() && (!program.name.empty() || program.ends);
  return {.what = isBehindEnd          ? Unreached::What::Blocks
                  : program.isCalled() ? Unreached::What::Subprogram
                  : isMain             ? Unreached::What::MainProgram
                                       : Unreached::What::Blocks,
          .program = program.name,
          .first = program.firstBlock,
          .last = program.lastBlock};
}

void addUnreached(const TextProgram& program, const std::vector<bool>& reached,
                  std::vector<Unreached>& all) {
  const auto isReached = [&reached](const Statement& each) {
    return each.place.line.value < reached.size() && reached[each.place.line.value];
  };
  const std::vector<Statement>& statements = program.tree->statements;
  if (std::none_of(statements.begin(), statements.end(), isReached)) {
    if (program.firstBlock.value != 0) {
      all.push_back(wholeOf(program, false));
    }
    return;
  }
  Unreached found;
  found.program = program.name;
  found.dependsOnValues = decides(*program.tree);
  const auto add = [&] {
    if (found.first.value != 0) {
      all.push_back(found);
    }
    found.first = {};
  };
  for (const Statement& each : statements) {
    if (isReached(each)) {
      add();
    } else if (isBlock(each)) {
      found.first = found.first.value == 0 ? each.place.line : found.first;
      found.last = each.place.line;
    }
  }
  add();
}

}  // namespace

std::vector<Unreached> Cursor::unreached() const {
  std::vector<Unreached> all;
  if (m_flow) {
    for (const TextProgram& program : m_sources.front().programs.all) {
      addUnreached(program, m_reached, all);
    }
    return all;
  }
  // What begins at a heading has its name from the line that was read last.
  const auto fromHeading = [this] {
    Lexer lexer(m_sources.front().text, m_language.dialect);
    while (lexer.lines() + 1 < m_line.value && lexer.nextLine()) {
    }
    return lexer;
  };
  const Programs programs = outlineOf(m_isAtHeading ? fromHeading() : m_lexer, m_language.dialect);
  for (const TextProgram& program : programs.all) {
    if (program.firstBlock.value != 0) {
      all.push_back(wholeOf(program, program.heading == Heading::None));
    }
  }
  return all;
}

// --- Heidenhain ---------------------------------------------------------------------------------

Cursor::Step Cursor::nextOfKlartext() {
  while (!m_control->take(m_made)) {
    if (m_isFinished) {
      return Step::End;
    }
    if (m_endless || m_control->isLost() || !readKlartextBlock()) {
      m_isFinished = true;
      m_control->finish();
    }
  }
  m_place = m_made.place;
  m_line = m_made.line;
  m_outcome = std::monostate{};
  if (m_made.fault) {
    m_outcome = outcomeOf(std::move(*m_made.fault));
    return Step::Report;
  }
  if (!m_made.ignored.empty()) {
    m_outcome = Ignored{std::move(m_made.ignored)};
    return Step::Report;
  }
  m_words = &m_made.words;
  return Step::Block;
}

bool Cursor::readKlartextBlock() {
  const Words* words = &m_block;
  std::uint16_t file = 0;
  if (!m_flow) {
    if (!m_lexer.next(m_block)) {
      return false;
    }
    ++m_executed;
    m_isAtHeading =
        m_hasWords && !m_block.tokens.empty() && headingOf(m_block, m_language) != Heading::None;
    if (m_isAtHeading) {  // another program: the one before has no end
      m_line = m_block.line;
      return false;
    }
    m_hasWords = m_hasWords || !m_block.tokens.empty();
    m_readPlace = {m_block.line, 0, 1};
  } else {
    const Statement* const statement = m_flow->due();
    if (statement == nullptr) {
      const bool isOfProgram = !m_flow->isInLocal();
      if (!isOfProgram) {
        m_control->report({FaultCode::NotClosed, "LBL", m_readPlace});
      }
      if (!m_flow->leave()) {
        return false;
      }
      if (isOfProgram) {
        m_control->leaveProgram();
      }
      return true;
    }
    m_flow->step();
    if (statement->place.file == m_readPlace.file &&
        statement->place.line.value <= m_readPlace.line.value) {
      m_jumpedFrom = m_readLine;
    }
    m_readPlace = statement->place;
    if (m_readPlace.file == 0) {
      m_reached[m_readPlace.line.value] = true;
    }
    if (++m_executed > m_sources.front().programs.lines +
                           std::min(m_options.repeatedLinesMax, kRepeatedPlainTextMax)) {
      m_endless = m_jumpedFrom;
      return false;
    }
    file = statement->place.file;
    words = std::get_if<Words>(&statement->what);
    if (words == nullptr) {
      return true;
    }
  }
  m_readLine = m_readPlace.file == 0 ? m_readPlace.line : m_readLine;
  bool isSkipped = false;
  for (const Token& token : words->tokens) {
    isSkipped = isSkipped || token.kind == TokenKind::BlockSkip;
    if (token.kind != TokenKind::Statement) {
      continue;
    }
    if (isSkipped && m_options.blockSkip) {
      continue;
    }
    const Place place{m_readPlace.line, file, token.column};
    const heidenhain::Steering steering =
        m_control->execute(token.text, place, m_readLine, isSkipped);
    if (Expected<void> done = steer(steering); !done) {
      m_control->report(std::move(done.error()));
    }
    break;  // what follows may be gone
  }
  return true;
}

Expected<void> Cursor::steer(const heidenhain::Steering& steering) {
  if (std::holds_alternative<std::monostate>(steering)) {
    return {};
  }
  if (std::holds_alternative<heidenhain::LabelEnd>(steering)) {
    if (m_flow && m_flow->isInLocal()) {
      static_cast<void>(m_flow->leave());
    }
    return {};
  }
  if (std::holds_alternative<heidenhain::ProgramEnd>(steering)) {
    if (m_flow && m_flow->leaveProgram()) {
      m_control->leaveProgram();
    }
    return {};
  }
  if (!m_flow) {
    m_place = m_readPlace;
    grow();
    // The present block has been read: the flow has stepped over it.
    const std::vector<Statement>& all =
        m_sources.front().programs.at(m_readPlace.line).tree->statements;
    const auto own = std::find_if(all.begin(), all.end(), [this](const Statement& each) {
      return each.place.line.value == m_readPlace.line.value;
    });
    m_flow->startAt(static_cast<std::size_t>(own - all.begin()));
    m_flow->step();
  }
  Statement statement;
  statement.place = m_readPlace;
  const bool isProgram = std::holds_alternative<Call>(steering);
  if (isProgram) {
    statement.what = std::get<Call>(steering);
  } else if (const auto* const label = std::get_if<heidenhain::LabelCall>(&steering)) {
    Call call;
    call.name = label->label;
    call.isLocal = true;
    call.sharesVariables = true;
    statement.what = std::move(call);
  } else if (const auto* const jump = std::get_if<Jump>(&steering)) {
    statement.what = *jump;
  } else {
    statement.what = std::get<RepeatLabel>(steering);
  }
  const Expected<bool> done = m_flow->execute(statement);
  if (!done && done.error().code == FaultCode::TargetMissing) {
    return fail(FaultCode::TargetMissing, "LBL " + done.error().argument);
  }
  if (!done) {
    return fail(done.error());
  }
  m_rounds += std::holds_alternative<Jump>(statement.what) ? 0 : 1;
  const Statement* const due = m_flow->due();
  if (std::holds_alternative<Jump>(statement.what) && due != nullptr &&
      due->place.line.value <= m_readPlace.line.value && m_readPlace.file == 0) {
    // A jump back by itself, with no other values than the time before, would be made for ever.
    const std::uint64_t changes = m_control->changes() + m_rounds + 1;
    std::uint64_t& before = m_jumpsBack[m_readPlace.line.value];
    if (before == changes) {
      m_endless = m_readLine;
    }
    before = changes;
  }
  if (isProgram) {
    m_control->enterProgram();
  }
  return {};
}

Cursor::Step Cursor::next() {
  if (m_isCut) {
    return Step::End;
  }
  if (m_control) {
    return nextOfKlartext();
  }
  if (!m_flow) {
    if (!m_lexer.next(m_block)) {
      return Step::End;
    }
    ++m_executed;
    m_line = m_block.line;
    m_place = {m_block.line, 0, 1};
    if (!m_block.tokens.empty()) {
      m_isAtHeading = m_hasWords && mayBeHeading(m_block.tokens.front()) &&
                      headingOf(m_block, m_language) != Heading::None;
      if (m_isAtHeading) {
        return Step::End;
      }
      m_hasWords = m_hasWords || hasWords(m_block, m_language);
    }
    return Step::Block;
  }
  for (;;) {
    if (m_flow->isStuck()) {
      m_endless = m_line;
      return Step::End;
    }
    const Statement* const statement = m_flow->due();
    if (statement == nullptr) {
      if (!m_flow->leave()) {
        return Step::End;
      }
      setReturned(std::nullopt);
      continue;
    }
    m_flow->step();
    setPlace(statement->place);
    if (m_place.file == 0) {
      m_reached[m_place.line.value] = true;
    }
    if (++m_executed > m_sources.front().programs.lines + m_options.repeatedLinesMax) {
      m_endless = m_jumpedFrom;
      return Step::End;
    }
    if (const auto* const words = std::get_if<Words>(&statement->what)) {
      m_words = words;
      return Step::Block;
    }
    m_outcome = std::monostate{};
    if (const auto* const faulty = std::get_if<Faulty>(&statement->what)) {
      m_outcome = faulty->fault;
    } else if (const auto* const with = std::get_if<Return>(&statement->what)) {
      m_outcome = leave(*with);
    } else if (Expected<bool> done = m_flow->execute(*statement); !done) {
      m_outcome = outcomeOf(std::move(done.error()));
    }
    if (!std::holds_alternative<std::monostate>(m_outcome)) {
      return Step::Report;
    }
  }
}

Outcome Cursor::leave(const Return& with) {
  const Expected<double> value = with.value ? m_variables.number(*with.value) : 0.0;
  if (!m_flow->leave()) {
    return Fault{FaultCode::NotCalled, "RETURN", m_place};
  }
  if (!value) {
    setReturned(kUnknown);
    return value.error();
  }
  setReturned(with.value ? std::optional(*value) : std::nullopt);
  return std::monostate{};
}

/// LinuxCNC, O codes, "Subroutines": #<_value> and #<_value_returned>.
void Cursor::setReturned(std::optional<double> value) {
  if (m_language.returnsValues) {
    static_cast<void>(m_variables.assign(variableNamed("<_VALUE>"), value.value_or(0.0)));
    static_cast<void>(m_variables.assign(variableNamed("<_VALUE_RETURNED>"), value ? 1.0 : 0.0));
  }
}

Outcome Cursor::outcomeOf(Fault fault) {
  if (fault.code == FaultCode::SubprogramMissing ||
      fault.code == FaultCode::NeitherNameNorProgram) {
    return SubprogramMissing{std::move(fault.argument)};
  }
  return fault;
}

Outcome Cursor::execute(const Token& statement) {
  Reader reader(statement.text, m_language.notation,
                {m_place.line, m_place.file, statement.column});
  const std::string word = reader.name();
  if (isSteering(statement.text, m_language)) {
    // A tree holds it already; what neither jumps nor repeats needs none.
    if (word == "DEF" && !m_flow) {
      const Expected<std::vector<Definition>> definitions = reader.definitions();
      if (!definitions) {
        return definitions.error();
      }
      for (const Definition& definition : *definitions) {
        if (const Expected<void> done = m_variables.define(definition); !done) {
          return done.error();
        }
      }
    } else if (word != "PROC" && word != "EXTERN") {
      grow();
    }
    return std::monostate{};
  }
  const auto found =
      std::find_if(m_language.otherStatements.begin(), m_language.otherStatements.end(),
                   [&word](const OtherStatement& each) { return each.word == word; });
  if (found == m_language.otherStatements.end()) {
    // "O10 IF" of another control.
    const std::string_view front = statement.text.substr(0, statement.text.find('['));
    return Unsupported{statement.address == 'O' ? std::string(base::trim(front)) : word};
  }
  switch (found->meaning) {
    case OtherStatement::Meaning::ModalCall:
      return modalCall(reader, statement.column);
    case OtherStatement::Meaning::Ignored:
      return Ignored{word};
  }
  return Unsupported{word};
}

Outcome Cursor::modalCall(Reader& reader, int column) {
  reader.skipBlanks();
  Token called;
  called.text = reader.rest();
  called.column = column;
  called.kind = called.text.find('(') == std::string_view::npos ? TokenKind::Name : TokenKind::Call;
  ModalCall made{reader.name(), std::nullopt};
  if (!made.name.empty() && nameEffect(m_language.dialect, made.name) == NameEffect::Unknown &&
      find(made.name) != nullptr) {
    grow();
    Expected<Call> call = callOf(called, m_language.notation, m_place);
    if (!call) {
      return std::move(call.error());
    }
    made.call = std::move(*call);
  }
  return made;
}

// --- calls --------------------------------------------------------------------------------------

Outcome Cursor::call(Call call) {
  grow();
  Statement statement;
  statement.place = m_place;
  statement.what = std::move(call);
  Expected<bool> done = m_flow->execute(statement);
  return done ? Outcome() : outcomeOf(std::move(done.error()));
}

Outcome Cursor::call(const Token& token, int times) {
  Expected<Call> made =
      callOf(token, m_language.notation, {m_place.line, m_place.file, token.column});
  if (!made) {
    return std::move(made.error());
  }
  made->times = Expression::constant(times);
  return call(std::move(*made));
}

Outcome Cursor::callNumber(int number, int times,
                           const std::optional<std::map<int, double>>& numbers) {
  Call made;
  made.name = fmt::format("O{}", number);
  made.times = Expression::constant(times);
  made.isNumbered = numbers.has_value();
  made.sharesVariables = !numbers.has_value();
  made.keepsValues = m_language.keepsArguments;
  for (const auto& [index, value] : numbers.value_or(std::map<int, double>{})) {
    made.arguments.resize(static_cast<std::size_t>(index));
    made.arguments.back() = Expression::constant(value);
  }
  return call(std::move(made));
}

Outcome Cursor::callBlock(int number, int times) {
  Call made;
  made.name = fmt::format("N{}", number);
  made.times = Expression::constant(times);
  made.isLocal = true;
  return call(std::move(made));
}

Outcome Cursor::leaveTo(int number, bool stays) {
  grow();
  Expected<bool> done = m_flow->leaveTo(fmt::format("N{}", number), stays);
  return done ? Outcome() : outcomeOf(std::move(done.error()));
}

}  // namespace rivulet::nc
