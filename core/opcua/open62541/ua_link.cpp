// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/ua_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/contract.h"
#include "opcua/control_map.h"
#include "opcua/node_map.h"
#include "opcua/open62541/method_call.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"
#include "opcua/trace_parts.h"

// How it works. Requests wait in one queue, oldest first. A request of Grouping::List is one
// service call. A request of Grouping::Single is a chain of calls, each sent when the previous one
// has been answered, and nothing after it is sent until the chain is complete: so the server sees
// the items in the order of the requests. Every service call has a serial number that travels
// through the library as its user data; the answer to a call whose request has expired finds no
// request with its serial and is dropped. Callbacks only record; the consequences (an expired
// deadline, a lost connection, the next call) are handled in `settle`, outside the library.
//
// Deadlines are the link's own. The library must never forget a call: it closes the connection when
// an answer comes to a call that it does not know. So its own timeouts are longer than any silence
// that the link endures, and the calls that wait for a late answer are counted (`m_calls.asked`).

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

namespace {

/// The library waits in whole milliseconds. A shorter remainder is waited for in naps of this
/// length, with a check of the network between them.
constexpr Duration kNap = std::chrono::microseconds(200);
/// Calls whose deadline has passed and that the server has not answered. As long as there are so
/// many, nothing more is sent: the answers to come would only queue up.
constexpr std::size_t kUnansweredMax = 4;

}  // namespace

base::Error UaLink::Impl::error(LinkError code) const {
  return base::makeError(code, sentenceOf(code), endpoint());
}

// --- callbacks of the library -------------------------------------------------------------------

void UaLink::Impl::onState(UA_Client* client, UA_SecureChannelState channel,
                           UA_SessionState session, UA_StatusCode status) noexcept {
  auto* self = static_cast<Impl*>(UA_Client_getContext(client));
  if (self->m_connection.isEstablished && (isBad(status) || channel != UA_SECURECHANNELSTATE_OPEN ||
                                           session != UA_SESSIONSTATE_ACTIVATED)) {
    self->m_connection.isLost = true;
    self->m_connection.hasActivity = true;
  }
}

void UaLink::Impl::onAnswer(UA_Client* client, void* serial, UA_UInt32 /*requestId*/,
                            void* response) noexcept {
  auto* self = static_cast<Impl*>(UA_Client_getContext(client));
  self->m_connection.hasActivity = true;
  self->answered(reinterpret_cast<std::uintptr_t>(serial), response);
}

std::uint64_t UaLink::Impl::nextSerial() {
  m_calls.asked.push_back({++m_calls.last, now()});
  return m_calls.last;
}

std::size_t UaLink::Impl::unanswered() const {
  const auto awaited = std::count_if(m_pending.begin(), m_pending.end(),
                                     [](const Pending& pending) { return pending.serial != 0; });
  const bool publishes = m_subscription && m_subscription->serial != 0;
  return m_calls.asked.size() - static_cast<std::size_t>(awaited) - (publishes ? 1 : 0) -
         (m_exchange.serial != 0 && !m_exchange.answered ? 1 : 0);
}

Duration UaLink::Impl::silence() const {
  return m_calls.asked.empty() ? Duration{}
                               : now() - std::max(m_connection.heardAt, m_calls.asked.front().at);
}

void UaLink::Impl::answered(std::uint64_t serial, void* response) {
  m_connection.heardAt = now();
  std::erase_if(m_calls.asked, [&](const Asked& asked) { return asked.serial == serial; });
  const UA_StatusCode status = static_cast<const UA_ResponseHeader*>(response)->serviceResult;
  if (meansConnectionLost(status)) {
    m_connection.isSessionEnded = m_connection.isSessionEnded || meansSessionEnded(status);
    m_connection.isLost = m_connection.isLost || m_connection.isEstablished;
    return;
  }
  if (m_exchange.serial == serial) {
    // Moved out; the library clears what is left.
    std::memcpy(m_exchange.response, response, m_exchange.responseType->memSize);
    UA_init(response, m_exchange.responseType);
    m_exchange.answered = true;
    return;
  }
  if (m_subscription && m_subscription->serial == serial) {
    m_subscription->serial = 0;
    m_connection.isLost =
        m_connection.isLost || isBad(status);  // what it tells would be missed without a word
    if (!isBad(status)) {
      takePublish(*static_cast<const UA_PublishResponse*>(response));
    }
    return;
  }
  const auto pending = std::find_if(m_pending.begin(), m_pending.end(),
                                    [&](const Pending& p) { return p.serial == serial; });
  if (pending == m_pending.end()) {
    return;  // it has expired
  }
  pending->serial = 0;
  pending->event.at = now();
  if (isBad(status)) {
    pending->failure = status;
    pending->done = true;
    return;
  }
  if (pending->operation == Operation::Read) {
    takeRead(*pending, *static_cast<const UA_ReadResponse*>(response));
  } else if (pending->operation == Operation::Call) {
    takeCall(*pending, *static_cast<const UA_CallResponse*>(response));
  } else {
    takeWrite(*pending, *static_cast<const UA_WriteResponse*>(response));
  }
}

void UaLink::Impl::takeRead(Pending& pending, const UA_ReadResponse& response) {
  std::vector<Reading>& readings = pending.event.readings;
  const std::size_t readingsBefore = readings.size();
  if (response.resultsSize != pending.nodesSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    pending.done = true;
    return;
  }
  for (std::size_t i = 0; i < response.resultsSize; ++i) {
    const std::size_t length =
        sharedNodeLength(pending.variables, readings.size(), pending.grouping);
    const Variable& variable = pending.variables[readings.size()];
    const Address* const address =
        isMapped() ? &addressOf({variable, length, length > 1 ? pending.grouping : Grouping::List})
                   : nullptr;
    if (address != nullptr && address->isNowhere()) {
      readings.insert(readings.end(), length, nowhere(variable));
    } else if (length > 1 || (address != nullptr && !address->range.empty())) {
      appendReadings(response.results[i], length, readings);
    } else if (address != nullptr) {
      readings.push_back(mappedReading(response.results[i], *m_map, variable));
    } else {
      readings.push_back(readingOf(response.results[i], variable.kind));
    }
  }
  for (std::size_t i = readingsBefore; i < readings.size(); ++i) {
    restoreMeant(pending.variables[i], readings[i]);
  }
  pending.done = readings.size() == pending.variables.size();
}

void UaLink::Impl::takeWrite(Pending& pending, const UA_WriteResponse& response) {
  std::vector<std::error_code>& statuses = pending.event.statuses;
  if (response.resultsSize != pending.nodesSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    pending.done = true;
    return;
  }
  for (std::size_t i = 0; i < response.resultsSize; ++i) {
    const std::size_t length =
        sharedNodeLength(pending.variables, statuses.size(), pending.grouping);
    const Variable& variable = pending.variables[statuses.size()];
    const bool isNowhere =
        isMapped() &&
        addressOf({variable, length, length > 1 ? pending.grouping : Grouping::List}).isNowhere();
    const UA_StatusCode status = isNowhere ? UA_STATUSCODE_BADNODEIDUNKNOWN : response.results[i];
    statuses.insert(
        statuses.end(), length,
        isBad(status) ? make_error_code(linkErrorOf(status, Operation::Write)) : std::error_code());
  }
  pending.done = statuses.size() == pending.variables.size();
}

void UaLink::Impl::takeCall(Pending& pending, const UA_CallResponse& response) {
  pending.failure =
      response.resultsSize == 1 ? response.results[0].statusCode : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  pending.done = true;
  if (!pending.from || isBad(pending.failure)) {
    return;
  }
  if (auto piece = tracePieceOf(response.results[0])) {
    pending.event.trace = std::make_shared<const trace::TracePiece>(*std::move(piece));
  } else {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
}

// --- requests -----------------------------------------------------------------------------------

base::RequestId UaLink::Impl::begin(Pending pending, bool hasMethod) {
  noticeLoss();  // comes before this request
  if (m_connection.isLost) {
    fail(pending, lossError());
  } else if (!hasMethod) {
    fail(pending, error(LinkError::MethodMissing));
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

base::RequestId UaLink::Impl::request(Operation operation, std::vector<Variable> variables,
                                      std::vector<double> values, Duration deadline,
                                      Grouping grouping) {
  Pending pending = newPending(operation, deadline);
  const bool isControl = m_options.map != nullptr || !isMapped();
  pending.grouping = isControl ? grouping : Grouping::List;
  pending.variables = std::move(variables);
  pending.values = std::move(values);
  if (operation == Operation::Read) {
    pending.event.readings.reserve(pending.variables.size());
  } else {
    pending.event.statuses.reserve(pending.variables.size());
  }

  noticeLoss();  // comes before this request
  if (m_connection.isLost) {
    fail(pending, lossError());
  } else if (const auto fault = requestFault(pending.variables, pending.values)) {
    fail(pending, error(*fault));
  } else if (const auto lost = lostByFloat(pending)) {
    fail(pending, *lost);
  } else if (pending.variables.empty()) {
    m_events.push_back(std::move(pending.event));  // nothing to request from the server
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

std::optional<base::Error> UaLink::Impl::lostByFloat(const Pending& pending) const {
  if (!m_floatCells.exist) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < pending.values.size(); ++i) {
    const double value = pending.values[i];
    if (!asFloat(value, m_map->cells.resolution)) {
      return base::makeError(
          LinkError::BadValue,
          fmt::format("R{} cannot be {}: the cells of this server are of type Float, which is off "
                      "by more than half the resolution of {}. Stay nearer to the origin, or give "
                      "the control cells of type Double.",
                      pending.variables[i].index, value, m_map->cells.resolution),
          endpoint());
    }
  }
  return std::nullopt;
}

/// A cell of type Float that carries what was sent shows what was meant.
void UaLink::Impl::restoreMeant(const Variable& variable, Reading& reading) const {
  if (!m_floatCells.exist || variable.kind != VariableKind::RParameter) {
    return;
  }
  const auto meant = m_floatCells.meant.find(variable.index);
  if (meant != m_floatCells.meant.end() &&
      static_cast<double>(static_cast<float>(meant->second)) == reading.number) {
    reading.number = meant->second;
  }
}

base::RequestId UaLink::Impl::store(const std::string& name, const std::string& text,
                                    Duration deadline) {
  Pending pending = newPending(Operation::Call, deadline);
  pending.path = pathOf(name);
  pending.text = text;
  return begin(std::move(pending), !isMapped() || m_methods.contains(kCopyToServer));
}

base::RequestId UaLink::Impl::readTrace(const trace::TracePosition& from, Duration deadline) {
  if (!givesTracePieces()) {
    return {};
  }
  Pending pending = newPending(Operation::Call, deadline);
  pending.event.kind = EventKind::TraceDone;
  pending.from = from;
  return begin(std::move(pending), true);
}

UA_StatusCode UaLink::Impl::sendCall(Pending& pending, void* serial) {
  if (pending.from) {
    std::array inputs = traceInputs(*pending.from);
    const std::string piece = memberIdentifier(m_commands->object, kFetchTracePiece);
    MethodCall method(borrowNodeId(m_commands->nameSpace, m_commands->object),
                      borrowNodeId(m_commands->nameSpace, piece), inputs);
    return __UA_Client_AsyncService(m_client, &method.request, &UA_TYPES[UA_TYPES_CALLREQUEST],
                                    &Impl::onAnswer, &UA_TYPES[UA_TYPES_CALLRESPONSE], serial,
                                    nullptr);
  }
  UA_String target = borrow(pending.path);
  UA_ByteString data = borrow(pending.text);
  UA_Boolean mayOverwrite = true;
  std::array inputs{borrowScalar(target, UA_TYPES_STRING), borrowScalar(data, UA_TYPES_BYTESTRING),
                    borrowScalar(mayOverwrite, UA_TYPES_BOOLEAN)};
  const std::string methodIdentifier = memberIdentifier(m_fileMethods, kCopyToServer);
  const auto mapped = m_methods.find(kCopyToServer);
  const bool isMappedMethod = mapped != m_methods.end();
  MethodCall method(
      isMappedMethod ? mapped->second.object->nodeId : borrowNodeId(m_namespace, m_fileMethods),
      isMappedMethod ? mapped->second.method->nodeId : borrowNodeId(m_namespace, methodIdentifier),
      inputs);
  return __UA_Client_AsyncService(m_client, &method.request, &UA_TYPES[UA_TYPES_CALLREQUEST],
                                  &Impl::onAnswer, &UA_TYPES[UA_TYPES_CALLRESPONSE], serial,
                                  nullptr);
}

const std::string& UaLink::Impl::identifier(const Node& node) {
  const auto found = m_identifiers.find(node);
  if (found != m_identifiers.end()) {
    return found->second;
  }
  return m_identifiers
      .emplace(node, node.length > 1 ? arrayIdentifier({node.first.index,
                                                        static_cast<int>(node.length), node.form})
                                     : nodeIdentifier(node.first))
      .first->second;
}

const UaLink::Impl::Address& UaLink::Impl::addressOf(const Node& node) {
  static const Address kNowhere;
  if (node.length == 1) {
    const auto found = m_addressed.find(node.first);
    return found == m_addressed.end() ? kNowhere : found->second;
  }
  const auto known = m_blocks.find(node);
  if (known != m_blocks.end()) {
    return known->second;
  }
  Address address;
  const CellNodes& cells = m_map->cells;
  const ParameterArray block{node.first.index, static_cast<int>(node.length), node.form};
  if (const std::string text = blockAddress(cells, block); !text.empty()) {
    if (cells.isArray) {
      const auto first = m_addressed.find(node.first);
      UA_copy(first->second.id.get(), address.id.get(), NodeId::type());
      const int from = block.first + cells.offset;
      address.range = fmt::format("{}:{}", from, from + block.count - 1);
    } else if (auto id = parsed(text)) {
      address.id = std::move(*id);
    }
  }
  return m_blocks.emplace(node, std::move(address)).first->second;
}

/// What the map says of a variable that the server does not have.
Reading UaLink::Impl::nowhere(const Variable& variable) const {
  Reading reading;
  if (auto letter = axisLetterOf(*m_map, variable)) {
    reading.text = std::move(*letter);
  } else {
    reading.status = LinkError::VariableMissing;
  }
  return reading;
}

UA_NodeId UaLink::Impl::nodeId(const Node& node, UA_String& range) {
  if (!isMapped()) {
    return borrowNodeId(m_namespace, identifier(node));
  }
  const Address& address = addressOf(node);
  if (!address.range.empty()) {
    range = borrow(address.range);  // an empty text is not none: node-opcua cuts a text by it
  }
  return address.id->nodeId;
}

void UaLink::Impl::sendDue() {
  for (Pending& pending : m_pending) {
    if (m_connection.isLost || unanswered() >= kUnansweredMax) {
      return;
    }
    if (!pending.isSent() && pending.serial == 0) {
      send(pending);
    }
    if (!pending.isSent()) {
      return;  // a chain in progress: what follows it waits
    }
  }
}

void UaLink::Impl::send(Pending& pending) {
  pending.serial = nextSerial();
  void* const serial = reinterpret_cast<void*>(static_cast<std::uintptr_t>(pending.serial));
  if (pending.operation == Operation::Call) {
    pending.itemsSent = 1;
    const UA_StatusCode called = sendCall(pending, serial);
    m_connection.isLost = m_connection.isLost || isBad(called);
    return;
  }
  const std::size_t first = pending.itemsSent;
  pending.itemsSent += pending.grouping == Grouping::Single ? 1 : pending.variables.size();
  m_scratch.nodes.clear();
  for (std::size_t item = first; item < pending.itemsSent; item += m_scratch.nodes.back().length) {
    const std::size_t length = sharedNodeLength(pending.variables, item, pending.grouping);
    m_scratch.nodes.push_back(
        {pending.variables[item], length, length > 1 ? pending.grouping : Grouping::List});
  }
  pending.nodesSent = m_scratch.nodes.size();

  UA_StatusCode status = UA_STATUSCODE_GOOD;
  if (pending.operation == Operation::Read) {
    m_scratch.readItems.resize(m_scratch.nodes.size());
    for (std::size_t i = 0; i < m_scratch.nodes.size(); ++i) {
      UA_ReadValueId& item = m_scratch.readItems[i];
      UA_ReadValueId_init(&item);
      item.nodeId = nodeId(m_scratch.nodes[i], item.indexRange);
      item.attributeId = UA_ATTRIBUTEID_VALUE;
    }
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
    request.nodesToRead = m_scratch.readItems.data();
    request.nodesToReadSize = m_scratch.readItems.size();
    status = __UA_Client_AsyncService(m_client, &request, &UA_TYPES[UA_TYPES_READREQUEST],
                                      &Impl::onAnswer, &UA_TYPES[UA_TYPES_READRESPONSE], serial,
                                      nullptr);
  } else {
    m_scratch.writeItems.resize(m_scratch.nodes.size());
    const std::size_t type = m_floatCells.exist ? UA_TYPES_FLOAT : UA_TYPES_DOUBLE;
    noteFloats(pending);
    std::size_t value = first;
    for (std::size_t i = 0; i < m_scratch.nodes.size(); ++i) {
      // The value only: some servers refuse a write that carries a status or timestamps.
      UA_WriteValue& item = m_scratch.writeItems[i];
      UA_WriteValue_init(&item);
      item.nodeId = nodeId(m_scratch.nodes[i], item.indexRange);
      item.attributeId = UA_ATTRIBUTEID_VALUE;
      item.value.hasValue = true;
      if (m_scratch.nodes[i].length > 1 || item.indexRange.length > 0) {
        UA_Variant_setArray(&item.value.value, numberToSend(pending, value),
                            m_scratch.nodes[i].length, &UA_TYPES[type]);
      } else {
        UA_Variant_setScalar(&item.value.value, numberToSend(pending, value), &UA_TYPES[type]);
      }
      value += m_scratch.nodes[i].length;
    }
    UA_WriteRequest request;
    UA_WriteRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.nodesToWrite = m_scratch.writeItems.data();
    request.nodesToWriteSize = m_scratch.writeItems.size();
    status = __UA_Client_AsyncService(m_client, &request, &UA_TYPES[UA_TYPES_WRITEREQUEST],
                                      &Impl::onAnswer, &UA_TYPES[UA_TYPES_WRITERESPONSE], serial,
                                      nullptr);
  }
  // The library closes the channel when sending fails: nothing can be sent afterwards.
  m_connection.isLost = m_connection.isLost || isBad(status);
}

void UaLink::Impl::noteFloats(const Pending& pending) {
  m_scratch.floats.clear();
  if (m_floatCells.exist) {
    for (std::size_t i = 0; i < pending.values.size(); ++i) {
      m_floatCells.meant[pending.variables[i].index] = pending.values[i];
      m_scratch.floats.push_back(static_cast<float>(pending.values[i]));
    }
  }
}

void* UaLink::Impl::numberToSend(Pending& pending, std::size_t item) {
  return m_floatCells.exist ? static_cast<void*>(&m_scratch.floats[item]) : &pending.values[item];
}

void UaLink::Impl::fail(Pending& pending, base::Error error) {
  Event event;
  event.kind = EventKind::RequestFailed;
  event.request = pending.id;
  event.sent = pending.event.sent;
  event.at = now();
  event.error = std::move(error);
  m_events.push_back(std::move(event));
}

void UaLink::Impl::finishAnswered() {
  for (Pending& pending : m_pending) {
    if (!pending.done) {
      continue;
    }
    if (isBad(pending.failure)) {
      fail(pending, requestError(pending.failure, pending.operation, endpoint()));
    } else {
      m_events.push_back(std::move(pending.event));
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

void UaLink::Impl::expire(Instant time) {
  for (Pending& pending : m_pending) {
    if (pending.deadline <= time) {
      fail(pending, error(LinkError::DeadlineExceeded));
      pending.done = true;
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

/// The library does not report every end of a connection.
void UaLink::Impl::noticeState() {
  UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
  UA_Client_getState(m_client, &channel, nullptr, nullptr);
  m_connection.isLost =
      m_connection.isLost || channel != UA_SECURECHANNELSTATE_OPEN || m_wire->isUnreadable();
  if (!m_connection.isLost && silence() >= m_options.silenceMax) {
    m_connection.isLost = true;
    m_connection.isSilent = true;
  }
}

base::Error UaLink::Impl::lossError() const {
  if (m_connection.isSessionEnded) {
    return sessionEnded(endpoint());
  }
  if (m_wire->isUnreadable()) {
    return unreadableAnswer(endpoint());
  }
  if (!m_connection.isSilent) {
    return error(LinkError::ConnectionLost);
  }
  return silenceError(m_options.silenceMax, endpoint());
}

void UaLink::Impl::noticeLoss() {
  if (!m_connection.isLost || m_connection.isLossReported) {
    return;
  }
  m_connection.isLossReported = true;
  m_pending.clear();
  Event event;
  event.kind = EventKind::ConnectionLost;
  event.at = now();
  event.sent = event.at;
  event.error = lossError();
  m_events.push_back(std::move(event));
}

void UaLink::Impl::settle() {
  finishAnswered();
  noticeState();
  if (!m_connection.isLost && !m_pending.empty()) {
    expire(now());
    sendDue();
  }
  if (!m_connection.isLost && m_subscription && m_subscription->serial == 0) {
    publish();
  }
  noticeLoss();
}

void UaLink::Impl::step(Instant until) {
  Instant limit = until;
  for (const Pending& pending : m_pending) {
    limit = std::min(limit, pending.deadline);
  }
  if (!m_calls.asked.empty()) {
    limit = std::min(limit, addSaturating(now() - silence(), m_options.silenceMax));
  }
  const Duration left = std::min(limit - now(), kIterationMax);
  m_connection.hasActivity = false;
  const auto ms =
      left < milliseconds(1) ? milliseconds::zero() : std::chrono::floor<milliseconds>(left);
  const UA_StatusCode status = UA_Client_run_iterate(m_client, static_cast<UA_UInt32>(ms.count()));
  m_connection.isLost = m_connection.isLost || isBad(status);
  if (ms == milliseconds::zero() && !m_connection.hasActivity && !m_connection.isLost) {
    m_clock.sleepUntil(std::min(limit, now() + kNap));
  }
  settle();
}

std::optional<Event> UaLink::Impl::wait(Instant until) {
  // Deadlines are checked only after the network: an answer that arrived in time counts, however
  // late the caller asks for it.
  noticeLoss();
  for (bool looked = false; m_events.empty(); looked = true) {
    if (looked && now() >= until) {
      return std::nullopt;
    }
    if (m_connection.isLost) {
      m_clock.sleepUntil(until);  // nothing can arrive any more
    } else {
      step(until);
    }
  }
  Event event = std::move(m_events.front());
  m_events.pop_front();
  return event;
}

// --- the public face ----------------------------------------------------------------------------

namespace {

/// An output argument of a method, or the error that it is not as specified.
template <class T>
[[nodiscard]] base::Result<T> output(const CallResponse& response, std::size_t index,
                                     std::size_t typeIndex, std::string_view method) {
  const UA_CallMethodResult& result = response->results[0];
  const T* value = index < result.outputArgumentsSize
                       ? scalarOf<T>(result.outputArguments[index], typeIndex)
                       : nullptr;
  if (value == nullptr) {
    return base::fail(unknownForm(method));
  }
  return *value;
}

/// The status number of a method, of whatever integer type this server uses.
[[nodiscard]] base::Result<int> statusOutput(const CallResponse& response,
                                             std::string_view method) {
  const UA_CallMethodResult& result = response->results[0];
  const auto number =
      result.outputArgumentsSize > 0 ? numberOf(result.outputArguments[0]) : std::nullopt;
  constexpr double kStatusMax = 1e6;
  if (!number || !(std::abs(*number) <= kStatusMax)) {  // NaN is none, either
    return base::fail(unknownForm(method));
  }
  return static_cast<int>(*number);
}

}  // namespace

UaLink::UaLink(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
UaLink::~UaLink() = default;

LoginKind loginKindOf(const ConnectOptions& options) {
  if (options.userCertificate) {
    return LoginKind::Certificate;
  }
  return options.user.empty() ? LoginKind::Anonymous : LoginKind::UserName;
}

base::Result<std::unique_ptr<UaLink>> UaLink::connect(const ConnectOptions& options) {
  auto impl = std::make_unique<Impl>(options);
  if (auto opened = impl->open(); !opened) {
    return base::fail(opened.error());
  }
  return std::unique_ptr<UaLink>(new UaLink(std::move(impl)));
}

base::Result<Connection> openConnection(const ConnectOptions& options) {
  auto opened = UaLink::connect(options);
  if (!opened) {
    return base::fail(opened.error());
  }
  const std::shared_ptr<UaLink> link = std::move(*opened);
  return Connection{link,
                    link.get(),
                    link.get(),
                    options.endpoint,
                    link->security(),
                    link->serverCertificate(),
                    link.get(),
                    options.map,
                    link.get()};
}

base::Instant UaLink::now() const {
  return m_impl->now();
}

base::RequestId UaLink::read(std::span<const Variable> variables, base::Duration deadline,
                             Grouping grouping) {
  return m_impl->request(Operation::Read, {variables.begin(), variables.end()}, {}, deadline,
                         grouping);
}

base::RequestId UaLink::write(std::span<const Assignment> assignments, base::Duration deadline,
                              Grouping grouping) {
  Targets targets = targetsOf(assignments);
  return m_impl->request(Operation::Write, std::move(targets.variables), std::move(targets.values),
                         deadline, grouping);
}

base::RequestId UaLink::store(const std::string& name, const std::string& text,
                              base::Duration deadline) {
  return m_impl->store(name, text, deadline);
}

base::RequestId UaLink::readTrace(const trace::TracePosition& from, base::Duration deadline) {
  return m_impl->readTrace(from, deadline);
}

std::optional<Event> UaLink::wait(base::Instant until) {
  return m_impl->wait(until);
}

base::Duration UaLink::silence() const {
  return m_impl->silence();
}

base::Result<void> UaLink::uploadProgram(const std::string& name, const std::string& text,
                                         bool overwrite) {
  const std::string path = m_impl->pathOf(name);
  UA_String target = borrow(path);
  UA_ByteString data = borrow(text);
  UA_Boolean mayOverwrite = overwrite;
  std::array inputs{borrowScalar(target, UA_TYPES_STRING), borrowScalar(data, UA_TYPES_BYTESTRING),
                    borrowScalar(mayOverwrite, UA_TYPES_BOOLEAN)};
  const auto answer = m_impl->callFileMethod(kCopyToServer, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  return {};
}

base::Result<std::string> UaLink::downloadProgram(const std::string& name) {
  const std::string path = m_impl->pathOf(name);
  UA_String source = borrow(path);
  std::array inputs{borrowScalar(source, UA_TYPES_STRING)};
  const auto answer = m_impl->callFileMethod(kCopyFromServer, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto data = output<UA_ByteString>(*answer, 0, UA_TYPES_BYTESTRING, kCopyFromServer);
  if (!data) {
    return base::fail(data.error());
  }
  return std::string(view(*data));
}

base::Result<void> UaLink::selectProgram(const std::string& name) {
  const std::string path = m_impl->pathOf(name);
  UA_String source = borrow(path);
  UA_UInt32 channel = 1;
  std::array inputs{borrowScalar(source, UA_TYPES_STRING), borrowScalar(channel, UA_TYPES_UINT32)};
  const auto answer = m_impl->callMethods(kSelect, inputs);
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, kSelect);
  if (!status) {
    return base::fail(status.error());
  }
  return commandResult(*status, name);
}

base::Result<ServerIdentity> UaLink::identity() {
  return m_impl->identity();
}

base::Result<std::string> UaLink::accessRights() {
  const auto answer = m_impl->callMethods(kGetMyAccessRights, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto rights = output<UA_String>(*answer, 0, UA_TYPES_STRING, kGetMyAccessRights);
  return rights ? base::Result<std::string>(std::string(view(*rights)))
                : base::fail(rights.error());
}

base::Result<bool> UaLink::mayWrite(const Variable& variable) {
  return m_impl->mayWrite(variable);
}

base::Result<std::vector<BrowsedNode>> UaLink::children(const std::string& address) {
  return m_impl->children(address);
}

base::Result<NodeValues> UaLink::history(const std::string& address, const HistorySpan& span) {
  return m_impl->history(address, span);
}

base::Result<std::vector<NodeFacts>> UaLink::examine(std::span<const std::string> addresses) {
  return m_impl->examine(addresses);
}

const ChannelSecurity& UaLink::security() const {
  return m_impl->security();
}

const std::optional<CertificateFacts>& UaLink::serverCertificate() const {
  return m_impl->serverCertificate();
}

base::Result<void> UaLink::watch(std::span<const std::string> addresses, base::Duration interval) {
  return m_impl->watch(addresses, interval);
}

std::vector<NodeChange> UaLink::takeChanges() {
  return m_impl->takeChanges();
}

base::Result<std::vector<NodeValue>> UaLink::callMethod(const std::string& object,
                                                        const std::string& method,
                                                        std::span<const std::string> inputs) {
  return m_impl->callMethod(object, method, inputs);
}

bool UaLink::isVirtualMachine() const {
  return m_impl->isVirtual();
}

Abilities UaLink::abilities() const {
  return m_impl->abilities();
}

base::Result<void> UaLink::cycleStart() {
  const auto answer = m_impl->callBeyond(kCycleStart, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, kCycleStart);
  if (!status) {
    return base::fail(status.error());
  }
  const auto message = output<UA_String>(*answer, 1, UA_TYPES_STRING, kCycleStart);
  return commandResult(*status, m_impl->endpoint(),
                       message ? std::string(view(*message)) : std::string());
}

base::Result<void> UaLink::reset() {
  const auto answer = m_impl->callBeyond(kReset, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  return {};
}

base::Result<trace::TracePiece> UaLink::fetchTracePiece(const trace::TracePosition& from) {
  if (!m_impl->givesTracePieces()) {
    return Control::fetchTracePiece(from);
  }
  trace::TracePosition position = from;
  std::array inputs = traceInputs(position);
  const auto answer = m_impl->callBeyond(kFetchTracePiece, inputs);
  return answer ? tracePieceOf((*answer)->results[0])
                : base::Result<trace::TracePiece>(base::fail(answer.error()));
}

base::Result<trace::ControlTrace> UaLink::fetchTrace() {
  return joinTrace([this](std::uint64_t from) -> base::Result<TracePart> {
    UA_UInt64 offset = from;
    std::array inputs{borrowScalar(offset, UA_TYPES_UINT64)};
    const auto answer = m_impl->callBeyond(kFetchTrace, inputs);
    if (!answer) {
      return base::fail(answer.error());
    }
    const auto data = output<UA_ByteString>(*answer, 0, UA_TYPES_BYTESTRING, kFetchTrace);
    const auto total = output<UA_UInt64>(*answer, 1, UA_TYPES_UINT64, kFetchTrace);
    if (!data || !total) {
      return base::fail(!data ? data.error() : total.error());
    }
    return TracePart{std::string(view(*data)), *total};
  });
}

}  // namespace rivulet::opcua
