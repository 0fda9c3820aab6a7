// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Replays the recorded events of a scheduler against the net of [P3]: each event must be allowed
/// by the net at its time, time must not go on while the net would give a processor to a task, and
/// the buffers must hold what the net says. Covers the two policies of [P3].
/// @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/result.h"
#include "pipeline/dispatcher.h"
#include "pipeline/event.h"
#include "pipeline/policy.h"

namespace rivulet::pipeline {

struct Conformance {
  std::size_t events = 0;                      ///< that the net allows
  std::optional<std::string> violation;        ///< one sentence on the first that it does not
  std::array<TaskRecord, kTaskCount> records;  ///< as the net counts: TREC
};

/// @param options  with which the events were recorded
/// @return errors of petri::loadNet; TaskBroken if the policy is none of [P3]
[[nodiscard]] base::Result<Conformance> checkConformance(std::span<const Event> events,
                                                         PolicyKind policy,
                                                         const DispatchOptions& options);

}  // namespace rivulet::pipeline
