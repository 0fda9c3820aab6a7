// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/recording_reader.h"

#include <algorithm>

#include "base/contract.h"
#include "trace/frames.h"
#include "trace/import/compression.h"

namespace rivulet::trace {

namespace {

constexpr std::string_view kPart = "This part of the recording";

template <class Record, class Time>
void keepWithin(std::vector<Record>& records, base::Instant from, base::Instant until, Time time) {
  records.erase(std::remove_if(records.begin(), records.end(),
                               [&](const Record& record) {
                                 return time(record) < from || time(record) > until;
                               }),
                records.end());
}

}  // namespace

base::Result<RecordingReader> RecordingReader::open(std::unique_ptr<base::ByteSource> bytes,
                                                    const base::Budget& budget) {
  RIVULET_ASSERT(bytes != nullptr);
  RecordingReader reader(budget);
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

base::Result<std::string> RecordingReader::textAt(std::uint64_t at, std::uint64_t bytes,
                                                  std::uint64_t held) {
  const base::Budget budget = m_budget.without(2 * held);  // what holds the parts grows
  if (auto fits = budget.require(static_cast<double>(bytes), kPart); !fits) {
    return base::fail(fits.error());
  }
  auto part = m_bytes->read(at, bytes);
  if (!part || !isCompressed(*part)) {
    return part;
  }
  auto frames = readFrames(*part, budget.without(bytes));
  return frames ? base::Result<std::string>(std::move(frames->text)) : base::fail(frames.error());
}

base::Result<void> RecordingReader::readIndex() {
  const std::uint64_t size = m_bytes->size();
  const auto tail = m_bytes->read(size - std::min(size, kIndexTailBytes), kIndexTailBytes);
  if (!tail) {
    return base::fail(tail.error());
  }
  const std::optional<IndexPlace> place = findIndex(*tail, size);
  if (!place) {
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
  const std::uint64_t size = m_bytes->size();
  if (auto fits = m_budget.require(static_cast<double>(size), "A recording without its index");
      !fits) {
    return fits;
  }
  const auto bytes = m_bytes->read(0, size);
  if (!bytes) {
    return base::fail(bytes.error());
  }
  const auto done = forEachFrame(
      *bytes, m_budget.without(size),
      [this](std::string_view text, std::uint64_t packed) { m_index.addFrame(text, packed); });
  if (!done) {
    return done;
  }
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
      auto part = textAt(at, group.bytes, text.size());
      if (!part) {
        return base::fail(part.error());
      }
      text += *part;
    }
    at += group.bytes;
  }
  auto recording = parseRecording(text, m_budget.without(text.capacity()));
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
