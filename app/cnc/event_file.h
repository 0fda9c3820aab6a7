// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Recorded events of a scheduler as lines of text, docs/formats.md. @threadsafety pure.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/dispatcher.h"
#include "pipeline/event.h"
#include "pipeline/policy.h"

namespace rivulet::cnc {

struct EventRecording {
  pipeline::PolicyKind policy = pipeline::PolicyKind::TaskDependency;
  pipeline::DispatchOptions dispatch;
  std::vector<pipeline::Event> events;
};

[[nodiscard]] std::string printEvents(const EventRecording& recording);
/// The lines before the events, and the events: together what `printEvents` gives.
[[nodiscard]] std::string printEventHead(pipeline::PolicyKind policy,
                                         const pipeline::DispatchOptions& dispatch);
[[nodiscard]] std::string printEventLines(std::span<const pipeline::Event> events);
/// @return an error that names the line
[[nodiscard]] base::Result<EventRecording> parseEvents(std::string_view text);

/// Reads a recording line by line, while it is written.
class EventReader {
 public:
  /// @param line  without its end @return an error that names the line
  [[nodiscard]] base::Result<void> addLine(std::string_view line);
  /// What has been read; nothing before its settings have come. Events may be taken out of it.
  [[nodiscard]] std::optional<EventRecording>& recording() { return m_recording; }

 private:
  std::size_t m_lines = 0;
  std::optional<EventRecording> m_recording;
};

}  // namespace rivulet::cnc
