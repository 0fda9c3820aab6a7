// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/recording_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "trace/lines.h"

namespace rivulet::trace {

namespace {

using lines::Fields;

constexpr std::string_view kIndexName = "rivulet-index";
constexpr int kIndexVersion = 1;

/// Position and feed of a live observation; angles between them are passed over.
void addLive(IndexGroup& group, Fields fields) {
  std::vector<std::string_view> words;
  while (fields.ok() && !fields.atEnd()) {
    words.push_back(fields.word());
  }
  const auto add = [](ValueRange& range, std::string_view word) {
    Fields one(word);
    const double value = one.number();
    if (one.ok()) {
      range.add(value);
    }
  };
  for (std::size_t axis = 0; words.size() > base::kAxisCount && axis < base::kAxisCount; ++axis) {
    add(group.positionMm[axis], words[axis]);
  }
  if (!words.empty()) {
    add(group.feedMmPerS, words.back());
  }
}

/// @return whether it was one
bool keepSpecialLine(RecordingIndex& index, std::string_view keyword, std::string_view line) {
  if (keyword == "rivulet-recording" || keyword == "run") {
    (index.head += line) += '\n';
  } else if (keyword == "trace") {
    (index.traceHeader = line) += '\n';
  } else if (keyword == "end") {
    (index.end = line) += '\n';
  } else {
    return false;
  }
  return true;
}

void addLine(RecordingIndex& index, IndexGroup& group, std::string_view line) {
  Fields fields(line);
  const std::string_view keyword = fields.word();
  if (keepSpecialLine(index, keyword, line) || keyword.size() != 1 ||
      std::string_view("lanzsbe").find(keyword) == std::string_view::npos) {
    return;
  }
  const base::Instant at = fields.instant();
  if (!fields.ok()) {
    return;
  }
  group.first = std::min(group.first, at);
  group.last = std::max(group.last, at);
  switch (keyword.front()) {
    case 'l':
      ++group.samples;
      addLive(group, fields);
      break;
    case 'a':
      ++group.accesses;
      group.accessMs.add(base::toMilliseconds(fields.duration()));
      break;
    case 'n':
      ++group.notes;
      break;
    case 's':
      ++group.controlSamples;
      break;
    default:
      break;
  }
}

std::int64_t nanosecondsOf(base::Instant at) {
  return at.time_since_epoch().count();
}

void appendRange(std::string& out, const ValueRange& range) {
  if (range.isEmpty()) {
    out += " - -";
  } else {
    fmt::format_to(std::back_inserter(out), " {} {}", range.min, range.max);
  }
}

ValueRange readRange(Fields& fields) {
  Fields ahead = fields;
  if (ahead.word() == "-") {
    fields = ahead;
    static_cast<void>(fields.word());
    return {};
  }
  ValueRange range;
  range.min = fields.number();
  range.max = fields.number();
  return range;
}

}  // namespace

void IndexGroup::add(const IndexGroup& next) {
  bytes += next.bytes;
  frames += next.frames;
  first = std::min(first, next.first);
  last = std::max(last, next.last);
  samples += next.samples;
  accesses += next.accesses;
  notes += next.notes;
  controlSamples += next.controlSamples;
  for (std::size_t axis = 0; axis < positionMm.size(); ++axis) {
    positionMm[axis].add(next.positionMm[axis]);
  }
  feedMmPerS.add(next.feedMmPerS);
  accessMs.add(next.accessMs);
}

void RecordingIndex::addFrame(std::string_view text, std::uint64_t bytes) {
  IndexGroup group;
  group.bytes = bytes;
  group.frames = 1;
  lines::LineReader reader(text);
  while (const auto line = reader.next()) {
    if (line->whole) {
      addLine(*this, group, line->text);
    }
  }
  if (!groups.empty() && groups.back().frames < m_framesPerGroup) {
    groups.back().add(group);
    return;
  }
  if (groups.size() >= kGroupsMax) {
    for (std::size_t i = 0; i < kGroupsMax / 2; ++i) {
      IndexGroup joined = groups[2 * i];
      joined.add(groups[2 * i + 1]);
      groups[i] = joined;
    }
    groups.resize(kGroupsMax / 2);
    m_framesPerGroup *= 2;
  }
  groups.push_back(group);
}

IndexGroup RecordingIndex::total() const {
  IndexGroup all;
  for (const IndexGroup& group : groups) {
    all.add(group);
  }
  return all;
}

std::string printIndex(const RecordingIndex& index) {
  std::string out = fmt::format("{} {}\n", kIndexName, kIndexVersion);
  out += index.head + index.traceHeader + index.end;
  for (const IndexGroup& group : index.groups) {
    fmt::format_to(std::back_inserter(out), "g {} {} {} {} {} {} {} {}", group.bytes, group.frames,
                   nanosecondsOf(group.first), nanosecondsOf(group.last), group.samples,
                   group.accesses, group.notes, group.controlSamples);
    for (const ValueRange& range : group.positionMm) {
      appendRange(out, range);
    }
    appendRange(out, group.feedMmPerS);
    appendRange(out, group.accessMs);
    out += '\n';
  }
  return out;
}

std::optional<RecordingIndex> parseIndex(std::string_view text) {
  lines::LineReader reader(text);
  const auto first = reader.next();
  const lines::Header header =
      lines::readHeader(first ? first->text : std::string_view(), kIndexName);
  if (!header.known || header.version != kIndexVersion) {
    return std::nullopt;
  }
  RecordingIndex index;
  while (const auto line = reader.next()) {
    Fields fields(line->text);
    const std::string_view keyword = fields.word();
    if (keepSpecialLine(index, keyword, line->text)) {
      continue;
    }
    IndexGroup group;
    group.bytes = fields.integer<std::uint64_t>();
    group.frames = fields.integer<std::uint64_t>();
    group.first = fields.instant();
    group.last = fields.instant();
    group.samples = fields.integer<std::uint64_t>();
    group.accesses = fields.integer<std::uint64_t>();
    group.notes = fields.integer<std::uint64_t>();
    group.controlSamples = fields.integer<std::uint64_t>();
    for (ValueRange& range : group.positionMm) {
      range = readRange(fields);
    }
    group.feedMmPerS = readRange(fields);
    group.accessMs = readRange(fields);
    if (!line->whole || keyword != "g" || !fields.ok()) {
      return std::nullopt;
    }
    index.groups.push_back(group);
  }
  return index;
}

}  // namespace rivulet::trace
