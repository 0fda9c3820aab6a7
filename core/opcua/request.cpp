// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/request.h"

#include <algorithm>
#include <cmath>

namespace rivulet::opcua {

Targets targetsOf(std::span<const Assignment> assignments) {
  Targets targets;
  targets.variables.reserve(assignments.size());
  targets.values.reserve(assignments.size());
  for (const Assignment& assignment : assignments) {
    targets.variables.push_back(assignment.variable);
    targets.values.push_back(assignment.value);
  }
  return targets;
}

PendingRequest newRequest(base::RequestId id, Operation operation, base::Instant sent,
                          base::Duration deadline) {
  PendingRequest request;
  request.id = id;
  request.operation = operation;
  request.deadline = addSaturating(sent, deadline);
  request.event.kind = operation == Operation::Read ? EventKind::ReadDone : EventKind::WriteDone;
  request.event.request = id;
  request.event.sent = sent;
  request.event.at = sent;
  return request;
}

std::optional<LinkError> requestFault(std::span<const Variable> variables,
                                      std::span<const double> values) {
  if (variables.size() > kItemsMax) {
    return LinkError::TooManyItems;
  }
  const bool isFinite =
      std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  return isFinite ? std::nullopt : std::optional(LinkError::BadValue);
}

Event unanswered(base::RequestId id, base::Instant sent, base::Instant at) {
  Event event;
  event.kind = EventKind::RequestFailed;
  event.request = id;
  event.sent = sent;
  event.at = at;
  event.error = base::makeError(LinkError::DeadlineExceeded,
                                "The control did not answer in time. Check the network and the "
                                "load of the control.");
  return event;
}

base::Instant addSaturating(base::Instant instant, base::Duration duration) {
  return duration > base::Instant::max() - instant ? base::Instant::max() : instant + duration;
}

}  // namespace rivulet::opcua
