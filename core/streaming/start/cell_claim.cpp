// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/cell_claim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "opcua/await.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;

constexpr Duration kClaimPoll = std::chrono::milliseconds{100};
/// A claim is −(number + this · beats).
constexpr double kPerBeat = kRunNumberMax + 1.0;
/// Times that the cell may be found changed by something else than a claim.
constexpr int kTriesMax = 5;

}  // namespace

std::optional<int> claimantOf(double value) {
  const double whole = -value;
  if (!(whole >= kPerBeat && whole < kPerBeat * kPerBeat) || whole != std::floor(whole)) {
    return std::nullopt;  // zero, a heartbeat, or what another program left
  }
  const auto number = static_cast<int>(std::fmod(whole, kPerBeat));
  return number != 0 ? std::optional(number) : std::nullopt;
}

opcua::Assignment CellClaim::nextBeat() {
  constexpr double kBeatsMax = 1e5;
  m_beats = m_beats < kBeatsMax ? m_beats + 1.0 : 1.0;
  return {opcua::rParameter(m_cell), -(m_number + kPerBeat * m_beats)};
}

Result<CellClaim::Seen> CellClaim::look() {
  const std::array<opcua::Variable, 2> watched{
      {{opcua::VariableKind::ChannelStatus, 0}, opcua::rParameter(m_cell)}};
  const Instant asked = m_link.now();
  const auto numbers = opcua::readNumbers(m_link, watched, m_deadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  if ((*numbers)[0] != opcua::kChannelReset) {
    return base::fail(channelBusy());
  }
  return Seen{(*numbers)[1], asked};
}

Result<void> CellClaim::pause(const Hooks& hooks) {
  if (hooks.isCancelled && hooks.isCancelled()) {
    return base::fail(StreamError::Cancelled, "Stopped before the run was started.");
  }
  return opcua::sleepUntil(m_link, m_link.now() + kClaimPoll);
}

Result<CellClaim::Seen> CellClaim::awaitFree(const Hooks& hooks, std::optional<int>& holder) {
  Result<Seen> seen = look();
  const Instant since = m_link.now();
  const double first = seen ? seen->value : 0.0;
  for (bool told = false; seen; seen = look()) {
    const std::optional<int> claimant = claimantOf(seen->value);
    if (!claimant || *claimant == m_number || m_link.now() - since > kLapse) {
      return seen;
    }
    if (seen->value != first) {
      holder = claimant;  // it lives
      return seen;
    }
    if (!told && m_link.now() - since > kSettle && hooks.waits) {
      told = true;
      hooks.waits();
    }
    if (Result<void> done = pause(hooks); !done) {
      return base::fail(done.error());
    }
  }
  return seen;
}

Result<std::optional<int>> CellClaim::take(const Hooks& hooks) {
  m_isHeld = false;
  std::optional<int> holder;
  for (int attempt = 0; attempt < kTriesMax; ++attempt) {
    const Result<Seen> free = awaitFree(hooks, holder);
    if (!free) {
      return base::fail(free.error());
    }
    if (holder) {
      return holder;
    }
    const opcua::Assignment claim = nextBeat();
    const Instant sent = m_link.now();
    if (Result<void> done = opcua::writeNow(m_link, {&claim, 1}, m_deadline); !done) {
      return base::fail(done.error());
    }
    const Instant written = m_link.now();
    const bool wasOurs = claimantOf(free->value) == m_number;
    const Duration watch = wasOurs || written - free->asked <= kQuick ? kSettle : kLapse;
    Seen seen;
    do {
      // A value that was confirmed may be readable only from the next interpolation cycle on.
      if (Result<void> done = pause(hooks); !done) {
        return base::fail(done.error());
      }
      const Result<Seen> now = look();
      if (!now) {
        return base::fail(now.error());
      }
      seen = *now;
    } while (seen.value == claim.value && seen.asked < written + watch);
    if (seen.value == claim.value) {
      m_isHeld = true;
      m_renewedAt = sent;
      m_nextBeat = m_link.now();
      return std::nullopt;
    }
    if (const std::optional<int> claimant = claimantOf(seen.value)) {
      return claimant;
    }
  }
  return base::fail(StreamError::OtherClient,
                    "Something else writes the cells of the run. Choose other cells, or find out "
                    "what writes them.");
}

Result<std::optional<int>> CellClaim::renew(const Hooks& hooks) {
  return m_link.now() - m_renewedAt < kRenewed ? std::optional<int>() : take(hooks);
}

void CellClaim::release() {
  if (!m_isHeld) {
    return;
  }
  m_isHeld = false;
  const std::array<opcua::Variable, 1> cell{opcua::rParameter(m_cell)};
  const auto numbers = opcua::readNumbers(m_link, cell, m_deadline);
  if (numbers && claimantOf((*numbers)[0]) == m_number) {
    const opcua::Assignment free{cell[0], 0.0};
    static_cast<void>(opcua::writeNow(m_link, {&free, 1}, m_deadline));
  }
}

std::optional<opcua::Event> CellClaim::wait(Instant until) {
  for (;;) {
    if (m_isHeld && !m_beatPending && m_link.now() >= m_nextBeat) {
      const opcua::Assignment claim = nextBeat();
      m_nextBeat = m_link.now() + kBeatInterval;
      m_beatPending = m_link.write({&claim, 1}, m_deadline, opcua::Grouping::List);
    }
    const bool beats = m_isHeld && !m_beatPending;
    std::optional<opcua::Event> event = m_link.wait(beats ? std::min(until, m_nextBeat) : until);
    if (event && m_beatPending == event->request &&
        event->kind != opcua::EventKind::ConnectionLost) {
      m_beatPending.reset();
      if (event->kind == opcua::EventKind::WriteDone) {
        m_renewedAt = event->sent;
      }
    } else if (event || m_link.now() >= until) {
      return event;
    }
  }
}

}  // namespace rivulet::streaming
