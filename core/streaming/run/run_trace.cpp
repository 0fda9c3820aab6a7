// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/run_trace.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace rivulet::streaming {

using base::Result;

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

std::optional<base::Duration> TraceFetch::lateness(base::Instant now) const {
  const bool isDue = m_taker != nullptr && !m_pending && now >= m_next;
  return isDue ? std::optional(now - m_next) : std::nullopt;
}

void TraceFetch::ask(opcua::Link& link, base::Duration deadline) {
  const base::RequestId id = link.readTrace(m_taker->position(), deadline);
  if (id == base::RequestId{}) {
    m_taker = nullptr;  // as a whole, after the run
  } else {
    m_pending = id;
  }
}

void TraceFetch::answered(const opcua::Event* event, base::Instant now) {
  m_pending.reset();
  m_next = now + kTraceInterval;
  if (event != nullptr && event->kind == opcua::EventKind::TraceDone) {
    m_taker->take(*event->trace);
    m_next = event->trace->isLast ? m_next : now;
  }
}

Result<void> fetchRest(opcua::Control& control, TraceTaker& taker) {
  for (bool isLast = false; !isLast;) {
    const Result<trace::TracePiece> piece = control.fetchTracePiece(taker.position());
    if (!piece) {
      return base::fail(piece.error());
    }
    taker.take(*piece);
    isLast = piece->isLast;
  }
  return {};
}

void RunTrace::take(const trace::TracePiece& piece) {
  const trace::ControlTrace& records = piece.records;
  if (!m_isBegun) {
    m_isBegun = true;
    m_kept.cycle = records.cycle;
    m_kept.rotaryAxes = records.rotaryAxes;
    if (m_writer != nullptr) {
      trace::ControlTrace head = m_kept;
      head.truncated = records.truncated;
      head.hasOwnBlocksOnly = m_isOfRun != nullptr;
      m_writer->controlTraceBegin(head);
    }
  }
  m_isTruncated = m_isTruncated || records.truncated;
  m_position = piece.next;
  if (m_isOfRun) {
    m_hasBlocks = m_hasBlocks || !records.blocks.empty();
    trace::ControlTrace ofRun = records;
    ofRun.hasOwnBlocksOnly = true;
    std::erase_if(ofRun.blocks,
                  [this](const trace::ExecutedBlock& block) { return !m_isOfRun(block); });
    judge(ofRun);
  } else {
    judge(records);
  }
  keepBeginning(records);
}

void RunTrace::judge(const trace::ControlTrace& records) {
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
  if (m_writer != nullptr) {
    m_writer->controlTracePiece(records);
  }
}

/// Once something has been left out, nothing is kept: the beginning has no holes.
void RunTrace::keepBeginning(const trace::ControlTrace& records) {
  if (m_kept.truncated) {
    return;
  }
  const bool hasAll = keep(m_kept.samples, records.samples);
  const bool hasBlocks = keep(m_kept.blocks, records.blocks);
  const bool hasEvents = keep(m_kept.events, records.events);
  m_kept.truncated = !hasAll || !hasBlocks || !hasEvents;
}

TraceFindings RunTrace::finish() {
  TraceFindings found;
  found.isWhole = !m_isTruncated;
  if (!m_isOfRun || m_hasBlocks || !m_first) {
    found.integrity = m_judge.finish();
  }  // else who has moved is not known
  found.pauses = std::move(m_pauses);
  if (m_first) {
    found.duration = m_last - *m_first;
  }
  m_kept.truncated = m_kept.truncated || m_isTruncated;
  found.kept = std::make_shared<const trace::ControlTrace>(std::move(m_kept));
  if (m_writer != nullptr && m_isBegun && found.isWhole) {
    m_writer->controlTraceEnd();
  }
  return found;
}

}  // namespace rivulet::streaming
