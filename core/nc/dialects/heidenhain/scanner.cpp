// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.h"
#include "nc/dialects/heidenhain/contour.h"

namespace rivulet::nc::heidenhain {

namespace {

using base::isDigit;

constexpr int kDepthMax = 50;

bool isLetter(char c) {
  return c >= 'A' && c <= 'Z';
}

/// Sine and cosine of multiples of 90 degrees are whole: COS 90 must not leave 6e-17.
double sine(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  if (std::fmod(turned, 180.0) == 0.0) {
    return 0.0;
  }
  if (std::fmod(turned, 90.0) == 0.0) {
    return turned == 90.0 || turned == -270.0 ? 1.0 : -1.0;
  }
  return std::sin(turned / kDegreesPerRadian);
}

}  // namespace

Expected<double> Parameters::number(const std::string& name) const {
  const auto& values = of(name);
  if (const auto found = values.find(name); found != values.end()) {
    return std::isnan(found->second) ? Expected<double>(fail(FaultCode::ValueUnknown, name))
                                     : Expected<double>(found->second);
  }
  if (const auto found = m_ofControl.find(name); found != m_ofControl.end()) {
    return found->second;
  }
  // Q100 to Q199 belong to the control (chapter Q parameters, "Preassigned Q parameters").
  const bool isPlain = name.size() > 1 && isDigit(name[1]);
  const int index = isPlain ? base::parseInteger(name.substr(1)).value_or(0) : 0;
  constexpr int kFirstOfControl = 100;
  constexpr int kLastOfControl = 199;
  return fail(index >= kFirstOfControl && index <= kLastOfControl ? FaultCode::OnlyOnControl
                                                                  : FaultCode::NotDefined,
              name);
}

Expected<std::string> Parameters::text(const std::string& name) const {
  const auto found = m_texts.find(name);
  return found == m_texts.end() ? Expected<std::string>(fail(FaultCode::NotDefined, name))
                                : Expected<std::string>(found->second);
}

bool Parameters::has(const std::string& name) const {
  return of(name).contains(name);
}

void Parameters::set(const std::string& name, double value) {
  auto& values = name.size() > 1 && name[1] == 'L' ? m_local.back() : m_global;
  const auto [known, isNew] = values.emplace(name, value);
  if (isNew || known->second != value) {
    known->second = value;
    ++m_changes;
  }
}

void Parameters::setText(const std::string& name, std::string value) {
  m_texts[name] = std::move(value);
}

void Parameters::setOfControl(int number, std::optional<double> value) {
  const std::string name = fmt::format("Q{}", number);
  if (value) {
    m_ofControl[name] = *value;
  } else {
    m_ofControl.erase(name);
  }
}

std::string withoutComments(std::string_view block) {
  std::string text(block);
  bool isQuoted = false;
  bool isComment = false;
  for (char& c : text) {
    const bool endsLine = c == '\n' || c == '\r';
    isQuoted = !endsLine && (c == '"' && !isComment ? !isQuoted : isQuoted);
    isComment = !endsLine && (isComment || (c == ';' && !isQuoted));
    if (isComment || endsLine || c == '\t' || (c == '~' && !isQuoted)) {
      c = ' ';
    } else if (!isQuoted) {
      c = base::toUpper(c);
    }
  }
  return text;
}

void Scanner::skipBlanks() {
  while (peek() == ' ') {
    ++m_at;
  }
}

bool Scanner::isAtEnd() {
  skipBlanks();
  return m_at >= m_text.size();
}

bool Scanner::take(char c) {
  skipBlanks();
  if (peek() != c || c == '\0') {
    return false;
  }
  ++m_at;
  return true;
}

bool Scanner::takePrefix(std::string_view letters) {
  skipBlanks();
  if (m_text.substr(m_at, letters.size()) != letters) {
    return false;
  }
  m_at += letters.size();
  return true;
}

bool Scanner::takeWord(std::string_view word) {
  const std::size_t from = m_at;
  if (takePrefix(word) && !isLetter(peek())) {
    return true;
  }
  m_at = from;
  return false;
}

std::string Scanner::takeName() {
  skipBlanks();
  const std::size_t from = m_at;
  while (isLetter(peek())) {
    ++m_at;
  }
  return std::string(m_text.substr(from, m_at - from));
}

std::optional<int> Scanner::takeInteger() {
  skipBlanks();
  const std::size_t from = m_at;
  while (isDigit(peek())) {
    ++m_at;
  }
  return base::parseInteger(m_text.substr(from, m_at - from));
}

std::optional<Expected<std::string>> Scanner::takeText() {
  skipBlanks();
  const std::size_t from = m_at;
  if (peek() == '"') {
    const std::size_t end = m_text.find('"', m_at + 1);
    if (end == std::string_view::npos) {
      return fault<std::string>(FaultCode::TextNotClosed);
    }
    m_at = end + 1;
    return Expected<std::string>(std::string(m_text.substr(from + 1, end - from - 1)));
  }
  if (takePrefix("QS")) {
    if (const std::optional<int> number = takeInteger()) {
      Expected<std::string> text = m_parameters.text(fmt::format("QS{}", *number));
      return text ? text : fault<std::string>(text.error().code, text.error().argument);
    }
    m_at = from;
  }
  return std::nullopt;
}

std::string Scanner::takeParameter() {
  skipBlanks();
  const std::size_t from = m_at;
  if (peek() != 'Q') {
    return {};
  }
  std::string name(1, m_text[m_at++]);
  if (peek() == 'L' || peek() == 'R') {
    name += m_text[m_at++];
  }
  if (isDigit(peek())) {
    if (const std::optional<int> number = takeInteger()) {
      return name + fmt::format("{}", *number);
    }
  }
  m_at = from;
  return {};
}

bool Scanner::isAtValue() {
  skipBlanks();
  const char c = peek();
  const bool isPoint =
      (c == '.' || c == ',') && m_at + 1 < m_text.size() && isDigit(m_text[m_at + 1]);
  if (isDigit(c) || c == '+' || c == '-' || isPoint) {
    return true;
  }
  const std::size_t from = m_at;
  const bool isParameter = !takeParameter().empty();
  m_at = from;
  return isParameter;
}

std::string Scanner::nextText() {
  skipBlanks();
  const std::string_view text = rest();
  return std::string(text.substr(0, text.find(' ')));
}

Expected<double> Scanner::number() {
  const std::size_t from = m_at;
  const auto isPart = [](char c) { return isDigit(c) || c == '.' || c == ','; };
  while (isPart(peek())) {
    ++m_at;
  }
  std::string digits(m_text.substr(from, m_at - from));
  std::replace(digits.begin(), digits.end(), ',', '.');
  if (digits.empty() || digits == ".") {
    return fault(FaultCode::ValueMissing);
  }
  const std::optional<double> value = base::parseNumber(digits);
  return value ? Expected<double>(*value) : fault(FaultCode::NotANumber, digits);
}

Expected<double> Scanner::value() {
  skipBlanks();
  double sign = 1.0;
  if (peek() == '+' || peek() == '-') {
    sign = peek() == '-' ? -1.0 : 1.0;
    ++m_at;
    skipBlanks();
  }
  const Place from = place();
  Expected<double> read = 0.0;
  if (const std::string name = takeParameter(); !name.empty()) {
    read = m_parameters.number(name);
    if (!read) {
      return fail(read.error().code, read.error().argument, from);
    }
  } else {
    read = number();
  }
  return read ? Expected<double>(sign * *read) : read;
}

// --- formulas -----------------------------------------------------------------------------------
// TNC 640 Conversational Programming, chapter Q parameters, "Entering formulas directly" and "Rules
// for formulas": brackets and functions, ^, then * and /, then + and -. FN 0 to FN 8 and FN 13:
// "Describing contours with mathematical functions" and "Angle functions".

Expected<double> Scanner::formula() {
  return sum();
}

Expected<double> Scanner::sum() {
  Expected<double> left = product();
  while (left) {
    skipBlanks();
    const bool adds = take('+');
    if (!adds && !take('-')) {
      break;
    }
    const Expected<double> right = product();
    left = right ? Expected<double>(adds ? *left + *right : *left - *right) : right;
  }
  return left;
}

Expected<double> Scanner::product() {
  Expected<double> left = power();
  while (left) {
    const bool multiplies = take('*');
    const bool divides = !multiplies && (take('/') || takeWord("DIV"));
    const bool isRest = !multiplies && !divides && take('%');
    const bool isLength = !multiplies && !divides && !isRest && takeWord("LEN");
    const bool isAngle = !multiplies && !divides && !isRest && !isLength && takeWord("ANG");
    if (!multiplies && !divides && !isRest && !isLength && !isAngle) {
      break;
    }
    const Expected<double> right = power();
    if (!right) {
      return right;
    }
    if ((divides || isRest) && *right == 0.0) {
      return fault(FaultCode::DivisionByZero);
    }
    if (isAngle) {
      // FN 13: the sine side first, the angle from 0 to 360 degrees.
      if (*left == 0.0 && *right == 0.0) {
        return fault(FaultCode::OutOfDomain, "0 ANG 0");
      }
      const double degrees = std::atan2(*left, *right) * kDegreesPerRadian;
      left = degrees < 0.0 ? degrees + 360.0 : degrees;
    } else {
      left = multiplies ? *left * *right
             : divides  ? *left / *right
             : isLength ? std::hypot(*left, *right)
                        : std::fmod(*left, *right);
    }
  }
  return left;
}

Expected<double> Scanner::power() {
  skipBlanks();
  if (peek() == '+' || peek() == '-') {
    return signedOperand();
  }
  Expected<double> left = operand();
  while (left && take('^')) {
    skipBlanks();
    const Expected<double> right = peek() == '+' || peek() == '-' ? signedOperand() : operand();
    if (!right) {
      return right;
    }
    const double result = std::pow(*left, *right);
    left = std::isfinite(result) ? Expected<double>(result) : fault(FaultCode::NotFinite);
  }
  return left;
}

Expected<double> Scanner::signedOperand() {
  if (++m_depth > kDepthMax) {
    return fault(FaultCode::NestedTooDeeply);
  }
  const double sign = peek() == '-' ? -1.0 : 1.0;
  ++m_at;
  const Expected<double> value = power();
  --m_depth;
  return value ? Expected<double>(sign * *value) : value;
}

Expected<double> Scanner::operand() {
  if (++m_depth > kDepthMax) {
    return fault(FaultCode::NestedTooDeeply);
  }
  skipBlanks();
  const Place from = place();
  Expected<double> result = 0.0;
  if (take('(')) {
    result = sum();
    if (result && !take(')')) {
      result = fault(FaultCode::BracketNotClosed);
    }
  } else if (const std::string name = takeParameter(); !name.empty()) {
    result = m_parameters.number(name);
    if (!result) {
      result = fail(result.error().code, result.error().argument, from);
    }
  } else if (isLetter(peek())) {
    const std::string word = takeName();
    if (word == "PI") {
      result = std::numbers::pi;
    } else {
      skipBlanks();
      const Expected<double> argument =
          peek() == '+' || peek() == '-' ? signedOperand() : operand();
      result = argument ? function(word, *argument) : argument;
    }
  } else {
    result = number();
  }
  --m_depth;
  return result;
}

Expected<double> Scanner::function(const std::string& name, double x) const {
  using Calculate = double (*)(double);
  struct Row {
    std::string_view name;
    Calculate calculate;
  };
  static constexpr std::array kFunctions{
      Row{"SIN", [](double v) { return sine(v); }},
      Row{"COS", [](double v) { return sine(v + 90.0); }},
      Row{"TAN", [](double v) { return sine(v) / sine(v + 90.0); }},
      Row{"ASIN", [](double v) { return std::asin(v) * kDegreesPerRadian; }},
      Row{"ACOS", [](double v) { return std::acos(v) * kDegreesPerRadian; }},
      Row{"ATAN", [](double v) { return std::atan(v) * kDegreesPerRadian; }},
      Row{"SQ", [](double v) { return v * v; }},
      Row{"SQRT", [](double v) { return std::sqrt(v); }},
      Row{"ABS", [](double v) { return std::abs(v); }},
      Row{"NEG", [](double v) { return -v; }},
      Row{"INT", [](double v) { return std::trunc(v); }},
      Row{"FRAC", [](double v) { return v - std::trunc(v); }},
      Row{"EXP", [](double v) { return std::exp(v); }},
      Row{"LN", [](double v) { return std::log(v); }},
      Row{"LOG", [](double v) { return std::log10(v); }},
      // What the sign of zero is differs between controls.
      Row{"SGN", [](double v) { return v > 0.0   ? 1.0
                                       : v < 0.0 ? -1.0
                                                 : std::nan(""); }},
  };
  const auto* const found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                         [&name](const Row& row) { return row.name == name; });
  if (found == kFunctions.end()) {
    return fault(FaultCode::NameUnknown, name);
  }
  const double result = found->calculate(x);
  return std::isfinite(result)
             ? Expected<double>(result)
             : fault(FaultCode::OutOfDomain, fmt::format("{}({})", name, base::formatNumber(x)));
}

}  // namespace rivulet::nc::heidenhain
