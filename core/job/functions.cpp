// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "job/main_program.h"

namespace rivulet::job {

namespace {

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

base::Result<Functions> functionsOf(const std::vector<std::string>& texts) {
  Functions functions;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::optional<int> number = numberOf(std::string_view(text).substr(0, equals));
    const std::string_view value =
        equals == std::string::npos ? "" : base::trim(std::string_view(text).substr(equals + 1));
    if (!number || value.empty() || value.find_first_of("\n;") != std::string_view::npos) {
      return base::fail(JobError::FunctionMalformed,
                        "What the control does for an M function is NUMBER=ignore, NUMBER=pass or "
                        "NUMBER=LINE, for example 163=ignore.",
                        text);
    }
    const std::string upper = base::toUpper(value);
    functions[*number] = upper == "IGNORE" ? ""
                         : upper == "PASS" ? fmt::format("M{}", *number)
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
  for (const auto& [number, line] : functions) {
    text += fmt::format("{}{}={}", text.empty() ? "" : "; ", number,
                        line.empty()                         ? "ignore"
                        : line == fmt::format("M{}", number) ? "pass"
                                                             : line);
  }
  return text;
}

std::string describe(const FunctionUse& use) {
  const std::string times = use.count > 1 ? fmt::format(", {} times", use.count) : "";
  return fmt::format("M{} (line {}{}): {}", use.number, use.line.value, times,
                     !use.text.empty() ? "the control executes " + use.text
                     : use.isAssumed
                         ? "left out, because nobody has said what it does. It moves nothing on a "
                           "virtual machine; on a control it has to be said (--m)"
                         : "left out");
}

}  // namespace rivulet::job
