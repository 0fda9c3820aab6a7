// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/await.h"

#include <fmt/format.h>

namespace rivulet::opcua {

base::Result<Event> awaitAnswer(Link& link, base::RequestId id, base::Duration deadline) {
  // The link reports its own deadline; twice that is a bug of the link, not of the control.
  const base::Instant until = link.now() + 2 * deadline;
  while (link.now() < until) {
    std::optional<Event> event = link.wait(until);
    if (!event) {
      continue;
    }
    if (event->kind == EventKind::ConnectionLost) {
      return base::fail(event->error);
    }
    if (event->request != id) {
      continue;
    }
    if (event->kind == EventKind::RequestFailed) {
      return base::fail(event->error);
    }
    return std::move(*event);
  }
  return base::fail(LinkError::DeadlineExceeded,
                    "The control did not answer in time. Check the network.");
}

base::Result<std::vector<Reading>> readNow(Link& link, std::span<const Variable> variables,
                                           base::Duration deadline) {
  base::Result<Event> event =
      awaitAnswer(link, link.read(variables, deadline, Grouping::List), deadline);
  if (!event) {
    return base::fail(event.error());
  }
  return std::move(event->readings);
}

base::Result<std::vector<double>> readNumbers(Link& link, std::span<const Variable> variables,
                                              base::Duration deadline) {
  const auto readings = readNow(link, variables, deadline);
  if (!readings) {
    return base::fail(readings.error());
  }
  std::vector<double> numbers;
  for (const Reading& reading : *readings) {
    if (reading.status) {
      return base::fail(reading.status,
                        "A variable of the control cannot be read. Check the access rights.");
    }
    numbers.push_back(reading.number);
  }
  return numbers;
}

base::Result<void> writeNow(Link& link, std::span<const Assignment> assignments,
                            base::Duration deadline) {
  const base::Result<Event> event =
      awaitAnswer(link, link.write(assignments, deadline, Grouping::List), deadline);
  if (!event) {
    return base::fail(event.error());
  }
  for (std::size_t i = 0; i < event->statuses.size(); ++i) {
    if (event->statuses[i]) {
      return base::fail(event->statuses[i],
                        fmt::format("R{} of the control cannot be written. Check the access rights "
                                    "and the number of R-parameters (MD28050).",
                                    assignments[i].variable.index));
    }
  }
  return {};
}

base::Result<void> sleepUntil(Link& link, base::Instant until) {
  while (link.now() < until) {
    if (const auto event = link.wait(until); event && event->kind == EventKind::ConnectionLost) {
      return base::fail(event->error);
    }
  }
  return {};
}

}  // namespace rivulet::opcua
