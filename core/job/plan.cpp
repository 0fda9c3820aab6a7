// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/plan.h"

#include <algorithm>
#include <utility>

#include "base/budget.h"
#include "nc/fault.h"

namespace rivulet::job {

namespace {

struct RefusalText {
  std::string_view name;
  std::string_view sentence;
};

const RefusalText& textOf(RefusalCode code) {
  static constexpr std::array<RefusalText, 8> kTexts{{
      {"not-translated",
       "There is no translation of %1 for the control: leave it out (--accept %1)."},
      {"curve-interrupted",
       "%1 stands within a spline, which cannot be split there: move the block before it."},
      {"start-unknown",
       "Where %1 begins, only the control knows: name X, Y and Z in a straight move before it, "
       "after the tool change, the offset or the move in machine coordinates."},
      {"cycle-incomplete",
       "The canned cycle %1 lacks a value, or has one that does not fit: write it into the block."},
      {"function-unknown",
       "%1 belongs to another machine: say what the control does for it, nothing (--m %1=ignore), "
       "the same (--m %1=pass), or for an M function a line (--m %1=\"M50\")."},
      {"length-of-other-tool",
       "%1 is no length of the tool in the spindle: the control has that of its own tool alone. "
       "Write the number of the tool after H, or take the length of the tool in the spindle, edge "
       "D1, for it (--accept with the H word)."},
      {"tool-not-called",
       "%1 is the length of a tool, but the program has not called one: write its tool change "
       "before. If that tool will be in the spindle when the job starts, --accept %1 takes the "
       "length of the tool in the spindle, edge D1."},
      {"length-kept",
       "The tool axis moves with the length of the tool before the change, %1: write G43 with H of "
       "the new tool before that move, or G49."},
  }};
  return kTexts[static_cast<std::size_t>(code)];
}

}  // namespace

nc::Place BlockPlaces::Run::at(std::uint32_t index) const {
  nc::Place place = first;
  place.line.value += index;
  return place;
}

void BlockPlaces::add(const nc::Place& place) {
  if (!m_runs.empty()) {
    Run& run = m_runs.back();
    const nc::Place next = run.at(run.count);
    if (place.line == next.line && place.file == next.file && place.column == next.column) {
      ++run.count;
      return;
    }
  }
  m_runs.push_back({place});
}

std::vector<nc::Place> BlockPlaces::all() const {
  std::vector<nc::Place> places;
  for (const Run& run : m_runs) {
    for (std::uint32_t i = 0; i < run.count; ++i) {
      places.push_back(run.at(i));
    }
  }
  return places;
}

std::size_t BlockPlaces::size() const {
  std::size_t count = 0;
  for (const Run& run : m_runs) {
    count += run.count;
  }
  return count;
}

std::size_t BlockPlaces::bytes() const {
  return base::Budget::bytesOf(m_runs);
}

std::string_view refusalName(RefusalCode code) {
  return textOf(code).name;
}

std::string describe(const Refusal& refusal) {
  return nc::filled(textOf(refusal.code).sentence, refusal.argument);
}

std::size_t Plan::stretchCount() const {
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](const Part& part) {
    const auto* const stretch = std::get_if<Stretch>(&part);
    return stretch != nullptr && stretch->number > 0;
  }));
}

std::size_t Plan::nativeCount() const {
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](const Part& part) {
    return std::holds_alternative<NativeBlock>(part);
  }));
}

std::size_t Plan::actionCount() const {
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](const Part& part) {
    const auto* const native = std::get_if<NativeBlock>(&part);
    return native != nullptr && native->reason != NativeReason::End;
  }));
}

}  // namespace rivulet::job
