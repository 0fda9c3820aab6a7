// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/lexer.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "base/text.h"
#include "nc/syntax/klartext.h"
#include "nc/syntax/language.h"

namespace rivulet::nc {

namespace {

using base::toUpper;

enum Class : std::uint8_t { kOther, kBlank, kDigit, kLetter };

constexpr std::array<std::uint8_t, 256> makeClasses() {
  std::array<std::uint8_t, 256> classes{};
  for (const char c : {' ', '\t', '\v', '\f'}) {
    classes[static_cast<unsigned char>(c)] = kBlank;
  }
  for (int c = '0'; c <= '9'; ++c) {
    classes[static_cast<std::size_t>(c)] = kDigit;
  }
  for (int c = 'A'; c <= 'Z'; ++c) {
    classes[static_cast<std::size_t>(c)] = kLetter;
    classes[static_cast<std::size_t>(c - 'A' + 'a')] = kLetter;
  }
  classes['_'] = kLetter;
  return classes;
}

constexpr std::array<std::uint8_t, 256> kClasses = makeClasses();

std::uint8_t classOf(char c) {
  return kClasses[static_cast<unsigned char>(c)];
}

/// Comparisons instead of a search in a text: it is asked for each word of a program.
template <char... kSet>
bool isOneOf(char c) {
  return ((c == kSet) || ...);
}

/// What may not stand directly after a number: the word would mean something else than what was
/// read, "X1,5" and "X10-R1" above all.
bool spoilsNumber(char c) {
  return isOneOf<'.', ',', '+', '-', '*', '/', '^', '#', '['>(c);
}

/// Addresses whose number may be one that a computer printed: "1e-05" is one word, not two.
bool isMeasure(char address) {
  return isOneOf<'A', 'B', 'C', 'F', 'I', 'J', 'K', 'Q', 'R', 'S', 'U', 'V', 'W', 'X', 'Y', 'Z'>(
      address);
}

/// Names that start a statement of the control's language; the rest of the line belongs to it.
constexpr std::array<std::string_view, 42> kStatements{
    "CALL",   "CANCEL", "CASE",    "CLEAR",    "DEF",    "DEFAULT", "DEFINE", "DO",  "ELSE",
    "ENDFOR", "ENDIF",  "ENDLOOP", "ENDWHILE", "EVERY",  "EXTCALL", "EXTERN", "FOR", "FROM",
    "GOTO",   "GOTOB",  "GOTOC",   "GOTOF",    "GOTOS",  "ID",      "IDS",    "IF",  "LOOP",
    "MCALL",  "PCALL",  "PROC",    "REDEF",    "REPEAT", "REPEATB", "SETINT", "SUB", "ENDSUB",
    "END",    "UNTIL",  "WHEN",    "WHENEVER", "WHILE",  "SAVE"};

/// True if the name, whatever its case, is one of the words.
bool isOneOfWords(std::string_view name, std::span<const std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [name](std::string_view word) {
    return std::equal(name.begin(), name.end(), word.begin(), word.end(),
                      [](char a, char b) { return toUpper(a) == b; });
  });
}

bool isStatement(std::string_view name, const Language& language) {
  // DO1, END1 and GOTO100 of the ISO dialects; SUB1 and CASE2 are names of SINUMERIK programs.
  while (!language.namesAreCalls && !name.empty() && classOf(name.back()) == kDigit) {
    name.remove_suffix(1);
  }
  return isOneOfWords(name, kStatements) || isOneOfWords(name, language.steering);
}

/// Reads one line. Pointers instead of indices: this loop decides how fast a program loads.
class LineReader {
 public:
  LineReader(std::string_view text, const Language& language, Place place, Words& words)
      : m_end(text.data() + text.size()),
        m_at(text.data()),
        m_column(m_at - (place.column - 1)),
        m_place(place),
        m_language(language),
        m_words(words),
        m_tokens(words.tokens) {}

  /// What stands behind the end of the block, ";" included.
  [[nodiscard]] std::string_view rest() const {
    return {m_at, static_cast<std::size_t>(m_end - m_at)};
  }

  void read() {
    skipBlanks();
    if (m_at == m_end) {
      return;
    }
    if (*m_at == '%') {
      add(TokenKind::Tape, m_at, m_end);
      m_at = m_end;
      return;
    }
    while (m_at != m_end) {
      switch (classOf(*m_at)) {
        case kBlank:
          ++m_at;
          break;
        case kLetter:
          readLetter();
          break;
        default:
          if (!readOther()) {
            return;
          }
      }
    }
  }

 private:
  void skipBlanks() {
    while (m_at != m_end && classOf(*m_at) == kBlank) {
      ++m_at;
    }
  }

  [[nodiscard]] char peek() const { return m_at == m_end ? '\0' : *m_at; }

  [[nodiscard]] int columnOf(const char* at) const { return static_cast<int>(at - m_column) + 1; }

  Token& add(TokenKind kind, const char* from, const char* to, char address = 0,
             double value = 0.0) {
    return m_tokens.emplace_back(
        Token{kind, address, m_hasPoint, Reference::Modal, columnOf(from), value,
              std::string_view(from, static_cast<std::size_t>(to - from))});
  }

  /// The end of the block without the comment after ";", which may stand inside quotes.
  [[nodiscard]] const char* endOfStatement() const {
    bool quoted = false;
    const char* end = m_at;
    for (; end != m_end && (quoted || *end != ';'); ++end) {
      quoted ^= *end == '"';
    }
    while (end != m_at && classOf(end[-1]) == kBlank) {
      --end;
    }
    return end;
  }

  void addStatement(const char* from, char address = 0) {
    const char* const end = endOfStatement();
    add(TokenKind::Statement, from, end, address);
    m_at = end;
  }

  /// True if no word can begin with what comes next: it belongs to the calculation before it.
  [[nodiscard]] bool isInCalculation(const char* at) const {
    while (at != m_end && classOf(*at) == kBlank) {
      ++at;
    }
    return at != m_end &&
           (classOf(*at) == kDigit ||
            isOneOf<'+', '-', '*', '/', '<', '>', '=', '^', ',', '.', '"', '\''>(*at));
  }

  /// The end of what cannot be read: a blank outside of brackets and quotes, before a word.
  [[nodiscard]] const char* endOfUnreadable(const char* at) const {
    int depth = 0;
    bool quoted = false;
    for (; at != m_end && (quoted || *at != ';'); ++at) {
      quoted ^= *at == '"';
      if (!quoted) {
        depth += isOneOf<'(', '['>(*at) ? 1 : (isOneOf<')', ']'>(*at) ? -1 : 0);
        if (depth <= 0 && classOf(*at) == kBlank && !isInCalculation(at)) {
          break;
        }
      }
    }
    return at;
  }

  /// A word with a value that is calculated, X=R1+2, X[#1], CR=R1, or a variable that is set, R1=5.
  void addCalculation(TokenKind kind, const char* from, char address) {
    const char* const valueFrom = m_at;
    Reader reader({from, static_cast<std::size_t>(m_end - from)}, m_language.notation,
                  {m_place.line, m_place.file, columnOf(from)});
    const bool isHashAddress = address != 0 && !m_language.notation.hasNames;
    Expected<Assignment> read = isHashAddress ? reader.address() : reader.assignment();
    m_at = from + reader.length();
    while (m_at != from && classOf(m_at[-1]) == kBlank) {
      --m_at;
    }
    const bool ends = m_at == m_end || isOneOf<' ', '\t', '\v', '\f', ';', '('>(*m_at) ||
                      (m_at != from && isOneOf<')', ']'>(m_at[-1])) || isAtNextWord();
    const bool goesOn = !ends || isInCalculation(m_at);
    if (!read) {
      m_at = endOfUnreadable(valueFrom);
    } else if (goesOn && !isHashAddress) {
      const char* const rest = std::exchange(m_at, endOfUnreadable(m_at));
      read = fail(FaultCode::RestNotUnderstood,
                  std::string(base::trim({rest, static_cast<std::size_t>(m_at - rest)})),
                  {m_place.line, m_place.file, columnOf(rest)});
    }
    Token& made = add(kind, from, m_at, address);
    if (!read || !isConstant(*read, made)) {
      if (kind == TokenKind::Word || kind == TokenKind::NamedValue) {
        const bool isLetter = address != 0 && !isTextOf(read);  // T="MILL_"<<R1 names a tool
        made.kind = isLetter ? TokenKind::Expression : TokenKind::Assignment;
      }
      made.calculation =
          m_words.calculations
              .emplace_back(std::make_shared<const Expected<Assignment>>(std::move(read)))
              .get();
    }
  }

  /// Blanks are not needed in RS-274/NGC: #1=2G0X3.
  [[nodiscard]] bool isAtNextWord() const {
    return m_language.hasPolarSigns &&
           (isOneOf<'#', '@', '^'>(*m_at) ||
            (classOf(*m_at) == kLetter && m_at + 1 != m_end && classOf(m_at[1]) != kLetter));
  }

  static bool isTextOf(const Expected<Assignment>& read) {
    return read && read->initial.kind == Initial::Kind::One &&
           read->initial.values.front()->op == Op::Concatenate;
  }

  /// X=(5) and X='HFF' are words like X5, T="MILL" has a text.
  static bool isConstant(const Assignment& read, Token& token) {
    const Expression* const value =
        read.initial.kind == Initial::Kind::One ? &*read.initial.values.front() : nullptr;
    const bool isText = value != nullptr && value->op == Op::Text;
    const bool takesConstant = token.kind == TokenKind::Word ||
                               token.kind == TokenKind::NamedValue ||
                               (token.kind == TokenKind::IndexedWord && isText);
    if (value == nullptr || !takesConstant || read.reference != Reference::Modal ||
        (value->op != Op::Number && !isText)) {
      return false;
    }
    token.kind = isText && token.kind != TokenKind::IndexedWord ? TokenKind::TextWord : token.kind;
    token.value = value->number;
    return true;
  }

  enum class NumberStatus { Read, Missing, Malformed };

  /// @return behind them
  const char* readDigits(const char* at, std::uint64_t& number) const {
    const char* const end = m_end;
    std::uint64_t read = number;
    for (; at != end && *at >= '0' && *at <= '9'; ++at) {
      read = read * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    number = read;
    return at;
  }

  NumberStatus readNumber(double& value) {
    bool negative = false;
    while (m_at != m_end && (*m_at == '-' || *m_at == '+')) {
      negative ^= *m_at == '-';
      ++m_at;
      skipBlanks();
      if (!m_language.hasRepeatedSigns) {
        break;
      }
    }
    const char* const from = m_at;
    std::uint64_t mantissa = 0;
    m_at = readDigits(from, mantissa);
    auto digits = m_at - from;
    std::ptrdiff_t decimals = 0;
    m_hasPoint = m_at != m_end && *m_at == '.';
    if (m_hasPoint) {
      const char* const point = m_at + 1;
      m_at = readDigits(point, mantissa);
      decimals = m_at - point;
      digits += decimals;
    }
    if (m_at != from && m_at != m_end && classOf(*m_at) == kBlank && goesOnBehindBlanks()) {
      return readSpacedNumber(from, negative, value);
    }
    if (digits == 0) {
      const bool isSign = m_at != m_end && (*m_at == '-' || *m_at == '+');
      return m_at == from && !isSign ? NumberStatus::Missing : NumberStatus::Malformed;
    }
    if (digits <= 15) {
      // Both operands are exact doubles, so the quotient is the correctly rounded number.
      static constexpr std::array<double, 16> kPowersOfTen{
          1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
      value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    } else {
      // The exponent form is not NC text: "1E5" must not become one number.
      const auto [end, status] =
          fast_float::from_chars(from, m_at, value, fast_float::chars_format::fixed);
      if (status != std::errc{} || end != m_at) {
        return NumberStatus::Malformed;
      }
    }
    if (negative) {
      value = -value;
    }
    return endsNumber() ? NumberStatus::Read : NumberStatus::Malformed;
  }

  /// True if what follows directly leaves the number what it is. In RS-274/NGC "^" begins a word,
  /// @5^30, and "#" an assignment, X1#2=3; on a Fanuc "," begins one, X10.,R2.
  [[nodiscard]] bool endsNumber() const {
    return m_at == m_end || !spoilsNumber(*m_at) ||
           (isOneOf<'^', '#'>(*m_at) && m_language.hasPolarSigns) ||
           (*m_at == ',' && m_language.hasCommaWords && m_at + 1 != m_end &&
            classOf(m_at[1]) == kLetter);
  }

  /// True if digits or a decimal point follow the blanks here: "1 0", "1 . 5".
  [[nodiscard]] bool goesOnBehindBlanks() const {
    const char* at = m_at;
    while (at != m_end && classOf(*at) == kBlank) {
      ++at;
    }
    return at != m_end && (classOf(*at) == kDigit || *at == '.');
  }

  /// A number with blanks in it, in one piece.
  [[gnu::noinline]] NumberStatus readSpacedNumber(const char* from, bool negative, double& value) {
    std::string digits;
    const char* end = from;
    for (m_at = from; m_at != m_end; ++m_at) {
      if (classOf(*m_at) == kDigit || *m_at == '.') {
        digits += *m_at;
        end = m_at + 1;
      } else if (classOf(*m_at) != kBlank) {
        break;
      }
    }
    m_at = end;
    m_isSpaced = true;
    m_hasPoint = digits.find('.') != std::string::npos;
    const char* const last = digits.data() + digits.size();
    const auto [parsed, status] =
        fast_float::from_chars(digits.data(), last, value, fast_float::chars_format::fixed);
    if (!m_language.ignoresBlanksInNumbers || status != std::errc{} || parsed != last) {
      return NumberStatus::Malformed;
    }
    value = negative ? -value : value;
    return endsNumber() ? NumberStatus::Read : NumberStatus::Malformed;
  }

  /// What stands directly behind the number of a coordinate and belongs to it: an exponent, or a
  /// unit, X1e-05 and X10mm. Taken for words of their own, they would leave a wrong number.
  /// @param from  of the number  @return Malformed if it cannot be read
  NumberStatus readExponent(const char* from, double& value) {
    const char letter = toUpper(*m_at);
    const char* at = m_at + 1;
    const auto isLetter = [this](const char* each) {
      return each != m_end && classOf(*each) == kLetter;
    };
    const bool isEx =
        m_language.notation.hasNames && letter == 'E' && isLetter(at) && toUpper(*at) == 'X';
    at += isEx ? 1 : 0;
    const char* const sign = at;
    at += at != m_end && (*at == '-' || *at == '+') ? 1 : 0;
    const bool isExponent = letter == 'E' && at != m_end && classOf(*at) == kDigit;
    if (!isExponent && (m_language.notation.hasNames || (letter != '_' && !isLetter(m_at + 1)))) {
      return NumberStatus::Read;
    }
    while (at != m_end && (classOf(*at) == kDigit || isLetter(at))) {
      ++at;
    }
    if (!isEx || !isExponent) {
      m_at = at;
      return NumberStatus::Malformed;
    }
    std::string number(from, m_at);
    std::erase_if(number, [](char c) { return c == '+' || classOf(c) == kBlank; });
    number += 'e';
    number.append(sign, at);
    const char* const last = number.data() + number.size();
    const auto [parsed, status] = fast_float::from_chars(number.data(), last, value);
    m_at = at;
    return status == std::errc{} && parsed == last && std::isfinite(value)
               ? NumberStatus::Read
               : NumberStatus::Malformed;
  }

  void addMalformed(const char* from, char address) {
    while (m_at != m_end && classOf(*m_at) != kBlank && classOf(*m_at) != kLetter &&
           !isOneOf<';', '(', ')'>(*m_at)) {
      ++m_at;
    }
    add(TokenKind::NumberMalformed, from, m_at, address);
  }

  void readLetter() {
    const char* const from = m_at++;
    if (m_at != m_end && classOf(*m_at) == kLetter) {
      readName(from);
      return;
    }
    const char address = toUpper(*from);
    if (m_at != m_end && address != 'O' && (*m_at == '-' || classOf(*m_at) == kDigit)) {
      readValueOf(from, address);  // as nearly all are
      return;
    }
    skipBlanks();
    const char c = peek();
    if (c == '=') {
      ++m_at;
      readAssignedValue(from, address, TokenKind::Word);
      return;
    }
    if (address == 'O' && startsSubprogramWord()) {
      addStatement(from, address);
      return;
    }
    if (isOneOf<'[', '#', '$', '<'>(c) && m_at != m_end) {
      // An index or, of any other letter, an array of that name.
      const bool isIndex = isOneOf<'G', 'M', 'S', 'T', 'H', 'D'>(address);
      addCalculation(!m_language.hasIndexedWords || c != '[' ? TokenKind::Expression
                     : isIndex                               ? TokenKind::IndexedWord
                                                             : TokenKind::Assignment,
                     from, address);
      return;
    }
    readValueOf(from, address);
  }

  /// The number or calculation directly after an address.
  void readValueOf(const char* from, char address) {
    const char* const numberFrom = m_at;
    double value = 0.0;
    NumberStatus status = readNumber(value);
    if (status == NumberStatus::Read && m_at != m_end && classOf(*m_at) == kLetter &&
        isMeasure(address)) {
      status = readExponent(numberFrom, value);
    }
    switch (status) {
      case NumberStatus::Read:
        add(TokenKind::Word, from, m_at, address, value);
        break;
      case NumberStatus::Missing:
        if (m_at != m_end && isOneOf<'[', '#', '$'>(*m_at)) {
          m_at = numberFrom;
          addCalculation(TokenKind::Expression, from, address);
        } else {
          add(TokenKind::NumberMissing, from, from + 1, address);
        }
        break;
      case NumberStatus::Malformed:
        addMalformed(numberFrom, address);
        break;
    }
  }

  /// O<name> and O100 with a word after it, as in "O100 while": RS-274/NGC.
  [[nodiscard]] bool startsSubprogramWord() const {
    if (!m_tokens.empty() && !(m_tokens.size() == 1 && m_tokens.front().address == 'N')) {
      return false;
    }
    const char* at = m_at;
    if (at != m_end && *at == '<') {
      return true;
    }
    while (at != m_end && (classOf(*at) == kDigit || *at == '.')) {
      ++at;
    }
    const bool hasNumber = at != m_at;
    at = behindBlanks(at);
    while (m_language.hasCommentsBehindOWords && at != m_end && *at == '(') {
      const char* const close = std::find(at, m_end, ')');
      at = close == m_end ? m_end : behindBlanks(close + 1);
    }
    // O1 G17 is the number of a program and a word.
    return hasNumber && at != m_end && classOf(*at) == kLetter && at + 1 != m_end &&
           classOf(at[1]) == kLetter;
  }

  [[nodiscard]] const char* behindBlanks(const char* at) const {
    while (at != m_end && classOf(*at) == kBlank) {
      ++at;
    }
    return at;
  }

  /// True if what was read is not the beginning of a calculation: at the end of the statement, and
  /// before a word of one letter. Operators are signs or words of two letters at least.
  [[nodiscard]] bool isAtWord() const {
    const char* at = m_at;
    while (at != m_end && classOf(*at) == kBlank) {
      ++at;
    }
    return at == m_end || isOneOf<';', '('>(*at) ||
           (classOf(*at) == kLetter && (at + 1 == m_end || classOf(at[1]) != kLetter));
  }

  /// Behind the "=" of `X=`, `CR=` or `M1=`.
  void readAssignedValue(const char* from, char address, TokenKind kind) {
    skipBlanks();
    const char* const valueFrom = m_at;
    double value = 0.0;
    m_isSpaced = false;
    const NumberStatus status = readNumber(value);
    if (status == NumberStatus::Read && isAtWord()) {
      add(kind, from, m_at, address, value);
      return;
    }
    const bool isMalformed =
        status != NumberStatus::Read && (m_isSpaced || (m_at != m_end && isOneOf<',', '.'>(*m_at)));
    if (isMalformed) {
      m_at = m_isSpaced ? m_at : valueFrom;
      addMalformed(valueFrom, address);
      return;
    }
    m_at = valueFrom;
    if (m_at == m_end || *m_at == ';') {
      add(TokenKind::NumberMissing, from, m_at, address);
    } else {
      addCalculation(kind, from, address);
    }
  }

  void readName(const char* from) {
    while (m_at != m_end && (classOf(*m_at) == kLetter || classOf(*m_at) == kDigit)) {
      ++m_at;
    }
    const char* const nameEnd = m_at;
    const std::string_view name(from, static_cast<std::size_t>(nameEnd - from));
    if (peek() == ':') {
      ++m_at;
      add(TokenKind::Label, from, m_at);
      return;
    }
    if (isStatement(name, m_language)) {
      addStatement(from);
      return;
    }
    skipBlanks();
    if (peek() == '=') {
      ++m_at;
      readAssignedValue(from, 0, TokenKind::NamedValue);
      return;
    }
    if (peek() == '[') {
      addCalculation(TokenKind::Assignment, from, 0);
      return;
    }
    // Behind a blank, "(" starts a comment unless it encloses a text, as in MSG ("...").
    if (peek() == '(' && (m_at == nameEnd || (m_end - m_at > 1 && m_at[1] == '"'))) {
      readArguments(from);
      return;
    }
    m_at = nameEnd;
    add(TokenKind::Name, from, nameEnd);
  }

  void readArguments(const char* from) {
    int depth = 0;
    bool quoted = false;
    for (; m_at != m_end; ++m_at) {
      if (*m_at == '"') {
        quoted = !quoted;
      } else if (!quoted && *m_at == '(') {
        ++depth;
      } else if (!quoted && *m_at == ')' && --depth == 0) {
        ++m_at;
        add(TokenKind::Call, from, m_at);
        return;
      }
    }
    add(TokenKind::CommentNotClosed, from, m_end);
  }

  /// Of the address that stands before it.
  void readAssignment() {
    const Token previous = m_tokens.back();
    m_tokens.pop_back();
    ++m_at;
    if (isOneOf<'M', 'S', 'T', 'H', 'D'>(previous.address)) {
      readAssignedValue(previous.text.data(), previous.address, TokenKind::IndexedWord);
    } else if (previous.address == 'R') {
      skipBlanks();
      addCalculation(TokenKind::Assignment, previous.text.data(), previous.address);
    } else {
      // I1=, A3=: an address of its own.
      readAssignedValue(previous.text.data(), 0, TokenKind::NamedValue);
    }
  }

  /// @return false if the rest of the line is done with
  bool readOther() {
    const char* const from = m_at;
    switch (*m_at) {
      case ';':
        return false;
      case '(':
        return readComment();
      case '/':
        if (m_tokens.empty() || m_language.skipsWithinBlocks ||
            (m_tokens.size() == 1 && m_tokens.front().address == 'N')) {
          ++m_at;
          if (m_at != m_end && classOf(*m_at) == kDigit) {
            ++m_at;
          }
          add(TokenKind::BlockSkip, from, m_at);
          return true;
        }
        break;
      case ':':
        // ":10" is the number of a main block.
        if (m_tokens.empty()) {
          ++m_at;
          double value = 0.0;
          if (readNumber(value) == NumberStatus::Read) {
            add(TokenKind::Word, from, m_at, 'N', value);
            return true;
          }
          m_at = from;
        }
        break;
      case '=':
        if (!m_tokens.empty() && m_tokens.back().kind == TokenKind::Word) {
          readAssignment();
          return true;
        }
        break;
      case ',':
        // ,R and ,C: how a corner ends.
        if (m_language.hasCommaWords && m_end - m_at > 2 && isOneOf<'R', 'C'>(toUpper(m_at[1]))) {
          m_at += 2;
          skipBlanks();
          double value = 0.0;
          if (readNumber(value) == NumberStatus::Read) {
            add(TokenKind::NamedValue, from, m_at, 0, value);
            return true;
          }
          m_at = from;
        }
        break;
      case '#':
      case '$':
        addCalculation(TokenKind::Assignment, from, 0);
        return true;
      case '@':
      case '^':
        if (m_language.hasPolarSigns) {
          ++m_at;
          skipBlanks();
          readValueOf(from, *from);
          return true;
        }
        break;
      default:
        break;
    }
    ++m_at;
    if (static_cast<unsigned char>(*from) >= 0x80) {
      // The bytes of one character, or a run of them, are one finding.
      while (m_at != m_end && static_cast<unsigned char>(*m_at) >= 0x80) {
        ++m_at;
      }
    }
    add(TokenKind::UnexpectedCharacter, from, m_at);
    return true;
  }

  bool readComment() {
    const char* const from = m_at;
    int depth = 0;
    int deepest = 0;
    for (; m_at != m_end; ++m_at) {
      if (*m_at == '(') {
        deepest = std::max(deepest, ++depth);
      } else if (*m_at == ')' && --depth == 0) {
        ++m_at;
        if (!m_language.hasBracketComments) {
          add(TokenKind::Comment, from, m_at);
        } else if (deepest > 1) {
          add(TokenKind::CommentNested, from, m_at);
        }
        return true;
      }
    }
    add(TokenKind::CommentNotClosed, from, m_end);
    m_at = m_end;
    return false;
  }

  const char* m_end;
  const char* m_at;
  const char* m_column;  ///< where the first column is
  Place m_place;
  const Language& m_language;
  bool m_hasPoint = false;  ///< of the number read last
  bool m_isSpaced = false;  ///< the same: with blanks in it
  Words& m_words;
  std::vector<Token>& m_tokens;
};

}  // namespace

std::string_view tokenName(const Token& token) {
  if (token.text.starts_with(',')) {  // ,R
    return token.text.substr(0, 2);
  }
  std::size_t length = 0;
  while (length < token.text.size() &&
         (classOf(token.text[length]) == kLetter || classOf(token.text[length]) == kDigit)) {
    ++length;
  }
  return token.text.substr(0, length);
}

Assignment assignmentOf(const Token& token) {
  Assignment made;
  made.target.op = Op::Variable;
  made.target.name = base::toUpper(tokenName(token));
  Expression value = Expression::constant(token.value);
  if (token.kind == TokenKind::TextWord) {
    value.op = Op::Text;
    const std::size_t open = token.text.find('"');
    value.name = token.text.substr(open + 1, token.text.size() - open - 2);
  }
  made.initial.values.emplace_back(std::move(value));
  return made;
}

std::string wordText(const Token& token) {
  return fmt::format("{}{}", token.address, token.value);
}

Words readWords(std::string_view text, const Language& language, Place place) {
  Words words;
  LineReader(text, language, place, words).read();
  return words;
}

namespace {

/// True if a control reads this as words: none is a name or has a part that is no NC text.
bool isWords(std::string_view text, const Language& language) {
  const Words words = readWords(text, language, {});
  return std::all_of(words.tokens.begin(), words.tokens.end(), [](const Token& token) {
    switch (token.kind) {
      case TokenKind::Word:
      case TokenKind::BlockSkip:
        return true;
      case TokenKind::Expression:
      case TokenKind::Assignment:
        return token.calculation != nullptr && token.calculation->has_value();
      case TokenKind::Statement:
        return token.text.find_first_of("[0123456789") != std::string_view::npos;
      default:
        return false;
    }
  });
}

}  // namespace

Semicolon semicolonOf(std::string_view text, const Language& language) {
  Semicolon found = Semicolon::EndsLine;
  for (std::size_t at = text.find(';'); at != std::string_view::npos; at = text.find(';', at)) {
    const std::size_t before = text.find_last_of("\r\n", at);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    int depth = 0;
    std::size_t from = begin;
    for (std::size_t i = begin; i < end; ++i) {
      depth = text[i] == '(' ? depth + 1 : text[i] == ')' ? std::max(depth - 1, 0) : depth;
      if (text[i] != ';' || depth > 0) {
        continue;
      }
      // Up to the next one.
      from = i + 1;
      std::size_t to = from;
      for (int inner = 0; to < end && (text[to] != ';' || inner > 0); ++to) {
        inner = text[to] == '(' ? inner + 1 : text[to] == ')' ? std::max(inner - 1, 0) : inner;
      }
      const std::string_view tail = base::trim(text.substr(from, to - from));
      if (!tail.empty() && !isWords(tail, language)) {
        return Semicolon::BeginsComment;
      }
      const bool isComment = !tail.empty() && tail.front() == '(' && tail.back() == ')';
      found = tail.empty() || isComment ? found : Semicolon::EndsBlock;
    }
    at = end;
  }
  return found;
}

Lexer::Lexer(std::string_view text, Dialect dialect, std::uint16_t file)
    : m_language(languageOf(dialect)), m_file(file) {
  // A byte order mark and the end marks of old systems are not part of the program.
  if (text.substr(0, 3) == "\xEF\xBB\xBF") {
    text.remove_prefix(3);
  }
  while (!text.empty() && (text.back() == '\x1A' || text.back() == '\0')) {
    text.remove_suffix(1);
  }
  if (text.empty()) {
    text = std::string_view("", 0);  // never a null pointer
  }
  m_text = text;
  m_position = text.data();
  m_end = text.data() + text.size();
  m_lineFeed = nullptr;
  m_return = nullptr;
}

bool Lexer::next(Block& block) {
  std::optional<std::string_view> line;
  block.column = 1;
  if (m_rest.empty()) {
    line = nextLine();
  } else {
    line = std::exchange(m_rest, {});
    block.column = m_restColumn;
  }
  if (!line) {
    return false;
  }
  block.line.value = m_line;
  block.tokens.clear();
  block.calculations.clear();
  if (m_language.isKlartext) {
    std::string_view whole = *line;
    for (std::string_view last = *line; klartextContinues(last);) {
      const std::optional<std::string_view> more = nextLine();
      if (!more) {
        break;
      }
      last = *more;
      whole = {whole.data(), static_cast<std::size_t>(last.data() + last.size() - whole.data())};
    }
    readKlartext(whole, block.tokens);
  } else {
    LineReader reader(*line, m_language, {block.line, m_file, block.column}, block);
    reader.read();
    if (m_language.semicolonEndsBlock && reader.rest().size() > 1) {
      keepRest(reader.rest(), block.column + static_cast<int>(line->size() - reader.rest().size()));
    }
  }
  return true;
}

void Lexer::keepRest(std::string_view rest, int column) {
  const std::string_view behind = rest.substr(1);
  if (base::trim(behind).empty()) {
    return;
  }
  if (!m_semicolon) {
    m_semicolon = semicolonOf(m_text, m_language);
  }
  if (*m_semicolon == Semicolon::EndsBlock) {
    m_rest = behind;
    m_restColumn = column + 1;
  }
}

std::optional<std::string_view> Lexer::nextLine() {
  if (m_position == m_end) {
    return std::nullopt;
  }
  ++m_line;
  const char* const begin = m_position;
  const auto find = [begin, this](char c, const char* known) {
    if (known != nullptr && known >= begin) {
      return known;
    }
    const void* const found = std::memchr(begin, c, static_cast<std::size_t>(m_end - begin));
    return found == nullptr ? m_end : static_cast<const char*>(found);
  };
  m_lineFeed = find('\n', m_lineFeed);
  m_return = find('\r', m_return);
  const char* const end = std::min(m_lineFeed, m_return);
  m_position = end;
  if (m_position != m_end && *m_position == '\r') {
    ++m_position;
    // CR CR LF, as some transfers leave it, ends one line.
    if (m_lineFeed - m_position == 1 && *m_position == '\r') {
      ++m_position;
    }
  }
  if (m_position != m_end && *m_position == '\n' && m_position == m_lineFeed) {
    ++m_position;
  }
  return std::string_view(begin, static_cast<std::size_t>(end - begin));
}

}  // namespace rivulet::nc
