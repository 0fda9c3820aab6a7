// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/faulty_link.h"

#include <algorithm>
#include <cmath>

#include "opcua/request.h"

namespace rivulet::streaming {

using base::Duration;
using base::Instant;
using opcua::Event;
using opcua::EventKind;
using opcua::LinkError;

namespace {

/// Interval between checks of the machine while nothing else happens.
constexpr Duration kStep = std::chrono::milliseconds{50};
/// The inner link never times out before the outer one.
constexpr Duration kNeverGivenUp = std::chrono::hours{10};

}  // namespace

FaultyLink::FaultyLink(machine::Machine& machine, const LinkFaults& faults, std::uint64_t seed)
    : m_machine(machine), m_inner(machine), m_faults(faults), m_random(seed) {
  m_inner.onWrite = [this](base::RequestId id, int cell, double value) {
    if (onWrite) {
      const bool stray = std::any_of(m_strays.begin(), m_strays.end(),
                                     [id](const Sent& request) { return request.inner == id; });
      onWrite(cell, value, stray);
    }
  };
}

Duration FaultyLink::drawn(Duration max) {
  // Short ones are frequent, long ones happen.
  const double share = m_random.uniform();
  return Duration{std::llround(share * share * static_cast<double>(max.count()))};
}

base::Error FaultyLink::lost() const {
  return base::makeError(LinkError::ConnectionLost, "The connection to the control is lost.");
}

void FaultyLink::reconnect() {
  breakConnection();
  m_connected = true;
  m_lossReported = false;
  m_lastArrival = now();
}

void FaultyLink::breakConnection() {
  m_connected = false;
  for (Sent& request : m_requests) {
    request.givenUp = true;
    if (request.inner) {
      m_strays.push_back(std::move(request));  // it is being served
    } else if (m_faults.strayMax > Duration{} && request.fate != Fate::RequestLost) {
      request.arrives = now() + drawn(m_faults.strayMax);
      m_strays.push_back(std::move(request));
    }
  }
  m_requests.clear();
}

base::RequestId FaultyLink::read(std::span<const opcua::Variable> variables, Duration deadline,
                                 opcua::Grouping grouping) {
  Sent request;
  request.isRead = true;
  request.variables.assign(variables.begin(), variables.end());
  request.grouping = grouping;
  return submit(std::move(request), deadline);
}

base::RequestId FaultyLink::write(std::span<const opcua::Assignment> assignments, Duration deadline,
                                  opcua::Grouping grouping) {
  Sent request;
  request.assignments.assign(assignments.begin(), assignments.end());
  request.grouping = grouping;
  return submit(std::move(request), deadline);
}

base::RequestId FaultyLink::store(const std::string& name, const std::string& text,
                                  Duration deadline) {
  Sent request;
  request.program = name;
  request.text = text;
  return submit(std::move(request), deadline);
}

base::RequestId FaultyLink::submit(Sent request, Duration deadline) {
  request.id = ++m_lastId;
  request.sent = now();
  request.deadline = now() + deadline;
  Duration late{};
  if (m_random.uniform() < m_faults.delayProbability) {
    late = drawn(m_faults.delayMax);
  }
  if (m_random.uniform() < m_faults.lostRequestProbability) {
    request.fate = Fate::RequestLost;
  } else if (m_random.uniform() < m_faults.lostAnswerProbability) {
    request.fate = Fate::AnswerLost;
  }
  request.arrives = std::max(m_lastArrival, now() + late);
  m_lastArrival = request.arrives;
  m_requests.push_back(std::move(request));
  if (m_connected && m_random.uniform() < m_faults.disconnectProbability) {
    breakConnection();
  }
  return m_lastId;
}

void FaultyLink::deliver(Sent& request) {
  if (!request.program.empty()) {
    request.inner = m_inner.store(request.program, request.text, kNeverGivenUp);
    return;
  }
  request.inner = request.isRead
                      ? m_inner.read(request.variables, kNeverGivenUp, request.grouping)
                      : m_inner.write(request.assignments, kNeverGivenUp, request.grouping);
}

std::optional<Event> FaultyLink::wait(Instant until) {
  for (;;) {
    if (onTime) {
      onTime();
    }
    if (!m_connected && !m_lossReported) {
      m_lossReported = true;
      Event event;
      event.kind = EventKind::ConnectionLost;
      event.at = now();
      event.error = lost();
      return event;
    }
    Instant next = std::min(until, now() + kStep);
    deliverArrived(m_strays, next);
    deliverArrived(m_requests, next);
    if (std::optional<Event> event = giveUp(next)) {
      return event;
    }
    if (std::optional<Event> event = nextEvent(next)) {
      if (std::optional<Event> heard = hear(std::move(*event))) {
        return heard;
      }
      continue;
    }
    if (now() >= until) {
      return std::nullopt;
    }
  }
}

void FaultyLink::deliverArrived(std::deque<Sent>& requests, Instant& next) {
  for (auto request = requests.begin(); request != requests.end();) {
    if (!request->inner && request->fate == Fate::RequestLost && request->givenUp) {
      request = requests.erase(request);
      continue;
    }
    if (!request->inner && request->fate != Fate::RequestLost) {
      if (request->arrives <= now()) {
        deliver(*request);
      } else {
        next = std::min(next, request->arrives);
      }
    }
    ++request;
  }
}

std::optional<Event> FaultyLink::giveUp(Instant& next) {
  for (Sent& request : m_requests) {
    if (!request.givenUp && request.deadline <= now()) {
      request.givenUp = true;
      return opcua::unanswered(request.id, request.sent, now());
    }
    if (!request.givenUp) {
      next = std::min(next, request.deadline);
    }
  }
  return std::nullopt;
}

std::optional<Event> FaultyLink::hear(Event event) {
  const auto isIt = [&](const Sent& request) { return request.inner == event.request; };
  if (const auto stray = std::find_if(m_strays.begin(), m_strays.end(), isIt);
      stray != m_strays.end()) {
    m_strays.erase(stray);
    return std::nullopt;
  }
  const auto request = std::find_if(m_requests.begin(), m_requests.end(), isIt);
  if (request == m_requests.end()) {
    return std::nullopt;
  }
  Sent answered = std::move(*request);
  m_requests.erase(request);
  if (answered.givenUp) {
    return std::nullopt;
  }
  if (answered.fate == Fate::AnswerLost) {
    // Nobody sees it: it is treated as one that never arrives, until its deadline.
    answered.inner.reset();
    answered.fate = Fate::RequestLost;
    m_requests.push_front(std::move(answered));
    return std::nullopt;
  }
  event.request = answered.id;
  event.sent = answered.sent;
  if (m_random.uniform() < m_faults.stallProbability) {
    stallClient();
  }
  event.at = now();
  return event;
}

std::optional<Event> FaultyLink::nextEvent(Instant until) {
  if (m_unheard.empty()) {
    return m_inner.wait(until);
  }
  Event event = std::move(m_unheard.front());
  m_unheard.pop_front();
  return event;
}

void FaultyLink::stallClient() {
  // The machine continues, and requests in transit arrive.
  const Instant back = now() + drawn(m_faults.stallMax);
  while (now() < back) {
    if (std::optional<Event> event = m_inner.wait(std::min(back, now() + kStep))) {
      m_unheard.push_back(*std::move(event));
    }
    if (onTime) {
      onTime();
    }
  }
}

base::Result<void> FaultyLink::uploadProgram(const std::string& name, const std::string& text,
                                             bool overwrite) {
  return m_connected ? m_inner.uploadProgram(name, text, overwrite) : base::fail(lost());
}

base::Result<std::string> FaultyLink::downloadProgram(const std::string& name) {
  return m_connected ? m_inner.downloadProgram(name) : base::fail(lost());
}

base::Result<void> FaultyLink::selectProgram(const std::string& name) {
  if (!m_connected) {
    return base::fail(lost());
  }
  if (!programInstead.empty()) {
    if (base::Result<void> stored = m_inner.uploadProgram(name, programInstead, true); !stored) {
      return stored;
    }
  }
  return m_inner.selectProgram(name);
}

base::Result<void> FaultyLink::cycleStart() {
  if (!m_connected) {
    return base::fail(lost());
  }
  if (onCycleStart) {
    onCycleStart();
  }
  return m_inner.cycleStart();
}

base::Result<void> FaultyLink::reset() {
  return m_connected ? m_inner.reset() : base::fail(lost());
}

base::Result<trace::ControlTrace> FaultyLink::fetchTrace() {
  return m_connected ? m_inner.fetchTrace() : base::fail(lost());
}

}  // namespace rivulet::streaming
