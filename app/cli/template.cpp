// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "cli/commands.h"
#include "templates/generator.h"
#include "trace/file.h"

namespace rivulet::cli {

Exit makeTemplate(const TemplateOptions& options) {
  templates::TemplateParameters parameters = options.point.parameters();
  parameters.rParameterCount = options.rParameterCount;
  const auto cells = templates::planCells(parameters);
  const auto text = templates::generateTemplate(parameters);
  if (!cells || !text) {
    return reportError(cells ? text.error() : cells.error(), options.json);
  }
  if (!options.output.empty()) {
    if (const auto written = trace::writeFile(options.output, *text); !written) {
      return reportError(written.error(), options.json);
    }
  }
  if (options.json) {
    nlohmann::ordered_json numbers;
    if (parameters.method == base::MethodKind::Window) {
      numbers = {{"run", cells->run},
                 {"delivered", cells->delivered},
                 {"latched", cells->latched},
                 {"executed", cells->executed},
                 {"layout", cells->layout},
                 {"state", cells->state},
                 {"client", cells->client},
                 {"owner", cells->owner},
                 {"heartbeat", cells->heartbeat},
                 {"first_window", cells->windowCount(0)},
                 {"window_stride", cells->windowStride},
                 {"windows", cells->windows},
                 {"slot_stride", cells->slotStride}};
    } else {
      numbers = {{"signal", cells->signal},
                 {"run", cells->run},
                 {"stop", cells->stop},
                 {"feed", cells->feed},
                 {"layout", cells->layout},
                 {"first_slot", cells->firstSlot},
                 {"slot_stride", cells->slotStride}};
    }
    printJson({{"name", templates::templateFileName(parameters)},
               {"layout_number", templates::layoutNumber(parameters)},
               {"r_parameters", cells->last() + 1},
               {"cells", numbers},
               {"file", options.output},
               {"text", *text}});
  } else if (options.output.empty()) {
    fmt::print("{}", *text);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
