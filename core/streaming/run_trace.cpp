// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run_trace.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace rivulet::streaming {

namespace {

/// @return whether there was room for all of them
template <class Record>
bool keep(std::vector<Record>& kept, const std::vector<Record>& records) {
  const std::size_t count =
      std::min(records.size(), RunTrace::kKeptMax - std::min(RunTrace::kKeptMax, kept.size()));
  kept.insert(kept.end(), records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count));
  return count == records.size();
}

}  // namespace

void RunTrace::take(const trace::TracePiece& piece) {
  const trace::ControlTrace& records = piece.records;
  if (!m_isBegun) {
    m_isBegun = true;
    m_kept.cycle = records.cycle;
    m_kept.rotaryAxes = records.rotaryAxes;
    if (m_writer != nullptr) {
      trace::ControlTrace head = m_kept;
      head.truncated = records.truncated;
      m_writer->controlTraceBegin(head);
    }
  }
  m_isTruncated = m_isTruncated || records.truncated;
  m_position = piece.next;
  m_judge.add(records);
  for (const trace::ControlSample& sample : records.samples) {
    if (const std::optional<trace::Pause> pause = m_finder.add(sample)) {
      m_pauses.push_back(*pause);
    }
  }
  if (!records.samples.empty()) {
    m_first = m_first.value_or(records.samples.front().at);
    m_last = records.samples.back().at;
  }
  // Once something has been left out, nothing is kept: the beginning has no holes.
  if (!m_kept.truncated) {
    const bool hasAll = keep(m_kept.samples, records.samples);
    const bool hasBlocks = keep(m_kept.blocks, records.blocks);
    const bool hasEvents = keep(m_kept.events, records.events);
    m_kept.truncated = !hasAll || !hasBlocks || !hasEvents;
  }
  if (m_writer != nullptr) {
    m_writer->controlTracePiece(records);
  }
}

bool RunTrace::finish(RunReport& report) {
  report.integrity = m_judge.finish();
  m_kept.truncated = m_kept.truncated || m_isTruncated;
  report.controlTrace = std::make_shared<const trace::ControlTrace>(std::move(m_kept));
  if (m_isTruncated) {
    return false;
  }
  report.pauses = std::move(m_pauses);
  if (m_first) {
    report.duration = m_last - *m_first;
  }
  if (m_writer != nullptr && m_isBegun) {
    m_writer->controlTraceEnd();
  }
  return true;
}

}  // namespace rivulet::streaming
