// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/load_machine.h"

#include <algorithm>

#include "report/known_machine.h"
#include "streaming/simulation/fitted_machine.h"

namespace rivulet::report {

namespace {

double radiusOf(const machine::Tool& tool) {
  return tool.hasEdge(1) ? tool.edges.front().radiusMm : -1.0;
}

bool isSameTool(const machine::Tool& a, const machine::Tool& b) {
  return a.number == b.number && a.name == b.name && radiusOf(a) == radiusOf(b);
}

}  // namespace

void LoadMachine::tell(gcode::LoadOptions& options) const {
  if (isFitted) {
    options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
  }
  options.toolRadiusMm = streaming::toolRadii(tools, isFitted);
}

bool operator==(const LoadMachine& a, const LoadMachine& b) {
  const auto& one = a.tools;
  const auto& other = b.tools;
  return a.words == b.words && a.isFitted == b.isFitted && one.has_value() == other.has_value() &&
         (!one || std::equal(one->tools.begin(), one->tools.end(), other->tools.begin(),
                             other->tools.end(), isSameTool));
}

LoadMachine loadMachineOf(const MachineStore& store, const std::string& endpoint,
                          const opcua::ServerIdentity& server, bool isVirtual,
                          const streaming::MachineProfile* profile) {
  LoadMachine machine{store.jobProfile(endpoint, isVirtual), std::nullopt, false};
  // The preset that stands for a control has its limits, but not its tools.
  const bool hasTools = profile != nullptr ? !profile->tools.empty() : isVirtual;
  if (const auto known = hasTools ? knownMachine(server, profile) : std::nullopt) {
    machine.tools = known->tools;
  }
  return machine;
}

}  // namespace rivulet::report
