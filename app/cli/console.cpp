// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/console.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "opcua/error.h"
#include "platform/log.h"
#include "report/report_json.h"
#include "streaming/run/run.h"
#include "templates/target.h"
#include "trace_fetch/http.h"

namespace rivulet::cli {

namespace {

base::Budget& budgetOfAll() {
  static base::Budget budget;
  return budget;
}

}  // namespace

void setMemoryBudget(const base::Budget& budget) {
  budgetOfAll() = budget;
}

const base::Budget& memoryBudget() {
  return budgetOfAll();
}

void printJson(const nlohmann::ordered_json& json) {
  // A file name may hold bytes that are not UTF-8: they are replaced, and the rest stays readable.
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

Exit exitFor(const base::Error& error) {
  const std::error_code anyLinkError = opcua::LinkError::NotReachable;
  const bool isConnection =
      error.code.category() == anyLinkError.category() || trace_fetch::isOfConnection(error);
  return isConnection ? Exit::Connection : Exit::BadInput;
}

Exit exitForRun(const base::Error& error) {
  using streaming::StreamError;
  const bool isAnothers =
      error.code == StreamError::Claimed || error.code == StreamError::ChannelBusy;
  const Exit exit = exitFor(error);
  return isAnothers || exit == Exit::Connection ? exit : Exit::Wrong;
}

void startLog(const std::string& level, const std::vector<std::string>& words) {
  if (const auto done = log::setUp({"rivulet-cli", level, log::recordingsFolder()}); !done) {
    log::logger().info(done.error().text());
  }
  log::logger().info("{}", fmt::join(words, " "));
}

Exit reportError(const base::Error& error, bool asJson) {
  if (asJson) {
    log::logger().info(error.text());
    printJson({{"error", report::errorJson(error)}});
  } else {
    log::logger().error(error.text());
  }
  return exitFor(error);
}

templates::TemplateParameters OperatingOptions::parameters() const {
  templates::TemplateParameters parameters;
  parameters.method = base::methodFromName(method).value_or(parameters.method);
  parameters.layout = templates::layoutFromName(layout).value_or(parameters.layout);
  parameters.pointsPerLoop = pointsPerLoop;
  parameters.windows = windows;
  parameters.baseCell = baseCell;
  parameters.correctionLimitMm = correctionLimitMm;
  parameters.liftMm = liftMm;
  parameters.packed = packed;
  parameters.silenceLimitS = silenceLimitS.value_or(parameters.silenceLimitS);
  if (factor.size() == 2) {
    parameters.factorLeast = factor[0];
    parameters.factorMost = factor[1];
  }
  parameters.windowsAhead = windowsAhead;
  parameters.slowDown = !noSlowDown;
  parameters = templates::forTarget(parameters,
                                    templates::targetFromName(control).value_or(parameters.target));
  parameters.feedPerPoint = feedCells == "point";
  if (!axes.empty()) {
    // The option parser has rejected everything that is not an axis.
    static_cast<void>(templates::chooseAxes(parameters, axes));
  }
  return parameters;
}

}  // namespace rivulet::cli
