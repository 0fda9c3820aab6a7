// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Recorded events of a scheduler as lines of text, docs/formats.md. @threadsafety pure.
#pragma once

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
/// @return an error that names the line
[[nodiscard]] base::Result<EventRecording> parseEvents(std::string_view text);

}  // namespace rivulet::cnc
