// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/job_loop.h"

#include <fmt/format.h>

#include <utility>

#include "templates/method_template.h"

namespace rivulet::templates {

namespace {

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
    isExecuted = isExecuted || line == "RIV_EXECUTED:";
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
  if (parameters.target != TargetControl::Sinumerik) {
    return base::fail(
        TemplateError::NotOnTarget,
        fmt::format("A whole job runs on a SINUMERIK: there is no loop for {}. Stream "
                    "the program as a single run.",
                    targetTitle(parameters.target)));
  }
  const std::string name = fmt::format("RIVLOOP_{}", program->layoutNumber);
  const auto method = methodTemplate(parameters).asSubprogram(name);
  if (!method) {
    return base::fail(TemplateError::BadCells, "A whole job runs with method window or credit.");
  }
  JobLoop loop{std::move(*program), 0, {}, 0};
  loop.name = name + ".SPF";
  loop.callCell = JobProtocol::callCell(loop.cells);
  loop.text = method->program(parameters, loop.cells, loop.layoutNumber);
  findLines(loop);
  return loop;
}

}  // namespace rivulet::templates
