// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/heartbeat.h"

#include <algorithm>
#include <chrono>

#include "feasibility/prediction/methods.h"
#include "templates/feed_cell.h"

namespace rivulet::streaming {

namespace {

/// Also where nobody stops the axes: without it, the program ends after 20 s at the earliest.
constexpr base::Duration kIntervalMax = std::chrono::seconds{1};
/// Signs within the time after which the axes stand.
constexpr int kPerLimit = 4;
static_assert(std::chrono::duration<double>(feasibility::kUsualBeatInterval).count() * kPerLimit ==
              templates::kSilenceLimitS);

}  // namespace

Heartbeat::Heartbeat(const templates::CellMap& cells)
    : m_exists(cells.windows > 0),
      m_interval(templates::watchesClient(cells)
                     ? std::min(kIntervalMax, base::fromSeconds(cells.silenceLimitS) / kPerLimit)
                     : kIntervalMax),
      m_assignment{{{opcua::rParameter(cells.heartbeat), 0.0}}} {
}

std::span<const opcua::Assignment> Heartbeat::next(base::Instant now) {
  m_assignment[0].value += 1.0;
  m_next = now + 2 * m_interval;
  return m_assignment;
}

}  // namespace rivulet::streaming
