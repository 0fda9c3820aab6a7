// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/flow/cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"

namespace rivulet::nc {

Cursor::Cursor(std::string_view text, Dialect dialect, Variables& variables,
               const CursorOptions& options)
    : m_language(languageOf(dialect)),
      m_variables(variables),
      m_options(options),
      m_lexer(text, dialect) {
  m_sources.emplace_back().text = text;
}

void Cursor::grow() {
  if (m_flow) {
    return;
  }
  Source& file = m_sources.front();
  file.programs = readPrograms(file.text, m_language.dialect, 0);
  m_flow.emplace(file.programs.first, m_variables,
                 [this](const std::string& name) { return find(name); });
  // The words of the present block have been read.
  const std::vector<Statement>& statements = file.programs.first->statements;
  const auto next =
      std::find_if(statements.begin(), statements.end(), [this](const Statement& each) {
        return each.place.line > m_place.line ||
               (each.place.line == m_place.line && !std::holds_alternative<Words>(each.what));
      });
  m_flow->startAt(static_cast<std::size_t>(next - statements.begin()));
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
    source.programs =
        readPrograms(source.text, m_language.dialect, static_cast<std::uint16_t>(loaded->second));
  }
  // A file of its own begins with the subprogram of its name, or is all of it.
  const Source& source = m_sources[loaded->second];
  std::shared_ptr<const Tree> named = in(source);
  return named ? named : source.programs.first;
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

bool Cursor::nextBehindEnd() {
  m_words = &m_block;
  if (m_flow || !m_lexer.next(m_block)) {
    return false;
  }
  m_line = m_block.line;
  return true;
}

Cursor::Step Cursor::next() {
  if (!m_flow) {
    if (!m_lexer.next(m_block)) {
      return Step::End;
    }
    ++m_executed;
    m_line = m_block.line;
    m_place = {m_block.line, 0, 1};
    return Step::Block;
  }
  for (;;) {
    const Statement* const statement = m_flow->due();
    if (statement == nullptr) {
      if (!m_flow->leave()) {
        return Step::End;
      }
      continue;
    }
    m_flow->step();
    setPlace(statement->place);
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
    } else if (std::holds_alternative<Return>(statement->what)) {
      if (!m_flow->leave()) {
        m_outcome = Fault{FaultCode::NotCalled, "RETURN", statement->place};
      }
    } else if (Expected<bool> done = m_flow->execute(*statement); !done) {
      m_outcome = outcomeOf(std::move(done.error()));
    }
    if (!std::holds_alternative<std::monostate>(m_outcome)) {
      return Step::Report;
    }
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
    return Unsupported{word};
  }
  switch (found->meaning) {
    case OtherStatement::Meaning::ModalCall:
      return ModalCall{reader.name()};
    case OtherStatement::Meaning::CallsProgram:
      if (reader.takeWord("PGM")) {
        return SubprogramMissing{std::string(base::trim(reader.rest()))};
      }
      break;
    case OtherStatement::Meaning::Ignored:
      return Ignored{word};
  }
  return Unsupported{word};
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
  for (const auto& [index, value] : numbers.value_or(std::map<int, double>{})) {
    made.arguments.resize(static_cast<std::size_t>(index));
    made.arguments.back() = Expression::constant(value);
  }
  return call(std::move(made));
}

}  // namespace rivulet::nc
