// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/job_trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rivulet::streaming {

using trace::ControlEvent;
using trace::ControlTrace;
using trace::ExecutedBlock;
using trace::Pause;

namespace {

/// The loop has moved, and not the main program.
bool isStreamed(const ExecutedBlock& block, const templates::JobLoop& loop) {
  return std::binary_search(loop.motionLines.begin(), loop.motionLines.end(), block.line.value);
}

/// The control is busy with its own blocks, or waits for the client between two stretches.
bool isBetween(const ControlEvent& event, const templates::JobLoop& loop) {
  return event.kind != ControlEvent::Kind::Dwell || event.line.value == loop.handoverLine;
}

base::Instant endOf(const Pause& pause) {
  return pause.start + pause.duration;
}

}  // namespace

/// A pause lies between the last move that ended before its end and the first that ends after it.
void StretchPauses::add(const ControlTrace& piece, const std::vector<Pause>& pauses) {
  for (const ExecutedBlock& block : piece.blocks) {
    if (block.moves()) {
      m_moves.push_back({block.to, isStreamed(block, m_loop)});
    }
  }
  m_latest = piece.samples.empty() ? m_latest : piece.samples.back().at;
  std::copy_if(piece.events.begin(), piece.events.end(), std::back_inserter(m_between),
               [this](const ControlEvent& event) { return isBetween(event, m_loop); });
  for (; m_settled < pauses.size(); ++m_settled) {
    const base::Instant end = endOf(pauses[m_settled]);
    dropMovesBefore(end);
    if (m_moves.empty() || m_moves.back().to <= end) {
      return;  // the next move is not known yet
    }
    if (m_moves.front().to <= end && m_moves[0].isStreamed && m_moves[1].isStreamed) {
      m_within.push_back(pauses[m_settled]);
    }
  }
  dropMovesBefore(m_latest);  // a pause that is found later ends later
}

void StretchPauses::dropMovesBefore(base::Instant at) {
  while (m_moves.size() > 1 && m_moves[1].to <= at) {
    m_moves.pop_front();
  }
}

std::vector<Pause> StretchPauses::finish() {
  std::erase_if(m_within, [this](const Pause& pause) {
    return std::any_of(m_between.begin(), m_between.end(), [&pause](const ControlEvent& event) {
      return event.from <= endOf(pause) && event.to >= pause.start;
    });
  });
  return std::move(m_within);
}

JobTrace::JobTrace(const std::vector<gcode::StreamPoint>& points, const templates::JobLoop& loop,
                   trace::RecordingWriter* writer)
    : m_run(points, loop.cells.rotaryAxes, trace::PointsOfRun::Growing, writer,
            [&loop](const ExecutedBlock& block) { return isStreamed(block, loop); }),
      m_pauses(loop) {
}

void JobTrace::take(const trace::TracePiece& piece) {
  m_run.take(piece);
  m_pauses.add(piece.records, m_run.pauses());
  m_tools.add(piece.records);
}

TraceFindings JobTrace::finish() {
  TraceFindings found = m_run.finish();
  found.pauses = m_pauses.finish();
  return found;
}

}  // namespace rivulet::streaming
