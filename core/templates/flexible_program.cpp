// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/flexible_program.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "templates/method_template.h"

namespace rivulet::templates {

namespace {

constexpr std::string_view kNamePrefix = "RIVULET_";
/// The number of a program whose own number is not known yet.
constexpr int kNoNumber = 0;

int numberOf(std::string_view text) {
  constexpr std::uint64_t kNumbers = (1U << 24U) - 1;
  return 1 + static_cast<int>(base::hashOf(text) % kNumbers);
}

std::string nameOf(const FlexibleProgram& program) {
  constexpr std::size_t kLongest = 24;
  const TemplateParameters& parameters = program.parameters;
  std::string name = base::toUpper(fmt::format(
      "{}{}_{}", kNamePrefix, base::methodName(parameters.method), parameters.pointsPerLoop));
  // Letters distinguish variants, so that one never replaces another on the control.
  name += methodTemplate(parameters).nameSuffix(parameters);
  if (parameters.axes != TemplateParameters{}.axes || base::any(parameters.rotaryAxes)) {
    name += axisLetters(parameters);
  }
  if (name.size() > kLongest) {
    name = fmt::format("{}{}", kNamePrefix, program.layoutNumber);
  }
  return name + ".MPF";
}

}  // namespace

base::Result<FlexibleProgram> makeProgram(const TemplateParameters& parameters) {
  base::Result<CellMap> cells = planCells(parameters);
  if (!cells) {
    return base::fail(cells.error());
  }
  const MethodTemplate& method = methodTemplate(parameters);
  FlexibleProgram program{
      parameters, std::move(*cells), {}, kNoNumber, {}, method.isForStudy(parameters)};
  program.layoutNumber = numberOf(method.program(parameters, program.cells, kNoNumber));
  program.text = method.program(parameters, program.cells, program.layoutNumber);
  program.name = nameOf(program);
  return program;
}

base::Result<void> requireProgram(const TemplateParameters& parameters) {
  const base::Result<CellMap> cells = planCells(parameters);
  return cells ? base::Result<void>() : base::fail(cells.error());
}

std::optional<int> baseCellOf(std::string_view fileName, int otherwise) {
  const std::string name = base::toUpper(fileName);
  const std::size_t begin = name.rfind(kNamePrefix);
  if (begin == std::string::npos) {
    return std::nullopt;
  }
  std::string_view rest = std::string_view(name).substr(begin + kNamePrefix.size());
  if (base::isDigit(rest.empty() ? 'X' : rest.front())) {
    return otherwise;  // the name was too long and is a number
  }
  const auto skipDigits = [&rest] {
    const auto end = std::find_if_not(rest.begin(), rest.end(), base::isDigit);
    const std::string_view digits = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(digits.size());
    return digits;
  };
  const auto skip = [&rest](std::string_view word) {
    const bool is = rest.substr(0, word.size()) == word;
    rest.remove_prefix(is ? word.size() : 0);
    return is;
  };
  const bool hasWindows =
      std::any_of(base::kMethodKinds.begin(), base::kMethodKinds.end(), [&](base::MethodKind kind) {
        return base::hasWindows(kind) && skip(base::toUpper(base::methodName(kind)) + "_");
      });
  if (!hasWindows || skipDigits().empty() || !skip("X") || skipDigits().empty()) {
    return std::nullopt;
  }
  return skip("B") ? base::parseInteger(skipDigits()).value_or(0) : 0;
}

}  // namespace rivulet::templates
