// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/surveyed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/axes.h"
#include "base/error.h"
#include "opcua/grouping.h"
#include "opcua/rights.h"
#include "opcua/survey_format.h"

namespace rivulet::machine {

namespace {

using nlohmann::json;

/// The worst of some thirty reads is about so many standard deviations above their median.
constexpr double kWorstSigmas = 2.0;
/// An array that costs less than this share of its elements one by one is charged as one node.
constexpr double kNodeShare = 0.5;

struct Timed {
  double cells = 0.0;
  double medianMs = 0.0;
  double mostMs = 0.0;
};

std::optional<Timed> timedOf(const json& entry) {
  const auto number = [&entry](const char* key) {
    const auto found = entry.find(key);
    return found != entry.end() && found->is_number() ? found->get<double>() : std::nan("");
  };
  const Timed timed{number("r_parameters"), number("median_ms"), number("most_ms")};
  const bool isSound = timed.cells >= 1.0 && timed.medianMs > 0.0 && timed.mostMs >= timed.medianMs;
  return isSound ? std::optional(timed) : std::nullopt;
}

/// The timed reads of one form; none: the control refused it, or was not asked.
std::vector<Timed> readsOf(const json& access, opcua::Grouping form) {
  std::vector<Timed> reads;
  for (const json& entry : access) {
    const auto name = entry.is_object() ? entry.find("form") : entry.end();
    if (entry.is_object() && name != entry.end() && *name == opcua::groupingName(form)) {
      if (const auto timed = timedOf(entry)) {
        reads.push_back(*timed);
      }
    }
  }
  return reads;
}

/// A request costs an overhead, and each node its time: the line through the medians.
void fitLists(AccessCost& access, const std::vector<Timed>& reads) {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double sigmaMs = 0.0;
  for (const Timed& each : reads) {
    n += 1.0;
    x += each.cells;
    y += each.medianMs;
    xx += each.cells * each.cells;
    xy += each.cells * each.medianMs;
    sigmaMs += (each.mostMs - each.medianMs) / kWorstSigmas / std::sqrt(each.cells);
  }
  const double spread = n * xx - x * x;
  const double nodeMs = spread > 0.0 ? std::max(0.0, (n * xy - x * y) / spread) : y / x;
  const auto ms = [](double value) { return base::fromSeconds(value / 1000.0); };
  access.nodeTimeMean = ms(nodeMs);
  access.readOverhead = ms(std::max(0.0, (y - nodeMs * x) / n));
  access.nodeTimeDeviation = ms(sigmaMs / n);
  access.nodeTimeMin = std::min(access.nodeTimeMin, access.nodeTimeMean);
}

void fitArrays(AccessCost& access, const json& timed) {
  const auto counts = readsOf(timed, opcua::Grouping::ArrayCount);
  const auto ranges = readsOf(timed, opcua::Grouping::ArrayRange);
  access.arrays.count = !counts.empty();
  access.arrays.range = !ranges.empty();
  const auto& arrays = counts.empty() ? ranges : counts;
  if (arrays.empty()) {
    return;
  }
  const auto longest = std::max_element(arrays.begin(), arrays.end(),
                                        [](auto& a, auto& b) { return a.cells < b.cells; });
  const double listMs = base::toMilliseconds(access.readOverhead) +
                        longest->cells * base::toMilliseconds(access.nodeTimeMean);
  access.arrays.charge =
      longest->medianMs < kNodeShare * listMs ? ArrayCharge::Node : ArrayCharge::Element;
}

/// Those of the survey that the machine has not, and the other way round.
void compareAxes(Surveyed& made, const json& names) {
  std::set<std::string> there;
  for (const json& name : names) {
    there.insert(name.is_string() ? name.get<std::string>() : std::string());
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const std::string name(1, base::kRotaryAxisNames[axis]);
    auto& limits = made.config.rotaryAxes[axis];
    if (there.erase(name) == 0) {
      limits.reset();
    } else if (!limits) {
      made.assumed.push_back("axis " + name + ", which the preset has not");
    }
  }
  for (const char axis : base::kAxisNames) {
    if (there.erase(std::string(1, axis)) == 0) {
      made.assumed.push_back(fmt::format("no axis {}: this machine has one", axis));
    }
  }
  for (const std::string& name : there) {
    made.assumed.push_back("axis " + name + ", which no virtual machine has");
  }
}

/// Those of files come together on a virtual machine.
void takeRights(Surveyed& made, const json& rights) {
  for (const opcua::RunRight right :
       {opcua::RunRight::ReadVariables, opcua::RunRight::WriteParameters,
        opcua::RunRight::ReadPrograms, opcua::RunRight::WritePrograms,
        opcua::RunRight::SelectProgram}) {
    const std::string title(opcua::rightTitle(right));
    const bool isRefused = rights.is_object() && rights.value(title, json()) == false;
    const bool isOfFiles = right >= opcua::RunRight::ReadPrograms;
    made.hasFileRights = made.hasFileRights && !(isRefused && isOfFiles);
    if (isRefused && !isOfFiles) {
      made.assumed.push_back("the right to " + title);
    }
  }
}

}  // namespace

std::error_code make_error_code(SurveyError code) {
  static const base::NamedCategory category("survey");
  return {static_cast<int>(code), category};
}

base::Result<Surveyed> asSurveyed(MachineConfig config, const std::string& text) {
  const json survey = json::parse(text, nullptr, false);
  if (!survey.is_object() || survey.value(opcua::kSurveyKey, json()) != opcua::kSurveyFormat) {
    return base::fail(SurveyError::NotASurvey,
                      "This is not a survey: rivulet-cli survey writes one with -o.");
  }
  const json parameters = survey.value("r_parameters", json());
  const json access = survey.value("access", json());
  const json axes = survey.value("axes", json());
  const auto damaged = [](const char* what) {
    return base::fail(SurveyError::Damaged,
                      fmt::format("The survey does not say {}. Make it again.", what));
  };
  if (!parameters.is_number_integer() || parameters < 1 ||
      parameters > opcua::kSurveyedParametersMax) {
    return damaged("how many R-parameters there are");
  }
  if (!axes.is_array()) {
    return damaged("which axes there are");
  }
  const std::vector<Timed> lists =
      access.is_array() ? readsOf(access, opcua::Grouping::List) : std::vector<Timed>();
  if (lists.empty()) {
    return damaged("how long a list of R-parameters takes to be read");
  }
  Surveyed made{std::move(config), true, {}};
  made.config.rParameterCount = parameters.get<int>();
  fitLists(made.config.access, lists);
  fitArrays(made.config.access, access);
  compareAxes(made, axes);
  takeRights(made, survey.value("rights", json()));
  made.assumed.emplace_back("the limits of the axes, the cycles, and what writing costs");
  return made;
}

}  // namespace rivulet::machine
