// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/event_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <optional>
#include <system_error>

#include "pipeline/error.h"
#include "pipeline/ring.h"

namespace rivulet::cnc {

namespace {

using pipeline::Event;
using pipeline::kBufferCount;
using pipeline::kTaskCount;

constexpr std::string_view kHead = "rivulet-cnc events 1";
constexpr std::array<std::string_view, 4> kKinds{"start", "select", "preempt", "complete"};
/// Columns of an event: kind, ns, task, other task, items taken and made, levels.
constexpr std::size_t kColumns = 6 + kBufferCount;

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) {
      words.push_back(line.substr(0, end));
    }
    line.remove_prefix(std::min(line.size(), end + 1));
  }
  return words;
}

/// A whole number within bounds.
std::optional<std::int64_t> numberOf(std::string_view word, std::int64_t low, std::int64_t high) {
  std::int64_t value = 0;  // times do not fit an int
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool isWhole = status == std::errc{} && end == word.data() + word.size();
  return isWhole && value >= low && value <= high ? std::optional(value) : std::nullopt;
}

constexpr std::int64_t kTimeMax = std::int64_t{1} << 62U;

std::optional<EventRecording> settingsOf(std::string_view line) {
  const std::vector<std::string_view> words = wordsOf(line);
  if (words.size() != 5) {
    return std::nullopt;
  }
  EventRecording recording;
  const auto facts =
      std::find_if(pipeline::policies().begin(), pipeline::policies().end(),
                   [&](const pipeline::PolicyFacts& one) { return one.name == words[0]; });
  const auto processors = numberOf(words[1], 1, static_cast<std::int64_t>(kTaskCount));
  const auto capacity = numberOf(words[2], 1, static_cast<std::int64_t>(pipeline::kRingCapacity));
  const auto cycle = numberOf(words[3], 1, kTimeMax);
  const auto taskCycle = numberOf(words[4], 0, kTimeMax);
  if (facts == pipeline::policies().end() || !processors || !capacity || !cycle || !taskCycle) {
    return std::nullopt;
  }
  recording.policy = facts->kind;
  recording.dispatch = {static_cast<int>(*processors), static_cast<int>(*capacity),
                        base::Duration{*cycle}, base::Duration{*taskCycle}};
  return recording;
}

std::optional<Event> eventOf(std::string_view line) {
  const std::vector<std::string_view> words = wordsOf(line);
  if (words.size() != kColumns) {
    return std::nullopt;
  }
  Event event;
  const auto* const kind = std::find(kKinds.begin(), kKinds.end(), words[0]);
  const auto at = numberOf(words[1], 0, kTimeMax);
  const auto task = numberOf(words[2], 1, static_cast<std::int64_t>(kTaskCount));
  const auto other = numberOf(words[3], 0, static_cast<std::int64_t>(kTaskCount));
  const auto took = numberOf(words[4], 0, 1);
  const auto made = numberOf(words[5], 0, 1);
  if (kind == kKinds.end() || !at || !task || !other || !took || !made) {
    return std::nullopt;
  }
  event.kind = static_cast<Event::Kind>(kind - kKinds.begin());
  event.at = base::Instant{base::Duration{*at}};
  event.task = static_cast<pipeline::Task>(*task - 1);
  if (*other > 0) {
    event.other = static_cast<pipeline::Task>(*other - 1);
  }
  event.took = *took == 1;
  event.made = *made == 1;
  for (std::size_t i = 0; i < kBufferCount; ++i) {
    const auto level =
        numberOf(words[6 + i], 0, static_cast<std::int64_t>(pipeline::kRingCapacity));
    if (!level) {
      return std::nullopt;
    }
    event.levels[i] = static_cast<int>(*level);
  }
  return event;
}

}  // namespace

std::string printEventHead(pipeline::PolicyKind policy, const pipeline::DispatchOptions& dispatch) {
  return fmt::format("{}\n{} {} {} {} {}\n", kHead, pipeline::factsOf(policy).name,
                     dispatch.processors, dispatch.capacity, dispatch.positionCycle.count(),
                     dispatch.taskCycle.count());
}

std::string printEventLines(std::span<const Event> events) {
  std::string text;
  for (const Event& event : events) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {}\n",
                   kKinds[static_cast<std::size_t>(event.kind)],
                   event.at.time_since_epoch().count(), indexOf(event.task) + 1,
                   event.other ? indexOf(*event.other) + 1 : 0, event.took ? 1 : 0,
                   event.made ? 1 : 0, fmt::join(event.levels, " "));
  }
  return text;
}

std::string printEvents(const EventRecording& recording) {
  return printEventHead(recording.policy, recording.dispatch) + printEventLines(recording.events);
}

base::Result<void> EventReader::addLine(std::string_view line) {
  ++m_lines;
  const auto refuse = [this](const char* what) {
    return base::fail(pipeline::PipelineError::TaskBroken,
                      fmt::format("Line {} is no {} of rivulet-cnc. Record the run again with "
                                  "--events.",
                                  m_lines, what));
  };
  if (m_lines == 1) {
    if (line != kHead) {
      return refuse("head of the events");
    }
  } else if (m_lines == 2) {
    m_recording = settingsOf(line);
    if (!m_recording) {
      return refuse("line of settings");
    }
  } else if (const auto event = m_recording ? eventOf(line) : std::nullopt) {
    m_recording->events.push_back(*event);
  } else {
    return refuse("event");
  }
  return {};
}

base::Result<EventRecording> parseEvents(std::string_view text) {
  EventReader reader;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const auto added = reader.addLine(text.substr(0, end)); !added) {
      return base::fail(added.error());
    }
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  if (!reader.recording()) {
    return base::fail(pipeline::PipelineError::TaskBroken,
                      "Line 1 is no head of the events of rivulet-cnc. Record the run again with "
                      "--events.");
  }
  return std::move(*reader.recording());
}

}  // namespace rivulet::cnc
