// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "job/main_program.h"

namespace rivulet::job {

std::optional<FunctionName> functionNameOf(std::string_view text) {
  constexpr int kLast = 99999;
  text = base::trim(text);
  const char letter = text.size() == 1 ? base::toUpper(text.front()) : '\0';
  if (letter >= 'U' && letter <= 'W') {
    return FunctionName{0, letter};
  }
  if (!text.empty() && (text.front() == 'M' || text.front() == 'm')) {
    text.remove_prefix(1);
  }
  const std::optional<int> number = base::parseInteger(text);
  return number && *number >= 0 && *number <= kLast ? std::optional(FunctionName{*number})
                                                    : std::nullopt;
}

base::Result<Functions> functionsOf(const std::vector<std::string>& texts) {
  Functions functions;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const auto name = functionNameOf(std::string_view(text).substr(0, equals));
    const std::string_view value =
        equals == std::string::npos ? "" : base::trim(std::string_view(text).substr(equals + 1));
    const std::string upper = base::toUpper(value);
    const bool isKnown = upper == "IGNORE" || upper == "PASS";
    if (!name || value.empty() || value.find_first_of("\n;") != std::string_view::npos ||
        (name->axis != 0 && !isKnown)) {
      return base::fail(JobError::FunctionMalformed,
                        "What the control does for an M function is NUMBER=ignore, NUMBER=pass or "
                        "NUMBER=LINE, for example 163=ignore; for an axis U, V or W it is W=ignore "
                        "or W=pass.",
                        text);
    }
    functions[*name] = upper == "IGNORE" ? ""
                       : upper == "PASS" ? textOf(*name)
                                         : std::string(value);
  }
  return functions;
}

base::Result<Functions> functionsOfText(std::string_view text) {
  std::vector<std::string> texts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    if (const std::string_view one = base::trim(text.substr(0, end)); !one.empty()) {
      texts.emplace_back(one);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return functionsOf(texts);
}

std::string textOf(const Functions& functions) {
  std::string text;
  for (const auto& [name, line] : functions) {
    const std::string word = textOf(name);
    text += fmt::format("{}{}={}", text.empty() ? "" : "; ", word.substr(name.axis == 0 ? 1 : 0),
                        line.empty()   ? "ignore"
                        : line == word ? "pass"
                                       : line);
  }
  return text;
}

std::string textOf(const FunctionName& name) {
  return name.axis != 0 ? std::string(1, name.axis) : fmt::format("M{}", name.number);
}

std::string describe(const FunctionUse& use) {
  const std::string times = use.count > 1 ? fmt::format(", {} times", use.count) : "";
  return fmt::format("{} (line {}{}): {}", textOf(use.name), use.line.value, times,
                     !use.text.empty() ? "the control executes " + use.text
                     : use.isAssumed
                         ? "left out, because nobody has said what it does. It moves nothing on a "
                           "virtual machine; on a control it has to be said (--m)"
                         : "left out");
}

}  // namespace rivulet::job
