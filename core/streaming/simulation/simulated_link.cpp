// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/simulated_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "base/units.h"
#include "opcua/request.h"

namespace rivulet::streaming {

using base::Instant;
using opcua::Event;
using opcua::EventKind;
using opcua::LinkError;

namespace {

/// No answer arrives at the moment of the request, however cheap access is: a client that polls
/// would never let time advance.
constexpr base::Duration kRoundTripMin = std::chrono::microseconds{100};

}  // namespace

base::RequestId SimulatedLink::read(std::span<const opcua::Variable> variables,
                                    base::Duration deadline, opcua::Grouping grouping) {
  Request request;
  request.kind = machine::AccessKind::Read;
  request.grouping = grouping;
  request.variables.assign(variables.begin(), variables.end());
  return submit(std::move(request), deadline);
}

base::RequestId SimulatedLink::write(std::span<const opcua::Assignment> assignments,
                                     base::Duration deadline, opcua::Grouping grouping) {
  Request request;
  request.kind = machine::AccessKind::Write;
  request.grouping = grouping;
  for (const opcua::Assignment& assignment : assignments) {
    request.variables.push_back(assignment.variable);
    request.values.push_back(assignment.value);
    request.refused = request.refused || !std::isfinite(assignment.value);
  }
  return submit(std::move(request), deadline);
}

base::RequestId SimulatedLink::store(const std::string& name, const std::string& text,
                                     base::Duration deadline) {
  Request request;
  request.kind = machine::AccessKind::Write;
  request.program = name;
  request.text = text;
  return submit(std::move(request), deadline);
}

base::RequestId SimulatedLink::readTrace(const trace::TracePosition& from,
                                         base::Duration /*deadline*/) {
  Event event;
  event.kind = EventKind::TraceDone;
  event.request = ++m_lastId;
  event.sent = now();
  event.at = now();
  event.trace = std::make_shared<const trace::TracePiece>(m_machine.takeTrace(from));
  m_traces.push_back(std::move(event));
  return m_lastId;
}

base::RequestId SimulatedLink::submit(Request request, base::Duration deadline) {
  request.id = ++m_lastId;
  request.sent = now();
  request.deadline = now() + deadline;
  request.event.request = request.id;
  request.event.sent = request.sent;
  request.event.kind =
      request.kind == machine::AccessKind::Read ? EventKind::ReadDone : EventKind::WriteDone;
  m_requests.push_back(std::move(request));
  return m_lastId;
}

void SimulatedLink::beginNode(Request& request) {
  // A list is one request; single accesses are one request each, sent when the last is answered.
  if (!request.begun || request.grouping == opcua::Grouping::Single) {
    m_machine.beginRequest(request.kind, request.begun ? now() : request.sent);
    ++m_served.requests;
  }
  request.begun = true;
  if (!request.program.empty()) {
    request.nextDoneAt = m_machine.serveProgram(request.text.size());
    return;
  }
  request.nextDoneAt = serveNode();
  const std::size_t length = nodeLength(request);
  const machine::ArrayAccess& arrays = m_machine.config().access.arrays;
  if (length > 1 && offers(request.grouping) && arrays.charge == machine::ArrayCharge::Element) {
    for (std::size_t element = 1; element < length; ++element) {
      request.nextDoneAt = serveNode();
    }
  }
}

base::Instant SimulatedLink::serveNode() {
  ++m_served.nodes;
  return m_machine.serveNode();
}

bool SimulatedLink::isServed(const Request& request) {
  return request.program.empty() && request.next == request.variables.size();
}

std::size_t SimulatedLink::nodeLength(const Request& request) {
  return opcua::sharedNodeLength(request.variables, request.next, request.grouping);
}

bool SimulatedLink::offers(opcua::Grouping grouping) const {
  const machine::ArrayAccess& arrays = m_machine.config().access.arrays;
  return grouping == opcua::Grouping::ArrayCount ? arrays.count : arrays.range;
}

std::optional<Event> SimulatedLink::wait(Instant until) {
  if (!m_traces.empty()) {
    Event event = std::move(m_traces.front());
    m_traces.pop_front();
    return event;
  }
  while (!m_requests.empty()) {
    Request& request = m_requests.front();
    const auto finish = [&]() -> std::optional<Event> {
      const bool silent = request.reported;
      Event event = std::move(request.event);
      event.at = now();
      m_requests.pop_front();
      return silent ? std::nullopt : std::optional<Event>(std::move(event));
    };
    if (request.refused) {
      request.event.kind = EventKind::RequestFailed;
      request.event.error = base::makeError(
          LinkError::BadValue, "A value to be written is not a number. Nothing was sent.");
      return finish();
    }
    if (isServed(request)) {
      const Instant answerAt = std::max(now(), request.sent + kRoundTripMin);
      if (answerAt > until) {
        break;
      }
      m_machine.advance(answerAt);
      if (std::optional<Event> event = finish()) {
        return event;
      }
      continue;
    }
    if (!request.begun) {
      beginNode(request);
    }
    if (!request.reported && request.deadline < request.nextDoneAt && request.deadline <= until) {
      // The client gives up, but the control still carries the request out.
      m_machine.advance(request.deadline);
      request.reported = true;
      return opcua::unanswered(request.id, request.sent, now());
    }
    if (request.nextDoneAt > until) {
      break;
    }
    m_machine.advance(request.nextDoneAt);
    if (!request.program.empty()) {
      if (const auto stored = m_machine.storeProgram(request.program, request.text, true);
          !stored) {
        request.event.kind = EventKind::RequestFailed;
        request.event.error = stored.error();
      }
      request.program.clear();
      continue;
    }
    const std::size_t length = nodeLength(request);
    access(request, length);
    request.next += length;
    if (!isServed(request)) {
      beginNode(request);
    }
  }
  m_machine.advance(until);
  return std::nullopt;
}

void SimulatedLink::access(Request& request, std::size_t length) {
  const std::size_t first = request.next;
  const bool isRead = request.kind == machine::AccessKind::Read;
  // An array exists only if all its elements exist.
  const bool isArray = length > 1;
  const bool exists =
      !isArray ||
      (offers(request.grouping) && m_machine.hasRParameter(request.variables[first].index) &&
       m_machine.hasRParameter(request.variables[first + length - 1].index));
  const machine::ArrayWrite write = m_machine.config().access.arrays.write;
  for (std::size_t item = first; item < first + length; ++item) {
    if (isRead) {
      opcua::Reading reading;
      if (exists) {
        reading = readVariable(request.variables[item]);
      } else {
        reading.status = LinkError::VariableMissing;
      }
      request.event.readings.push_back(std::move(reading));
      continue;
    }
    std::error_code status;
    if (!exists) {
      status = LinkError::VariableMissing;
    } else if (isArray && write == machine::ArrayWrite::Refused) {
      status = LinkError::NotWritable;
    } else if (!isArray || item == first || write == machine::ArrayWrite::All) {
      status = writeVariable(request, item);
    }
    request.event.statuses.push_back(status);
  }
}

std::error_code SimulatedLink::writeVariable(const Request& request, std::size_t item) {
  const opcua::Variable& variable = request.variables[item];
  if (variable.kind != opcua::VariableKind::RParameter) {
    return LinkError::NotWritable;
  }
  if (!m_machine.hasRParameter(variable.index)) {
    return LinkError::VariableMissing;
  }
  if (onWrite) {
    onWrite(request.id, variable.index, request.values[item]);
  }
  m_machine.writeRParameter(variable.index, request.values[item]);
  return {};
}

opcua::Reading SimulatedLink::readVariable(const opcua::Variable& variable) const {
  opcua::Reading reading;
  if (variable.kind == opcua::VariableKind::RParameter) {
    if (m_machine.hasRParameter(variable.index)) {
      reading.number = m_machine.rParameter(variable.index);
    } else {
      reading.status = LinkError::VariableMissing;
    }
    return reading;
  }
  const bool isAxis = variable.kind == opcua::VariableKind::ActualPosition ||
                      variable.kind == opcua::VariableKind::DistanceToGo ||
                      variable.kind == opcua::VariableKind::AxisName;
  const std::optional<std::size_t> rotary = m_machine.config().rotaryAt(variable.index);
  const bool isLinear = variable.index >= 0 && variable.index < static_cast<int>(base::kAxisCount);
  if (isAxis && !isLinear && !rotary) {
    reading.status = LinkError::VariableMissing;
    return reading;
  }
  const machine::MachineState state = m_machine.state();
  const auto axis = static_cast<std::size_t>(variable.index);
  switch (variable.kind) {
    case opcua::VariableKind::RParameter:
      break;
    case opcua::VariableKind::ActualPosition:
      reading.number = rotary ? state.actualDeg[*rotary] : state.actualMm[axis];
      break;
    case opcua::VariableKind::DistanceToGo:
      reading.number = rotary ? state.distanceToGoDeg[*rotary] : state.distanceToGoMm[axis];
      break;
    case opcua::VariableKind::PathFeed:
      reading.number = base::mmPerMinFromMmPerS(state.feedMmPerS);
      break;
    case opcua::VariableKind::ProgramStatus:
      reading.number = static_cast<double>(state.program);
      break;
    case opcua::VariableKind::ChannelStatus:
      reading.number = static_cast<double>(state.channel);
      break;
    case opcua::VariableKind::LineNumber:
      reading.number = state.line;
      break;
    case opcua::VariableKind::ProgramName:
      reading.text = state.programName;
      break;
    case opcua::VariableKind::Message:
      reading.text = state.message;
      break;
    case opcua::VariableKind::Alarm:
      reading.number = state.alarm;
      break;
    case opcua::VariableKind::AxisName:
      reading.text = rotary ? base::kRotaryAxisNames[*rotary] : base::kAxisNames[axis];
      break;
    case opcua::VariableKind::ToolNumber:
    case opcua::VariableKind::ToolName:
    case opcua::VariableKind::EdgeNumber:
    case opcua::VariableKind::SpindleSpeed:
    case opcua::VariableKind::SpindleSpeedSet:
    case opcua::VariableKind::SpindleTurn:
    case opcua::VariableKind::GFunction:
    case opcua::VariableKind::MFunction:
      return readEquipment(variable);
  }
  return reading;
}

/// What a machine has not, it does not serve; nor does it serve other groups of functions.
opcua::Reading SimulatedLink::readEquipment(const opcua::Variable& variable) const {
  const machine::MachineConfig& config = m_machine.config();
  const machine::EquipmentState state = m_machine.state().equipment;
  opcua::Reading reading;
  bool isThere = false;
  switch (variable.kind) {
    case opcua::VariableKind::ToolNumber:
      isThere = config.tools.has_value();
      reading.number = state.tool;
      break;
    case opcua::VariableKind::ToolName:
      isThere = config.tools.has_value();
      reading.text = state.toolName;
      break;
    case opcua::VariableKind::EdgeNumber:
      isThere = config.tools.has_value();
      reading.number = state.edge;
      break;
    case opcua::VariableKind::SpindleSpeed:
      isThere = config.spindle && variable.index == 0;
      reading.number = std::abs(state.spindlePerMin);
      break;
    case opcua::VariableKind::SpindleSpeedSet:
      isThere = config.spindle && variable.index == 0;
      reading.number = std::abs(state.spindleCommandPerMin);
      break;
    case opcua::VariableKind::SpindleTurn:
      isThere = config.spindle && variable.index == 0;
      reading.number = static_cast<double>(opcua::turnOf(state.spindlePerMin));
      break;
    case opcua::VariableKind::GFunction:
      isThere = variable.index == opcua::kWorkOffsetGroup;
      reading.text = fmt::format("G{}", state.workOffset);
      break;
    case opcua::VariableKind::MFunction:
      isThere = config.coolantTime &&
                (variable.index == opcua::kFloodGroup || variable.index == opcua::kMistGroup);
      reading.number = variable.index == opcua::kFloodGroup
                           ? (state.flood ? opcua::kFloodOn : opcua::kCoolantOff)
                           : (state.mist ? opcua::kMistOn : opcua::kCoolantOff);
      break;
    default:
      break;
  }
  if (!isThere) {
    return {LinkError::VariableMissing, 0.0, {}};
  }
  return reading;
}

base::Result<void> SimulatedLink::uploadProgram(const std::string& name, const std::string& text,
                                                bool overwrite) {
  return m_machine.storeProgram(name, text, overwrite);
}

base::Result<std::string> SimulatedLink::downloadProgram(const std::string& name) {
  return m_machine.programText(name);
}

base::Result<void> SimulatedLink::selectProgram(const std::string& name) {
  return m_machine.selectProgram(name);
}

base::Result<void> SimulatedLink::cycleStart() {
  m_served = {};
  return m_machine.cycleStart();
}

base::Result<void> SimulatedLink::reset() {
  m_machine.reset();
  return {};
}

base::Result<trace::ControlTrace> SimulatedLink::fetchTrace() {
  return m_machine.trace();
}

base::Result<trace::TracePiece> SimulatedLink::fetchTracePiece(const trace::TracePosition& from) {
  return m_machine.takeTrace(from);
}

}  // namespace rivulet::streaming
