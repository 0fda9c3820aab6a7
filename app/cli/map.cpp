// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console.h"
#include "cli/described_machines.h"
#include "opcua/control_map.h"
#include "opcua/map_proposal.h"

namespace rivulet::cli {

namespace {

using opcua::NodeFacts;
using opcua::Variable;

/// A node of a map, as it was read.
struct Proof {
  std::string key;
  std::string address;
  NodeFacts first;
  NodeFacts second;  ///< read again: what moves differs
  bool needsWrite = false;
};

/// The server has no node of this address, or it cannot be read.
bool isThere(const Proof& proof) {
  return !proof.second.status;
}

std::vector<Proof> namedBy(const opcua::ControlMap& map) {
  std::vector<Proof> proofs;
  const opcua::CellNodes& cells = map.cells;
  if (cells.first <= cells.last) {
    for (const int number : {cells.first, cells.last}) {
      proofs.push_back({cells.isArray ? "cells" : fmt::format("cells, R{}", number),
                        opcua::cellAddress(cells, number),
                        {},
                        {},
                        true});
      if (cells.isArray) {
        break;
      }
    }
  }
  for (const Variable& variable : opcua::mappableVariables()) {
    const auto node = map.nodes.find(variable);
    if (node != map.nodes.end()) {
      proofs.push_back({opcua::mapKeyOf(variable), node->second, {}, {}, false});
    }
  }
  return proofs;
}

/// Paths cannot be read; the survey knows their nodes.
std::string nodeOf(const opcua::Survey& survey, const std::string& address) {
  for (const opcua::SurveyedNode& one : survey.nodes) {
    if (opcua::isBrowsePath(address) && one.path == address) {
      return one.node.address;
    }
  }
  return address;
}

base::Result<std::vector<Proof>> prove(opcua::NodeBrowser& browser, const opcua::Survey& survey,
                                       const opcua::ControlMap& map) {
  std::vector<Proof> proofs = namedBy(map);
  std::vector<std::string> addresses;
  for (const Proof& proof : proofs) {
    addresses.push_back(nodeOf(survey, proof.address));
  }
  for (NodeFacts Proof::*const reading : {&Proof::first, &Proof::second}) {
    auto facts = browser.examine(addresses);
    if (!facts) {
      return base::fail(facts.error());
    }
    for (std::size_t i = 0; i < proofs.size(); ++i) {
      proofs[i].*reading = std::move((*facts)[i]);
    }
  }
  return proofs;
}

std::string typeOf(const NodeFacts& facts) {
  const std::string type = facts.type.empty() ? "?" : facts.type;
  return facts.isArray ? fmt::format("{}[{}]", type, facts.length) : type;
}

std::string rightsOf(const NodeFacts& facts) {
  return facts.mayRead && facts.mayWrite ? "read, write"
         : facts.mayWrite                ? "write"
         : facts.mayRead                 ? "read"
                                         : "none";
}

std::string valueOf(const Proof& proof) {
  if (!isThere(proof)) {
    return proof.second.status == opcua::LinkError::VariableMissing ? "no such node" : "no value";
  }
  std::string value = proof.first.status || proof.first.value == proof.second.value
                          ? proof.second.value
                          : fmt::format("{}, then {}", proof.first.value, proof.second.value);
  return proof.needsWrite && !proof.second.mayWrite
             ? fmt::format("{} (cells must be writable for this user)", value)
             : value;
}

void printProofs(const std::vector<Proof>& proofs) {
  fmt::print("{:<18} {:<12} {:<12} {:<24} {}\n", "key", "type", "this user", "value", "node");
  for (const Proof& proof : proofs) {
    fmt::print("{:<18} {:<12} {:<12} {:<24} {}\n", proof.key, typeOf(proof.second),
               rightsOf(proof.second), valueOf(proof), proof.address);
  }
}

std::vector<std::string> remarksOn(const opcua::Survey& survey,
                                   const opcua::MapProposal& proposal) {
  std::vector<std::string> remarks = proposal.remarks;
  if (!survey.incomplete.empty()) {
    remarks.push_back(survey.incomplete + " What is missing may be among the others.");
  }
  for (const opcua::MapGap& gap : opcua::gapsOf(proposal.map)) {
    if (gap.key != "methods" || proposal.methods.empty()) {
      remarks.push_back(fmt::format("Not found: {}. Without it, {}.", gap.key, gap.consequence));
    }
  }
  return remarks;
}

nlohmann::ordered_json asJson(const opcua::Survey& survey, const std::vector<Proof>& proofs,
                              const std::vector<std::string>& remarks, const std::string& text) {
  nlohmann::ordered_json nodes = nlohmann::ordered_json::array();
  for (const Proof& proof : proofs) {
    nodes.push_back({{"key", proof.key},
                     {"address", proof.address},
                     {"there", isThere(proof)},
                     {"type", typeOf(proof.second)},
                     {"readable", proof.second.mayRead},
                     {"writable", proof.second.mayWrite},
                     {"value", proof.second.value}});
  }
  return {{"nodes_seen", survey.nodes.size()},
          {"whole", survey.incomplete.empty()},
          {"mapped", nodes},
          {"remarks", remarks},
          {"map", text}};
}

}  // namespace

Exit map(const MapOptions& options) {
  const auto connection = connectTo(options.endpoint, std::make_shared<const opcua::ControlMap>());
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  opcua::SurveyLimits limits;
  limits.nodesMax = options.nodesMax;
  limits.depthMax = options.depthMax;
  limits.timeMax = base::fromSeconds(options.timeMaxS);
  const auto survey = opcua::surveyServer(*connection->browser, *connection->link, limits);
  if (!survey) {
    return reportError(survey.error(), options.json);
  }
  const auto machines = describedMachines(*connection);
  const opcua::MapProposal proposal = opcua::proposeMap(*survey);
  const auto proofs = prove(*connection->browser, *survey, proposal.map);
  if (!proofs) {
    return reportError(proofs.error(), options.json);
  }
  std::string status;
  for (const Proof& proof : *proofs) {
    if (proof.key == opcua::mapKeyOf({opcua::VariableKind::ChannelStatus, 0}) && isThere(proof)) {
      status = proof.second.value;
    }
  }
  const std::string text = opcua::proposalText(proposal, status);
  const std::vector<std::string> remarks = remarksOn(*survey, proposal);
  if (!options.output.empty()) {
    if (const auto written = base::writeFile(options.output, text); !written) {
      return reportError(written.error(), options.json);
    }
  }
  if (options.json) {
    auto json = asJson(*survey, *proofs, remarks, text);
    json["machines"] = machinesAsJson(machines);
    printJson(json);
    return Exit::Done;
  }
  printMachines(machines);
  fmt::print("{} nodes seen; each of these was read twice, nothing was written.\n\n",
             survey->nodes.size());
  printProofs(*proofs);
  fmt::print("\n");
  for (const std::string& remark : remarks) {
    fmt::print("{}\n", remark);
  }
  if (options.output.empty()) {
    fmt::print("\n{}", text);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
