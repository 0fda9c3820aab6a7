// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/continuation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

#include "base/text.h"

namespace rivulet::templates {

namespace {

/// What a line does to the order in which lines are executed.
struct FlowLine {
  bool isMotion = false;
  bool isStop = false;     ///< STOPRE
  bool goesOn = true;      ///< the next line may follow
  std::string_view label;  ///< where it may jump to; empty: nowhere
};

FlowLine flowLineOf(std::string_view line) {
  FlowLine flow;
  flow.isMotion = line.starts_with("G1 ");
  flow.isStop = line == "STOPRE";
  const std::size_t jump = line.find("GOTO");
  if (jump != std::string_view::npos) {
    const std::size_t label = line.find(' ', jump);
    flow.label =
        label == std::string_view::npos ? std::string_view() : base::trim(line.substr(label));
    flow.goesOn = jump != 0;  // "IF ... GOTOF LABEL" may go on
  }
  flow.goesOn = flow.goesOn && line != "M30" && line != "M17";
  return flow;
}

}  // namespace

std::vector<base::Continuation> continuationsOf(std::string_view program) {
  std::vector<FlowLine> lines;
  std::map<std::string_view, std::size_t> labels;
  while (!program.empty()) {
    const std::size_t end = program.find('\n');
    const std::string_view line = base::trim(program.substr(0, end));
    program.remove_prefix(end == std::string_view::npos ? program.size() : end + 1);
    if (line.ends_with(':') && !line.starts_with(';')) {
      labels[line.substr(0, line.size() - 1)] = lines.size();
    }
    lines.push_back(line.starts_with(';') ? FlowLine{} : flowLineOf(line));
  }
  const bool hasStop =
      std::any_of(lines.begin(), lines.end(), [](const FlowLine& line) { return line.isStop; });
  std::vector<base::Continuation> found;
  for (std::size_t from = 0; hasStop && from < lines.size(); ++from) {
    if (!lines[from].isMotion) {
      continue;
    }
    std::vector<bool> isSeen(lines.size(), false);
    std::vector<std::size_t> next{from + 1};
    while (!next.empty()) {
      const std::size_t at = next.back();
      next.pop_back();
      if (at >= lines.size() || isSeen[at] || lines[at].isStop) {
        continue;
      }
      isSeen[at] = true;
      if (lines[at].isMotion) {
        found.push_back({base::LineNumber{static_cast<std::uint32_t>(from + 1)},
                         base::LineNumber{static_cast<std::uint32_t>(at + 1)}});
        continue;
      }
      if (lines[at].goesOn) {
        next.push_back(at + 1);
      }
      if (const auto label = labels.find(lines[at].label); label != labels.end()) {
        next.push_back(label->second);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace rivulet::templates
