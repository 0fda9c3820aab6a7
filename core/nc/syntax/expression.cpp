// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/syntax/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "base/text.h"
#include "nc/limits.h"

namespace rivulet::nc {

namespace {

using base::isBlank;
using base::isDigit;
using base::isNameLetter;

// Longer words before their beginnings.
constexpr std::array kComparisons{
    OperatorWord{"==", Op::Equal},     OperatorWord{"<>", Op::Unequal},
    OperatorWord{"<=", Op::LessEqual}, OperatorWord{">=", Op::GreaterEqual},
    OperatorWord{"<", Op::Less},       OperatorWord{">", Op::Greater}};
constexpr std::array kConcatenation{OperatorWord{"<<", Op::Concatenate}};
constexpr std::array kOr{OperatorWord{"OR", Op::Or}};
constexpr std::array kXor{OperatorWord{"XOR", Op::Xor}};
constexpr std::array kAnd{OperatorWord{"AND", Op::And}};
constexpr std::array kBitOr{OperatorWord{"B_OR", Op::BitOr}};
constexpr std::array kBitXor{OperatorWord{"B_XOR", Op::BitXor}};
constexpr std::array kBitAnd{OperatorWord{"B_AND", Op::BitAnd}};
constexpr std::array kSums{OperatorWord{"+", Op::Add}, OperatorWord{"-", Op::Subtract}};
constexpr std::array kProducts{OperatorWord{"*", Op::Multiply}, OperatorWord{"/", Op::Divide},
                               OperatorWord{"DIV", Op::IntegerDivide},
                               OperatorWord{"MOD", Op::Modulo}};
using Level = std::span<const OperatorWord>;
constexpr std::array<Level, 10> kSinumerikLevels{
    kComparisons, kConcatenation, kOr, kXor, kAnd, kBitOr, kBitXor, kBitAnd, kSums, kProducts};

constexpr std::array kHashLogic{OperatorWord{"AND", Op::And}, OperatorWord{"XOR", Op::Xor},
                                OperatorWord{"OR", Op::Or}};
constexpr std::array kHashComparisons{
    OperatorWord{"EQ", Op::Equal},     OperatorWord{"NE", Op::Unequal},
    OperatorWord{"LE", Op::LessEqual}, OperatorWord{"GE", Op::GreaterEqual},
    OperatorWord{"LT", Op::Less},      OperatorWord{"GT", Op::Greater}};
constexpr std::array kHashProducts{OperatorWord{"*", Op::Multiply}, OperatorWord{"/", Op::Divide},
                                   OperatorWord{"MOD", Op::FloorModulo}};
constexpr std::array kPowers{OperatorWord{"**", Op::Power}};
constexpr std::array<Level, 5> kHashLevels{kHashLogic, kHashComparisons, kSums, kHashProducts,
                                           kPowers};

constexpr std::array kSinumerikFunctions{
    FunctionWord{"SIN", Op::Sin, 1},       FunctionWord{"COS", Op::Cos, 1},
    FunctionWord{"TAN", Op::Tan, 1},       FunctionWord{"ASIN", Op::Asin, 1},
    FunctionWord{"ACOS", Op::Acos, 1},     FunctionWord{"ATAN2", Op::Atan2, 2},
    FunctionWord{"SQRT", Op::Sqrt, 1},     FunctionWord{"POT", Op::Square, 1},
    FunctionWord{"ABS", Op::Abs, 1},       FunctionWord{"TRUNC", Op::Truncate, 1},
    FunctionWord{"ROUND", Op::Round, 1},   FunctionWord{"ROUNDUP", Op::RoundUp, 1},
    FunctionWord{"LN", Op::Ln, 1},         FunctionWord{"EXP", Op::Exp, 1},
    FunctionWord{"MINVAL", Op::MinVal, 2}, FunctionWord{"MAXVAL", Op::MaxVal, 2},
    FunctionWord{"BOUND", Op::Bound, 3}};
constexpr std::array kHashFunctions{
    FunctionWord{"SIN", Op::Sin, 1},       FunctionWord{"COS", Op::Cos, 1},
    FunctionWord{"TAN", Op::Tan, 1},       FunctionWord{"ASIN", Op::Asin, 1},
    FunctionWord{"ACOS", Op::Acos, 1},     FunctionWord{"ATAN", Op::Atan2, 2},
    FunctionWord{"SQRT", Op::Sqrt, 1},     FunctionWord{"ABS", Op::Abs, 1},
    FunctionWord{"FIX", Op::RoundDown, 1}, FunctionWord{"FUP", Op::RoundUp, 1},
    FunctionWord{"ROUND", Op::Round, 1},   FunctionWord{"LN", Op::Ln, 1},
    FunctionWord{"EXP", Op::Exp, 1},       FunctionWord{"EXISTS", Op::Exists, 1}};

constexpr std::array<std::string_view, 7> kTypeNames{"INT",    "REAL", "BOOL", "CHAR",
                                                     "STRING", "AXIS", "FRAME"};

/// @param upper  in upper case; the text in any
bool beginsWithWord(std::string_view text, std::string_view upper) {
  return text.size() >= upper.size() &&
         std::equal(upper.begin(), upper.end(), text.begin(),
                    [](char a, char b) { return a == base::toUpper(b); });
}

/// R, R5: no other name begins like that. @param text  from the name on
bool beginsWithR(std::string_view text) {
  if (text.empty() || base::toUpper(text[0]) != 'R') {
    return false;
  }
  const auto* const end =
      std::find_if(text.begin() + 1, text.end(), [](char c) { return !isDigit(c); });
  return end == text.end() || !isNameLetter(*end);
}

}  // namespace

Expression Expression::constant(double value) {
  Expression expression;
  expression.number = value;
  return expression;
}

const Notation& sinumerikNotation() {
  static constexpr Notation notation{kSinumerikLevels, kSinumerikFunctions, '(', ')', true};
  return notation;
}

const Notation& hashNotation() {
  static constexpr Notation notation{kHashLevels, kHashFunctions, '[', ']', false};
  return notation;
}

std::string_view typeName(Type type) {
  return kTypeNames[static_cast<std::size_t>(type)];
}

Reader::Reader(std::string_view text, const Notation& notation, Place place)
    : m_text(text), m_notation(notation), m_begin(place) {
}

// --- characters and words -------------------------------------------------------------------

void Reader::skipBlanks() {
  while (m_at < m_text.size() && isBlank(m_text[m_at])) {
    ++m_at;
  }
}

bool Reader::take(char c) {
  skipBlanks();
  if (peek() != c) {
    return false;
  }
  ++m_at;
  return true;
}

std::string Reader::name() {
  skipBlanks();
  std::size_t end = m_at;
  while (end < m_text.size() &&
         (isNameLetter(m_text[end]) || (end > m_at && isDigit(m_text[end])))) {
    ++end;
  }
  std::string found = base::toUpper(m_text.substr(m_at, end - m_at));
  m_at = end;
  return found;
}

bool Reader::takeWord(std::string_view upper) {
  skipBlanks();
  const std::size_t end = m_at + upper.size();
  const char next = end < m_text.size() ? m_text[end] : '\0';
  if (!beginsWithWord(m_text.substr(m_at), upper) || isNameLetter(next) || isDigit(next)) {
    return false;
  }
  m_at = end;
  return true;
}

std::size_t Reader::endOf(const OperatorWord& sign, std::size_t at) const {
  const std::string_view word = sign.word;
  if (!beginsWithWord(m_text.substr(at), word)) {
    return at;
  }
  const std::size_t end = at + word.size();
  const char next = end < m_text.size() ? m_text[end] : '\0';
  // "MODE" is not MOD, "*" of "**" is no product and "<" of "<<" no comparison. In the notation
  // with # words need no boundary: "EQ2" is EQ and 2.
  const bool goesOn =
      m_notation.hasNames && isNameLetter(word.back()) && (isNameLetter(next) || isDigit(next));
  return goesOn || (word == "*" && next == '*') || (word == "<" && next == '<') ? at : end;
}

std::size_t Reader::behindBlanks() const {
  std::size_t at = m_at;
  while (at < m_text.size() && isBlank(m_text[at])) {
    ++at;
  }
  return at;
}

bool Reader::takeOperator(const OperatorWord& sign) {
  const std::size_t begin = behindBlanks();
  const std::size_t end = endOf(sign, begin);
  m_at = end == begin ? m_at : end;
  return end != begin;
}

Reader::Ahead Reader::operatorAhead() const {
  const std::size_t begin = behindBlanks();
  constexpr std::string_view kEnds = ")],";
  if (begin == m_text.size() || kEnds.find(m_text[begin]) != kEnds.npos) {
    return {};
  }
  const char first = base::toUpper(m_text[begin]);
  for (std::size_t level = 0; level < m_notation.levels.size(); ++level) {
    for (const OperatorWord& sign : m_notation.levels[level]) {
      const std::size_t end = sign.word.front() == first ? endOf(sign, begin) : begin;
      if (end != begin) {
        return {sign.op, level, end};
      }
    }
  }
  return {};
}

bool Reader::isAtEnd() {
  skipBlanks();
  return m_at >= m_text.size();
}

Place Reader::place() const {
  return {m_begin.line, m_begin.file, m_begin.column + static_cast<int>(m_at)};
}

std::nullopt_t Reader::fault(FaultCode code, std::string argument) {
  if (!m_fault) {
    m_fault = Fault{code, std::move(argument), place()};
  }
  return std::nullopt;
}

template <class T>
Expected<T> Reader::outcome(std::optional<T> value) {
  if (!value) {
    return fail(*m_fault);
  }
  return std::move(*value);
}

Expression Reader::node(Op op, Place place, std::vector<Expression> operands) const {
  Expression made;
  made.op = op;
  made.place = place;
  made.operands = std::move(operands);
  return made;
}

// --- expressions ----------------------------------------------------------------------------

Expected<Expression> Reader::expression() {
  return outcome(level(0));
}

/// No two operators of a notation fit at one place but within a level, where the longer one comes
/// first. So what follows an operand is looked up once, not by each level again.
Reader::Result Reader::level(std::size_t weakest) {
  Result left = unary();
  for (int chain = 0; left; ++chain) {
    const Ahead found = operatorAhead();
    if (found.end == 0 || found.level < weakest) {
      return left;
    }
    if (chain == kChainMax) {
      return fault(FaultCode::NestedTooDeeply);
    }
    m_at = found.end;
    Result right = level(found.level + 1);
    if (!right) {
      return fault(FaultCode::OperandMissing);
    }
    Expression made = node(found.op, left->place);
    made.operands.reserve(2);
    made.operands.push_back(std::move(*left));
    made.operands.push_back(std::move(*right));
    *left = std::move(made);
  }
  return left;
}

Reader::Result Reader::unary() {
  if (++m_depth > kBracketsMax) {
    return fault(FaultCode::NestedTooDeeply);
  }
  Result value = unaryInner();
  --m_depth;
  return value;
}

Reader::Result Reader::unaryInner() {
  static constexpr std::array kSigns{OperatorWord{"-", Op::Negate},
                                     OperatorWord{"B_NOT", Op::BitNot},
                                     OperatorWord{"NOT", Op::Not}};
  skipBlanks();
  const Place at = place();
  if (take('+')) {
    return unary();
  }
  const char first = base::toUpper(peek());
  for (const OperatorWord& sign : kSigns) {
    if (sign.word.front() == first && (sign.op == Op::Negate || m_notation.hasNames) &&
        takeOperator(sign)) {
      Result value = unary();
      if (value && value->op == Op::Number && sign.op == Op::Negate) {
        value->number = -value->number;
        return value;
      }
      return value ? Result(node(sign.op, at, {std::move(*value)})) : std::nullopt;
    }
  }
  return primary();
}

Reader::Result Reader::primary() {
  skipBlanks();
  const char c = peek();
  if (isDigit(c) || c == '.') {
    return number();
  }
  if (c == m_notation.open) {
    ++m_at;
    Result value = level(0);
    return !value || take(m_notation.close) ? std::move(value) : fault(FaultCode::BracketNotClosed);
  }
  if (c == '#' && !m_notation.hasNames) {
    return hash();
  }
  if (c == '$') {
    return system();
  }
  if (c == '\'') {
    return bits();
  }
  if (c == '"') {
    return text();
  }
  if (!isNameLetter(c)) {
    return c == '\0' ? fault(FaultCode::ValueMissing)
                     : fault(FaultCode::NotAValue, std::string(1, c));
  }
  return named();
}

Reader::Result Reader::number() {
  const std::size_t from = m_at;
  Expression made = node(Op::Number, place());
  while (isDigit(peek()) || peek() == '.') {
    ++m_at;
  }
  std::optional<double> value;
  // SINUMERIK writes the exponent as EX: 8.2EX-3.
  if (m_notation.hasNames && beginsWithWord(m_text.substr(m_at), "EX")) {
    std::string literal(m_text.substr(from, m_at - from));
    m_at += 2;
    const std::size_t exponent = m_at;
    m_at += peek() == '-' || peek() == '+' ? 1 : 0;
    while (isDigit(peek())) {
      ++m_at;
    }
    literal += "e" + std::string(m_text.substr(exponent, m_at - exponent));
    value = base::parseNumber(literal);
  } else {
    value = base::parseNumber(m_text.substr(from, m_at - from));
  }
  if (!value) {
    return fault(FaultCode::NotANumber, std::string(m_text.substr(from, m_at - from)));
  }
  made.number = *value;
  return made;
}

Reader::Result Reader::bits() {
  const std::size_t end = m_text.find('\'', m_at + 1);
  const std::string digits =
      end == std::string_view::npos ? "" : base::toUpper(m_text.substr(m_at + 1, end - m_at - 1));
  const std::size_t radix = digits.size() < 2  ? 0
                            : digits[0] == 'H' ? 16
                            : digits[0] == 'B' ? 2
                                               : 0;
  Expression made = node(Op::Number, place());
  for (std::size_t i = 1; i < digits.size() && radix != 0; ++i) {
    const std::size_t digit = std::string_view("0123456789ABCDEF").find(digits[i]);
    if (digit >= radix) {
      return fault(FaultCode::ConstantMalformed);
    }
    made.number = static_cast<double>(radix) * made.number + static_cast<double>(digit);
  }
  if (radix == 0) {
    return fault(FaultCode::ConstantMalformed);
  }
  m_at = end + 1;
  return made;
}

Reader::Result Reader::text() {
  const std::size_t end = m_text.find('"', m_at + 1);
  if (end == std::string_view::npos) {
    return fault(FaultCode::TextNotClosed);
  }
  Expression made = node(Op::Text, place());
  made.name = m_text.substr(m_at + 1, end - m_at - 1);
  m_at = end + 1;
  return made;
}

/// Behind "R" or "$R": digits, or an index in brackets.
Reader::Result Reader::rParameter(Op op) {
  Expression made = node(op, place());
  const std::size_t from = m_at;
  while (isDigit(peek())) {
    ++m_at;
  }
  if (m_at > from) {
    const std::optional<double> number = base::parseNumber(m_text.substr(from, m_at - from));
    made.operands.push_back(Expression::constant(number.value_or(-1.0)));
    return made;
  }
  if (!take('[')) {
    return fault(FaultCode::RNumberMissing);
  }
  Result index = level(0);
  if (!index || !take(']')) {
    return fault(FaultCode::BracketNotClosed);
  }
  made.operands.push_back(std::move(*index));
  return made;
}

bool Reader::indices(Expression& made) {
  if (!take('[')) {
    return true;
  }
  do {
    Result index = level(0);
    if (!index) {
      return false;
    }
    made.operands.push_back(std::move(*index));
  } while (take(','));
  if (!take(']')) {
    fault(FaultCode::BracketNotClosed);
    return false;
  }
  return true;
}

/// $R5, $PI, $AC_PATHN, $AA_IM[X], $AC_MARKER[R1+1].
Reader::Result Reader::system() {
  Expression made = node(Op::System, place());
  ++m_at;
  if ((peek() == 'R' || peek() == 'r') && m_at + 1 < m_text.size() &&
      (isDigit(m_text[m_at + 1]) || m_text[m_at + 1] == '[')) {
    ++m_at;
    return rParameter(Op::MainR);
  }
  made.name = "$" + name();
  if (made.name == "$PI") {
    made.op = Op::Number;
    made.number = std::numbers::pi;
    return made;
  }
  return indices(made) ? Result(std::move(made)) : std::nullopt;
}

/// #5, ##2, #[expression], #<name>.
Reader::Result Reader::hash() {
  Expression made = node(Op::Hash, place());
  if (!take('#')) {
    return fault(FaultCode::VariableNumberMissing);
  }
  skipBlanks();
  if (peek() == '<') {
    const std::size_t end = m_text.find('>', m_at);
    if (end == std::string_view::npos) {
      return fault(FaultCode::VariableNameNotClosed);
    }
    made.op = Op::Variable;
    for (const char c : base::toUpper(m_text.substr(m_at, end + 1 - m_at))) {
      made.name += isBlank(c) ? "" : std::string(1, c);
    }
    m_at = end + 1;
    return made;
  }
  Result index;
  if (++m_depth > kBracketsMax) {
    return fault(FaultCode::NestedTooDeeply);
  }
  if (peek() == '#') {
    index = hash();
  } else if (take('[')) {
    index = level(0);
    if (index && !take(']')) {
      return fault(FaultCode::BracketNotClosed);
    }
  } else if (isNameLetter(peek())) {
    return fault(FaultCode::NoSuchHash, "#" + name());
  } else if (isDigit(peek())) {
    index = number();
  }
  --m_depth;
  if (!index) {
    return fault(FaultCode::VariableNumberMissing);
  }
  made.operands.push_back(std::move(*index));
  return made;
}

Reader::Result Reader::named() {
  const std::size_t from = m_at;
  const Place at = place();
  if (m_notation.hasNames && beginsWithR(rest())) {
    ++m_at;
    Result made = rParameter(Op::R);
    if (made) {
      made->place = at;
    }
    return made;
  }
  const std::string key = name();
  if (m_notation.hasNames && (key == "TRUE" || key == "FALSE")) {
    Expression made = node(Op::Number, at);
    made.number = key == "TRUE" ? 1.0 : 0.0;
    return made;
  }
  const auto found = std::find_if(m_notation.functions.begin(), m_notation.functions.end(),
                                  [&key](const FunctionWord& f) { return f.word == key; });
  if (found != m_notation.functions.end()) {
    return found->op == Op::Exists ? exists(at) : function(*found, at);
  }
  skipBlanks();
  if (!m_notation.hasNames || peek() == '(') {
    return fault(FaultCode::NameUnknown, key);
  }
  m_at = from + key.size();
  Expression made = node(Op::Variable, at);
  made.name = key;
  const std::size_t behind = m_at;
  skipBlanks();
  if (peek() != '[') {
    m_at = behind;
    return made;
  }
  return indices(made) ? Result(std::move(made)) : std::nullopt;
}

/// Behind the first argument of ATAN: a second one follows as "]/[".
bool Reader::hasSecond() const {
  std::string_view signs = "]/[";
  for (std::size_t at = m_at; at < m_text.size() && !signs.empty(); ++at) {
    if (m_text[at] == signs.front()) {
      signs.remove_prefix(1);
    } else if (!isBlank(m_text[at])) {
      return false;
    }
  }
  return signs.empty();
}

Reader::Result Reader::function(const FunctionWord& word, Place at) {
  Expression made = node(word.op, at);
  if (!take(m_notation.open)) {
    return fault(FaultCode::ArgumentsMissing, std::string(word.word));
  }
  for (int i = 0; i < word.arguments; ++i) {
    // The ISO dialects write two arguments as ATAN[y]/[x].
    if (i > 0 && word.ofOne != Op::Number && !hasSecond() && take(']')) {
      made.op = word.ofOne;
      return made;
    }
    const bool hasComma = (m_notation.hasNames || m_notation.hasCommas) && i > 0 && take(',');
    if (i > 0 && !hasComma && (m_notation.hasNames || !(take(']') && take('/') && take('[')))) {
      return m_notation.hasNames ? fault(FaultCode::TooFewArguments, std::string(word.word))
                                 : fault(FaultCode::AtanMalformed);
    }
    Result argument = level(0);
    if (!argument) {
      return std::nullopt;
    }
    made.operands.push_back(std::move(*argument));
  }
  return take(m_notation.close) ? Result(std::move(made)) : fault(FaultCode::BracketNotClosed);
}

Reader::Result Reader::exists(Place at) {
  if (!take('[')) {
    return fault(FaultCode::ExistsMalformed);
  }
  skipBlanks();
  Result variable = peek() == '#' ? hash() : std::nullopt;
  if (!variable || !take(']')) {
    return fault(FaultCode::ExistsMalformed);
  }
  return node(Op::Exists, at, {std::move(*variable)});
}

// --- assignments and definitions ------------------------------------------------------------

Expected<Expression> Reader::target() {
  return outcome(readTarget());
}

Reader::Result Reader::readTarget() {
  skipBlanks();
  const std::size_t from = m_at;
  Result made = primary();
  const bool fits = made && (made->op == Op::R || made->op == Op::MainR || made->op == Op::Hash ||
                             made->op == Op::Variable || made->op == Op::System);
  return !made || fits
             ? std::move(made)
             : fault(FaultCode::NotAssignable, std::string(m_text.substr(from, m_at - from)));
}

Expected<Assignment> Reader::assignment() {
  Result target = readTarget();
  if (!target) {
    return fail(*m_fault);
  }
  if (!take('=')) {
    fault(FaultCode::EqualsMissing);
    return fail(*m_fault);
  }
  Reference reference = Reference::Modal;
  std::optional<Initial> value =
      target->op != Op::Variable || takeReference(reference) ? initial() : std::nullopt;
  if (!value) {
    return fail(*m_fault);
  }
  Assignment made{std::move(*target), std::move(*value), reference, {}};
  if (!m_notation.hasNames) {
    const std::string_view behind = base::trim(rest());
    const std::size_t end = behind.find(')');
    if (behind.starts_with('(') && end != std::string_view::npos) {
      made.text = behind.substr(1, end - 1);
    }
  }
  return made;
}

namespace {

struct ReferenceWord {
  std::string_view word;
  Reference reference;
};
constexpr std::array kReferenceWords{
    ReferenceWord{"AC", Reference::Absolute}, ReferenceWord{"DC", Reference::Nearest},
    ReferenceWord{"ACP", Reference::Positive}, ReferenceWord{"ACN", Reference::Negative},
    ReferenceWord{"IC", Reference::Incremental}};

}  // namespace

std::string_view referenceWord(Reference reference) {
  const auto* const found =
      std::find_if(kReferenceWords.begin(), kReferenceWords.end(),
                   [reference](const ReferenceWord& each) { return each.reference == reference; });
  return found == kReferenceWords.end() ? std::string_view() : found->word;
}

/// AC(...), IC(...). @return false: see the fault
bool Reader::takeReference(Reference& reference) {
  const auto* const found =
      std::find_if(kReferenceWords.begin(), kReferenceWords.end(),
                   [this](const ReferenceWord& each) { return takeWord(each.word); });
  if (found == kReferenceWords.end()) {
    return true;
  }
  reference = found->reference;
  if (peek() != '(') {
    fault(FaultCode::ArgumentsMissing, std::string(found->word));
  }
  return peek() == '(';
}

void Reader::roundToIncrement(Expression& node) {
  node.op = node.op == Op::Round ? Op::RoundToIncrement : node.op;
  for (Expression& operand : node.operands) {
    roundToIncrement(operand);
  }
}

Expected<Assignment> Reader::address() {
  skipBlanks();
  Assignment made;
  made.target = node(Op::Variable, place());
  made.target.name = base::toUpper(m_text.substr(m_at++, 1));
  Result value = take('=') ? level(0) : unary();
  if (!value) {
    return fail(*m_fault);
  }
  // Lengths and angles have an increment; other numbers are whole.
  constexpr std::string_view kWithIncrement = "XYZUVWABCIJKQR";
  if (m_notation.roundsAddresses &&
      kWithIncrement.find(made.target.name) != std::string_view::npos) {
    roundToIncrement(*value);
  }
  made.initial.values.emplace_back(std::move(value));
  return made;
}

std::optional<Initial> Reader::initial() {
  Initial made;
  const bool isSet = m_notation.hasNames && takeWord("SET");
  if (isSet || (m_notation.hasNames && takeWord("REP"))) {
    made.kind = isSet ? Initial::Kind::Set : Initial::Kind::Rep;
    if (!take('(')) {
      return fault(FaultCode::ListMalformed);
    }
    do {
      skipBlanks();
      if (peek() == ',' || peek() == ')') {
        made.values.emplace_back();
        continue;
      }
      made.values.push_back(level(0));
      if (!made.values.back()) {
        return std::nullopt;
      }
    } while (take(','));
    if (!take(')')) {
      return fault(FaultCode::ListMalformed);
    }
    return made;
  }
  made.values.push_back(level(0));
  return made.values.back() ? std::optional(std::move(made)) : std::nullopt;
}

std::optional<Type> Reader::type() {
  const std::string word = name();
  const auto found = std::find(kTypeNames.begin(), kTypeNames.end(), word);
  if (found == kTypeNames.end()) {
    return fault(FaultCode::NoSuchType, word);
  }
  const auto made = static_cast<Type>(found - kTypeNames.begin());
  if (made == Type::String && take('[')) {
    // The length of a string limits nothing here.
    if (!level(0) || !take(']')) {
      return fault(FaultCode::SizeMalformed);
    }
  }
  return made;
}

std::optional<Definition> Reader::definition(Type type, bool isParameter) {
  Definition made;
  made.type = type;
  skipBlanks();
  made.place = place();
  made.name = name();
  if (made.name.empty()) {
    return fault(FaultCode::NameMissing);
  }
  if (take('[')) {
    do {
      skipBlanks();
      if (isParameter && (peek() == ',' || peek() == ']')) {
        made.sizes.emplace_back();
        continue;
      }
      made.sizes.push_back(level(0));
      if (!made.sizes.back()) {
        return fault(FaultCode::SizeMalformed);
      }
    } while (take(','));
    if (!take(']') || made.sizes.size() > 3) {
      return fault(FaultCode::SizeMalformed);
    }
  }
  if (take('=')) {
    made.initial = initial();
    if (!made.initial) {
      return std::nullopt;
    }
  }
  return made;
}

Expected<std::vector<Definition>> Reader::definitions() {
  std::vector<Definition> all;
  static constexpr std::array<std::string_view, 5> kScopes{"NCK", "CHAN", "SYNR", "SYNW", "SYNRW"};
  while (std::any_of(kScopes.begin(), kScopes.end(),
                     [this](std::string_view word) { return takeWord(word); })) {
  }
  const std::optional<Type> kind = type();
  if (kind) {
    do {
      std::optional<Definition> made = definition(*kind, false);
      if (!made) {
        break;
      }
      all.push_back(std::move(*made));
    } while (take(','));
  }
  if (m_fault) {
    return fail(*m_fault);
  }
  return all;
}

Expected<std::vector<Definition>> Reader::parameters() {
  std::vector<Definition> all;
  if (!take('(') || take(')')) {
    return all;
  }
  do {
    const bool isReference = takeWord("VAR");
    const std::optional<Type> kind = type();
    std::optional<Definition> made = kind ? definition(*kind, true) : std::nullopt;
    if (!made) {
      return fail(*m_fault);
    }
    made->isReference = isReference;
    all.push_back(std::move(*made));
  } while (take(','));
  if (!take(')')) {
    return fail(FaultCode::ParametersMalformed, {}, place());
  }
  return all;
}

Expected<std::vector<std::optional<Expression>>> Reader::arguments() {
  std::vector<std::optional<Expression>> all;
  if (!take('(') || take(')')) {
    return all;
  }
  do {
    skipBlanks();
    if (peek() == ',' || peek() == ')') {
      all.emplace_back();
      continue;
    }
    all.push_back(level(0));
    if (!all.back()) {
      return fail(*m_fault);
    }
  } while (take(','));
  if (!take(')')) {
    return fail(FaultCode::BracketNotClosed, {}, place());
  }
  return all;
}

Expected<Expression> parseExpression(std::string_view text, const Notation& notation, Place place) {
  Reader reader(text, notation, place);
  Expected<Expression> made = reader.expression();
  if (made && !reader.isAtEnd()) {
    return fail(FaultCode::RestNotUnderstood, std::string(base::trim(reader.rest())),
                reader.place());
  }
  return made;
}

}  // namespace rivulet::nc
