// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/feed_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "templates/feed_cell.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using templates::FeedCell;

/// A write that was not answered is repeated after this time.
constexpr Duration kRepeat = std::chrono::milliseconds{50};
/// Between two looks at the axes, at least: two interpolation cycles of a slow control.
constexpr Duration kLookInterval = std::chrono::milliseconds{16};
/// The same while they stand, and while they do not although they should.
constexpr Duration kStandInterval = std::chrono::milliseconds{250};
/// The cell is read this often in case another client writes it.
constexpr Duration kWatchInterval = std::chrono::seconds{2};
/// … and so much later also if the stream has no time.
constexpr Duration kOverdue = std::chrono::seconds{3};
/// Axes that stand differ by less from one look to the next.
constexpr double kStandsMm = 0.001;
/// A standstill and its hold begin and end with accesses; one that began or ends at a STOPRE is
/// longer.
constexpr Duration kHoldShorter = std::chrono::milliseconds{50};
constexpr Duration kHoldLonger = std::chrono::milliseconds{300};
/// Longer than any path takes to brake.
constexpr Duration kStandDeadline = std::chrono::seconds{3};

}  // namespace

FeedControl::FeedControl(const templates::CellMap& cells)
    : m_exists(cells.hasFeedCell()),
      m_beat(cells),
      m_silenceLimit(
          base::fromSeconds(templates::watchesClient(cells) ? cells.silenceLimitS : 0.0)),
      m_assignment{{{opcua::rParameter(std::max(0, cells.overrideWanted)), FeedCell::kProgrammed}}},
      m_cells{opcua::rParameter(std::max(0, cells.overrideWanted)),
              opcua::rParameter(std::max(0, cells.overrideActs))},
      m_all(m_cells) {
  for (int axis = 0; axis < static_cast<int>(base::kAxisCount); ++axis) {
    m_all.push_back({opcua::VariableKind::ActualPosition, axis});
  }
}

void FeedControl::watchRotary(const std::array<int, base::kRotaryAxisCount>& axisOf) {
  m_all.resize(m_cells.size() + base::kAxisCount);
  for (const int axis : axisOf) {
    if (axis >= 0) {
      m_all.push_back({opcua::VariableKind::ActualPosition, axis});
    }
  }
  m_place.clear();
}

void FeedControl::want(const FeedOrder& order, Instant now) {
  if (m_nextRead == Instant{}) {
    m_nextRead = now;
  }
  const bool isSame =
      order.holds == m_asked.holds && (order.percent == m_asked.percent ||
                                       (std::isnan(order.percent) && std::isnan(m_asked.percent)));
  if (!m_exists || isSame) {
    return;
  }
  m_asked = order;
  FeedOrder taken = order;
  if (!(order.percent >= FeedCell::kHold) || order.percent > FeedCell::kMax) {
    note(now, fmt::format("feed: an override of {} % is refused: choose {:g} to {:g} %",
                          order.percent, FeedCell::kHold, FeedCell::kMax));
    taken.percent = m_order.percent;
  }
  m_order = taken;
  const double percent = taken.holds ? FeedCell::kHold : taken.percent;
  if (percent == m_seen.wantedPercent && taken.holds == m_seen.holds && !m_seen.isForeign) {
    return;
  }
  m_orderedAt = now;
  m_mustWrite = true;
  m_nextWrite = now;
  note(now, taken.holds    ? std::string("feed: hold requested")
            : m_seen.holds ? fmt::format("feed: continue requested, override {:g} %", percent)
                           : fmt::format("feed: override {:g} % requested", percent));
}

bool FeedControl::mustWrite(Instant now) const {
  return m_exists && m_mustWrite && now >= m_nextWrite;
}

std::span<const opcua::Assignment> FeedControl::write(Instant now) {
  m_mustWrite = false;
  m_assignment[0].value = m_order.holds ? FeedCell::kHold : m_order.percent;
  m_seen.isForeign = false;
  begin(now, m_assignment[0].value, false);
  return m_assignment;
}

void FeedControl::written(Instant at) {
  m_mustConfirm = true;
  m_nextRead = at;
}

void FeedControl::begin(Instant ordered, double percent, bool isForeign) {
  account(ordered);
  m_seen.wantedPercent = percent;
  m_seen.holds = percent == FeedCell::kHold;
  m_seen.stoodAfter.reset();
  m_seen.isIgnored = false;
  m_place.clear();
  const bool isRepeated = !m_events.empty() && m_events.back().percent == percent &&
                          m_events.back().isForeign == isForeign;
  if (!isRepeated) {
    m_events.push_back({isForeign ? ordered : m_orderedAt, percent, isForeign, {}, {}});
  }
}

bool FeedControl::mustRead(Instant now) const {
  const bool isOverdue = now >= m_nextRead + kOverdue;
  return m_exists && now >= m_nextRead && (m_mustConfirm || m_seen.holds || isOverdue);
}

bool FeedControl::mayRead(Instant now) const {
  return m_exists && now >= m_nextRead;
}

std::span<const opcua::Variable> FeedControl::read(Instant now) {
  m_readsAxes = m_seen.holds;
  m_nextRead = now + kLookInterval;
  return m_readsAxes ? m_all : m_cells;
}

void FeedControl::seen(std::span<const opcua::Reading> readings, Instant at) {
  if (m_mustWrite || readings.size() < m_cells.size() || readings[0].status || readings[1].status) {
    return;  // it is about to change, or the control has not told
  }
  const double wanted = readings[0].number;
  if (wanted != m_seen.wantedPercent) {
    note(at, fmt::format("feed: another client has set the override to {:g} %: it stays until the "
                         "next order",
                         wanted));
    m_seen.isForeign = true;
    begin(at, wanted, true);
  }
  m_seen.actsPercent = readings[1].number;
  const bool obeys = *m_seen.actsPercent <= m_seen.wantedPercent;
  if (m_mustConfirm && !m_seen.holds) {
    m_mustConfirm = !obeys && at - m_events.back().at <= kStandDeadline;
    if (!obeys && !m_mustConfirm) {
      m_seen.isIgnored = true;
      note(at, fmt::format("feed: the control does not obey: its override is {:g} %",
                           *m_seen.actsPercent));
    }
  }
  if (m_readsAxes && m_seen.holds) {
    takePlace(readings.subspan(m_cells.size()), at);
  }
  m_nextRead = at + (m_mustConfirm  ? kLookInterval
                     : m_seen.holds ? kStandInterval
                                    : kWatchInterval);
}

void FeedControl::takePlace(std::span<const opcua::Reading> readings, Instant at) {
  std::vector<double> place;
  for (const opcua::Reading& reading : readings) {
    if (reading.status) {
      return;  // that is not standing
    }
    place.push_back(reading.number);
  }
  double movedMm = 0.0;
  for (std::size_t axis = 0; axis < std::min(place.size(), m_place.size()); ++axis) {
    movedMm = std::max(movedMm, std::abs(place[axis] - m_place[axis]));
  }
  const bool isKnown = m_place.size() == place.size() && at - m_placeAt >= kLookInterval;
  const bool stands = isKnown && movedMm < kStandsMm && m_seen.actsPercent == FeedCell::kHold;
  const bool wasIgnored = m_seen.isIgnored;
  if (stands && !m_seen.stoodAfter) {
    const Instant since = m_events.back().at;
    m_seen.stoodAfter = at - since;
    m_events.back().stoodAfter = m_seen.stoodAfter;
    m_mustConfirm = false;
    note(at, fmt::format("feed: the axes stand, {:.3f} s after it was requested",
                         base::toSeconds(*m_seen.stoodAfter)));
  }
  if (stands) {
    m_seen.isIgnored = false;
  } else if (isKnown && !m_events.empty() &&
             (m_seen.stoodAfter || at - m_events.back().at > kStandDeadline)) {
    m_seen.isIgnored = true;
    m_mustConfirm = false;
  }
  if (m_seen.isIgnored && !wasIgnored) {
    note(at,
         "feed: the axes move although the override is 0: what moves now does not obey it. Stop it "
         "at the control.");
  }
  if (m_place.size() != place.size() || at - m_placeAt >= kLookInterval) {
    m_place = std::move(place);
    m_placeAt = at;
  }
}

void FeedControl::beaten(Instant sent, Instant at) {
  const Duration silence = m_beatenAt ? sent - *m_beatenAt : Duration{};
  m_beatenAt = at;
  m_beat.arrived(at);
  if (m_silenceLimit == Duration{} || silence <= m_silenceLimit) {
    return;
  }
  note(at,
       fmt::format("feed: for {:.1f} s no sign of this client has reached the control: the axes "
                   "have stood meanwhile",
                   base::toSeconds(silence)));
  if (m_seen.wantedPercent > FeedCell::kHold) {
    m_lost += silence - m_silenceLimit;
  }
}

void FeedControl::lost(Instant now) {
  m_mustWrite = true;
  m_nextWrite = now + kRepeat;
}

void FeedControl::account(Instant now) {
  m_lost = lostTime(now);
  m_accountedTo = now;
}

Duration FeedControl::lostTime(Instant now) const {
  const double share = 1.0 - std::min(1.0, m_seen.wantedPercent / FeedCell::kProgrammed);
  const bool isSlow = m_exists && share > 0.0 && now > m_accountedTo;
  return m_lost +
         (isSlow ? base::fromSeconds(share * base::toSeconds(now - m_accountedTo)) : Duration{});
}

void FeedControl::note(Instant at, std::string text) {
  m_notes.push_back({at, std::move(text)});
}

std::vector<trace::Note> FeedControl::takeNotes() {
  return std::exchange(m_notes, {});
}

std::vector<FeedEvent> FeedControl::events(Instant now) const {
  std::vector<FeedEvent> events = m_events;
  for (std::size_t i = 0; i < events.size(); ++i) {
    events[i].lasted = (i + 1 < events.size() ? events[i + 1].at : now) - events[i].at;
  }
  return events;
}

std::vector<trace::Pause> takeHolds(std::vector<trace::Pause>& pauses,
                                    std::span<const FeedEvent> events) {
  std::vector<trace::Pause> holds;
  auto from = pauses.begin();
  for (const FeedEvent& event : events) {
    if (!event.isHold()) {
      continue;
    }
    const Duration shortest = event.lasted - event.stoodAfter.value_or(kStandDeadline);
    const auto found = std::find_if(from, pauses.end(), [&](const trace::Pause& pause) {
      return pause.duration + kHoldShorter >= shortest &&
             pause.duration <= event.lasted + kHoldLonger;
    });
    if (found != pauses.end()) {
      holds.push_back(*found);
      from = pauses.erase(found);
    }
  }
  return holds;
}

}  // namespace rivulet::streaming
