// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/rule.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text.h"

namespace rivulet::report {

namespace {

/// The longer signs first: "<=" begins with "<".
constexpr std::array<std::string_view, 6> kSigns{"<=", ">=", "==", "!=", "<", ">"};

bool holds(double figure, std::string_view sign, double value) {
  if (sign == "<") {
    return figure < value;
  }
  if (sign == "<=") {
    return figure <= value;
  }
  if (sign == ">") {
    return figure > value;
  }
  if (sign == ">=") {
    return figure >= value;
  }
  return (figure == value) == (sign == "==");
}

/// The member of that name, or of that name with a unit.
const nlohmann::ordered_json* memberOf(const nlohmann::ordered_json& json,
                                       const std::string& name) {
  static constexpr std::array<std::string_view, 7> kUnits{"",     "_mm", "_s",         "_ms",
                                                          "_deg", "_hz", "_mm_per_min"};
  for (const std::string_view unit : kUnits) {
    const auto found = json.find(name + std::string(unit));
    if (found != json.end()) {
      return &*found;
    }
  }
  return nullptr;
}

std::optional<double> figureOf(const nlohmann::ordered_json& result, std::string_view name) {
  const nlohmann::ordered_json* json = &result;
  while (!name.empty() && json != nullptr && json->is_object()) {
    const std::string_view part = name.substr(0, name.find('.'));
    name.remove_prefix(std::min(name.size(), part.size() + 1));
    json = memberOf(*json, std::string(part));
  }
  if (json == nullptr || !name.empty()) {
    return std::nullopt;
  }
  if (json->is_boolean()) {
    return json->get<bool>() ? 1.0 : 0.0;
  }
  if (json->is_array()) {
    return static_cast<double>(json->size());
  }
  return json->is_number() ? std::optional(json->get<double>()) : std::nullopt;
}

/// Splits at a word between blanks. @param text  shortened by the part and the word
std::string_view takeUntil(std::string_view& text, std::string_view word) {
  const std::string separator = fmt::format(" {} ", word);
  const std::size_t at = text.find(separator);
  const std::string_view part = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + separator.size());
  return part;
}

}  // namespace

std::error_code make_error_code(RuleError code) {
  static const base::NamedCategory category("rule");
  return {static_cast<int>(code), category};
}

base::Result<Rule> Rule::parse(std::string_view text) {
  const auto bad = [](std::string_view part) {
    return base::fail(RuleError::BadRule,
                      fmt::format("\"{}\" is no comparison. Write, for example, \"skipped>0 or "
                                  "contour_error.max>0.05\".",
                                  part));
  };
  text = base::trim(text);
  if (text.empty()) {
    return bad(text);
  }
  Rule rule;
  while (!text.empty()) {
    std::string_view alternative = takeUntil(text, "or");
    std::vector<Comparison> comparisons;
    do {
      const std::string_view part = takeUntil(alternative, "and");
      const std::size_t at = part.find_first_of("<>=!");
      const std::string_view rest = at == std::string_view::npos ? "" : part.substr(at);
      const auto sign = std::find_if(kSigns.begin(), kSigns.end(), [rest](std::string_view one) {
        return rest.substr(0, one.size()) == one;
      });
      const std::string_view figure = base::trim(part.substr(0, at));
      if (sign == kSigns.end() || figure.empty()) {
        return bad(part);
      }
      const auto value = base::parseNumber(base::trim(rest.substr(sign->size())));
      if (!value) {
        return bad(part);
      }
      comparisons.push_back({std::string(figure), std::string(*sign), *value});
    } while (!alternative.empty());
    rule.m_alternatives.push_back(std::move(comparisons));
  }
  return rule;
}

Rule::Verdict Rule::judge(const nlohmann::ordered_json& result) const {
  Verdict verdict;
  for (const std::vector<Comparison>& comparisons : m_alternatives) {
    bool all = true;
    for (const Comparison& comparison : comparisons) {
      const auto figure = figureOf(result, comparison.figure);
      if (!figure) {
        verdict.unknown.push_back(comparison.figure);
      }
      all = all && figure && holds(*figure, comparison.sign, comparison.value);
    }
    verdict.applies = verdict.applies || all;
  }
  return verdict;
}

}  // namespace rivulet::report
