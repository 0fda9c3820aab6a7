// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/hosted_run.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "opcua/await.h"
#include "streaming/control/access_probe.h"

namespace rivulet::streaming {

using base::Duration;
using base::Instant;
using base::Result;

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
  describeTo(update);
  m_ledger.update(update);
}

}  // namespace rivulet::streaming
