// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "nc/syntax/parser.h"

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

/// Distributes the lines of a text over its programs.
class Splitter {
 public:
  Splitter(std::string_view text, Dialect dialect, std::uint16_t file)
      : m_lexer(text, dialect), m_language(languageOf(dialect)), m_file(file) {
    begin();
    m_programs.first = m_parts.back().tree;
  }

  Programs split() {
    Block block;
    for (Lexer::Position at = m_lexer.position(); m_lexer.next(block); at = m_lexer.position()) {
      m_programs.lines.push_back(at);
      line(block, {at.at, static_cast<std::size_t>(m_lexer.position().at - at.at)});
    }
    while (m_parts.size() > 1) {
      // A SUB without its ENDSUB.
      const Part part = std::move(m_parts.back());
      end();
      add(part.place, Faulty{{FaultCode::NotClosed, part.name, part.place}});
    }
    end();
    return std::move(m_programs);
  }

 private:
  struct Part {
    std::shared_ptr<Tree> tree;
    std::unique_ptr<SteeringParser> parser;
    std::string name;  ///< of an O SUB
    Place place;
  };

  void begin(std::string name = {}, Place place = {}) {
    Part& part = m_parts.emplace_back();
    part.tree = std::make_shared<Tree>();
    part.parser = m_language.steeringParser(*part.tree);
    part.name = std::move(name);
    part.place = place;
  }

  void end() {
    if (m_parts.back().parser) {
      m_parts.back().parser->finish();
    }
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

  template <class What>
  void add(Place place, What what) {
    Statement& made = m_parts.back().tree->statements.emplace_back();
    made.place = place;
    made.what = std::move(what);
  }

  void line(const Block& block, std::string_view text) {
    if (block.tokens.empty()) {
      return;
    }
    const Token& front = block.tokens.front();
    const Place place{block.line, m_file, front.column};
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
      text = base::trim(text);
      if (std::optional<std::string> name = takeOName(text)) {
        beginNamed(std::move(*name));
      }
    }
    std::vector<Label>& labels = m_parts.back().tree->labels;
    const Token* statement = nullptr;
    bool hasWords = false;
    for (const Token& token : block.tokens) {
      if (token.kind == TokenKind::Statement && isSteering(token.text, m_language)) {
        statement = &token;
      } else if (token.kind == TokenKind::Label) {
        labels.push_back({base::toUpper(tokenName(token)), m_parts.back().tree->statements.size()});
      } else if (token.kind == TokenKind::Word && token.address == 'N') {
        labels.push_back({numberLabel(token), m_parts.back().tree->statements.size()});
      } else {
        hasWords = true;
      }
    }
    if (hasWords) {
      add(place, Words{});
    }
    if (statement != nullptr) {
      steer(*statement, {block.line, m_file, statement->column});
    }
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

  void steer(const Token& statement, Place place) {
    std::string_view rest = statement.text;
    if (m_language.namesAreCalls && firstName(rest) == "PROC") {
      rest.remove_prefix(4);
      beginNamed(firstNameWithDigits(base::trim(rest)));
    } else if (std::optional<std::string> name =
                   m_language.hasOWords ? takeOName(rest) : std::nullopt) {
      const std::string word = firstName(base::trim(rest));
      if (word == "SUB") {
        if (m_parts.size() > 1) {
          Part& outer = m_parts.front();
          Statement& made = outer.tree->statements.emplace_back();
          made.place = m_parts.back().place;
          made.what = Faulty{{FaultCode::SubprogramInside, m_parts.back().name, made.place}};
        }
        begin(*name, place);
        m_programs.named.emplace(std::move(*name), m_parts.back().tree);
        return;
      }
      if (word == "ENDSUB") {
        if (m_parts.size() == 1) {
          add(place, Faulty{{FaultCode::NotCalled, *name + " " + word, place}});
        } else {
          end();
        }
        return;
      }
    }
    m_parts.back().parser->steer(statement.text, place);
  }

  static std::string firstNameWithDigits(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && (base::isNameLetter(text[end]) || isDigit(text[end]))) {
      ++end;
    }
    return base::toUpper(text.substr(0, end));
  }

  Lexer m_lexer;
  const Language& m_language;
  std::uint16_t m_file;
  Programs m_programs;
  std::vector<Part> m_parts;  ///< the innermost SUB last
};

}  // namespace

Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file) {
  return Splitter(text, dialect, file).split();
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
