// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/machine_functions.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace rivulet::report {

using nlohmann::ordered_json;

namespace {

class Category final : public std::error_category {
 public:
  [[nodiscard]] const char* name() const noexcept override { return "machine-functions"; }
  [[nodiscard]] std::string message(int) const override { return "no M function"; }
};

/// M163, 163. @return nothing: no number of an M function
std::optional<int> numberOf(std::string_view text) {
  constexpr int kLast = 99999;
  text = base::trim(text);
  if (!text.empty() && (text.front() == 'M' || text.front() == 'm')) {
    text.remove_prefix(1);
  }
  const std::optional<int> number = base::parseInteger(text);
  return number && *number >= 0 && *number <= kLast ? number : std::nullopt;
}

}  // namespace

std::error_code make_error_code(FunctionError code) {
  static const Category category;
  return {static_cast<int>(code), category};
}

base::Result<MachineFunctions> functionsOf(const std::vector<std::string>& texts) {
  MachineFunctions functions;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::optional<int> number = numberOf(std::string_view(text).substr(0, equals));
    const std::string_view value =
        equals == std::string::npos ? "" : base::trim(std::string_view(text).substr(equals + 1));
    if (!number || value.empty() || value.find('\n') != std::string_view::npos) {
      return base::fail(FunctionError::Malformed,
                        "Write --m NUMBER=ignore, --m NUMBER=pass or --m NUMBER=\"LINE\".", text);
    }
    const std::string upper = base::toUpper(value);
    functions[*number] = upper == "IGNORE" ? ""
                         : upper == "PASS" ? fmt::format("M{}", *number)
                                           : std::string(value);
  }
  return functions;
}

MachineFunctions functionsOfJson(const ordered_json& json) {
  MachineFunctions functions;
  if (!json.is_object()) {
    return functions;
  }
  for (const auto& [name, line] : json.items()) {
    const std::optional<int> number = numberOf(name);
    if (number && line.is_string()) {
      functions[*number] = line.get<std::string>();
    }
  }
  return functions;
}

ordered_json functionsJson(const MachineFunctions& functions) {
  ordered_json json = ordered_json::object();
  for (const auto& [number, line] : functions) {
    json[std::to_string(number)] = line;
  }
  return json;
}

std::string describe(const job::FunctionUse& use) {
  const std::string times = use.count > 1 ? fmt::format(", {} times", use.count) : "";
  return fmt::format("M{} (line {}{}): {}", use.number, use.line.value, times,
                     !use.text.empty() ? "the control executes " + use.text
                     : use.isAssumed
                         ? "left out, because nobody has said what it does. It moves nothing on a "
                           "virtual machine; on a control it has to be said (--m)"
                         : "left out");
}

ordered_json functionsJson(const std::vector<job::FunctionUse>& uses) {
  ordered_json json = ordered_json::array();
  for (const job::FunctionUse& use : uses) {
    json.push_back({{"number", use.number},
                    {"line", use.line.value},
                    {"count", use.count},
                    {"text", use.text},
                    {"assumed", use.isAssumed}});
  }
  return json;
}

}  // namespace rivulet::report
