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
/// Factors go out this often at most, and leave the link to the stream for so many times as long as
/// they took.
constexpr Duration kFactorInterval = std::chrono::milliseconds{20};
constexpr int kFactorShare = 2;
/// The recording has no more of them.
constexpr Duration kFactorNoteInterval = std::chrono::milliseconds{100};
/// Of the products of two machines.
constexpr double kSamePercent = 1e-6;
/// Longer than any path takes to brake.
constexpr Duration kStandDeadline = std::chrono::seconds{3};

}  // namespace

FeedControl::FeedControl(const templates::CellMap& cells)
    : m_exists(cells.hasFeedCell()),
      m_beat(cells),
      m_silenceLimit(
          base::fromSeconds(templates::watchesClient(cells) ? cells.silenceLimitS : 0.0)),
      m_map(cells),
      m_cells{opcua::rParameter(std::max(0, cells.overrideWanted)),
              opcua::rParameter(std::max(0, cells.overrideActs))},
      m_all(m_cells) {
  if (cells.hasFactor()) {
    m_cells.push_back(opcua::rParameter(cells.factor));
    m_all = m_cells;
  }
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
  wantFactor(order, now);
  const bool isSame =
      order.holds == m_asked.holds && (order.percent == m_asked.percent ||
                                       (std::isnan(order.percent) && std::isnan(m_asked.percent)));
  if (!m_exists || isSame) {
    return;
  }
  m_asked = order;
  FeedOrder taken = order;
  taken.source.reset();
  if (!(order.percent >= FeedCell::kHold) || order.percent > FeedCell::kMax) {
    note(now, fmt::format("feed: an override of {} % is refused: choose {:g} to {:g} %",
                          order.percent, FeedCell::kHold, FeedCell::kMax));
    taken.percent = m_order.percent;
  }
  m_order = taken;
  const double percent = taken.holds ? FeedCell::kHold : taken.percent;
  if (percent == m_seen.wantedPercent && !m_seen.isForeign) {
    return;
  }
  const bool didHold = m_seen.wantedPercent == FeedCell::kHold;
  m_orderedAt = now;
  m_mustWrite = true;
  m_nextWrite = now;
  note(now, taken.holds ? std::string("feed: hold requested")
            : didHold   ? fmt::format("feed: continue requested, override {:g} %", percent)
                        : fmt::format("feed: override {:g} % requested", percent));
}

void FeedControl::wantFactor(const FeedOrder& order, Instant now) {
  if (!m_map.hasFactor() || !order.source) {
    return;
  }
  const live::FactorSeen& source = *order.source;
  if ((!m_factor.told || !source.isSaidLike(*m_factor.told)) && now >= m_factor.tellNext) {
    m_factor.told = source;
    m_factor.tellNext = now + kFactorNoteInterval;
    note(now, "feed source: " + (source.why.empty() ? std::string("it is followed") : source.why));
  }
  m_seen.source = source;
  // Whoever lets axes go that the operator holds does not know the source.
  const double wanted = order.holds ? 1.0 : source.factor;
  if (wanted == m_factor.wanted) {
    return;
  }
  m_factor.wanted = wanted;
  m_factor.readAt = source.since;
  m_factor.mustWrite = true;
  if (wanted == 0.0) {
    m_factor.next = now;
  }
}

bool FeedControl::mustWrite(Instant now) const {
  return m_exists && ((m_mustWrite && now >= m_nextWrite) ||
                      (m_factor.mustWrite && now >= m_factor.next && now >= m_nextWrite));
}

std::span<const opcua::Assignment> FeedControl::write(Instant now) {
  m_assignments.clear();
  const bool isHold = m_mustWrite && m_order.holds;
  const auto addFactor = [&] {
    if (std::exchange(m_factor.mustWrite, false)) {
      m_assignments.push_back({opcua::rParameter(m_map.factor), m_factor.wanted});
      beginFactor(now);
    }
  };
  // Axes that are let go find the factor there; those that are to be held do not wait for it.
  if (!isHold) {
    addFactor();
  }
  if (std::exchange(m_mustWrite, false)) {
    const double percent = m_order.holds ? FeedCell::kHold : m_order.percent;
    m_assignments.push_back({opcua::rParameter(std::max(0, m_map.overrideWanted)), percent});
    m_isSent = true;
    m_seen.isForeign = false;
    m_mustConfirm = true;
    begin(now, percent, false);
  }
  if (isHold) {
    addFactor();
  }
  return m_assignments;
}

void FeedControl::written(Instant at) {
  if (std::exchange(m_factor.isSent, false)) {
    ++m_factor.report.written;
    m_factor.next = at + std::max(kFactorInterval, kFactorShare * (at - m_factor.sentAt));
    if (m_factor.timedFrom) {
      m_factor.delays.add(at - *m_factor.timedFrom);
    }
  }
  m_isSent = false;
  m_nextRead = m_mustConfirm ? at : std::min(m_nextRead, at + kStandInterval);
}

double FeedControl::product() const {
  return templates::overrideOf(m_map, m_seen.wantedPercent, m_seen.factor);
}

void FeedControl::forgetPlace() {
  m_seen.stoodAfter.reset();
  m_seen.isIgnored = false;
  m_seen.liftedMm.reset();
  m_place.clear();
}

void FeedControl::beginFactor(Instant now) {
  account(now);
  const bool didHold = m_seen.holds;
  m_seen.factor = m_factor.wanted;
  m_seen.holds = m_seen.wantedPercent == FeedCell::kHold || m_seen.factor == 0.0;
  m_factor.isSent = true;
  m_factor.sentAt = now;
  const bool follows = m_seen.source && m_seen.source->state == live::FactorState::Follows;
  m_factor.timedFrom = follows && !m_order.holds ? std::optional(m_factor.readAt) : std::nullopt;
  if (m_seen.factor != 0.0) {
    m_factor.report.least = std::min(m_factor.report.least, m_seen.factor);
    m_factor.report.most = std::max(m_factor.report.most, m_seen.factor);
  }
  if (m_seen.holds != didHold) {
    forgetPlace();
    m_mustConfirm = true;
    m_events.push_back(
        {now, m_seen.holds ? FeedCell::kHold : m_seen.wantedPercent, false, true, {}, {}});
  }
  if (m_seen.holds != didHold || now >= m_factor.noteNext) {
    m_factor.noteNext = now + kFactorNoteInterval;
    note(now, fmt::format("{}{:g}", kFactorNote, m_seen.factor));
  }
}

void FeedControl::begin(Instant ordered, double percent, bool isForeign) {
  account(ordered);
  m_seen.wantedPercent = percent;
  m_seen.holds = percent == FeedCell::kHold || m_seen.factor == 0.0;
  forgetPlace();
  const bool isRepeated = !m_events.empty() && m_events.back().percent == percent &&
                          m_events.back().isForeign == isForeign && !m_events.back().isSource;
  if (!isRepeated) {
    const bool isSource = m_seen.isHeldBySource();
    m_events.push_back({isForeign ? ordered : m_orderedAt,
                        isSource ? FeedCell::kHold : percent,
                        isForeign,
                        isSource,
                        {},
                        {}});
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
  const bool isKnown =
      readings.size() >= m_cells.size() &&
      std::none_of(readings.begin(), readings.begin() + static_cast<std::ptrdiff_t>(m_cells.size()),
                   [](const opcua::Reading& reading) { return reading.status; });
  if (m_mustWrite || !isKnown) {
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
  if (m_map.hasFactor() && readings[2].number != m_seen.factor && !m_factor.mustWrite &&
      !m_factor.isSent) {
    note(at, fmt::format("feed: another client has written the factor {:g}: {:g} is written again",
                         readings[2].number, m_factor.wanted));
    m_factor.mustWrite = true;
  }
  m_seen.actsPercent = readings[1].number;
  const bool obeys = *m_seen.actsPercent <= product() + kSamePercent;
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
  constexpr std::size_t kZ = 2;
  if (m_seen.liftedMm) {
    m_seen.liftedMm = place[kZ] - m_standsAtZMm;
  }
  double movedMm = 0.0;
  for (std::size_t axis = 0; axis < std::min(place.size(), m_place.size()); ++axis) {
    if (axis == kZ && m_seen.liftedMm) {
      continue;  // it may be lifted
    }
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
    if (m_map.lifts) {
      m_standsAtZMm = place[kZ];
      m_seen.liftedMm = 0.0;
    }
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
  if (product() > FeedCell::kHold) {
    m_lost += silence - m_silenceLimit;
  }
}

void FeedControl::lost(Instant now) {
  // What was not sent is not repeated: another client may have written the override meanwhile.
  m_mustWrite = std::exchange(m_isSent, false) || m_mustWrite;
  m_factor.mustWrite = std::exchange(m_factor.isSent, false) || m_factor.mustWrite;
  m_nextWrite = now + kRepeat;
}

void FeedControl::account(Instant now) {
  m_lost = lostTime(now);
  m_accountedTo = now;
}

Duration FeedControl::lostTime(Instant now) const {
  const double share = 1.0 - std::min(1.0, product() / FeedCell::kProgrammed);
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

std::optional<FactorReport> FeedControl::factors() const {
  if (!m_map.hasFactor()) {
    return std::nullopt;
  }
  FactorReport report = m_factor.report;
  report.delay = m_factor.delays.statistics();
  return report;
}

std::vector<trace::Pause> takeHolds(std::vector<trace::Pause>& pauses,
                                    std::span<const FeedEvent> events) {
  std::vector<trace::Pause> holds;
  auto from = pauses.begin();
  for (std::size_t i = 0; i < events.size(); ++i) {
    FeedEvent event = events[i];
    if (!event.isHold()) {
      continue;
    }
    // One standstill, whoever held in turn.
    for (; i + 1 < events.size() && events[i + 1].isHold(); ++i) {
      event.lasted += events[i + 1].lasted;
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
