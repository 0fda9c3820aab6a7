// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/ledger.h"

#include <utility>

namespace rivulet::streaming {

void Ledger::update(const LiveUpdate& update) {
  if (m_writer != nullptr && update.sample) {
    m_writer->sample(*update.sample);
  }
  if (m_writer != nullptr && update.pause) {
    m_writer->pause(*update.pause);
  }
  m_next.update(update);
}

void Ledger::access(const trace::Access& access) {
  m_requests.add(access.took);
  m_nodes += static_cast<std::size_t>(access.nodes);
  if (access.nodes > 0) {  // a file has none
    m_perNode.add(access.took / access.nodes);
  }
  if (m_writer != nullptr) {
    m_writer->access(access);
  }
  m_next.access(access);
}

void Ledger::note(const trace::Note& note) {
  if (m_writer != nullptr) {
    m_writer->note(note);
  }
  m_next.note(note);
}

void Ledger::granted() {
  if (onGranted) {
    onGranted();
  }
  m_next.granted();
}

AccessStatistics Ledger::statistics() const {
  AccessStatistics statistics;
  statistics.nodes = m_nodes;
  statistics.perNode = m_perNode.statistics();
  statistics.perRequest = m_requests.statistics();
  statistics.requests = statistics.perRequest.count;
  return statistics;
}

trace::RunStart runStartOf(trace::RunStart known, const RunSettings& settings,
                           const gcode::Program& program) {
  trace::RunStart start = std::move(known);
  start.method = base::methodName(settings.parameters.method);
  start.pointsPerLoop = settings.parameters.pointsPerLoop;
  start.layout = templates::layoutName(settings.parameters.layout);
  if (const std::string axes = templates::axisLetters(settings.parameters); axes != "XYZ") {
    start.axes = axes;
  }
  start.deltaMm = settings.deltaMm;
  start.feedMmPerS = settings.feedMmPerS;
  start.feedOverride = settings.programFeeds ? settings.programFeeds->overrideFactor : 0.0;
  start.programName = program.name;
  start.programHash = program.hash;
  start.runNumber = settings.runNumber;
  start.user = settings.origin.user;
  start.computer = settings.origin.computer;
  return start;
}

}  // namespace rivulet::streaming
