// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "nc/function_number.h"
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

/// A comment, and what is left of one that holds brackets: "(A (B) )".
bool isComment(const Token& token) {
  return token.kind == TokenKind::Comment || token.kind == TokenKind::CommentNested ||
         (token.kind == TokenKind::UnexpectedCharacter && token.text == ")");
}

constexpr std::string_view kPlainBegin = "BEGIN PGM";

/// N=5 sets a variable N.
bool isBlockNumber(const Token& token) {
  return token.kind == TokenKind::Word && token.address == 'N' &&
         token.text.find('=') == std::string_view::npos;
}

/// PROC NAME, also behind a block number.
const Token* procedureOf(const Words& block) {
  for (const Token& token : block.tokens) {
    if (token.kind == TokenKind::Statement) {
      return firstName(token.text) == "PROC" ? &token : nullptr;
    }
    if (!isBlockNumber(token)) {
      return nullptr;
    }
  }
  return nullptr;
}

/// "NAME" of PROC NAME(...).
std::string procedureName(std::string_view statement) {
  statement.remove_prefix(std::string_view("PROC").size());
  return base::toUpper(tokenName({.text = base::trim(statement)}));
}

std::shared_ptr<const Tree> treeOf(Fault fault) {
  auto tree = std::make_shared<Tree>();
  Statement& only = tree->statements.emplace_back();
  only.place = fault.place;
  only.what = Faulty{std::move(fault)};
  return tree;
}

/// Distributes the lines of a text over its programs.
class Splitter {
 public:
  /// @param detail  nothing: no statements
  /// @param lineEnds  of the whole text, about
  /// @param budget  of the statements
  Splitter(const Lexer& lexer, Dialect dialect, std::uint16_t file, std::optional<Detail> detail,
           std::size_t lineEnds, const base::Budget& budget)
      : m_lexer(lexer),
        m_budget(budget),
        m_lineEnds(lineEnds),
        m_language(languageOf(dialect)),
        m_file(file),
        m_detail(detail.value_or(Detail::Blocks)),
        m_isOutline(!detail) {
    begin({});
  }

  Programs split() {
    Block block;
    while (!m_programs.isCut && m_lexer.next(block)) {
      m_programs.bytes += m_isOutline ? 0 : bytesOf(block);
      m_programs.isCut = m_programs.bytes > m_budget.left();
      line(block);
    }
    m_programs.lines = m_lexer.lines();
    endSubprograms();
    end();
    std::stable_sort(m_programs.all.begin(), m_programs.all.end(),
                     [](const TextProgram& a, const TextProgram& b) {
                       return a.firstLine.value < b.firstLine.value;
                     });
    return std::move(m_programs);
  }

 private:
  struct Part {
    TextProgram program;
    std::shared_ptr<Tree> tree;
    std::unique_ptr<BlockParser> parser;
    Place place;
  };

  /// At least what the statements of a block take, with labels and calculations.
  [[nodiscard]] std::size_t bytesOf(const Words& block) const {
    constexpr std::size_t kTokenBytes = sizeof(Token) + sizeof(Label);
    constexpr std::size_t kCalculatedBytes = sizeof(Expression) / 2 + sizeof(Token);  // per letter
    std::size_t bytes = sizeof(Statement) + sizeof(Words);
    for (const Token& token : block.tokens) {
      const bool isMore = token.kind == TokenKind::Statement || token.calculation != nullptr;
      bytes += kTokenBytes + (isMore ? token.text.size() * kCalculatedBytes : 0) +
               (m_detail == Detail::Statements || isMore ? sizeof(Statement) : 0);
    }
    return bytes;
  }

  Part& begin(Place place) {
    Part& part = m_parts.emplace_back();
    part.tree = std::make_shared<Tree>();
    part.parser = m_language.blockParser(*part.tree, m_language, m_detail);
    part.program.tree = part.tree;
    part.program.firstLine = place.line;
    part.place = place;
    return part;
  }

  void end() {
    Part part = std::move(m_parts.back());
    m_parts.pop_back();
    part.parser->finish();
    const bool isOnly =
        m_parts.empty() && std::all_of(m_programs.all.begin(), m_programs.all.end(),
                                       [](const TextProgram& each) { return each.isInside; });
    if (isOnly || part.program.firstBlock.value != 0) {
      m_programs.all.push_back(std::move(part.program));
    }
  }

  /// A SUB without its ENDSUB.
  void endSubprograms() {
    while (m_parts.size() > 1) {
      m_parts.back().parser->fault(FaultCode::NotClosed, m_parts.back().program.name,
                                   m_parts.back().place);
      end();
    }
  }

  void name(std::string name) {
    Part& part = m_parts.back();
    const auto [known, isNew] = m_programs.named.emplace(name, part.tree);
    if (!isNew && known->second != part.tree) {
      known->second = treeOf({FaultCode::ProgramTwice, name, part.place});
    }
    if (part.program.name.empty()) {
      part.program.name = std::move(name);
    }
  }

  /// A program begins here, or goes on to begin: an archive's header may stand before PROC, and "%"
  /// before anything.
  void beginProgram(Heading heading, Place place) {
    endSubprograms();
    const Heading before = m_parts.back().program.heading;
    const bool isFresh = m_parts.back().program.firstBlock.value == 0 &&
                         (before < heading || heading == Heading::Tape);
    if (!isFresh) {
      end();
      begin(place);
    }
    m_parts.back().program.heading = std::max(m_parts.back().program.heading, heading);
  }

  void line(Block& block) {
    if (block.tokens.empty()) {
      return;
    }
    const Token& front = block.tokens.front();
    const Place place{block.line, m_file, front.column};
    switch (headingOf(block, m_language)) {
      case Heading::Tape:
        beginProgram(Heading::Tape, place);
        return;
      case Heading::Archive: {
        // %_N_NAME_SPF
        beginProgram(Heading::Archive, place);
        const std::string text = base::toUpper(base::trim(front.text.substr(4)));
        const std::size_t kind = text.rfind('_');
        m_parts.back().program.isMain = text.substr(std::min(kind, text.size())) == "_MPF";
        m_parts.back().program.isSubprogram = text.substr(std::min(kind, text.size())) == "_SPF";
        name(text.substr(0, kind));
        return;
      }
      case Heading::Number: {
        std::string_view text = front.text;
        std::optional<std::string> number = takeOName(text);
        beginProgram(Heading::Number, place);
        name(number ? std::move(*number) : std::string());
        block.tokens.erase(block.tokens.begin());
        break;
      }
      case Heading::Procedure: {
        beginProgram(Heading::Procedure, place);
        m_parts.back().program.isSubprogram = !m_parts.back().program.isMain;
        const Token statement = *procedureOf(block);
        name(procedureName(statement.text));
        m_parts.back().parser->steer(statement.text, {block.line, m_file, statement.column});
        return;
      }
      case Heading::PlainText: {
        beginProgram(Heading::PlainText, place);
        const std::string_view text = base::trim(front.text.substr(kPlainBegin.size()));
        m_parts.back().program.name = text.substr(0, text.find_last_of(' '));
        break;
      }
      case Heading::None:
        break;
    }
    makeRoom();
    // A copy is as large as its words; the block keeps its room for the next line.
    std::string_view rest = take(static_cast<const Words&>(block), block.line);
    while (!rest.empty()) {
      const Place at{block.line, m_file, m_column};
      Words more = readWords(rest, m_language, at);
      const Token first = more.tokens.empty() ? Token() : more.tokens.front();
      const std::string called = base::toUpper(tokenName(first));
      // A program can be called at the beginning of a block only.
      const bool isCall = (first.kind == TokenKind::Name || first.kind == TokenKind::Call) &&
                          nameEffect(m_language.dialect, called) == NameEffect::Unknown;
      if (isCall || first.kind == TokenKind::UnexpectedCharacter) {
        m_parts.back().parser->fault(isCall ? FaultCode::NotDefined : FaultCode::SyntaxCharacter,
                                     isCall ? called : std::string(first.text), at);
        return;
      }
      rest = take(std::move(more), block.line);
    }
  }

  /// A long list is not moved to a larger place again and again: both would be there at once.
  void makeRoom() {
    constexpr std::size_t kLong = 4096;
    std::vector<Statement>& statements = m_parts.back().tree->statements;
    if (statements.size() >= kLong && statements.size() == statements.capacity()) {
      const std::size_t left = m_lineEnds - std::min(m_lineEnds, m_lexer.lines());
      statements.reserve(statements.size() + kLong +
                         std::min(left, m_budget.items(sizeof(Statement))));
    }
  }

  void note(const Token& token) {
    TextProgram& program = m_parts.back().program;
    if (token.kind == TokenKind::Word && token.address == 'M') {
      const std::optional<int> number = functionNumber(token.value);
      const MEffect effect = number ? mEffect(m_language.dialect, *number) : MEffect::None;
      program.ends = program.ends || effect == MEffect::End;
      program.returns = program.returns || effect == MEffect::Return;
    } else if (token.kind == TokenKind::Name) {
      program.returns = program.returns || base::toUpper(token.text) == "RET";
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
        labels.push_back(
            {m_language.isKlartext ? std::string(token.text) : base::toUpper(tokenName(token)),
             next});
      } else if (isBlockNumber(token)) {
        labels.push_back({numberLabel(token), next});
      } else {
        hasWords = hasWords || !isComment(token) || m_detail == Detail::Statements;
        note(token);
      }
    }
    if (statement) {
      words.tokens.pop_back();  // a statement is the rest of its block
    }
    const bool isBoundary =
        statement && isSubprogramBoundary(statement->text, {line, m_file, statement->column});
    // The ends of a program and of a subprogram of plain text do nothing themselves.
    const std::string_view plain = m_language.isKlartext && !words.tokens.empty()
                                       ? words.tokens.back().text
                                       : std::string_view();
    const bool isPlainEnd = plain.starts_with("END PGM") || plain.starts_with("LBL");
    if ((hasWords && !isPlainEnd) || (statement && !isBoundary)) {
      TextProgram& program = m_parts.back().program;
      program.firstBlock = program.firstBlock.value == 0 ? line : program.firstBlock;
      program.lastBlock = line;
    }
    if (isBoundary || m_isOutline) {
      return {};
    }
    if (hasWords) {
      const Place place{line, m_file, words.tokens.front().column};
      m_parts.back().parser->words(std::move(words), place);
    }
    if (!statement) {
      return {};
    }
    const std::string_view rest =
        m_parts.back().parser->steer(statement->text, {line, m_file, statement->column});
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

  /// O100 SUB and O100 ENDSUB.
  bool isSubprogramBoundary(std::string_view statement, Place place) {
    std::string_view rest = statement;
    if (std::optional<std::string> name = m_language.hasOWords ? takeOName(rest) : std::nullopt) {
      const std::string word = firstName(base::trim(rest));
      if (word == "SUB") {
        if (m_parts.size() > 1) {
          m_parts.front().parser->fault(FaultCode::SubprogramInside, m_parts.back().program.name,
                                        m_parts.back().place);
        }
        TextProgram& program = begin(place).program;
        program.isSubprogram = true;
        program.isInside = true;
        this->name(std::move(*name));
        return true;
      }
      if (word == "ENDSUB") {
        if (m_parts.size() == 1) {
          m_parts.back().parser->fault(FaultCode::NotCalled, *name + " " + word, place);
        } else {
          m_parts.back().parser->steer(statement, place);
          end();
        }
        return true;
      }
    }
    return false;
  }

  Lexer m_lexer;
  base::Budget m_budget;
  std::size_t m_lineEnds;
  const Language& m_language;
  std::uint16_t m_file;
  Detail m_detail;
  bool m_isOutline;
  int m_column = 1;
  Programs m_programs;
  std::vector<Part> m_parts;  ///< the innermost SUB last
};

}  // namespace

const TextProgram& Programs::main() const {
  const auto first = std::find_if(all.begin(), all.end(),
                                  [](const TextProgram& each) { return !each.isCalled(); });
  const auto outside =
      std::find_if(all.begin(), all.end(), [](const TextProgram& each) { return !each.isInside; });
  return first != all.end() ? *first : *outside;
}

const TextProgram& Programs::at(base::LineNumber line) const {
  const auto last = std::find_if(all.rbegin(), all.rend(), [line](const TextProgram& each) {
    return !each.isInside && each.firstLine.value <= line.value;
  });
  return last != all.rend() ? *last : main();
}

Programs readPrograms(std::string_view text, Dialect dialect, std::uint16_t file, Detail detail,
                      const base::Budget& budget) {
  const auto lineEnds = std::max(std::count(text.begin(), text.end(), '\n'),
                                 std::count(text.begin(), text.end(), '\r'));
  return Splitter(Lexer(text, dialect, file), dialect, file, detail,
                  static_cast<std::size_t>(lineEnds), budget)
      .split();
}

Programs outlineOf(const Lexer& rest, Dialect dialect) {
  return Splitter(rest, dialect, 0, std::nullopt, 0, {}).split();
}

std::shared_ptr<const Tree> parseSinumerik(std::string text, const base::Budget& budget) {
  const auto owned = std::make_shared<const std::string>(std::move(text));
  const Programs programs = readPrograms(*owned, Dialect::Sinumerik, 0, Detail::Statements, budget);
  if (programs.isCut) {
    return treeOf({FaultCode::ProgramTooLarge, {}, {}});
  }
  const auto tree = std::const_pointer_cast<Tree>(programs.main().tree);  // ours alone
  tree->text = owned;
  return tree;
}

Heading headingOf(const Words& block, const Language& language) {
  const Token& front = block.tokens.front();
  if (!mayBeHeading(front)) {
    return Heading::None;
  }
  if (front.kind == TokenKind::Tape) {
    return front.text.starts_with("%_N_") ? Heading::Archive : Heading::Tape;
  }
  if (language.isKlartext) {
    return front.kind == TokenKind::Statement && front.text.starts_with(kPlainBegin)
               ? Heading::PlainText
               : Heading::None;
  }
  const bool isNumber = front.kind == TokenKind::Word &&
                        (front.address == 'O' || (front.address == 'N' && front.text[0] == ':'));
  if (isNumber && language.hasOWords) {
    return Heading::Number;
  }
  return language.namesAreCalls && procedureOf(block) != nullptr ? Heading::Procedure
                                                                 : Heading::None;
}

bool hasWords(const Words& block, const Language& language) {
  const auto isSilent = [](const Token& token) {
    return token.kind == TokenKind::Tape || token.kind == TokenKind::Label || isComment(token) ||
           isBlockNumber(token);
  };
  const bool hasNumber = !block.tokens.empty() && headingOf(block, language) == Heading::Number;
  return !std::all_of(block.tokens.begin() + (hasNumber ? 1 : 0), block.tokens.end(), isSilent);
}

bool mayHoldSeveral(std::string_view text, const Language& language) {
  // How often `mark` stands at the beginning of a line and `goesOn` holds for what follows it.
  const auto count = [text](std::string_view letters, const auto& goesOn) {
    int found = 0;
    for (const char letter : letters) {
      for (std::size_t at = text.find(letter); at != text.npos && found < 2;
           at = text.find(letter, at + 1)) {
        std::size_t begin = at;
        while (begin > 0 && isBlank(text[begin - 1])) {
          --begin;
        }
        const bool beginsLine = begin == 0 || text[begin - 1] == '\n' || text[begin - 1] == '\r';
        found += beginsLine && goesOn(text.substr(at)) ? 1 : 0;
      }
    }
    return found >= 2;
  };
  const auto isNumber = [](std::string_view rest) {
    const std::size_t digit = rest.find_first_not_of(" \t", 1);
    return digit != rest.npos && isDigit(rest[digit]);
  };
  const auto isArchive = [](std::string_view rest) { return rest.starts_with("%_N_"); };
  const auto isProcedure = [](std::string_view rest) {
    return firstName(rest.substr(0, 5)) == "PROC";
  };
  return (language.hasOWords && count("Oo:", isNumber)) ||
         (language.namesAreCalls && (count("%", isArchive) || count("Pp", isProcedure)));
}

bool isSteering(std::string_view statement, const Language& language) {
  const auto& words = language.steering;
  return std::find(words.begin(), words.end(), firstName(statement)) != words.end() ||
         (language.hasOStatements && !statement.empty() &&
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
