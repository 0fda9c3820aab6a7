// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/rights.h"

#include <algorithm>
#include <array>

#include "base/sentence.h"
#include "opcua/await.h"
#include "opcua/control_map.h"

namespace rivulet::opcua {

namespace {

struct RightFacts {
  RunRight right;
  std::string_view title;
  std::string_view purpose;
  std::string_view remedy;
  std::string_view remedyOfMapped;
  /// Each of these rights of the server includes it.
  std::array<std::string_view, 2> names;
  bool isEssential;
};

constexpr std::array<RightFacts, 5> kRights{
    {{RunRight::ReadVariables,
      RIVULET_SENTENCE("RightTexts", "read variables"),
      RIVULET_SENTENCE("RightTexts", "follows the run"),
      RIVULET_SENTENCE("RightTexts",
                       "Call GiveUserAccess with StateRead; if that is not enough, with "
                       "SinuReadAll."),
      RIVULET_SENTENCE("RightTexts",
                       "Let this OPC UA user read the nodes of the map, in the settings of the "
                       "server."),
      {"StateRead", "SinuReadAll"},
      true},
     {RunRight::WriteParameters,
      RIVULET_SENTENCE("RightTexts", "write R-parameters"),
      RIVULET_SENTENCE("RightTexts", "sends the points"),
      RIVULET_SENTENCE("RightTexts",
                       "Call GiveUserAccess with StateWrite; if that is not enough, with "
                       "SinuWriteAll. The protection level of R-parameters (MD51051) must allow "
                       "it, too."),
      RIVULET_SENTENCE("RightTexts",
                       "Let this OPC UA user write the cells of the map, in the settings of the "
                       "server."),
      {"StateWrite", "SinuWriteAll"},
      true},
     {RunRight::ReadPrograms,
      RIVULET_SENTENCE("RightTexts", "read programs"),
      RIVULET_SENTENCE("RightTexts",
                       "checks which program is on the control; without it the operator does"),
      RIVULET_SENTENCE("RightTexts", "Call GiveUserAccess with FsRead."),
      RIVULET_SENTENCE("RightTexts",
                       "Name the method in the map (methods.read), if the server has one, and let "
                       "this OPC UA user call it."),
      {"FsRead", ""},
      false},
     {RunRight::WritePrograms,
      RIVULET_SENTENCE("RightTexts", "write programs"),
      RIVULET_SENTENCE("RightTexts",
                       "brings its program to the control; without it the operator copies it"),
      RIVULET_SENTENCE("RightTexts", "Call GiveUserAccess with FsWrite."),
      RIVULET_SENTENCE("RightTexts",
                       "Name the method in the map (methods.write), if the server has one, and let "
                       "this OPC UA user call it."),
      {"FsWrite", ""},
      false},
     {RunRight::SelectProgram,
      RIVULET_SENTENCE("RightTexts", "select a program"),
      RIVULET_SENTENCE("RightTexts", "selects its program; without it the operator does"),
      RIVULET_SENTENCE("RightTexts", "Call GiveUserAccess with ApWrite."),
      RIVULET_SENTENCE("RightTexts",
                       "Name the method in the map (methods.select), if the server has one, and "
                       "let this OPC UA user call it."),
      {"ApWrite", ""},
      false}}};

/// A name that nobody gives a program.
constexpr const char* kAbsentProgram = "RIVULET_RIGHTS_TEST.MPF";

[[nodiscard]] const RightFacts& factsOf(RunRight right) {
  return kRights[static_cast<std::size_t>(right)];
}

[[nodiscard]] std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (end > begin) {
      parts.push_back(text.substr(begin, end - begin));
    }
    begin = end + 1;
  }
  return parts;
}

[[nodiscard]] bool isListed(const std::vector<std::string>& names, std::string_view name) {
  return !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
}

/// A program that does not exist is found missing only by a user who may look for it.
[[nodiscard]] bool foundMissing(const std::error_code& code) {
  return code == LinkError::ProgramMissing;
}

/// What the server does, as far as it can be seen without changing anything.
[[nodiscard]] base::Result<std::optional<bool>> tryRight(RunRight right, Link& link,
                                                         Control& control, const Variable& cell,
                                                         base::Duration deadline) {
  switch (right) {
    case RunRight::ReadVariables: {
      const auto readings = readNow(link, {&cell, 1}, deadline);
      if (!readings) {
        return base::fail(readings.error());
      }
      return !readings->front().status;
    }
    case RunRight::WriteParameters: {
      const auto may = control.mayWrite(cell);
      return may ? std::optional(*may) : std::nullopt;
    }
    case RunRight::ReadPrograms: {
      const auto text = control.downloadProgram(kAbsentProgram);
      return text.has_value() || foundMissing(text.error().code);
    }
    case RunRight::SelectProgram: {
      const auto selected = control.selectProgram(kAbsentProgram);
      return selected.has_value() || foundMissing(selected.error().code) ||
             selected.error().code == LinkError::ChannelNotInReset;
    }
    case RunRight::WritePrograms:
      break;  // a test would leave a program on the control
  }
  return std::nullopt;
}

}  // namespace

base::Result<RightsReport> examineRights(const Connection& connection) {
  const int cell = connection.map != nullptr ? connection.map->cells.first : 0;
  auto report =
      examineRights(*connection.link, *connection.control, kRightsDeadline, rParameter(cell));
  if (report) {
    report->isMapped = connection.map != nullptr;
  }
  return report;
}

base::Result<RightsReport> examineRights(Link& link, Control& control, base::Duration deadline,
                                         const Variable& cell) {
  RightsReport report;
  std::vector<std::string> listed;
  if (const auto rights = control.accessRights()) {
    listed = split(*rights);
    report.isListed = true;
  }
  for (const RightFacts& facts : kRights) {
    // What the server does counts more than what it says.
    const auto tried = tryRight(facts.right, link, control, cell, deadline);
    if (!tried) {
      return base::fail(tried.error());
    }
    RightFinding finding{facts.right, *tried};
    if (!finding.isGiven && report.isListed) {
      finding.isGiven = isListed(listed, facts.names[0]) || isListed(listed, facts.names[1]);
    }
    report.findings.push_back(finding);
  }
  for (const std::string& name : listed) {
    const bool isNeeded = std::any_of(kRights.begin(), kRights.end(), [&](const RightFacts& facts) {
      return facts.names[0] == name || facts.names[1] == name;
    });
    if (!isNeeded) {
      report.excess.push_back(name);
    }
  }
  return report;
}

std::string_view rightTitle(RunRight right) {
  return factsOf(right).title;
}
std::string_view rightPurpose(RunRight right) {
  return factsOf(right).purpose;
}
std::string_view rightRemedy(RunRight right, bool isMapped) {
  return isMapped ? factsOf(right).remedyOfMapped : factsOf(right).remedy;
}
bool isEssential(RunRight right) {
  return factsOf(right).isEssential;
}

}  // namespace rivulet::opcua
