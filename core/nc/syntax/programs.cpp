// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "nc/modal/vocabulary.h"
#include "nc/syntax/lexer.h"

namespace rivulet::nc {

namespace {

using base::isBlank;
using base::isDigit;

std::string firstName(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && base::isNameLetter(text[end])) {
    ++end;
  }
  return base::toUpper(text.substr(0, end));
}

/// N=5 sets a variable N.
bool isBlockNumber(const Token& token) {
  return token.kind == TokenKind::Word && token.address == 'N' &&
         token.text.find('=') == std::string_view::npos;
}

/// Distributes the lines of a text over its programs.
class Splitter {
 public:
  Splitter(std::string_view text, Dialect dialect, std::uint16_t file, Detail detail)
      : m_lexer(text, dialect, file),
        m_language(languageOf(dialect)),
        m_file(file),
        m_detail(detail) {
    begin();
    m_programs.first = m_parts.back().tree;
  }

  Programs split() {
    Block block;
    while (m_lexer.next(block)) {
      line(block);
    }
    m_programs.lines = m_lexer.lines();
    while (m_parts.size() > 1) {
      // A SUB without its ENDSUB.
      const std::string name = m_parts.back().name;
      const Place place = m_parts.back().place;
      end();
      m_parts.back().parser->fault(FaultCode::NotClosed, name, place);
    }
    end();
    return std::move(m_programs);
  }

 private:
  struct Part {
    std::shared_ptr<Tree> tree;
    std::unique_ptr<BlockParser> parser;
    std::string name;  ///< of an O SUB
    Place place;
  };

  void begin(std::string name = {}, Place place = {}) {
    Part& part = m_parts.emplace_back();
    part.tree = std::make_shared<Tree>();
    part.parser = m_language.blockParser(*part.tree, m_detail);
    part.name = std::move(name);
    part.place = place;
  }

  void end() {
    m_parts.back().parser->finish();
    m_parts.pop_back();
  }

  /// The program with this name begins here.
  void beginNamed(std::string name) {
    if (!m_parts.back().tree->statements.empty()) {
      end();
      begin();
    }
    m_programs.named.emplace(std::move(name), m_parts.back().tree);
  }

  void line(Block& block) {
    if (block.tokens.empty()) {
      return;
    }
    const Token& front = block.tokens.front();
    if (front.kind == TokenKind::Tape && front.text.starts_with("%_N_")) {
      // The header of a program in an archive: %_N_NAME_SPF.
      const std::string name = base::toUpper(base::trim(front.text.substr(4)));
      beginNamed(name.substr(0, name.rfind('_')));
      return;
    }
    // O1234 and :1234 begin a program of the ISO dialects.
    const bool isNumber =
        front.kind == TokenKind::Word &&
        (front.address == 'O' || (front.address == 'N' && front.text.front() == ':'));
    if (m_language.hasOWords && isNumber) {
      std::string_view text = front.text;
      if (std::optional<std::string> name = takeOName(text)) {
        beginNamed(std::move(*name));
      }
    }
    Words words = std::move(static_cast<Words&>(block));
    std::string_view rest = take(std::move(words), block.line);
    while (!rest.empty()) {
      const Place place{block.line, m_file, m_column};
      Words more = readWords(rest, m_language, place);
      const Token first = more.tokens.empty() ? Token() : more.tokens.front();
      const std::string name = base::toUpper(tokenName(first));
      // A program can be called at the beginning of a block only.
      const bool isCall = (first.kind == TokenKind::Name || first.kind == TokenKind::Call) &&
                          nameEffect(m_language.dialect, name) == NameEffect::Unknown;
      if (isCall || first.kind == TokenKind::UnexpectedCharacter) {
        m_parts.back().parser->fault(isCall ? FaultCode::NotDefined : FaultCode::SyntaxCharacter,
                                     isCall ? name : std::string(first.text), place);
        return;
      }
      rest = take(std::move(more), block.line);
    }
  }

  /// @return what follows a statement that steers; its column is in `m_column`
  std::string_view take(Words words, base::LineNumber line) {
    std::vector<Label>& labels = m_parts.back().tree->labels;
    const std::size_t next = m_parts.back().tree->statements.size();
    std::optional<Token> statement;
    bool hasWords = false;
    for (const Token& token : words.tokens) {
      if (token.kind == TokenKind::Statement &&
          (m_detail == Detail::Statements || isSteering(token.text, m_language))) {
        statement = token;
      } else if (token.kind == TokenKind::Label) {
        labels.push_back({base::toUpper(tokenName(token)), next});
      } else if (isBlockNumber(token)) {
        labels.push_back({numberLabel(token), next});
      } else {
        hasWords = hasWords || token.kind != TokenKind::Comment || m_detail == Detail::Statements;
      }
    }
    if (statement) {
      words.tokens.pop_back();  // a statement is the rest of its block
    }
    if (hasWords) {
      const Place place{line, m_file, words.tokens.front().column};
      m_parts.back().parser->words(std::move(words), place);
    }
    if (!statement) {
      return {};
    }
    const std::string_view rest = steer(statement->text, {line, m_file, statement->column});
    m_column = statement->column + static_cast<int>(rest.data() - statement->text.data());
    return rest;
  }

  [[nodiscard]] std::string numberLabel(const Token& token) const {
    std::string digits;
    for (const char c : token.text) {
      digits += isDigit(c) ? std::string(1, c) : "";
    }
    return m_language.comparesNumbersAsText
               ? "N" + digits
               : fmt::format("N{}", base::parseInteger(digits).value_or(-1));
  }

  std::string_view steer(std::string_view statement, Place place) {
    std::string_view rest = statement;
    if (m_language.namesAreCalls && firstName(rest) == "PROC") {
      rest.remove_prefix(4);
      beginNamed(base::toUpper(tokenName({.text = base::trim(rest)})));
    } else if (std::optional<std::string> name =
                   m_language.hasOWords ? takeOName(rest) : std::nullopt) {
      const std::string word = firstName(base::trim(rest));
      if (word == "SUB") {
        if (m_parts.size() > 1) {
          m_parts.front().parser->fault(FaultCode::SubprogramInside, m_parts.back().name,
                                        m_parts.back().place);
        }
        begin(*name, place);
        m_programs.named.emplace(std::move(*name), m_parts.back().tree);
        return {};
      }
      if (word == "ENDSUB") {
        if (m_parts.size() == 1) {
          m_parts.back().parser->fault(FaultCode::NotCalled, *name + " " + word, place);
        } else {
          end();
        }
        return {};
      }
    }
    return m_parts.back().parser->steer(statement, place);
  }

  Lexer m_lexer;
  const Language& m_language;
  std::uint16_t m_file;
  Detail m_detail;
  int m_column = 1;
  Programs m_programs;
  std::vector<Part> m_parts;  ///< the innermost SUB last
};

}  // namespace

Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file, Detail detail) {
  return Splitter(text, dialect, file, detail).split();
}

std::shared_ptr<const Tree> parseSinumerik(std::string text) {
  const auto owned = std::make_shared<const std::string>(std::move(text));
  const Programs programs = readPrograms(*owned, Dialect::Sinumerik, 0, Detail::Statements);
  auto tree = std::make_shared<Tree>(*programs.first);
  tree->text = owned;
  return tree;
}

bool isSteering(std::string_view statement, const Language& language) {
  const auto& words = language.steering;
  return std::find(words.begin(), words.end(), firstName(statement)) != words.end() ||
         (language.hasOWords && !statement.empty() &&
          (statement.front() == 'O' || statement.front() == 'o'));
}

std::optional<std::string> takeOName(std::string_view& text) {
  const auto skipBlanks = [&text] {
    while (!text.empty() && isBlank(text.front())) {
      text.remove_prefix(1);
    }
  };
  skipBlanks();
  if (text.empty() || (text.front() != 'O' && text.front() != 'o' && text.front() != ':')) {
    return std::nullopt;
  }
  text.remove_prefix(1);
  skipBlanks();
  if (!text.empty() && text.front() == '<') {
    const std::size_t end = text.find('>');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    std::string name = base::toUpper(text.substr(0, end + 1));
    name.erase(std::remove_if(name.begin(), name.end(), isBlank), name.end());
    text.remove_prefix(end + 1);
    return "O" + name;
  }
  std::size_t digits = 0;
  while (digits < text.size() && isDigit(text[digits])) {
    ++digits;
  }
  if (digits == 0) {
    return std::nullopt;
  }
  const std::optional<int> number = base::parseInteger(text.substr(0, digits));
  text.remove_prefix(digits);
  return fmt::format("O{}", number.value_or(-1));
}

}  // namespace rivulet::nc
