// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/generator.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "templates/method_template.h"

namespace rivulet::templates {

namespace {

/// The number of a program whose own number is not known yet.
constexpr int kNoNumber = 0;

int numberOf(const TemplateParameters& parameters, const CellMap& cells) {
  constexpr std::uint64_t kNumbers = (1U << 24U) - 1;
  const std::string text = methodTemplate(parameters.method).program(parameters, cells, kNoNumber);
  return 1 + static_cast<int>(base::hashOf(text) % kNumbers);
}

}  // namespace

base::Result<std::string> generateTemplate(const TemplateParameters& parameters) {
  const base::Result<CellMap> cells = planCells(parameters);
  if (!cells) {
    return base::fail(cells.error());
  }
  return methodTemplate(parameters.method)
      .program(parameters, *cells, numberOf(parameters, *cells));
}

int layoutNumber(const TemplateParameters& parameters) {
  const base::Result<CellMap> cells = planCellsAnywhere(parameters);
  return cells ? numberOf(parameters, *cells) : kNoNumber;
}

std::string templateFileName(const TemplateParameters& parameters) {
  constexpr std::size_t kLongest = 24;
  std::string name = base::toUpper(
      fmt::format("RIVULET_{}_{}", base::methodName(parameters.method), parameters.pointsPerLoop));
  // Letters distinguish variants, so that one never replaces another on the control.
  name += methodTemplate(parameters.method).nameSuffix(parameters);
  if (parameters.axes != TemplateParameters{}.axes || base::any(parameters.rotaryAxes)) {
    name += axisLetters(parameters);
  }
  if (name.size() > kLongest) {
    name = fmt::format("RIVULET_{}", layoutNumber(parameters));
  }
  return name + ".MPF";
}

}  // namespace rivulet::templates
