// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Proposes a map of a server nobody has described: walks through its nodes, and guesses from
/// names, types and array lengths which is what. A guess is for a person to check; nothing is
/// written.
/// @threadsafety `surveyServer` as the link; else pure.
#pragma once

#include <string>
#include <vector>

#include "base/instant.h"
#include "opcua/control_map.h"
#include "opcua/link.h"
#include "opcua/node_browser.h"

namespace rivulet::opcua {

/// A node that was met on the walk.
struct SurveyedNode {
  BrowsedNode node;
  std::string path;        ///< from Objects, as an address
  std::size_t parent = 0;  ///< its index in the survey; of the first node itself
  NodeFacts facts;         ///< of a variable
};

struct SurveyLimits {
  std::size_t nodesMax = 20'000;
  int depthMax = 8;  ///< levels below Objects
  base::Duration timeMax = std::chrono::seconds(60);
};

struct Survey {
  std::vector<SurveyedNode> nodes;  ///< the first is Objects
  std::string incomplete;           ///< why not all nodes were seen; empty: they were
};

/// Walks through what is below Objects, level by level, without the standard's own nodes.
/// @param link  tells the time @return the error of a request
[[nodiscard]] base::Result<Survey> surveyServer(NodeBrowser& browser, const Link& link,
                                                const SurveyLimits& limits = {});

/// What a method seems to be; its arguments have not been looked at.
struct ProposedMethod {
  std::string key;  ///< "write", "read", "select"
  std::string object;
  std::string address;
};

struct MapProposal {
  ControlMap map;  ///< without states, units and methods: they cannot be seen
  std::vector<ProposedMethod> methods;
  /// For a person: several nodes fit, and the like. Sentences.
  std::vector<std::string> remarks;
  bool isSinumerik = false;  ///< no map is needed
};

[[nodiscard]] MapProposal proposeMap(const Survey& survey);

/// The proposal as a file. What has to be said by a person is a comment in it: until then, it is
/// refused.
/// @param channelStatus  what the control shows now; empty: not known
[[nodiscard]] std::string proposalText(const MapProposal& proposal,
                                       const std::string& channelStatus);

/// The words of a name in lower case: "actPos_X1" is act, pos, x, 1.
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view name);

}  // namespace rivulet::opcua
