// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/hosted_run.h"

#include <fmt/format.h>

#include <array>

#include "base/hash.h"
#include "opcua/await.h"
#include "streaming/control/access_probe.h"

namespace rivulet::streaming {

using base::Duration;
using base::Instant;
using base::Result;

namespace {

/// Synchronized actions run in every interpolation cycle, of some milliseconds.
constexpr Duration kFeedCellDeadline = std::chrono::seconds{2};
constexpr Duration kFeedCellInterval = std::chrono::milliseconds{10};

}  // namespace

HostedRun::HostedRun(opcua::Link& link, opcua::Control& control,
                     const templates::FlexibleProgram& flexible, const RunSettings& settings,
                     RunOrders& orders, RunSink& sink, trace::RecordingWriter* writer)
    : m_link(link),
      m_control(control),
      m_flexible(flexible),
      m_cells(flexible.cells),
      m_settings(settings),
      m_orders(orders),
      m_ledger(sink, writer),
      m_feed(flexible.cells),
      m_claim(m_link, m_control, m_cells, m_settings) {
  m_settings.parameters = flexible.parameters;
}

std::uint64_t HostedRun::entropy(const std::string& hash) const {
  const auto now = static_cast<std::uint64_t>(m_link.now().time_since_epoch().count());
  return base::hashOf(hash) ^ ((now + 1) * base::kHashPrime);
}

Result<void> HostedRun::claim(int number) {
  return unlessCancelled(m_claim.take(number,
                                      {[this] { return m_orders.stopRequested(m_link.now()); },
                                       [this] { publish(RunState::Armed, "claim"); }},
                                      m_ledger));
}

Result<void> HostedRun::renewClaim() {
  return unlessCancelled(m_claim.renew());
}

Result<void> HostedRun::unlessCancelled(Result<void> claimed) {
  m_isCancelled = !claimed && claimed.error().code == StreamError::Cancelled;
  return m_isCancelled ? Result<void>() : claimed;
}

Result<std::optional<AccessForms>> HostedRun::chooseAccess() {
  if (m_settings.access == AccessChoice::Fixed || m_cells.slotCount() == 0) {
    return std::nullopt;
  }
  if (!m_cells.scratch) {
    return base::fail(opcua::LinkError::Rejected,
                      "Arrays need consecutive cells, and Rivulet may not use the cells between "
                      "the points. Choose the contiguous layout, or lists.");
  }
  Result<AccessForms> forms = probeAccess(
      m_claim.link(), {m_cells.scratch->first, m_cells.scratch->last}, m_settings.requestDeadline);
  if (!forms) {
    return base::fail(forms.error());
  }
  m_settings.grouping = forms->best();
  m_ledger.note({m_link.now(), fmt::format("access form: {}", groupingName(m_settings.grouping))});
  if (m_settings.access == AccessChoice::Array && !forms->array()) {
    return base::fail(opcua::LinkError::Rejected,
                      "No form of array access works on this control. Use lists.");
  }
  return std::optional(std::move(*forms));
}

Result<void> HostedRun::startProgram(const std::vector<int>& cleared, const char* waitingFor) {
  std::vector<opcua::Assignment> clear;
  for (const int cell : cleared) {
    clear.push_back({opcua::rParameter(cell), 0.0});
  }
  if (Result<void> done = opcua::writeNow(m_claim.link(), clear, m_settings.setupDeadline); !done) {
    return done;
  }
  publish(RunState::Armed, waitingFor);
  return m_control.abilities().startsOnRequest ? m_control.cycleStart() : Result<void>();
}

Result<void> HostedRun::awaitStart(Duration interval, const std::function<Result<bool>()>& isOurs) {
  const Instant until = m_link.now() + m_settings.startDeadline;
  while (m_link.now() < until) {
    if (m_orders.stopRequested(m_link.now())) {
      return cancel();
    }
    const Result<bool> seen = isOurs();
    if (!seen) {
      return base::fail(seen.error());
    }
    if (*seen) {
      return {};
    }
    pause(interval);
  }
  return base::fail(StreamError::NotStarted,
                    "Cycle start was not pressed in time. Start again when the machine is ready.");
}

Result<void> HostedRun::cancel() {
  m_isCancelled = true;
  const Instant asked = m_link.now();
  if (m_control.abilities().startsOnRequest) {
    if (Result<void> done = m_control.reset(); !done) {
      return done;
    }
    m_cancelTime = m_link.now() - asked;
  }
  return {};
}

Result<void> HostedRun::requireFeedCell() {
  if (!m_cells.hasFeedCell()) {
    m_ledger.note({m_link.now(), "the program has no feed cell: hold acts before the next window"});
    return {};
  }
  // The program has begun with 0 there: only what acts on the feed has written another value.
  Result<void> obeys =
      awaitOverride({opcua::rParameter(m_cells.overrideWanted), templates::FeedCell::kProgrammed},
                    templates::FeedCell::kProgrammed, [this](double acts) {
                      return fmt::format(
                          "The control does not obey the feed cell (R{} is {:g}): hold, stop and "
                          "override would not act. Nothing was moved: check that a SINUMERIK has "
                          "synchronized actions, or a LinuxCNC the components of "
                          "docs/linuxcnc.md.",
                          m_cells.overrideActs, acts);
                    });
  if (!obeys || !m_cells.hasFactor()) {
    return obeys;
  }
  for (const double factor : {0.0, m_cells.factorLeast, 1.0}) {
    obeys =
        awaitOverride({opcua::rParameter(m_cells.factor), factor},
                      templates::overrideOf(m_cells, templates::FeedCell::kProgrammed, factor),
                      [this, factor](double acts) {
                        return fmt::format(
                            "The control does not obey the factor of the override (with {:g} in "
                            "R{}, R{} is {:g}). Nothing was moved: check that the control has "
                            "synchronized actions, or start without a source of factors.",
                            factor, m_cells.factor, m_cells.overrideActs, acts);
                      });
    if (!obeys) {
      return obeys;
    }
  }
  return {};
}

Result<void> HostedRun::awaitOverride(const opcua::Assignment& tried, double most,
                                      const std::function<std::string(double acts)>& ignored) {
  const std::array<opcua::Variable, 2> cells{opcua::rParameter(m_cells.overrideWanted),
                                             opcua::rParameter(m_cells.overrideActs)};
  if (Result<void> done = opcua::writeNow(m_claim.link(), {&tried, 1}, m_settings.setupDeadline);
      !done) {
    return done;
  }
  const Instant until = m_link.now() + kFeedCellDeadline;
  for (;;) {
    if (Result<void> done = beat(); !done) {
      return done;
    }
    const auto numbers = opcua::readNumbers(m_claim.link(), cells, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[0] != templates::FeedCell::kProgrammed) {
      return base::fail(StreamError::OtherClient,
                        fmt::format("Another client has written {:g} into R{}, the feed cell. "
                                    "Nothing was moved: find out who holds the machine.",
                                    (*numbers)[0], m_cells.overrideWanted));
    }
    const double acts = (*numbers)[1];
    // Method credit is slower while nothing follows.
    if (acts <= most &&
        (acts > templates::FeedCell::kHold) == (most > templates::FeedCell::kHold)) {
      return {};
    }
    if (m_link.now() >= until) {
      return base::fail(StreamError::FeedCellIgnored, ignored(acts));
    }
    pause(kFeedCellInterval);
  }
}

Result<void> HostedRun::beat() {
  if (!m_feed.beat().isDue(m_link.now())) {
    return {};
  }
  const Instant sent = m_link.now();
  if (Result<void> done =
          opcua::writeNow(m_claim.link(), m_feed.beat().next(sent), m_settings.setupDeadline);
      !done) {
    return done;
  }
  m_feed.beaten(sent, m_link.now());
  return {};
}

Result<void> HostedRun::followFeed() {
  if (Result<void> done = beat(); !done) {
    return done;
  }
  opcua::Link& link = m_claim.link();
  m_feed.want(feedOrdered(m_orders, m_link.now()), m_link.now());
  if (m_feed.mustWrite(m_link.now())) {
    if (Result<void> done =
            opcua::writeNow(link, m_feed.write(m_link.now()), m_settings.setupDeadline);
        !done) {
      return done;
    }
    m_feed.written(m_link.now());
  }
  if (m_feed.mayRead(m_link.now())) {
    const auto cells = m_feed.read(m_link.now());
    const auto readings = opcua::readNow(link, cells, m_settings.setupDeadline);
    if (!readings) {
      return base::fail(readings.error());
    }
    m_feed.seen(*readings, m_link.now());
  }
  for (const trace::Note& note : m_feed.takeNotes()) {
    m_ledger.note(note);
  }
  return {};
}

void HostedRun::pause(Duration duration) {
  const Instant until = m_link.now() + duration;
  while (m_link.now() < until) {
    if (!m_claim.link().wait(until)) {
      return;
    }
  }
}

void HostedRun::publish(RunState state, const char* waitingFor) {
  LiveUpdate update;
  update.state = state;
  update.at = m_link.now();
  update.waitingFor = waitingFor;
  if (m_feed.exists()) {
    update.feed = m_feed.state();
  }
  describeTo(update);
  m_ledger.update(update);
}

}  // namespace rivulet::streaming
