// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/await.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "opcua/control_map.h"

namespace rivulet::opcua {

namespace {

/// What is refused may have been falsified on its way: asked again, it is known.
constexpr int kAttemptsMax = 3;

}  // namespace

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

namespace {

/// "R12", "channel.status"
std::string variableName(const Variable& variable) {
  return variable.kind == VariableKind::RParameter ? fmt::format("R{}", variable.index)
                                                   : mapKeyOf(variable);
}

}  // namespace

base::Result<std::vector<double>> readNumbers(Link& link, std::span<const Variable> variables,
                                              base::Duration deadline) {
  base::Error error;
  for (int attempt = 0; attempt < kAttemptsMax; ++attempt) {
    const auto readings = readNow(link, variables, deadline);
    if (!readings) {
      error = readings.error();
    } else {
      std::vector<double> numbers;
      std::error_code refused;
      std::string name;
      for (std::size_t i = 0; i < readings->size(); ++i) {
        const Reading& reading = (*readings)[i];
        if (reading.status && !refused) {
          refused = reading.status;
          name = variableName(variables[i]);
        }
        numbers.push_back(reading.number);
      }
      if (!refused) {
        return numbers;
      }
      error =
          base::makeError(refused, fmt::format("A variable of the control cannot be read ({}). {}",
                                               name, remedyForItem(refused)));
    }
    if (!mayBeFalsified(error.code)) {
      break;
    }
  }
  return base::fail(error);
}

base::Result<void> writeNow(Link& link, std::span<const Assignment> assignments,
                            base::Duration deadline) {
  base::Error error;
  for (int attempt = 0; attempt < kAttemptsMax; ++attempt) {
    const base::Result<Event> event =
        awaitAnswer(link, link.write(assignments, deadline, Grouping::List), deadline);
    if (!event) {
      error = event.error();
    } else {
      const auto bad = std::find_if(event->statuses.begin(), event->statuses.end(),
                                    [](const std::error_code& status) { return !!status; });
      if (bad == event->statuses.end()) {
        return {};
      }
      const auto item = static_cast<std::size_t>(bad - event->statuses.begin());
      error =
          base::makeError(*bad, fmt::format("R{} of the control cannot be written. {}",
                                            assignments[item].variable.index, remedyForItem(*bad)));
    }
    if (!mayBeFalsified(error.code)) {
      break;
    }
  }
  return base::fail(error);
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
