// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/machinery.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "opcua/error.h"
#include "opcua/node_browser.h"

namespace rivulet::opcua {

namespace {

constexpr std::size_t kMachinesMax = 8;
constexpr std::size_t kJobsMax = 20;
/// Object Machines. @source OPC 40001-1, 7
constexpr const char* kMachinesFolder = "nsu=http://opcfoundation.org/UA/Machinery/;i=1001";

/// A browse name.
struct Name {
  std::string_view uri;
  std::string_view name;
};
using Path = std::vector<Name>;

constexpr Name core(std::string_view name) {
  return {"http://opcfoundation.org/UA/", name};
}
constexpr Name device(std::string_view name) {
  return {"http://opcfoundation.org/UA/DI/", name};
}
constexpr Name machinery(std::string_view name) {
  return {"http://opcfoundation.org/UA/Machinery/", name};
}
constexpr Name tool(std::string_view name) {
  return {"http://opcfoundation.org/UA/MachineTool/", name};
}

/// Where a text of a machine may be; of several places of one text the first that exists counts.
struct Place {
  std::string DescribedMachine::*text;
  Path path;
};

/// @source OPC 40001-1, 8 and 12 to 14; OPC 40501-1, 8
const std::vector<Place>& places() {
  static const std::vector<Place> kPlaces = [] {
    std::vector<Place> list;
    const auto identified = [&list](std::string DescribedMachine::*text, Name name) {
      list.push_back({text, {device("Identification"), name}});
    };
    identified(&DescribedMachine::manufacturer, device("Manufacturer"));
    identified(&DescribedMachine::model, device("Model"));
    identified(&DescribedMachine::serialNumber, device("SerialNumber"));
    identified(&DescribedMachine::softwareRevision, device("SoftwareRevision"));
    identified(&DescribedMachine::productInstanceUri, device("ProductInstanceUri"));
    identified(&DescribedMachine::yearOfConstruction, machinery("YearOfConstruction"));
    identified(&DescribedMachine::location, machinery("Location"));
    for (const auto& [text, name] :
         {std::pair(&DescribedMachine::state, machinery("MachineryItemState")),
          std::pair(&DescribedMachine::operationMode, machinery("MachineryOperationMode"))}) {
      const Name current = core("CurrentState");
      list.push_back({text, {machinery("MachineryBuildingBlocks"), name, current}});
      list.push_back({text, {tool("Monitoring"), tool("MachineTool"), name, current}});
      list.push_back({text, {machinery("Monitoring"), machinery("Status"), name, current}});
    }
    const auto active = [&list](std::string DescribedMachine::*text, Path rest) {
      rest.insert(rest.begin(), {tool("Production"), tool("ActiveProgram")});
      list.push_back({text, std::move(rest)});
    };
    active(&DescribedMachine::program, {tool("Name")});
    active(&DescribedMachine::programState, {tool("State"), core("CurrentState")});
    active(&DescribedMachine::job, {tool("JobIdentifier")});
    return list;
  }();
  return kPlaces;
}

/// Names of MachineOperationMode. @source OPC 40501-1, 10.3
constexpr std::array<std::string_view, 6> kMachineToolModes{
    "Manual", "Automatic", "Setup", "AutoWithManualIntervention", "Service", "Other"};

/// The connection is at fault, so nothing more can be read.
bool isFatal(const base::Error& error) {
  return error.code == LinkError::ConnectionLost || error.code == LinkError::DeadlineExceeded ||
         error.code == LinkError::NotReachable;
}

std::optional<int> wholeNumber(const NodeFacts& facts) {
  int number = 0;
  const std::string& text = facts.value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !facts.status && facts.isNumber && error == std::errc() && end == text.data() + text.size()
             ? std::optional(number)
             : std::nullopt;
}

/// Finds nodes by their browse names, each folder listed once.
class Guide {
 public:
  explicit Guide(NodeBrowser& browser) : m_browser(browser) {}

  /// @return what is below the node; empty if the user may not see it
  [[nodiscard]] base::Result<std::vector<BrowsedNode>> children(const std::string& address) {
    if (const auto known = m_known.find(address); known != m_known.end()) {
      return known->second;
    }
    auto nodes = m_browser.children(address);
    if (!nodes && isFatal(nodes.error())) {
      return base::fail(nodes.error());
    }
    return m_known[address] = nodes ? *std::move(nodes) : std::vector<BrowsedNode>();
  }

  /// @return its address; empty: there is no such node
  [[nodiscard]] base::Result<std::string> find(std::string from, const Path& path) {
    for (const Name& step : path) {
      const auto nodes = children(from);
      if (!nodes) {
        return base::fail(nodes.error());
      }
      const auto found = std::find_if(nodes->begin(), nodes->end(), [&](const BrowsedNode& node) {
        return node.name == step.name && node.nameUri == step.uri;
      });
      if (found == nodes->end()) {
        return std::string();
      }
      from = found->address;
    }
    return from;
  }

  /// The values of variables; those without an address, or that cannot be read, have a status.
  [[nodiscard]] base::Result<std::vector<NodeFacts>> values(
      const std::vector<std::string>& addresses) {
    NodeFacts missing;
    missing.status = LinkError::VariableMissing;
    std::vector<NodeFacts> facts(addresses.size(), missing);
    std::vector<std::string> there;
    std::copy_if(addresses.begin(), addresses.end(), std::back_inserter(there),
                 [](const std::string& address) { return !address.empty(); });
    if (there.empty()) {
      return facts;
    }
    auto read = m_browser.examine(there);
    if (!read) {
      return isFatal(read.error()) ? base::Result<std::vector<NodeFacts>>(base::fail(read.error()))
                                   : facts;
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < addresses.size(); ++i) {
      if (!addresses[i].empty()) {
        facts[i] = std::move((*read)[next++]);
      }
    }
    return facts;
  }

 private:
  NodeBrowser& m_browser;
  std::map<std::string, std::vector<BrowsedNode>> m_known;
};

base::Result<void> readTexts(Guide& guide, const std::string& address, DescribedMachine& machine) {
  std::vector<std::string> addresses;
  for (const Place& place : places()) {
    auto found = guide.find(address, place.path);
    if (!found) {
      return base::fail(found.error());
    }
    addresses.push_back(*std::move(found));
  }
  // Machine tools of the first versions have a number in place of the state machine.
  auto mode = guide.find(address, {tool("Monitoring"), tool("MachineTool"), tool("OperationMode")});
  if (!mode) {
    return base::fail(mode.error());
  }
  addresses.push_back(*std::move(mode));
  const auto facts = guide.values(addresses);
  if (!facts) {
    return base::fail(facts.error());
  }
  for (std::size_t i = 0; i < places().size(); ++i) {
    std::string& text = machine.*(places()[i].text);
    if (text.empty() && !(*facts)[i].status) {
      text = (*facts)[i].value;
    }
  }
  const auto number = wholeNumber(facts->back());
  if (machine.operationMode.empty() && number && *number >= 0 &&
      static_cast<std::size_t>(*number) < kMachineToolModes.size()) {
    machine.operationMode = kMachineToolModes[static_cast<std::size_t>(*number)];
  }
  return {};
}

/// How far the job of the active program is, from the list of jobs. @source OPC 40501-1, 8.5
base::Result<void> readJob(Guide& guide, const std::string& address, DescribedMachine& machine) {
  const auto plan = guide.find(address, {tool("Production"), tool("ProductionPlan")});
  if (!plan) {
    return base::fail(plan.error());
  }
  if (plan->empty()) {
    return {};
  }
  const auto jobs = guide.children(*plan);
  if (!jobs) {
    return base::fail(jobs.error());
  }
  std::size_t looked = 0;
  for (const BrowsedNode& job : *jobs) {
    if (job.kind != NodeKind::Object || ++looked > kJobsMax) {
      continue;
    }
    std::vector<std::string> addresses;
    for (const Path& path : {Path{tool("Identifier")}, Path{tool("State"), core("CurrentState")},
                             Path{tool("RunsCompleted")}, Path{tool("RunsPlanned")},
                             Path{tool("RunsPlanned"), tool("IsValid")}}) {
      auto found = guide.find(job.address, path);
      if (!found) {
        return base::fail(found.error());
      }
      addresses.push_back(*std::move(found));
    }
    const auto facts = guide.values(addresses);
    if (!facts) {
      return base::fail(facts.error());
    }
    const NodeFacts& identifier = (*facts)[0];
    if (identifier.status || identifier.value != machine.job) {
      continue;
    }
    machine.jobState = (*facts)[1].status ? std::string() : (*facts)[1].value;
    machine.runsCompleted = wholeNumber((*facts)[2]);
    const NodeFacts& isValid = (*facts)[4];
    const bool isPlanned = isValid.status || isValid.value != "0";
    machine.runsPlanned = isPlanned ? wholeNumber((*facts)[3]) : std::nullopt;
    return {};
  }
  return {};
}

}  // namespace

base::Result<std::vector<DescribedMachine>> readMachines(NodeBrowser& browser) {
  Guide guide(browser);
  const auto nodes = guide.children(kMachinesFolder);
  if (!nodes) {
    return base::fail(nodes.error());
  }
  std::vector<DescribedMachine> machines;
  for (const BrowsedNode& node : *nodes) {
    if (node.kind != NodeKind::Object || machines.size() == kMachinesMax) {
      continue;
    }
    // Without the mandatory identification it is no machine.
    const auto identification = guide.find(node.address, {device("Identification")});
    if (!identification) {
      return base::fail(identification.error());
    }
    if (identification->empty()) {
      continue;
    }
    DescribedMachine machine;
    machine.name = node.name;
    auto read = readTexts(guide, node.address, machine);
    if (read && !machine.job.empty()) {
      read = readJob(guide, node.address, machine);
    }
    if (!read) {
      return base::fail(read.error());
    }
    machines.push_back(std::move(machine));
  }
  return machines;
}

}  // namespace rivulet::opcua
