// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/export.h"

#include <algorithm>

#include "base/text.h"

namespace rivulet::trace {

namespace {

bool isSameTime(const Envelope& a, const Envelope& b, std::size_t begin, std::size_t end) {
  if (&a == &b) {
    return true;
  }
  if (b.size() < end) {
    return false;
  }
  for (std::size_t i = begin; i < end; ++i) {
    if (a.timeAt(i) != b.timeAt(i)) {
      return false;
    }
  }
  return true;
}

std::string heading(std::string_view name, std::string_view unit) {
  std::string text(name);
  if (!unit.empty()) {
    text.append(" [").append(unit).append("]");
  }
  if (text.find_first_of(";\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  }
  return quoted + "\"";
}

}  // namespace

std::vector<SharedTimes> sharedTimesOf(const std::vector<ExportedSignal>& exported,
                                       base::Instant from, base::Instant to) {
  std::vector<SharedTimes> groups;
  for (const ExportedSignal& one : exported) {
    const std::size_t begin = one.samples->firstAt(from);
    const std::size_t end = std::max(begin, one.samples->firstAt(to + base::Duration{1}));
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const SharedTimes& group) {
      return group.begin == begin && group.end == end &&
             isSameTime(*group.members.front()->samples, *one.samples, begin, end);
    });
    if (same != groups.end()) {
      same->members.push_back(&one);
    } else {
      groups.push_back({begin, end, {&one}});
    }
  }
  // The last column is filled to the end: readers tell by it how wide the table is.
  std::stable_sort(groups.begin(), groups.end(), [](const SharedTimes& a, const SharedTimes& b) {
    return a.end - a.begin < b.end - b.begin;
  });
  return groups;
}

std::string printSignals(const std::vector<ExportedSignal>& exported, base::Instant from,
                         base::Instant to, std::string_view timeName, std::string_view timeUnit) {
  const std::vector<SharedTimes> groups = sharedTimesOf(exported, from, to);
  std::string text;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    // The name of a column is unique, and readers see that it is a time.
    const std::string number = i == 0 ? std::string() : " " + std::to_string(i + 1);
    text += (i == 0 ? "" : ";") + heading(std::string(timeName) + number, timeUnit);
    for (const ExportedSignal* member : groups[i].members) {
      text += ";" + heading(member->name, member->unit);
    }
    rows = std::max(rows, groups[i].end - groups[i].begin);
  }
  text += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const SharedTimes& group = groups[i];
      const std::size_t sample = group.begin + row;
      const bool isThere = sample < group.end;
      text += i == 0 ? "" : ";";
      if (isThere) {
        const base::Instant at = group.members.front()->samples->timeAt(sample);
        text += base::formatNumber(base::toSeconds(at.time_since_epoch()));
      }
      for (const ExportedSignal* member : group.members) {
        text += ';';
        text += isThere ? base::formatNumber(member->samples->valueAt(sample)) : std::string();
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace rivulet::trace
