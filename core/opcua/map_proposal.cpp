// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/map_proposal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/text.h"

namespace rivulet::opcua {

namespace {

/// Fewer cells do not hold the windows of a run.
constexpr std::size_t kCellsMin = 16;

enum class Carries { Number, Text, State, Alarm };

/// Words by which a node is recognised.
struct Clue {
  Variable variable;
  Carries carries;
  /// Of each list one word must be in the name or in that of an object above it.
  std::vector<std::vector<std::string_view>> needed;
  std::vector<std::string_view> forbidden;  ///< in the name or in that of its parent
  std::vector<std::string_view> better;
};

std::vector<Clue> makeClues() {
  std::vector<Clue> clues;
  constexpr std::array<std::string_view, 6> kLetters{"x", "y", "z", "a", "b", "c"};
  const std::vector<std::string_view> commanded{"command",  "commanded", "cmd",     "set",
                                                "setpoint", "target",    "nominal", "programmed"};
  std::vector<std::string_view> noPosition = commanded;
  noPosition.insert(noPosition.end(),
                    {"distance", "dist", "dtg", "togo", "go", "remaining", "rest", "error", "name",
                     "speed", "velocity", "load", "limit", "current", "temperature"});
  for (std::size_t axis = 0; axis < kLetters.size(); ++axis) {
    const int index = static_cast<int>(axis);
    clues.push_back(
        {{VariableKind::ActualPosition, index},
         Carries::Number,
         {{kLetters[axis]}, {"position", "positions", "pos", "actual", "act", "axes", "axis"}},
         noPosition,
         {"actual", "act", "position", "pos", "work", "workpiece"}});
    clues.push_back({{VariableKind::DistanceToGo, index},
                     Carries::Number,
                     {{kLetters[axis]}, {"distance", "dist", "dtg", "togo", "remaining", "rest"}},
                     {"name", "error"},
                     {"go", "togo"}});
  }
  std::vector<std::string_view> noFeed = commanded;
  noFeed.insert(noFeed.end(), {"override", "limit", "unit", "rapid"});
  clues.push_back({{VariableKind::PathFeed, 0},
                   Carries::Number,
                   {{"feed", "feedrate", "pathfeed"}},
                   noFeed,
                   {"actual", "act", "path"}});
  clues.push_back(
      {{VariableKind::ChannelStatus, 0},
       Carries::State,
       {{"status", "state", "mode"},
        {"channel", "machine", "cnc", "control", "controller", "nc", "execution"}},
       {"door", "spindle", "tool", "program", "axis", "turn", "connection", "operation", "coolant"},
       {"channel", "execution", "status", "state"}});
  clues.push_back({{VariableKind::Alarm, 0},
                   Carries::Alarm,
                   {{"alarm", "fault", "error"}},
                   {"text", "message", "history", "count", "time", "position", "following"},
                   {"alarm", "number", "active"}});
  clues.push_back({{VariableKind::ProgramName, 0},
                   Carries::Text,
                   {{"program", "prog"}, {"name", "selected", "file"}},
                   {"message", "status", "state", "line"},
                   {"selected", "name"}});
  clues.push_back({{VariableKind::ProgramStatus, 0},
                   Carries::Number,
                   {{"program", "prog"}, {"status", "state"}},
                   {"line"},
                   {}});
  clues.push_back({{VariableKind::LineNumber, 0},
                   Carries::Number,
                   {{"line", "block"}, {"number", "no", "actual", "act", "current", "program"}},
                   {"count", "max"},
                   {"number", "line"}});
  clues.push_back(
      {{VariableKind::Message, 0}, Carries::Text, {{"message", "msg"}}, {"alarm", "error"}, {}});
  clues.push_back({{VariableKind::ToolNumber, 0},
                   Carries::Number,
                   {{"tool"}, {"number", "no", "id"}},
                   commanded,
                   {"actual", "act"}});
  clues.push_back(
      {{VariableKind::ToolName, 0}, Carries::Text, {{"tool"}, {"name", "ident"}}, {}, {}});
  std::vector<std::string_view> noSpeed = commanded;
  noSpeed.insert(noSpeed.end(), {"override", "limit", "max"});
  clues.push_back({{VariableKind::SpindleSpeed, 0},
                   Carries::Number,
                   {{"spindle"}, {"speed", "rpm"}},
                   noSpeed,
                   {"actual", "act"}});
  clues.push_back({{VariableKind::SpindleSpeedSet, 0},
                   Carries::Number,
                   {{"spindle"}, {"speed", "rpm"}, commanded},
                   {"override", "limit", "max"},
                   {}});
  return clues;
}

bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool hasAny(const std::vector<std::string>& words, std::span<const std::string_view> some) {
  return std::any_of(some.begin(), some.end(),
                     [&](std::string_view word) { return contains(words, word); });
}

bool fits(const NodeFacts& facts, Carries carries) {
  if (facts.isArray) {
    return false;
  }
  switch (carries) {
    case Carries::Number:
      return facts.isNumber;
    case Carries::Text:
      return facts.isText;
    case Carries::State:
      return facts.isNumber || facts.isText || facts.isBoolean;
    case Carries::Alarm:
      return facts.isNumber || facts.isBoolean;
  }
  return false;
}

class Proposer {
 public:
  explicit Proposer(const Survey& survey) : m_survey(survey) {
    for (const SurveyedNode& one : survey.nodes) {
      m_words.push_back(wordsOf(one.node.name));
    }
  }

  MapProposal run() {
    const std::string sinumerik = fmt::format("nsu={};", kNamespaceUri);
    m_proposal.isSinumerik = std::any_of(
        m_survey.nodes.begin(), m_survey.nodes.end(),
        [&](const SurveyedNode& one) { return one.node.address.starts_with(sinumerik); });
    if (m_proposal.isSinumerik) {
      m_proposal.map = sinumerikMap(99, 3);
      m_proposal.remarks.emplace_back(
          "This server has the names of a SINUMERIK: Rivulet knows them without a map.");
      return std::move(m_proposal);
    }
    findCells();
    for (const Clue& clue : makeClues()) {
      findVariable(clue);
    }
    findMethods();
    return std::move(m_proposal);
  }

 private:
  /// How well a node fits; nothing: not at all. What is in the name itself counts more.
  std::optional<int> scoreOf(std::size_t at, const Clue& clue) const {
    const std::vector<std::string>& own = m_words[at];
    const std::vector<std::string>& parent = m_words[m_survey.nodes[at].parent];
    std::vector<std::string> above = parent;
    for (std::size_t up = m_survey.nodes[at].parent; up != 0; up = m_survey.nodes[up].parent) {
      above.insert(above.end(), m_words[up].begin(), m_words[up].end());
    }
    if (hasAny(own, clue.forbidden) || hasAny(parent, clue.forbidden)) {
      return std::nullopt;
    }
    int score = 0;
    bool isOwn = false;
    for (const auto& words : clue.needed) {
      const bool inName = hasAny(own, words);
      if (!inName && !hasAny(above, words)) {
        return std::nullopt;
      }
      isOwn = isOwn || inName;
      score += inName ? 4 : 1;
    }
    for (const std::string_view word : clue.better) {
      score += contains(own, word) ? 2 : contains(above, word) ? 1 : 0;
    }
    return isOwn ? std::optional(score) : std::nullopt;
  }

  void findVariable(const Clue& clue) {
    int best = 0;
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at < m_survey.nodes.size(); ++at) {
      const SurveyedNode& one = m_survey.nodes[at];
      if (one.node.kind != NodeKind::Variable || !fits(one.facts, clue.carries) ||
          m_cells.contains(at)) {
        continue;
      }
      const std::optional<int> score = scoreOf(at, clue);
      if (score && *score >= best) {
        if (*score > best) {
          found.clear();
        }
        best = *score;
        found.push_back(at);
      }
    }
    if (found.empty()) {
      return;
    }
    const std::string key = mapKeyOf(clue.variable);
    m_proposal.map.nodes[clue.variable] = m_survey.nodes[found.front()].node.address;
    if (found.size() > 1) {
      m_proposal.remarks.push_back(
          fmt::format("{} may also be {}.", key, m_survey.nodes[found[1]].path));
    }
  }

  // --- cells ------------------------------------------------------------------------------------

  /// Variables below one node whose names differ in one number only.
  struct Group {
    std::map<int, std::size_t> nodes;  ///< by number
  };

  void findCells() {
    std::size_t most = kCellsMin - 1;
    for (std::size_t at = 0; at < m_survey.nodes.size(); ++at) {
      const NodeFacts& facts = m_survey.nodes[at].facts;
      if (facts.isArray && facts.type == "Double" && facts.mayWrite && facts.length > most) {
        most = facts.length;
        m_cells = {at};
        CellNodes& cells = m_proposal.map.cells;
        cells = {};
        cells.isArray = true;
        cells.node = m_survey.nodes[at].node.address;
        cells.last = static_cast<int>(facts.length) - 1;
      }
    }
    for (const auto& [name, group] : groups()) {
      takeGroup(group, most);
    }
    if (m_proposal.map.cells.last >= m_proposal.map.cells.first) {
      m_proposal.remarks.emplace_back(
          "That a number on the server is the R number of a cell is a guess: compare with the "
          "control, and correct first, last and offset of [cells].");
    }
  }

  [[nodiscard]] std::map<std::pair<std::size_t, std::string>, Group> groups() const {
    std::map<std::pair<std::size_t, std::string>, Group> groups;
    for (std::size_t at = 0; at < m_survey.nodes.size(); ++at) {
      const SurveyedNode& one = m_survey.nodes[at];
      if (one.facts.isArray || one.facts.type != "Double" || !one.facts.mayWrite) {
        continue;
      }
      const std::string& name = one.node.name;
      const auto last = std::find_if(name.rbegin(), name.rend(), base::isDigit);
      const auto first = std::find_if_not(last, name.rend(), base::isDigit);
      const std::string digits(first.base(), last.base());
      const auto number = base::parseInteger(digits);
      // "07" has another pattern than "7".
      if (!number || std::to_string(*number) != digits) {
        continue;
      }
      const std::string pattern =
          std::string(name.begin(), first.base()) + "{}" + std::string(last.base(), name.end());
      groups[{one.parent, pattern}].nodes.emplace(*number, at);
    }
    return groups;
  }

  /// The longest row of numbers without a gap, if it is longer than what was found before.
  void takeGroup(const Group& group, std::size_t& most) {
    std::vector<std::pair<int, std::size_t>> row;
    for (const auto& [number, at] : group.nodes) {
      if (!row.empty() && row.back().first + 1 != number) {
        row.clear();
      }
      row.emplace_back(number, at);
      const auto pattern = row.size() > most ? patternOf(row) : std::nullopt;
      if (pattern) {
        most = row.size();
        m_proposal.map.cells = *pattern;
        m_cells.clear();
        for (const auto& [cell, node] : row) {
          m_cells.insert(node);
        }
      }
    }
  }

  /// One address for all of them, by node ids if these follow the numbers, else by paths.
  [[nodiscard]] std::optional<CellNodes> patternOf(
      const std::vector<std::pair<int, std::size_t>>& row) const {
    CellNodes cells;
    cells.first = row.front().first;
    cells.last = row.back().first;
    for (const bool byPath : {false, true}) {
      const auto addressOf = [&](std::size_t at) -> const std::string& {
        return byPath ? m_survey.nodes[at].path : m_survey.nodes[at].node.address;
      };
      const std::string& address = addressOf(row.front().second);
      // Whichever number of the address is the one that follows.
      for (std::size_t begin = 0; begin < address.size(); ++begin) {
        if (!base::isDigit(address[begin]) || (begin > 0 && base::isDigit(address[begin - 1]))) {
          continue;
        }
        std::size_t end = begin;
        while (end < address.size() && base::isDigit(address[end])) {
          ++end;
        }
        const auto number = base::parseInteger(address.substr(begin, end - begin));
        if (!number) {
          continue;
        }
        cells.node = address.substr(0, begin) + "{}" + address.substr(end);
        cells.offset = *number - cells.first;
        if (std::all_of(row.begin(), row.end(), [&](const auto& one) {
              return cellAddress(cells, one.first) == addressOf(one.second);
            })) {
          return cells;
        }
      }
    }
    return std::nullopt;
  }

  // --- methods ----------------------------------------------------------------------------------

  void findMethods() {
    struct Kind {
      std::string_view key;
      std::vector<std::string_view> verbs;
    };
    const std::array<Kind, 3> kinds{Kind{"write", {"write", "put", "upload", "store"}},
                                    Kind{"read", {"read", "get", "download"}},
                                    Kind{"select", {"select"}}};
    constexpr std::array<std::string_view, 4> kThings{"file", "program", "prog", "nc"};
    for (const Kind& kind : kinds) {
      for (std::size_t at = 0; at < m_survey.nodes.size(); ++at) {
        const SurveyedNode& one = m_survey.nodes[at];
        if (one.node.kind == NodeKind::Method && hasAny(m_words[at], kind.verbs) &&
            hasAny(m_words[at], kThings)) {
          m_proposal.methods.push_back(
              {std::string(kind.key), m_survey.nodes[one.parent].node.address, one.node.address});
          break;
        }
      }
    }
  }

  const Survey& m_survey;
  std::vector<std::vector<std::string>> m_words;
  std::set<std::size_t> m_cells;  ///< nodes that are cells
  MapProposal m_proposal;
};

}  // namespace

base::Result<Survey> surveyServer(NodeBrowser& browser, const Link& link,
                                  const SurveyLimits& limits) {
  Survey survey;
  const base::Instant until = link.now() + limits.timeMax;
  SurveyedNode root;
  root.node = {kObjectsFolder, 0, "Objects", NodeKind::Object};
  survey.nodes.push_back(std::move(root));
  std::set<std::string> seen{kObjectsFolder};
  std::size_t levelBegin = 0;
  for (int depth = 1; levelBegin < survey.nodes.size(); ++depth) {
    const std::size_t levelEnd = survey.nodes.size();
    for (std::size_t at = levelBegin; at < levelEnd; ++at) {
      if (survey.nodes[at].node.kind == NodeKind::Method) {
        continue;  // below it are only its arguments
      }
      if (depth > limits.depthMax) {
        survey.incomplete =
            fmt::format("Nodes below level {} were not looked at.", limits.depthMax);
        continue;
      }
      if (link.now() >= until) {
        survey.incomplete =
            fmt::format("Not all nodes were seen in {:.0f} s.", base::toSeconds(limits.timeMax));
        break;
      }
      auto nodes = browser.children(survey.nodes[at].node.address);
      if (!nodes) {
        return base::fail(nodes.error());
      }
      for (BrowsedNode& node : *nodes) {
        // The standard's own nodes (those of namespace 0) are the server's, not the control's.
        const bool isStandard = node.address.find(';') == std::string::npos;
        if (isStandard || !seen.insert(node.address).second) {
          continue;
        }
        if (survey.nodes.size() >= limits.nodesMax) {
          survey.incomplete =
              fmt::format("Only the first {} nodes were looked at.", limits.nodesMax);
          break;
        }
        SurveyedNode found;
        found.path = fmt::format("{}/{}", survey.nodes[at].path, escapedStep(node.name));
        found.parent = at;
        found.node = std::move(node);
        survey.nodes.push_back(std::move(found));
      }
      if (!survey.incomplete.empty()) {
        break;
      }
    }
    levelBegin = levelEnd;
    if (depth > limits.depthMax || !survey.incomplete.empty()) {
      break;
    }
  }
  std::vector<std::string> addresses;
  std::vector<std::size_t> places;
  for (std::size_t at = 0; at < survey.nodes.size(); ++at) {
    if (survey.nodes[at].node.kind == NodeKind::Variable) {
      addresses.push_back(survey.nodes[at].node.address);
      places.push_back(at);
    }
  }
  auto facts = browser.examine(addresses);
  if (!facts) {
    return base::fail(facts.error());
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    survey.nodes[places[i]].facts = std::move((*facts)[i]);
  }
  return survey;
}

MapProposal proposeMap(const Survey& survey) {
  return Proposer(survey).run();
}

std::string proposalText(const MapProposal& proposal, const std::string& channelStatus) {
  std::string text =
      "# Proposed by names, types and lengths of arrays: compare every line with the control.\n"
      "# docs/mapping.md has all keys. Units that are not given are mm, degrees and mm/min.\n\n" +
      controlMapText(proposal.map);
  constexpr std::string_view kChannel = "[channel]\n";
  const std::size_t channel = text.find(kChannel);
  if (!proposal.isSinumerik && channel != std::string::npos) {
    const std::string now =
        channelStatus.empty() ? std::string() : fmt::format(" It shows {} now.", channelStatus);
    text.insert(channel + kChannel.size(),
                fmt::format("# Say which values mean what, then remove the #.{}\n"
                            "# reset = []\n# active = []\n# interrupted = []\n",
                            now));
  }
  if (!proposal.methods.empty()) {
    text +=
        "\n# Methods are not called to try them. If their arguments are those of docs/mapping.md,\n"
        "# remove the #.\n# [methods]\n";
    text += fmt::format("# object = \"{}\"\n", proposal.methods.front().object);
    for (const ProposedMethod& method : proposal.methods) {
      text += fmt::format("# {} = \"{}\"\n", method.key, method.address);
    }
  }
  return text;
}

std::vector<std::string> wordsOf(std::string_view name) {
  enum class Class { None, Lower, Upper, Digit };
  const auto classOf = [](char c) {
    return base::isDigit(c)       ? Class::Digit
           : c >= 'a' && c <= 'z' ? Class::Lower
           : c >= 'A' && c <= 'Z' ? Class::Upper
                                  : Class::None;
  };
  std::vector<std::string> words;
  Class before = Class::None;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const Class now = classOf(name[i]);
    const Class next = i + 1 < name.size() ? classOf(name[i + 1]) : Class::None;
    // A word begins at each change; a capital letter belongs to the small ones after it.
    const bool isCapital = now == Class::Upper && next == Class::Lower;
    const bool continues = before == now && !(isCapital && before == Class::Upper);
    const bool follows = before == Class::Upper && now == Class::Lower;
    if (now != Class::None) {
      if (words.empty() || before == Class::None || !(continues || follows)) {
        words.emplace_back();
      }
      const char c = name[i];
      words.back() += now == Class::Upper ? static_cast<char>(c - 'A' + 'a') : c;
    }
    before = now;
  }
  return words;
}

}  // namespace rivulet::opcua
