// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console.h"
#include "cli/described_machines.h"
#include "opcua/await.h"
#include "opcua/node_map.h"
#include "opcua/rights.h"
#include "opcua/survey_format.h"
#include "platform/interrupt.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;
using opcua::Grouping;
using opcua::Variable;
using opcua::VariableKind;

constexpr base::Duration kSurveyDeadline = std::chrono::seconds{5};
/// Reads of each form: fewer of those that take long.
constexpr int kSurveyReads = 30;
constexpr int kSurveyReadsMin = 5;
constexpr int kSurveyNodes = 150;

/// What a run or its display reads, one of each kind.
constexpr std::array kSurveyedVariables{
    Variable{VariableKind::RParameter, 0},    Variable{VariableKind::ActualPosition, 0},
    Variable{VariableKind::DistanceToGo, 0},  Variable{VariableKind::PathFeed, 0},
    Variable{VariableKind::ProgramStatus, 0}, Variable{VariableKind::ChannelStatus, 0},
    Variable{VariableKind::LineNumber, 0},    Variable{VariableKind::ProgramName, 0},
    Variable{VariableKind::Message, 0},       Variable{VariableKind::Alarm, 0},
    Variable{VariableKind::AxisName, 0},      Variable{VariableKind::ToolNumber, 0},
    Variable{VariableKind::ToolName, 0},      Variable{VariableKind::EdgeNumber, 0},
    Variable{VariableKind::SpindleSpeed, 0},  Variable{VariableKind::SpindleSpeedSet, 0},
    Variable{VariableKind::SpindleTurn, 0},   Variable{VariableKind::GFunction, 8},
    Variable{VariableKind::MFunction, 0},
};

/// Reads everything that is wanted of one control, and writes nothing to it.
class Survey {
 public:
  explicit Survey(const opcua::Connection& connection)
      : m_connection(connection), m_link(*connection.link) {}

  base::Result<ordered_json> make() {
    ordered_json survey{{opcua::kSurveyKey, opcua::kSurveyFormat},
                        {"tool_version", RIVULET_VERSION},
                        {"surveyed_at_utc", utcNow()}};
    const auto identity = m_connection.control->identity();
    if (!identity) {
      return base::fail(identity.error());
    }
    survey["server"] = {{"application_uri", identity->applicationUri},
                        {"product", identity->productName},
                        {"version", identity->softwareVersion},
                        {"build", identity->buildNumber}};
    survey["virtual_machine"] = m_connection.control->isVirtualMachine();
    survey["security"] =
        m_connection.security ? opcua::securityText(*m_connection.security) : std::string();
    survey["machines"] = machinesAsJson(describedMachines(m_connection));
    for (const auto& part : {&Survey::rights, &Survey::variables, &Survey::axes,
                             &Survey::parameters, &Survey::access}) {
      if (interrupt::wasSeen()) {
        return base::fail(base::makeError(streaming::StreamError::Cancelled,
                                          "The survey was broken off. Nothing was written."));
      }
      if (base::Result<void> done = (this->*part)(survey); !done) {
        return base::fail(done.error());
      }
    }
    return survey;
  }

 private:
  base::Result<void> rights(ordered_json& survey) {
    const auto report = opcua::examineRights(m_connection);
    if (!report) {
      return base::fail(report.error());
    }
    for (const opcua::RightFinding& finding : report->findings) {
      survey["rights"][std::string(opcua::rightTitle(finding.right))] =
          finding.isGiven ? ordered_json(*finding.isGiven) : ordered_json();
    }
    return {};
  }

  base::Result<void> variables(ordered_json& survey) {
    for (const Variable& variable : kSurveyedVariables) {
      const auto reading = readOne(variable);
      if (!reading) {
        return base::fail(reading.error());
      }
      survey["variables"][opcua::nodeIdentifier(variable)] =
          reading->status ? ordered_json(false) : ordered_json(true);
    }
    return {};
  }

  base::Result<void> axes(ordered_json& survey) {
    survey["axes"] = ordered_json::array();
    for (int axis = 0;; ++axis) {
      const auto name = readOne({VariableKind::AxisName, axis});
      if (!name) {
        return base::fail(name.error());
      }
      if (name->status || name->text.empty()) {
        return {};
      }
      survey["axes"].push_back(name->text);
    }
  }

  /// How many R-parameters there are: the first that cannot be read, by halving.
  base::Result<void> parameters(ordered_json& survey) {
    int there = -1;
    int missing = opcua::kSurveyedParametersMax;
    for (int next = 0; there + 1 < missing;) {
      const auto reading = readOne(opcua::rParameter(next));
      if (!reading) {
        return base::fail(reading.error());
      }
      (reading->status ? missing : there) = next;
      const bool isOpen = missing == opcua::kSurveyedParametersMax;
      next = isOpen ? std::min(2 * there + 1, missing - 1) : there + (missing - there) / 2;
      if (isOpen && there == missing - 1) {
        break;
      }
    }
    m_parameters = there + 1;
    survey["r_parameters"] = m_parameters;
    return {};
  }

  base::Result<void> access(ordered_json& survey) {
    survey["access"] = ordered_json::array();
    for (const Grouping form :
         {Grouping::List, Grouping::Single, Grouping::ArrayCount, Grouping::ArrayRange}) {
      for (const int count : {1, 3, 14, 28, 100}) {
        if (count > m_parameters || (count == 1 && form != Grouping::List)) {
          continue;
        }
        base::Result<ordered_json> timed = timeReads(form, count);
        if (!timed) {
          return base::fail(timed.error());
        }
        survey["access"].push_back(*std::move(timed));
      }
    }
    return {};
  }

  base::Result<ordered_json> timeReads(Grouping form, int count) {
    std::vector<Variable> cells;
    for (int i = 0; i < count; ++i) {
      cells.push_back(opcua::rParameter(i));
    }
    ordered_json timed{{"form", opcua::groupingName(form)}, {"r_parameters", count}};
    std::vector<double> ms;
    const int reads = std::clamp(kSurveyNodes / count, kSurveyReadsMin, kSurveyReads);
    for (int i = 0; i < reads; ++i) {
      const base::Instant sent = m_link.now();
      const auto answer =
          opcua::awaitAnswer(m_link, m_link.read(cells, kSurveyDeadline, form), kSurveyDeadline);
      if (!answer) {
        if (answer.error().code == opcua::LinkError::ConnectionLost) {
          return base::fail(answer.error());
        }
        timed["refused"] = answer.error().message;
        return timed;
      }
      const bool areRead = std::none_of(answer->readings.begin(), answer->readings.end(),
                                        [](const opcua::Reading& r) { return bool(r.status); });
      if (!areRead) {
        timed["refused"] = "The values cannot be read in this form.";
        return timed;
      }
      ms.push_back(base::toMilliseconds(answer->at - sent));
    }
    std::sort(ms.begin(), ms.end());
    timed["median_ms"] = ms[ms.size() / 2];
    timed["most_ms"] = ms.back();
    return timed;
  }

  base::Result<opcua::Reading> readOne(const Variable& variable) {
    auto readings = opcua::readNow(m_link, {&variable, 1}, kSurveyDeadline);
    return readings ? base::Result<opcua::Reading>(std::move(readings->front()))
                    : base::fail(readings.error());
  }

  const opcua::Connection& m_connection;
  opcua::Link& m_link;
  int m_parameters = 0;
};

void printSurvey(const ordered_json& survey) {
  const auto text = [](const ordered_json& value) { return value.get<std::string>(); };
  fmt::print(
      "{} {} ({}), {}\n", text(survey["server"]["product"]), text(survey["server"]["version"]),
      text(survey["server"]["build"]),
      survey["security"].get<std::string>().empty() ? "in virtual time" : text(survey["security"]));
  std::vector<std::string> names = survey["axes"].get<std::vector<std::string>>();
  fmt::print("axes: {}; R0 to R{}\n", fmt::join(names, " "), survey["r_parameters"].get<int>() - 1);
  for (const auto& [name, isGiven] : survey["rights"].items()) {
    fmt::print("{:<20} {}\n", name,
               isGiven.is_null() ? "not known" : (isGiven.get<bool>() ? "yes" : "no"));
  }
  for (const auto& [node, isRead] : survey["variables"].items()) {
    if (!isRead.get<bool>()) {
      fmt::print("cannot be read: {}\n", node);
    }
  }
  for (const ordered_json& timed : survey["access"]) {
    fmt::print("{:<12} {:>3} R-parameters: {}\n", text(timed["form"]),
               timed["r_parameters"].get<int>(),
               timed.contains("refused")
                   ? "refused: " + text(timed["refused"])
                   : fmt::format("{:.2f} ms (worst {:.2f})", timed["median_ms"].get<double>(),
                                 timed["most_ms"].get<double>()));
  }
}

}  // namespace

Exit survey(const SurveyOptions& options) {
  interrupt::watch();
  const auto connection = connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  const auto survey = Survey(*connection).make();
  if (!survey) {
    return reportError(survey.error(), options.json);
  }
  if (options.json) {
    printJson(*survey);
  } else {
    printSurvey(*survey);
  }
  if (!options.output.empty()) {
    if (const auto written = base::writeFile(options.output, survey->dump(2) + '\n'); !written) {
      return reportError(written.error(), options.json);
    }
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
