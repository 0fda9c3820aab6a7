// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/contract.h"
#include "base/units.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

using Operation = Formula::Operation;
using Values = std::vector<double>;

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr std::size_t kManyArguments = 16;
constexpr int kDepthMax = 100;

struct Function {
  std::string_view name;
  Operation operation;
  std::size_t argumentsMin = 1;
  std::size_t argumentsMax = 1;
};
constexpr std::array<Function, 13> kFunctions{{
    {"abs", Operation::Abs},
    {"sqrt", Operation::Sqrt},
    {"exp", Operation::Exp},
    {"ln", Operation::Ln},
    {"sin", Operation::Sin},
    {"cos", Operation::Cos},
    {"tan", Operation::Tan},
    {"atan2", Operation::Atan2, 2, 2},
    {"hypot", Operation::Hypot, 2, kManyArguments},
    {"min", Operation::Min, 2, kManyArguments},
    {"max", Operation::Max, 2, kManyArguments},
    {"d", Operation::Derivative},
    {"per_min", Operation::PerMinute},
}};

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

double binary(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::Power:
      return std::pow(a, b);
    case Operation::Atan2:
      return std::atan2(a, b) / kRadians;
    case Operation::Hypot:
      return std::hypot(a, b);
    case Operation::Min:
      return std::isnan(b) ? b : std::min(a, b);
    default:
      return std::isnan(b) ? b : std::max(a, b);
  }
}

double unary(Operation operation, double a) {
  switch (operation) {
    case Operation::Negate:
      return -a;
    case Operation::Abs:
      return std::abs(a);
    case Operation::Sqrt:
      return std::sqrt(a);
    case Operation::Exp:
      return std::exp(a);
    case Operation::Ln:
      return std::log(a);
    case Operation::Sin:
      return std::sin(a * kRadians);
    case Operation::Cos:
      return std::cos(a * kRadians);
    case Operation::Tan:
      return std::tan(a * kRadians);
    default:
      return base::mmPerMinFromMmPerS(a);
  }
}

bool isBinary(Operation operation) {
  switch (operation) {
    case Operation::Add:
    case Operation::Subtract:
    case Operation::Multiply:
    case Operation::Divide:
    case Operation::Power:
    case Operation::Atan2:
    case Operation::Hypot:
    case Operation::Min:
    case Operation::Max:
      return true;
    default:
      return false;
  }
}

void differentiate(Values& values, const std::vector<base::Instant>& at) {
  for (std::size_t i = values.size(); i-- > 1;) {
    const double seconds = base::toSeconds(at[i] - at[i - 1]);
    values[i] = seconds > 0.0 ? (values[i] - values[i - 1]) / seconds : kNoValue;
  }
  if (!values.empty()) {
    values.front() = kNoValue;
  }
}

}  // namespace

/// Sum, product, power, part: one function per level of precedence.
class FormulaParser {
 public:
  explicit FormulaParser(std::string_view text) : m_text(text) {}

  base::Result<Formula> parse() {
    if (sum() && !atEnd()) {
      refuse();
    }
    if (m_error) {
      return base::fail(*m_error);
    }
    return std::move(m_formula);
  }

 private:
  bool atEnd() {
    while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0) {
      ++m_at;
    }
    return m_at == m_text.size();
  }
  bool accept(char c) {
    if (atEnd() || m_text[m_at] != c) {
      return false;
    }
    ++m_at;
    return true;
  }
  bool refuse() {
    if (!m_error) {
      m_error = atEnd()
                    ? base::makeError(FormulaError::NotComplete, "The formula is not complete.", {})
                    : base::makeError(FormulaError::NotUnderstood,
                                      "The formula is not understood from here on.",
                                      std::string(m_text.substr(m_at)));
    }
    return false;
  }
  void add(Operation operation) { m_formula.m_steps.push_back({operation, 0.0, 0}); }

  bool sum() {
    if (m_depth == kDepthMax) {
      return refuse();
    }
    ++m_depth;
    bool isGood = product();
    while (isGood && !atEnd() && (m_text[m_at] == '+' || m_text[m_at] == '-')) {
      const Operation operation = m_text[m_at++] == '+' ? Operation::Add : Operation::Subtract;
      isGood = product();
      add(operation);
    }
    --m_depth;
    return isGood;
  }

  bool product() {
    bool isGood = factor();
    while (isGood && !atEnd() && (m_text[m_at] == '*' || m_text[m_at] == '/')) {
      const Operation operation = m_text[m_at++] == '*' ? Operation::Multiply : Operation::Divide;
      isGood = factor();
      add(operation);
    }
    return isGood;
  }

  /// -x^2 is -(x^2), and 2^3^2 is 2^(3^2).
  bool factor() {
    if (m_depth == kDepthMax) {
      return refuse();
    }
    ++m_depth;
    bool isGood = false;
    if (accept('-')) {
      isGood = factor();
      add(Operation::Negate);
    } else {
      isGood = part();
      if (isGood && accept('^')) {
        isGood = factor();
        add(Operation::Power);
      }
    }
    --m_depth;
    return isGood;
  }

  bool part() {
    if (accept('(')) {
      return sum() && (accept(')') || refuse());
    }
    if (accept('\'')) {
      const std::size_t end = m_text.find('\'', m_at);
      if (end == std::string_view::npos || end == m_at) {
        return refuse();
      }
      addName(m_text.substr(m_at, end - m_at));
      m_at = end + 1;
      return true;
    }
    if (atEnd()) {
      return refuse();
    }
    return isLetter(m_text[m_at]) ? word() : number();
  }

  bool number() {
    double value = 0.0;
    const char* const first = m_text.data() + m_at;
    const auto [end, status] = std::from_chars(first, m_text.data() + m_text.size(), value);
    if (status != std::errc{} || !(isDigit(*first) || *first == '.')) {
      return refuse();
    }
    m_at += static_cast<std::size_t>(end - first);
    m_formula.m_steps.push_back({Operation::Number, value, 0});
    return true;
  }

  bool word() {
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && (isLetter(m_text[m_at]) || isDigit(m_text[m_at]))) {
      ++m_at;
    }
    const std::string_view name = m_text.substr(begin, m_at - begin);
    if (!accept('(')) {
      addName(name);
      return true;
    }
    const auto function = std::find_if(kFunctions.begin(), kFunctions.end(),
                                       [name](const Function& one) { return one.name == name; });
    if (function == kFunctions.end()) {
      m_error = base::makeError(FormulaError::UnknownFunction,
                                "There is no such function. Press F1 for those there are.",
                                std::string(name));
      return false;
    }
    std::size_t arguments = 0;
    do {
      if (!sum()) {
        return false;
      }
      ++arguments;
      // Of several arguments, two at a time.
      if (arguments > 1) {
        add(function->operation);
      }
    } while (arguments < function->argumentsMax && accept(','));
    if (arguments < function->argumentsMin || !accept(')')) {
      return refuse();
    }
    if (function->argumentsMax == 1) {
      add(function->operation);
    }
    return true;
  }

  void addName(std::string_view name) {
    std::vector<std::string>& names = m_formula.m_names;
    auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      names.emplace_back(name);
      found = names.end() - 1;
    }
    m_formula.m_steps.push_back(
        {Operation::Name, 0.0, static_cast<std::size_t>(found - names.begin())});
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_depth = 0;
  Formula m_formula;
  std::optional<base::Error> m_error;
};

std::error_code make_error_code(FormulaError code) {
  static const base::NamedCategory category("trace formula");
  return {static_cast<int>(code), category};
}

base::Result<Formula> Formula::parse(std::string_view text) {
  return FormulaParser(text).parse();
}

std::vector<double> Formula::evaluate(const std::vector<base::Instant>& at,
                                      const std::vector<Values>& signalValues) const {
  RIVULET_ASSERT(signalValues.size() == m_names.size());
  std::vector<Values> stack;
  for (const Step& step : m_steps) {
    if (step.operation == Operation::Number) {
      stack.emplace_back(at.size(), step.number);
    } else if (step.operation == Operation::Name) {
      RIVULET_ASSERT(signalValues[step.name].size() == at.size());
      stack.push_back(signalValues[step.name]);
    } else if (isBinary(step.operation)) {
      const Values second = std::move(stack.back());
      stack.pop_back();
      Values& first = stack.back();
      for (std::size_t i = 0; i < first.size(); ++i) {
        first[i] = binary(step.operation, first[i], second[i]);
      }
    } else if (step.operation == Operation::Derivative) {
      differentiate(stack.back(), at);
    } else {
      for (double& value : stack.back()) {
        value = unary(step.operation, value);
      }
    }
  }
  return std::move(stack.back());
}

}  // namespace rivulet::trace
