// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/point_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.h"
#include "gcode/packed_points.h"
#include "gcode/thinning.h"
#include "live/error.h"

namespace rivulet::live {

namespace {

using base::Duration;
using base::Instant;

/// Few lines: what is read does not wait in the source.
constexpr std::size_t kReadBytes = 256;
/// Of a source that cannot wait, this much is read in a turn.
constexpr int kReadsMax = 1024;
/// Points that such a source may be ahead of the machine.
constexpr std::size_t kAheadMax = 100'000;
/// Windows of points that wait here.
constexpr std::size_t kWindowsQueued = 2;
/// A source that has said nothing for so long is shown as silent.
constexpr Duration kSilenceShown = std::chrono::seconds{1};
/// The source is told how far the run is this often at most.
constexpr Duration kReportInterval = std::chrono::milliseconds{10};

base::AxisPosition placeOf(const gcode::StreamPoint& point) {
  return {point.positionMm, point.rotaryDeg};
}

/// Without acceleration, s.
double moveS(const base::AxisPosition& from, const gcode::StreamPoint& to) {
  return base::wayAlongFeed(base::distance(from.mm, to.positionMm),
                            base::turnDeg(from.deg, to.rotaryDeg)) /
         to.feedMmPerS;
}

base::Error tooLong() {
  return base::makeError(LiveError::TooLong,
                         fmt::format("The line has more than {} characters.", kLineBytesMax));
}

}  // namespace

PointStream::PointStream(Source& source, const Agreement& agreement, const Limits& limits)
    : m_source(source), m_agreement(agreement), m_limits(limits) {
  m_summary.source = source.name();
}

void PointStream::begin(const SupplyStart& start, Instant now) {
  RIVULET_ASSERT(!m_gate && start.plan.pointsMax >= 1);
  m_gate.emplace(m_agreement, start.tool, std::min(start.feedMmPerMin, m_agreement.feedMmPerMinMax),
                 start.axes, start.rotaryAxes, start.plan.packedAxes > 0);
  m_tool = start.tool;
  m_plan = start.plan;
  m_limits.queuedMax = m_limits.queuedMax == 0 ? kWindowsQueued * m_plan.pointsMax
                                               : std::max(m_limits.queuedMax, m_plan.pointsMax);
  m_heardAt = m_now = now;
}

bool PointStream::hasRoom() const {
  return m_queue.size() < (m_source.canWait() ? m_limits.queuedMax : kAheadMax);
}

void PointStream::turn(Instant now) {
  if (!m_gate) {
    return;
  }
  m_now = now;
  for (int reads = 0; !m_summary.hasEnded;) {
    if (!hasRoom() && m_source.canWait()) {
      m_heardAt = now;  // it was not asked
      break;
    }
    if (const auto line = m_reader.next()) {
      takeLine(*line);
      continue;
    }
    if (m_reader.isTooLong()) {
      refuse(tooLong(), m_summary.lines + 1);
      break;
    }
    if (++reads > kReadsMax || !readBytes(now)) {
      break;
    }
  }
  checkSilence(now);
  m_acceptedRate.add(now, m_summary.accepted);
  m_executedRate.add(now, executedOfSource());
  report(now);
}

bool PointStream::readBytes(Instant now) {
  std::array<char, kReadBytes> bytes;
  const std::size_t count = m_source.read(bytes);
  if (count > 0) {
    m_reader.add({bytes.data(), count});
    m_readAt = m_heardAt = now;
  } else if (m_source.isClosed()) {
    closed();
  }
  return count > 0;
}

void PointStream::closed() {
  if (!m_reader.rest().empty()) {
    refuse(base::makeError(LiveError::Incomplete,
                           "The source was closed in the middle of the line, so it is not used."),
           m_summary.lines + 1);
  } else if (!m_source.endsByClosing()) {
    refuse(base::makeError(LiveError::SourceClosed, "The source was closed without `end`."),
           m_summary.lines);
  } else {
    m_summary.hasEnded = true;
  }
}

void PointStream::checkSilence(Instant now) {
  if (!m_summary.hasEnded && now - m_heardAt >= m_limits.endAfter) {
    refuse(base::makeError(LiveError::SourceSilent,
                           fmt::format("Nothing has come from the source for {:.0f} s.",
                                       base::toSeconds(m_limits.endAfter))),
           m_summary.lines);
  }
}

void PointStream::refuse(const base::Error& error, std::size_t line) {
  m_summary.hasEnded = true;
  m_summary.refusal = error;
  m_summary.refusal.context = fmt::format("{}, line {}", m_summary.source, line);
  m_summary.refusal.message += " Nothing after that is executed.";
}

void PointStream::takeLine(std::string_view text) {
  const base::Result<Line> line =
      text.size() > kLineBytesMax ? base::fail(tooLong()) : parseLine(text);
  if (!line) {
    refuse(line.error(), m_summary.lines + 1);
    return;
  }
  ++m_summary.lines;
  switch (line->kind) {
    case Line::Kind::Nothing:
      break;
    case Line::Kind::Hold:
      m_holdAsked = true;
      break;
    case Line::Kind::End:
      m_summary.hasEnded = true;
      break;
    case Line::Kind::Point:
      takePoint(*line);
      break;
    case Line::Kind::Feed:
      refuse(base::makeError(LiveError::FactorAmongPoints,
                             "A factor of the feed would wait here behind points that are not read "
                             "yet. Send factors over a source of their own."),
             m_summary.lines);
      break;
  }
}

base::Result<void> PointStream::requireNumber(const Line& line) {
  if (!line.number && !m_source.canWait()) {
    return base::fail(LiveError::NumberMissing,
                      "This source can lose points, so each needs a number: N1 X0.5, then N2.");
  }
  if (line.number && m_number && *line.number != *m_number + 1.0) {
    return base::fail(LiveError::NumberWrong,
                      fmt::format("N{} was expected after N{}, but N{} came: a point is missing, "
                                  "or came twice.",
                                  *m_number + 1.0, *m_number, *line.number));
  }
  m_number = line.number ? line.number : m_number;
  return {};
}

void PointStream::takePoint(const Line& line) {
  if (const base::Result<void> numbered = requireNumber(line); !numbered) {
    refuse(numbered.error(), m_summary.lines);
    return;
  }
  if (!hasRoom()) {
    refuse(base::makeError(LiveError::Overrun,
                           "The source is faster than the machine and cannot wait. Send fewer "
                           "points, or use a pipe, unix: or tcp:."),
           m_summary.lines);
    return;
  }
  const auto point =
      m_gate->take(line, base::LineNumber{static_cast<std::uint32_t>(m_summary.lines)});
  if (!point) {
    refuse(point.error(), m_summary.lines);
    return;
  }
  if (!*point) {
    ++m_summary.merged;
    m_summary.firstMerged = m_summary.firstMerged == 0 ? m_summary.lines : m_summary.firstMerged;
    return;
  }
  ++m_summary.accepted;
  const double seconds = moveS(m_queue.empty() ? front() : placeOf(m_queue.back().point), **point);
  const auto parts = m_plan.secondsMax > 0.0
                         ? static_cast<std::size_t>(gcode::partsOf(seconds, m_plan.secondsMax))
                         : std::size_t{1};
  m_parts += parts;
  m_queue.push_back({**point, parts, m_readAt, std::exchange(m_holdAsked, false)});
}

base::AxisPosition PointStream::front() const {
  return m_ends.empty() ? m_tool : placeOf(m_points[m_ends.back() - 1]);
}

bool PointStream::isBeforeHold() const {
  return !m_queue.empty() && m_queue.front().isAfterHold && m_given == 0 &&
         m_executed < m_points.size();
}

bool PointStream::beginsWindow(const Queued& queued) const {
  return queued.isAfterHold ||
         (!m_plan.feedPerPoint && queued.point.feedMmPerS != m_queue.front().point.feedMmPerS);
}

std::size_t PointStream::windowSize() const {
  std::size_t count = 0;
  double seconds = 0.0;
  base::AxisPosition from = front();
  std::size_t given = m_given;
  const gcode::StreamPoint first = partOf(from, m_queue.front(), given + 1);
  const auto isFar = [&](const Queued& queued) {
    return m_plan.packedAxes > 0 && !gcode::sharesCell(base::Packing(m_plan.packedAxes), first,
                                                       partOf(from, queued, given + 1));
  };
  for (const Queued& queued : m_queue) {
    if (count > 0 && given == 0 && beginsWindow(queued)) {
      break;
    }
    const double partS = moveS(from, queued.point) / static_cast<double>(queued.parts);
    for (; given < queued.parts; ++given) {
      seconds += partS;
      const bool isTooLong = m_plan.secondsMax > 0.0 && seconds > m_plan.secondsMax;
      if (count == m_plan.pointsMax || (count > 0 && (isTooLong || isFar(queued)))) {
        return count;
      }
      ++count;
    }
    from = placeOf(queued.point);
    given = 0;
  }
  return count;
}

gcode::StreamPoint PointStream::partOf(const base::AxisPosition& from, const Queued& queued,
                                       std::size_t number) const {
  gcode::StreamPoint point = queued.point;
  if (number < queued.parts) {
    const auto place = gcode::onMove(
        from, placeOf(point), static_cast<double>(number) / static_cast<double>(queued.parts));
    point.positionMm = place.mm;
    point.rotaryDeg = place.deg;
    if (m_plan.packedAxes > 0) {
      gcode::roundToSteps(point, from);
    }
  }
  return point;
}

void PointStream::givePart() {
  const Queued& queued = m_queue.front();
  if (m_given == 0) {
    m_arrivals.push_back({m_points.size(), queued.arrived});
  }
  m_points.push_back(partOf(front(), queued, ++m_given));
  if (m_given < queued.parts) {
    return;
  }
  m_ends.push_back(m_points.size());
  m_queue.pop_front();
  m_given = 0;
}

std::optional<std::size_t> PointStream::takeWindow(Instant now) {
  if (m_queue.empty() || isBeforeHold()) {
    return std::nullopt;
  }
  const std::size_t count = windowSize();
  const bool isWhole = count == m_plan.pointsMax || m_points.size() + count < m_parts ||
                       m_summary.hasEnded || m_holdAsked;
  if (!isWhole && now - m_queue.front().arrived < m_limits.fullWithin) {
    return std::nullopt;
  }
  m_summary.shortWindows += isWhole ? 0 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    givePart();
  }
  ++m_summary.windows;
  m_begins.push_back(m_points.size());
  return count;
}

bool PointStream::wantsHold(Instant now) const {
  const bool isIdle = m_queue.empty() && !m_summary.hasEnded && m_executed == m_points.size();
  return isIdle && m_gate && (m_holdAsked || now - m_heardAt >= m_limits.holdAfter);
}

void PointStream::windowMoves(Instant now) {
  RIVULET_ASSERT(m_begun + 1 < m_begins.size());
  const std::size_t end = m_begins[m_begun + 1];
  Instant begins = now;
  for (std::size_t i = m_begins[m_begun]; i < end; ++i) {
    if (!m_arrivals.empty() && m_arrivals.front().part == i) {
      m_delays.add(begins - m_arrivals.front().at);
      m_recentDelays.add(begins - m_arrivals.front().at);
      m_arrivals.pop_front();
    }
    begins += base::fromSeconds(moveS(i == 0 ? m_tool : placeOf(m_points[i - 1]), m_points[i]));
  }
  ++m_begun;
  m_firstBegun = m_firstBegun.value_or(now);
  m_lastBegun = now;
}

void PointStream::executed(std::size_t points) {
  m_executed = std::min(points, m_points.size());
}

std::size_t PointStream::executedOfSource() const {
  return static_cast<std::size_t>(std::upper_bound(m_ends.begin(), m_ends.end(), m_executed) -
                                  m_ends.begin());
}

const gcode::StreamPoint* PointStream::lastOfSource() const {
  const std::size_t executed = executedOfSource();
  return executed == 0 ? nullptr : &m_points[m_ends[executed - 1] - 1];
}

void PointStream::report(Instant now) {
  const Reported reported{now, m_summary.accepted, executedOfSource()};
  const bool isNew = !m_reported || reported.accepted != m_reported->accepted ||
                     reported.executed != m_reported->executed;
  if (!m_source.takesReplies() || !isNew ||
      (m_reported && now - m_reported->at < kReportInterval)) {
    return;
  }
  m_reported = reported;
  m_source.tell(progress());
}

Progress PointStream::progress() const {
  const gcode::StreamPoint* const last = lastOfSource();
  return {m_summary.accepted, executedOfSource(), last == nullptr ? 0 : last->line.value,
          m_summary.merged, last == nullptr ? m_tool.mm : last->positionMm};
}

void PointStream::finish(std::string_view outcome, const std::string& error) {
  if (!m_source.takesReplies()) {
    return;
  }
  Progress last = progress();
  last.end = Progress::End{std::string(outcome), error};
  m_source.tell(last);
}

Summary PointStream::summary() const {
  Summary summary = m_summary;
  summary.executed = executedOfSource();
  summary.lastLine = progress().line;
  summary.delay = m_delays.statistics();
  addTheory(summary.windowTime, summary.leastDelay, summary.mostDelay);
  return summary;
}

void PointStream::addTheory(Duration& windowTime, Duration& least, Duration& most) const {
  if (m_begun <= 1) {
    return;
  }
  windowTime = (m_lastBegun - *m_firstBegun) / static_cast<Duration::rep>(m_begun - 1);
  const std::size_t queued = m_limits.queuedMax / m_plan.pointsMax;
  least = std::min(windowTime, m_limits.fullWithin);
  most = windowTime * static_cast<Duration::rep>(1 + m_plan.windowsMax + queued);
}

SourceState PointStream::state() const {
  if (m_summary.hasEnded) {
    return m_summary.refusal.code ? SourceState::Refused : SourceState::Ended;
  }
  if (m_summary.lines == 0) {
    return SourceState::Waiting;
  }
  return m_now - m_heardAt >= kSilenceShown ? SourceState::Silent : SourceState::Receiving;
}

Level PointStream::level() const {
  Level level;
  level.state = state();
  level.silence = m_now - m_heardAt;
  level.lines = m_summary.lines;
  level.accepted = m_summary.accepted;
  level.merged = m_summary.merged;
  level.executed = executedOfSource();
  level.waiting = m_summary.accepted - level.executed;
  level.capacity = m_limits.queuedMax + m_plan.windowsMax * m_plan.pointsMax;
  level.acceptedPerS = m_acceptedRate.perS();
  level.executedPerS = m_executedRate.perS();
  level.delays = std::min(m_delays.count(), kRecentDelays);
  if (level.delays > 0) {
    level.delayMedian = m_recentDelays.quantile(500);
    level.delayP99 = m_recentDelays.quantile(990);
  }
  Duration windowTime{};
  addTheory(windowTime, level.leastDelay, level.mostDelay);
  level.refusal = m_summary.refusal;
  return level;
}

}  // namespace rivulet::live
