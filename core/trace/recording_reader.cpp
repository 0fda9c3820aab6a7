// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/recording_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.h"
#include "base/file.h"
#include "trace/frames.h"
#include "trace/import/compression.h"

namespace rivulet::trace {

namespace {

/// An index of `RecordingIndex::kGroupsMax` groups is much smaller.
constexpr std::uint64_t kIndexBytesMax = std::uint64_t{64} << 20U;

template <class Record, class Time>
void keepWithin(std::vector<Record>& records, base::Instant from, base::Instant until, Time time) {
  records.erase(std::remove_if(records.begin(), records.end(),
                               [&](const Record& record) {
                                 return time(record) < from || time(record) > until;
                               }),
                records.end());
}

}  // namespace

base::Result<RecordingReader> RecordingReader::open(std::unique_ptr<base::ByteSource> bytes) {
  RIVULET_ASSERT(bytes != nullptr);
  RecordingReader reader;
  reader.m_bytes = std::move(bytes);
  if (auto done = reader.readIndex(); !done) {
    return base::fail(done.error());
  }
  if (!reader.m_hadIndex) {
    if (auto done = reader.makeIndex(); !done) {
      return base::fail(done.error());
    }
  }
  auto ends = parseRecording(reader.m_index.head + reader.m_index.end);
  if (!ends) {
    return base::fail(ends.error());
  }
  reader.m_start = std::move(ends->start);
  reader.m_end = std::move(ends->end);
  return reader;
}

base::Result<std::string> RecordingReader::textAt(std::uint64_t at, std::uint64_t bytes) {
  auto part = m_bytes->read(at, bytes);
  if (!part) {
    return part;
  }
  return isCompressed(*part) ? readFrames(*part).text : *part;
}

base::Result<void> RecordingReader::readIndex() {
  const std::uint64_t size = m_bytes->size();
  const auto tail = m_bytes->read(size - std::min(size, kIndexTailBytes), kIndexTailBytes);
  if (!tail) {
    return base::fail(tail.error());
  }
  const std::optional<IndexPlace> place = findIndex(*tail, size);
  if (!place || place->bytes > kIndexBytesMax) {
    return {};
  }
  const auto packed = m_bytes->read(place->at, place->bytes);
  if (!packed) {
    return base::fail(packed.error());
  }
  if (auto index = unpackIndex(*packed)) {
    m_index = std::move(*index);
    m_hadIndex = true;
  }
  return {};
}

base::Result<void> RecordingReader::makeIndex() {
  if (m_bytes->size() > base::kFileBytesMax) {
    return base::fail(
        base::FileError::Unreadable,
        fmt::format("The file has no index, or a damaged one, and is larger than {} MiB: it cannot "
                    "be read as a whole.",
                    base::kFileBytesMax >> 20U));
  }
  const auto bytes = m_bytes->read(0, m_bytes->size());
  if (!bytes) {
    return base::fail(bytes.error());
  }
  forEachFrame(*bytes,
               [this](std::string_view text, std::uint64_t size) { m_index.addFrame(text, size); });
  // What has no first line is no recording: say so as everywhere.
  if (m_index.head.empty()) {
    m_index.head = bytes->substr(0, 100);
  }
  return {};
}

base::Result<Recording> RecordingReader::read(base::Instant from, base::Instant until) {
  RIVULET_ASSERT(from <= until);
  std::string text = m_index.head + m_index.traceHeader;
  std::uint64_t at = 0;
  for (const IndexGroup& group : m_index.groups) {
    if (group.first <= until && group.last >= from) {
      auto part = textAt(at, group.bytes);
      if (!part) {
        return base::fail(part.error());
      }
      text += *part;
    }
    at += group.bytes;
  }
  auto recording = parseRecording(text);
  if (!recording) {
    return recording;
  }
  recording->points = {};
  recording->pointsComplete = false;
  recording->end = m_end;
  recording->complete = m_end.has_value();
  const auto within = [&](auto& records, auto time) { keepWithin(records, from, until, time); };
  within(recording->samples, [](const LiveSample& sample) { return sample.at; });
  within(recording->accesses, [](const Access& access) { return access.sent; });
  within(recording->pauses, [](const Pause& pause) { return pause.start; });
  within(recording->notes, [](const Note& note) { return note.at; });
  if (recording->controlTrace) {
    within(recording->controlTrace->samples, [](const ControlSample& sample) { return sample.at; });
    within(recording->controlTrace->blocks, [](const ExecutedBlock& block) { return block.from; });
    within(recording->controlTrace->events, [](const ControlEvent& event) { return event.from; });
    recording->controlTrace->truncated = true;
  }
  return recording;
}

}  // namespace rivulet::trace
