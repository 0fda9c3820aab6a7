// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/start_claim.h"

#include <array>
#include <utility>

#include "opcua/await.h"
#include "streaming/recovery/run_on_control.h"
#include "templates/job_loop.h"

namespace rivulet::streaming {

using base::Result;

Result<void> StartClaim::take(int number, CellClaim::Hooks hooks, RunSink& notes) {
  if (m_settings.origin.user.empty()) {
    return {};
  }
  m_hooks = std::move(hooks);
  m_claim.emplace(m_link, m_cells.heartbeat, number, m_settings.setupDeadline);
  if (Result<void> done = answer(m_claim->take(m_hooks)); !done) {
    return done;
  }
  if (m_settings.transfer != TransferWay::Link) {
    return {};
  }
  if (const Result<void> stored = storeRunLabel(m_control, labelCell(), number, m_settings.origin);
      !stored) {
    notes.note({m_link.now(), "the name of the run could not be stored: " + stored.error().text()});
  }
  return {};
}

Result<void> StartClaim::renew() {
  return m_claim ? answer(m_claim->renew(m_hooks)) : Result<void>();
}

void StartClaim::release() {
  if (m_claim) {
    m_claim->release();
  }
}

Result<void> StartClaim::answer(const Result<std::optional<int>>& holder) {
  if (!holder) {
    return base::fail(withName(holder.error()));
  }
  return *holder ? Result<void>(base::fail(claimedBy(**holder))) : Result<void>();
}

int StartClaim::labelCell() const {
  return m_cells.heartbeat - templates::WindowProtocol::Heartbeat;
}

std::optional<RunOrigin> StartClaim::originOf(int number) {
  const Result<std::string> label = m_control.downloadProgram(runLabelName(labelCell()));
  return label ? runLabelOf(*label, number) : std::nullopt;
}

base::Error StartClaim::claimedBy(int number) {
  // The other client stores its name after it has got the cells.
  const base::Instant until = m_link.now() + 2 * CellClaim::kSettle;
  std::optional<RunOrigin> origin = originOf(number);
  while (!origin && m_link.now() < until &&
         opcua::sleepUntil(m_link, m_link.now() + CellClaim::kBeatInterval)) {
    origin = originOf(number);
  }
  return base::makeError(StreamError::Claimed,
                         "Another client has claimed the cells on the control and is about to "
                         "start. Nothing was changed. Wait until its run has ended.",
                         describeOrigin(number, origin));
}

base::Error StartClaim::withName(base::Error error) {
  if (error.code != StreamError::ChannelBusy || m_settings.origin.user.empty()) {
    return error;
  }
  // Each stretch of a whole job is a run of its own; the job has the number before the first.
  const std::array<opcua::Variable, 3> cells{
      opcua::rParameter(m_cells.heartbeat), opcua::rParameter(m_cells.owner),
      opcua::rParameter(labelCell() + templates::WindowProtocol::Asked)};
  const auto numbers = opcua::readNumbers(m_link, cells, m_settings.setupDeadline);
  if (!numbers) {
    return error;
  }
  const int owner = runNumberOf((*numbers)[1]);
  for (const int number : {claimantOf((*numbers)[0]).value_or(owner),
                           owner - templates::JobProtocol::stretchOf((*numbers)[2])}) {
    if (const auto origin = number > 0 ? originOf(number) : std::nullopt) {
      error.context = describeOrigin(number, origin);
      break;
    }
  }
  return error;
}

}  // namespace rivulet::streaming
