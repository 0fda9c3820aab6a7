// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/job_trace.h"

#include <algorithm>

#include "trace/analysis/pauses.h"

namespace rivulet::streaming {

namespace {

using trace::ControlEvent;
using trace::ControlTrace;
using trace::ExecutedBlock;
using trace::Pause;

bool isStreamed(const ExecutedBlock& block, const templates::JobLoop& loop) {
  return std::binary_search(loop.motionLines.begin(), loop.motionLines.end(), block.line.value);
}

/// The control is busy with its own blocks, or waits for the client between two stretches.
bool isBetween(const ControlEvent& event, const templates::JobLoop& loop) {
  return event.kind != ControlEvent::Kind::Dwell || event.line.value == loop.handoverLine;
}

}  // namespace

ControlTrace streamedTrace(const ControlTrace& trace, const templates::JobLoop& loop) {
  ControlTrace streamed = trace;
  streamed.blocks.erase(
      std::remove_if(streamed.blocks.begin(), streamed.blocks.end(),
                     [&loop](const ExecutedBlock& block) { return !isStreamed(block, loop); }),
      streamed.blocks.end());
  return streamed;
}

std::vector<Pause> pausesInStretches(const ControlTrace& trace, const templates::JobLoop& loop) {
  std::vector<ExecutedBlock> moves;
  std::copy_if(trace.blocks.begin(), trace.blocks.end(), std::back_inserter(moves),
               [](const ExecutedBlock& block) { return block.moves(); });
  std::vector<Pause> pauses = trace::findPauses(trace);
  const auto isOfControl = [&](const Pause& pause) {
    const base::Instant end = pause.start + pause.duration;
    const auto after = std::upper_bound(
        moves.begin(), moves.end(), end,
        [](base::Instant at, const ExecutedBlock& block) { return at < block.to; });
    if (after == moves.begin() || after == moves.end() || !isStreamed(*after, loop) ||
        !isStreamed(*std::prev(after), loop)) {
      return true;
    }
    return std::any_of(trace.events.begin(), trace.events.end(), [&](const ControlEvent& event) {
      return isBetween(event, loop) && event.from <= end && event.to >= pause.start;
    });
  };
  pauses.erase(std::remove_if(pauses.begin(), pauses.end(), isOfControl), pauses.end());
  return pauses;
}

}  // namespace rivulet::streaming
