// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/job_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "templates/method_template.h"

namespace rivulet::templates {

namespace {

/// After these lines a loop waits for the client, when it has executed a stretch.
constexpr std::array<std::string_view, 2> kExecuted{"RIV_EXECUTED:", "o180 while"};

/// Where the loop moves, and where it waits after a stretch.
void findLines(JobLoop& loop) {
  std::uint32_t number = 0;
  bool isExecuted = false;
  std::string_view rest = loop.text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++number;
    if (line.starts_with("G1 ")) {
      loop.motionLines.push_back(number);
    }
    isExecuted = isExecuted || std::any_of(kExecuted.begin(), kExecuted.end(),
                                           [&](auto begin) { return line.starts_with(begin); });
    if (isExecuted && loop.handoverLine == 0 && line.starts_with("G4 ")) {
      loop.handoverLine = number;
    }
  }
}

}  // namespace

std::string_view subprogramName(const JobLoop& loop) {
  return std::string_view(loop.name).substr(0, loop.name.find('.'));
}

base::Result<JobLoop> makeJobLoop(const TemplateParameters& wanted) {
  TemplateParameters parameters = wanted;
  parameters.liftMm = 0.0;  // the control's own blocks would take it along
  base::Result<FlexibleProgram> program = makeProgram(parameters);
  if (!program) {
    return base::fail(program.error());
  }
  if (program->cells.corrects()) {
    return base::fail(
        TemplateError::BadCorrection,
        "A whole job has no online correction: its native blocks would take it along.");
  }
  const bool isSinumerik = parameters.target == TargetControl::Sinumerik;
  const std::string name =
      fmt::format("{}_{}", isSinumerik ? "RIVLOOP" : "rivloop", program->layoutNumber);
  const auto method = methodTemplate(parameters).asSubprogram(name);
  if (!method) {
    return base::fail(TemplateError::BadCells, "A whole job runs with method window or credit.");
  }
  JobLoop loop{std::move(*program), isSinumerik, 0, {}, 0};
  loop.name = isSinumerik ? name + ".SPF" : name;
  loop.callCell = JobProtocol::callCell(loop.cells);
  loop.text = method->program(parameters, loop.cells, loop.layoutNumber);
  findLines(loop);
  return loop;
}

}  // namespace rivulet::templates
