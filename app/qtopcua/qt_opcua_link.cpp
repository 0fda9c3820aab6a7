// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "qtopcua/qt_opcua_link.h"

#include <open62541/statuscodes.h>

#include <QOpcUaLocalizedText>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "opcua/host_check.h"
#include "opcua/node_map.h"
#include "opcua/open62541/monotonic_clock.h"
#include "opcua/open62541/status.h"
#include "opcua/request.h"
#include "opcua/trace_parts.h"
#include "qtopcua/client_thread.h"

// How it works. As in `UaLink`, requests wait in one queue, oldest first; a request of
// Grouping::Single is a chain of calls; deadlines are the link's own. Unlike there, one service
// call is under way at a time. The answer to a call whose request has expired finds no request
// with its serial and is dropped; until it comes, nothing more is sent.

namespace rivulet::qtopcua {

namespace {

using base::Duration;
using base::Instant;
using opcua::addSaturating;
using opcua::Assignment;
using opcua::Event;
using opcua::EventKind;
using opcua::Grouping;
using opcua::LinkError;
using opcua::Operation;
using opcua::Reading;
using opcua::Variable;
using opcua::VariableKind;

/// Connecting takes a dozen answers.
constexpr int kConnectDeadlines = 6;

[[nodiscard]] QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Text form of a node id with a text.
[[nodiscard]] QString nodeText(int nameSpace, std::string_view identifier) {
  return QStringLiteral("ns=%1;s=").arg(nameSpace) + qt(identifier);
}

/// Of the standard's own namespace. @source OPC UA part 6, A.3
constexpr const char* kNamespaceArray = "i=2255";
constexpr const char* kServerArray = "i=2254";
constexpr const char* kProductName = "i=2261";
constexpr const char* kSoftwareVersion = "i=2264";
constexpr const char* kBuildNumber = "i=2265";

/// The number of a scalar of any numeric type.
[[nodiscard]] std::optional<double> numberOf(const QVariant& value) {
  switch (value.metaType().id()) {
    case QMetaType::Bool:
    case QMetaType::Char:
    case QMetaType::SChar:
    case QMetaType::UChar:
    case QMetaType::Short:
    case QMetaType::UShort:
    case QMetaType::Int:
    case QMetaType::UInt:
    case QMetaType::Long:
    case QMetaType::ULong:
    case QMetaType::LongLong:
    case QMetaType::ULongLong:
    case QMetaType::Float:
    case QMetaType::Double:
      return value.toDouble();
    default:
      return std::nullopt;
  }
}

[[nodiscard]] std::optional<std::string> textOf(const QVariant& value) {
  if (value.metaType().id() == QMetaType::QString) {
    return value.toString().toStdString();
  }
  if (value.canConvert<QOpcUaLocalizedText>()) {
    return value.value<QOpcUaLocalizedText>().text().toStdString();
  }
  return std::nullopt;
}

/// Elements of an array: Qt OPC UA shows one element as a scalar.
[[nodiscard]] QVariantList elementsOf(const QVariant& value) {
  if (value.metaType().id() == QMetaType::QVariantList) {
    return value.toList();
  }
  return value.isValid() ? QVariantList{value} : QVariantList();
}

[[nodiscard]] std::uint32_t statusOf(QOpcUa::UaStatusCode status) {
  return static_cast<std::uint32_t>(status);
}

[[nodiscard]] Reading readingOf(const QOpcUaReadResult& result, VariableKind kind) {
  Reading reading;
  if (opcua::isBad(statusOf(result.statusCode()))) {
    reading.status = opcua::linkErrorOf(statusOf(result.statusCode()), Operation::Read);
    return reading;
  }
  if (opcua::isText(kind)) {
    if (auto text = textOf(result.value())) {
      reading.text = std::move(*text);
      return reading;
    }
  } else if (const auto number = numberOf(result.value()); number && std::isfinite(*number)) {
    reading.number = *number;
    return reading;
  }
  reading.status = LinkError::BadValue;
  return reading;
}

/// One reading per element of an array.
void appendReadings(const QOpcUaReadResult& result, std::size_t length,
                    std::vector<Reading>& readings) {
  const std::uint32_t status = statusOf(result.statusCode());
  const QVariantList list = elementsOf(result.value());
  const bool fits = static_cast<std::size_t>(list.size()) == length;
  for (std::size_t i = 0; i < length; ++i) {
    Reading reading;
    const QVariant element = fits ? list.at(static_cast<qsizetype>(i)) : QVariant();
    const double number = element.toDouble();
    if (opcua::isBad(status)) {
      reading.status = opcua::linkErrorOf(status, Operation::Read);
    } else if (element.metaType().id() != QMetaType::Double || !std::isfinite(number)) {
      reading.status = LinkError::BadValue;
    } else {
      reading.number = number;
    }
    readings.push_back(std::move(reading));
  }
}

/// An output argument of a method; not valid if there is none.
[[nodiscard]] QVariant output(const QVariant& outputs, qsizetype index) {
  if (outputs.metaType().id() == QMetaType::QVariantList) {
    const QVariantList list = outputs.toList();
    return index < list.size() ? list.at(index) : QVariant();
  }
  return index == 0 ? outputs : QVariant();
}

/// The status number of a method, of whatever integer type this server uses.
[[nodiscard]] base::Result<int> statusOutput(const QVariant& outputs, std::string_view method) {
  const auto number = numberOf(output(outputs, 0));
  if (!number || std::abs(*number) > 1e6) {
    return base::fail(opcua::unknownForm(method));
  }
  return static_cast<int>(*number);
}

[[nodiscard]] base::Result<std::string> bytesOutput(const QVariant& outputs, qsizetype index,
                                                    std::string_view method) {
  const QVariant value = output(outputs, index);
  if (value.metaType().id() != QMetaType::QByteArray) {
    return base::fail(opcua::unknownForm(method));
  }
  return value.toByteArray().toStdString();
}

/// The arguments of `kFetchTracePiece`.
[[nodiscard]] QList<QOpcUa::TypedVariant> traceInputs(const trace::TracePosition& from) {
  QList<QOpcUa::TypedVariant> inputs;
  for (const std::uint64_t number : {from.start, from.samples, from.blocks, from.events}) {
    inputs.append({QVariant::fromValue<quint64>(number), QOpcUa::Types::UInt64});
  }
  return inputs;
}

/// Its answer.
[[nodiscard]] base::Result<trace::TracePiece> tracePieceOf(const QVariant& outputs) {
  constexpr qsizetype kOutputs = 6;
  const QVariantList list = elementsOf(outputs);
  if (list.size() != kOutputs || list.at(0).metaType().id() != QMetaType::QByteArray ||
      list.at(kOutputs - 1).metaType().id() != QMetaType::Bool) {
    return base::fail(opcua::unknownForm(opcua::kFetchTracePiece));
  }
  trace::TracePiece piece;
  qsizetype index = 1;
  for (std::uint64_t* const next :
       {&piece.next.start, &piece.next.samples, &piece.next.blocks, &piece.next.events}) {
    *next = list.at(index++).toULongLong();
  }
  auto records = trace::parseControlTrace(list.at(0).toByteArray().toStdString());
  if (!records) {
    return base::fail(records.error());
  }
  piece.records = std::move(*records);
  piece.isLast = list.at(kOutputs - 1).toBool();
  return piece;
}

[[nodiscard]] QOpcUa::TypedVariant textInput(const std::string& text) {
  return {QVariant(qt(text)), QOpcUa::Types::String};
}

[[nodiscard]] QOpcUa::TypedVariant bytesInput(const std::string& text) {
  return {QVariant(QByteArray::fromStdString(text)), QOpcUa::Types::ByteString};
}

}  // namespace

class QtOpcUaLink::Impl {
 public:
  explicit Impl(opcua::ConnectOptions options) : m_options(std::move(options)), m_thread(m_clock) {}

  [[nodiscard]] base::Result<void> open();

  [[nodiscard]] Instant now() const { return m_clock.now(); }
  [[nodiscard]] const std::string& endpoint() const { return m_options.endpoint; }
  [[nodiscard]] bool isVirtual() const { return m_isVirtual; }
  [[nodiscard]] opcua::Abilities abilities() const {
    return m_commands ? m_commands->abilities : opcua::Abilities{};
  }
  [[nodiscard]] base::Result<opcua::ServerIdentity> identity();
  [[nodiscard]] base::Result<bool> mayWrite(const Variable& variable);

  base::RequestId request(Operation operation, std::vector<Variable> variables,
                          std::vector<double> values, Duration deadline, Grouping grouping);
  base::RequestId store(const std::string& name, const std::string& text, Duration deadline);
  [[nodiscard]] bool givesTracePieces() const { return m_commands && m_commands->tracePieces; }
  base::RequestId readTrace(const trace::TracePosition& from, Duration deadline);
  std::optional<Event> wait(Instant until);
  [[nodiscard]] Duration silence() const;

  /// Calls a method and waits for its answer. @return its output arguments
  [[nodiscard]] base::Result<QVariant> call(int nameSpace, std::string_view object,
                                            std::string_view method,
                                            const QList<QOpcUa::TypedVariant>& inputs);
  [[nodiscard]] base::Result<QVariant> callFileMethod(std::string_view method,
                                                      const QList<QOpcUa::TypedVariant>& inputs);
  [[nodiscard]] base::Result<QVariant> callMethods(std::string_view method,
                                                   const QList<QOpcUa::TypedVariant>& inputs) {
    return call(m_namespace, opcua::kMethodsObject, method, inputs);
  }
  [[nodiscard]] base::Result<QVariant> callBeyond(std::string_view method,
                                                  const QList<QOpcUa::TypedVariant>& inputs);

 private:
  using Pending = opcua::PendingRequest;

  /// The call in progress, be it that of a request that has expired.
  struct Asked {
    std::uint64_t serial = 0;
    Instant at{};
  };

  /// A call that its caller waits for; it goes before all requests that have not been sent.
  struct Exchange {
    std::uint64_t serial = 0;  ///< 0: not sent yet
    std::optional<Answer> answer;
  };

  [[nodiscard]] base::Error error(LinkError code) const {
    return base::makeError(code, opcua::sentenceOf(code), endpoint());
  }
  [[nodiscard]] base::Error lossError() const {
    return m_isSilent ? opcua::silenceError(m_options.silenceMax, endpoint())
                      : error(LinkError::ConnectionLost);
  }

  [[nodiscard]] Pending newPending(Operation operation, Duration deadline) {
    return opcua::newRequest(++m_lastId, operation, now(), deadline);
  }
  base::RequestId begin(Pending pending);
  [[nodiscard]] std::uint64_t nextSerial();
  void take(Answer answer);
  static void takeRead(Pending& pending, const Answer& answer);
  static void takeWrite(Pending& pending, const Answer& answer);
  static void takeCall(Pending& pending, const Answer& answer);
  void step(Instant until);
  void settle();
  void finishAnswered();
  void expire(Instant time);
  void noticeState();
  void noticeLoss();
  void sendDue();
  void send(Pending& pending);
  void fail(Pending& pending, base::Error error);
  const QString& nodeOf(const Variable& first, std::size_t length, Grouping grouping);

  /// Makes a call as soon as it can be made. @param ask  given the serial of the call
  [[nodiscard]] base::Result<Answer> exchange(const std::function<void(std::uint64_t)>& ask,
                                              Operation operation, const std::string& subject,
                                              Instant deadline);
  /// Attributes of some nodes. One result per item.
  [[nodiscard]] base::Result<QList<QOpcUaReadResult>> readItems(const QList<QOpcUaReadItem>& items,
                                                                Instant deadline);
  [[nodiscard]] base::Result<bool> exists(int nameSpace, std::string_view identifier,
                                          Instant deadline);
  [[nodiscard]] base::Result<void> resolveNamespaces(Instant deadline);

  /// Where the methods are that a SINUMERIK does not have.
  struct Commands {
    int nameSpace = 0;
    std::string_view object;
    opcua::Abilities abilities;
    bool tracePieces = false;  ///< `kFetchTracePiece`
  };

  opcua::ConnectOptions m_options;
  opcua::MonotonicClock m_clock;
  ClientThread m_thread;
  int m_namespace = 0;
  bool m_isVirtual = false;
  std::optional<Commands> m_commands;
  std::string_view m_fileMethods = opcua::kMethodsObject;  ///< where this edition keeps them
  std::map<std::tuple<Variable, std::size_t, Grouping>, QString> m_nodes;

  std::deque<Pending> m_pending;
  std::deque<Event> m_events;
  std::optional<Asked> m_asked;
  std::optional<Exchange> m_exchange;
  base::RequestId m_lastId;
  std::uint64_t m_lastSerial = 0;
  Instant m_heardAt{};  ///< the last answer, be it late
  bool m_isSilent = false;
  bool m_lost = false;
  bool m_lossReported = false;
};

// --- connection ---------------------------------------------------------------------------------

base::Result<void> QtOpcUaLink::Impl::open() {
  const auto refuse = [&](const char* why) {
    return base::fail(opcua::LinkKindError::NotAble, why, endpoint());
  };
  if (m_options.map != nullptr || !m_options.nodes.empty()) {
    return refuse(
        "The link qtopcua knows the names of a SINUMERIK only. Use the link open62541 with a map.");
  }
  const opcua::SecurityChoice& security = m_options.security;
  if (!m_options.user.empty() || m_options.userCertificate ||
      (security != opcua::unencrypted() && !security.prefersNone)) {
    return refuse(
        "The link qtopcua connects without encryption and without a user only. Use the link "
        "open62541, or allow a connection without encryption.");
  }
  if (auto host = opcua::requireHost(m_options.endpoint); !host) {
    return host;
  }
  const std::uint32_t status =
      m_thread.connect(qt(m_options.endpoint), qt(m_options.name),
                       addSaturating(now(), kConnectDeadlines * m_options.connectDeadline));
  if (status == kNoBackend) {
    return refuse(
        "Qt OPC UA is installed without its plugin for open62541. Install the plugin, or use the "
        "link open62541.");
  }
  if (opcua::isBad(status)) {
    return base::fail(opcua::connectError(status, endpoint()));
  }
  return resolveNamespaces(addSaturating(now(), 2 * m_options.connectDeadline));
}

base::Result<void> QtOpcUaLink::Impl::resolveNamespaces(Instant deadline) {
  const auto answer = readItems({QOpcUaReadItem(QString::fromLatin1(kNamespaceArray))}, deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  const QVariantList uris = elementsOf(answer->at(0).value());
  const auto indexOf = [&](std::string_view uri) -> std::optional<int> {
    const qsizetype index = uris.indexOf(QVariant(qt(uri)));
    return index < 0 ? std::nullopt : std::optional(static_cast<int>(index));
  };
  const auto found = indexOf(opcua::kNamespaceUri);
  if (!found) {
    return base::fail(error(LinkError::NamespaceMissing));
  }
  m_namespace = *found;
  // The namespace alone proves nothing; the object itself must be there.
  if (const auto nameSpace = indexOf(opcua::kVirtualNamespaceUri)) {
    const auto isThere = exists(*nameSpace, opcua::kVirtualObject, deadline);
    if (!isThere) {
      return base::fail(isThere.error());
    }
    if (*isThere) {
      m_isVirtual = true;
      const auto givesPieces =
          exists(*nameSpace,
                 opcua::memberIdentifier(opcua::kVirtualObject, opcua::kFetchTracePiece), deadline);
      if (!givesPieces) {
        return base::fail(givesPieces.error());
      }
      m_commands = Commands{*nameSpace, opcua::kVirtualObject, {true, true}, *givesPieces};
      return {};
    }
  }
  if (const auto nameSpace = indexOf(opcua::kBridgeNamespaceUri)) {
    opcua::Abilities abilities;
    for (const auto& [method, ability] : {std::pair(opcua::kCycleStart, &abilities.startsOnRequest),
                                          {opcua::kFetchTrace, &abilities.keepsTrace}}) {
      const auto isThere =
          exists(*nameSpace, opcua::memberIdentifier(opcua::kBridgeObject, method), deadline);
      if (!isThere) {
        return base::fail(isThere.error());
      }
      *ability = *isThere;
    }
    m_commands = Commands{*nameSpace, opcua::kBridgeObject, abilities, false};
  }
  return {};
}

base::Result<bool> QtOpcUaLink::Impl::exists(int nameSpace, std::string_view identifier,
                                             Instant deadline) {
  const auto answer =
      readItems({QOpcUaReadItem(nodeText(nameSpace, identifier), QOpcUa::NodeAttribute::NodeClass)},
                deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  return answer->at(0).value().isValid() && !opcua::isBad(statusOf(answer->at(0).statusCode()));
}

base::Result<opcua::ServerIdentity> QtOpcUaLink::Impl::identity() {
  QList<QOpcUaReadItem> items;
  for (const char* node : {kServerArray, kProductName, kSoftwareVersion, kBuildNumber}) {
    items.append(QOpcUaReadItem(QString::fromLatin1(node)));
  }
  const auto answer = readItems(items, addSaturating(now(), m_options.commandDeadline));
  if (!answer) {
    return base::fail(answer.error());
  }
  opcua::ServerIdentity identity;
  // The first entry of its server array is the server itself.
  const QVariantList servers = elementsOf(answer->at(0).value());
  if (!servers.isEmpty()) {
    identity.applicationUri = servers.at(0).toString().toStdString();
  }
  const auto text = [&](qsizetype item) {
    return textOf(answer->at(item).value()).value_or(std::string());
  };
  identity.productName = text(1);
  identity.softwareVersion = text(2);
  identity.buildNumber = text(3);
  return identity;
}

base::Result<bool> QtOpcUaLink::Impl::mayWrite(const Variable& variable) {
  const auto answer = readItems(
      {QOpcUaReadItem(nodeOf(variable, 1, Grouping::List), QOpcUa::NodeAttribute::UserAccessLevel)},
      addSaturating(now(), m_options.commandDeadline));
  if (!answer) {
    return base::fail(answer.error());
  }
  const std::uint32_t status = statusOf(answer->at(0).statusCode());
  if (opcua::isBad(status)) {
    return base::fail(
        opcua::requestError(status, Operation::Read, opcua::nodeIdentifier(variable)));
  }
  constexpr unsigned kCurrentWrite = 2;  // @source OPC UA part 3, 8.57
  const auto level = numberOf(answer->at(0).value());
  return level && (static_cast<unsigned>(*level) & kCurrentWrite) != 0;
}

// --- requests -----------------------------------------------------------------------------------

base::RequestId QtOpcUaLink::Impl::request(Operation operation, std::vector<Variable> variables,
                                           std::vector<double> values, Duration deadline,
                                           Grouping grouping) {
  Pending pending = newPending(operation, deadline);
  pending.grouping = grouping;
  pending.variables = std::move(variables);
  pending.values = std::move(values);
  noticeLoss();  // comes before this request
  if (m_lost) {
    fail(pending, error(LinkError::ConnectionLost));
  } else if (const auto fault = opcua::requestFault(pending.variables, pending.values)) {
    fail(pending, error(*fault));
  } else if (pending.variables.empty()) {
    m_events.push_back(std::move(pending.event));  // nothing to request from the server
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

base::RequestId QtOpcUaLink::Impl::store(const std::string& name, const std::string& text,
                                         Duration deadline) {
  Pending pending = newPending(Operation::Call, deadline);
  pending.path = opcua::programPath(name);
  pending.text = text;
  return begin(std::move(pending));
}

base::RequestId QtOpcUaLink::Impl::readTrace(const trace::TracePosition& from, Duration deadline) {
  if (!givesTracePieces()) {
    return {};
  }
  Pending pending = newPending(Operation::Call, deadline);
  pending.event.kind = EventKind::TraceDone;
  pending.from = from;
  return begin(std::move(pending));
}

base::RequestId QtOpcUaLink::Impl::begin(Pending pending) {
  noticeLoss();  // comes before this request
  if (m_lost) {
    fail(pending, error(LinkError::ConnectionLost));
  } else {
    m_pending.push_back(std::move(pending));
    sendDue();
  }
  return m_lastId;
}

const QString& QtOpcUaLink::Impl::nodeOf(const Variable& first, std::size_t length,
                                         Grouping grouping) {
  const Grouping form = length > 1 ? grouping : Grouping::List;
  const auto [entry, isNew] = m_nodes.try_emplace({first, length, form});
  if (isNew) {
    entry->second =
        nodeText(m_namespace,
                 length > 1 ? opcua::arrayIdentifier({first.index, static_cast<int>(length), form})
                            : opcua::nodeIdentifier(first));
  }
  return entry->second;
}

std::uint64_t QtOpcUaLink::Impl::nextSerial() {
  m_asked = Asked{++m_lastSerial, now()};
  return m_lastSerial;
}

void QtOpcUaLink::Impl::sendDue() {
  if (m_lost || m_asked || (m_exchange && m_exchange->serial == 0) || m_pending.empty()) {
    return;
  }
  send(m_pending.front());  // nothing is under way, so the oldest one has something to send
}

void QtOpcUaLink::Impl::send(Pending& pending) {
  pending.serial = nextSerial();
  if (pending.operation == Operation::Call) {
    pending.itemsSent = 1;
    if (pending.from) {
      m_thread.call(pending.serial, nodeText(m_commands->nameSpace, m_commands->object),
                    nodeText(m_commands->nameSpace,
                             opcua::memberIdentifier(m_commands->object, opcua::kFetchTracePiece)),
                    traceInputs(*pending.from));
      return;
    }
    m_thread.call(
        pending.serial, nodeText(m_namespace, m_fileMethods),
        nodeText(m_namespace, opcua::memberIdentifier(m_fileMethods, opcua::kCopyToServer)),
        {textInput(pending.path),
         bytesInput(pending.text),
         {QVariant(true), QOpcUa::Types::Boolean}});
    return;
  }
  const std::size_t first = pending.itemsSent;
  pending.itemsSent +=
      pending.grouping == Grouping::Single ? std::size_t{1} : pending.variables.size();
  QList<QOpcUaReadItem> reads;
  QList<QOpcUaWriteItem> writes;
  for (std::size_t item = first; item < pending.itemsSent;) {
    const std::size_t length = opcua::sharedNodeLength(pending.variables, item, pending.grouping);
    const QString& node = nodeOf(pending.variables[item], length, pending.grouping);
    if (pending.operation == Operation::Read) {
      reads.append(QOpcUaReadItem(node));
    } else if (length == 1) {
      writes.append(QOpcUaWriteItem(node, QOpcUa::NodeAttribute::Value,
                                    QVariant(pending.values[item]), QOpcUa::Types::Double));
    } else {
      QVariantList values;
      for (std::size_t i = 0; i < length; ++i) {
        values.append(pending.values[item + i]);
      }
      writes.append(QOpcUaWriteItem(node, QOpcUa::NodeAttribute::Value, QVariant(values),
                                    QOpcUa::Types::Double));
    }
    item += length;
  }
  if (pending.operation == Operation::Read) {
    m_thread.read(pending.serial, std::move(reads));
  } else {
    m_thread.write(pending.serial, std::move(writes));
  }
}

void QtOpcUaLink::Impl::take(Answer answer) {
  m_heardAt = answer.at;
  if (m_asked && m_asked->serial == answer.serial) {
    m_asked.reset();
  }
  if (opcua::meansConnectionLost(answer.status)) {
    m_lost = true;
    return;
  }
  if (m_exchange && m_exchange->serial == answer.serial) {
    m_exchange->answer = std::move(answer);
    return;
  }
  const auto pending = std::find_if(m_pending.begin(), m_pending.end(),
                                    [&](const Pending& p) { return p.serial == answer.serial; });
  if (pending == m_pending.end()) {
    return;  // it has expired
  }
  pending->serial = 0;
  pending->event.at = answer.at;
  if (opcua::isBad(answer.status)) {
    pending->failure = answer.status;
    pending->done = true;
  } else if (pending->operation == Operation::Read) {
    takeRead(*pending, answer);
  } else if (pending->operation == Operation::Write) {
    takeWrite(*pending, answer);
  } else {
    takeCall(*pending, answer);
  }
}

void QtOpcUaLink::Impl::takeCall(Pending& pending, const Answer& answer) {
  pending.done = true;
  if (!pending.from) {
    return;
  }
  if (auto piece = tracePieceOf(answer.outputs)) {
    pending.event.trace = std::make_shared<const trace::TracePiece>(*std::move(piece));
  } else {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
}

void QtOpcUaLink::Impl::takeRead(Pending& pending, const Answer& answer) {
  std::vector<Reading>& readings = pending.event.readings;
  for (const QOpcUaReadResult& result : answer.readings) {
    if (readings.size() == pending.itemsSent) {
      break;
    }
    const std::size_t length =
        opcua::sharedNodeLength(pending.variables, readings.size(), pending.grouping);
    if (length > 1) {
      appendReadings(result, length, readings);
    } else {
      readings.push_back(readingOf(result, pending.variables[readings.size()].kind));
    }
  }
  if (readings.size() != pending.itemsSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  pending.done =
      pending.failure != UA_STATUSCODE_GOOD || readings.size() == pending.variables.size();
}

void QtOpcUaLink::Impl::takeWrite(Pending& pending, const Answer& answer) {
  std::vector<std::error_code>& statuses = pending.event.statuses;
  for (const QOpcUaWriteResult& result : answer.writes) {
    if (statuses.size() == pending.itemsSent) {
      break;
    }
    const std::size_t length =
        opcua::sharedNodeLength(pending.variables, statuses.size(), pending.grouping);
    const std::uint32_t status = statusOf(result.statusCode());
    statuses.insert(statuses.end(), length,
                    opcua::isBad(status)
                        ? make_error_code(opcua::linkErrorOf(status, Operation::Write))
                        : std::error_code());
  }
  if (statuses.size() != pending.itemsSent) {
    pending.failure = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  pending.done =
      pending.failure != UA_STATUSCODE_GOOD || statuses.size() == pending.variables.size();
}

void QtOpcUaLink::Impl::fail(Pending& pending, base::Error error) {
  Event event;
  event.kind = EventKind::RequestFailed;
  event.request = pending.id;
  event.sent = pending.event.sent;
  event.at = now();
  event.error = std::move(error);
  m_events.push_back(std::move(event));
}

void QtOpcUaLink::Impl::finishAnswered() {
  for (Pending& pending : m_pending) {
    if (!pending.done) {
      continue;
    }
    if (opcua::isBad(pending.failure)) {
      fail(pending, opcua::requestError(pending.failure, pending.operation, endpoint()));
    } else {
      m_events.push_back(std::move(pending.event));
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

void QtOpcUaLink::Impl::expire(Instant time) {
  for (Pending& pending : m_pending) {
    if (pending.deadline <= time) {
      fail(pending, error(LinkError::DeadlineExceeded));
      pending.done = true;
    }
  }
  std::erase_if(m_pending, [](const Pending& pending) { return pending.done; });
}

Duration QtOpcUaLink::Impl::silence() const {
  return m_asked ? now() - std::max(m_heardAt, m_asked->at) : Duration{};
}

void QtOpcUaLink::Impl::noticeState() {
  m_lost = m_lost || m_thread.isLost();
  if (!m_lost && silence() > m_options.silenceMax) {
    m_lost = true;
    m_isSilent = true;
  }
}

void QtOpcUaLink::Impl::noticeLoss() {
  if (!m_lost || m_lossReported) {
    return;
  }
  m_lossReported = true;
  m_pending.clear();
  Event event;
  event.kind = EventKind::ConnectionLost;
  event.at = now();
  event.sent = event.at;
  event.error = lossError();
  m_events.push_back(std::move(event));
}

void QtOpcUaLink::Impl::settle() {
  finishAnswered();
  noticeState();
  if (!m_lost) {
    expire(now());
    sendDue();
  }
  noticeLoss();
}

void QtOpcUaLink::Impl::step(Instant until) {
  Instant limit = until;
  for (const Pending& pending : m_pending) {
    limit = std::min(limit, pending.deadline);
  }
  if (m_asked) {
    limit = std::min(limit, addSaturating(now() - silence(), m_options.silenceMax));
  }
  if (auto answer = m_thread.take(limit)) {
    take(std::move(*answer));
  }
  settle();
}

std::optional<Event> QtOpcUaLink::Impl::wait(Instant until) {
  // Deadlines are checked only after the answers: one that arrived in time counts, however late the
  // caller asks for it.
  noticeLoss();
  for (bool looked = false; m_events.empty(); looked = true) {
    if (looked && now() >= until) {
      return std::nullopt;
    }
    if (m_lost) {
      m_clock.sleepUntil(until);  // nothing can arrive any more
    } else {
      step(until);
    }
  }
  Event event = std::move(m_events.front());
  m_events.pop_front();
  return event;
}

// --- methods ------------------------------------------------------------------------------------

base::Result<Answer> QtOpcUaLink::Impl::exchange(const std::function<void(std::uint64_t)>& ask,
                                                 Operation operation, const std::string& subject,
                                                 Instant deadline) {
  m_exchange = Exchange{};
  std::uint32_t status = UA_STATUSCODE_GOOD;
  while (status == UA_STATUSCODE_GOOD && !m_exchange->answer) {
    if (m_lost) {
      status = UA_STATUSCODE_BADCONNECTIONCLOSED;
    } else if (now() >= deadline) {
      status = UA_STATUSCODE_BADTIMEOUT;
    } else {
      if (!m_asked && m_exchange->serial == 0) {
        m_exchange->serial = nextSerial();
        ask(m_exchange->serial);
      }
      step(deadline);
    }
  }
  std::optional<Answer> answer = std::move(m_exchange->answer);
  m_exchange.reset();
  settle();
  status = answer ? answer->status : status;
  if (opcua::isBad(status)) {
    return base::fail(m_isSilent ? lossError() : opcua::requestError(status, operation, subject));
  }
  return std::move(*answer);
}

base::Result<QList<QOpcUaReadResult>> QtOpcUaLink::Impl::readItems(
    const QList<QOpcUaReadItem>& items, Instant deadline) {
  auto answer = exchange([&](std::uint64_t serial) { m_thread.read(serial, items); },
                         Operation::Read, endpoint(), deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  if (answer->readings.size() != items.size()) {
    return base::fail(
        opcua::requestError(UA_STATUSCODE_BADUNKNOWNRESPONSE, Operation::Read, endpoint()));
  }
  return answer->readings;
}

base::Result<QVariant> QtOpcUaLink::Impl::call(int nameSpace, std::string_view object,
                                               std::string_view method,
                                               const QList<QOpcUa::TypedVariant>& inputs) {
  const std::string identifier = opcua::memberIdentifier(object, method);
  auto answer = exchange(
      [&](std::uint64_t serial) {
        m_thread.call(serial, nodeText(nameSpace, object), nodeText(nameSpace, identifier), inputs);
      },
      Operation::Call, identifier, addSaturating(now(), m_options.commandDeadline));
  if (!answer) {
    return base::fail(answer.error());
  }
  return answer->outputs;
}

base::Result<QVariant> QtOpcUaLink::Impl::callFileMethod(
    std::string_view method, const QList<QOpcUa::TypedVariant>& inputs) {
  auto answer = call(m_namespace, m_fileMethods, method, inputs);
  if (!answer && answer.error().code == LinkError::MethodMissing) {
    const std::string_view other =
        m_fileMethods == opcua::kMethodsObject ? opcua::kFileMethodsObject : opcua::kMethodsObject;
    answer = call(m_namespace, other, method, inputs);
    m_fileMethods = answer ? other : m_fileMethods;
  }
  return answer;
}

base::Result<QVariant> QtOpcUaLink::Impl::callBeyond(std::string_view method,
                                                     const QList<QOpcUa::TypedVariant>& inputs) {
  if (!m_commands) {
    return base::fail(opcua::onlyVirtual(endpoint()));
  }
  return call(m_commands->nameSpace, m_commands->object, method, inputs);
}

// --- the public face ----------------------------------------------------------------------------

QtOpcUaLink::QtOpcUaLink(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
QtOpcUaLink::~QtOpcUaLink() = default;

base::Result<std::unique_ptr<QtOpcUaLink>> QtOpcUaLink::connect(
    const opcua::ConnectOptions& options) {
  auto impl = std::make_unique<Impl>(options);
  if (auto opened = impl->open(); !opened) {
    return base::fail(opened.error());
  }
  return std::unique_ptr<QtOpcUaLink>(new QtOpcUaLink(std::move(impl)));
}

base::Result<opcua::Connection> openQtConnection(const opcua::ConnectOptions& options) {
  auto opened = QtOpcUaLink::connect(options);
  if (!opened) {
    return base::fail(opened.error());
  }
  const std::shared_ptr<QtOpcUaLink> link = std::move(*opened);
  return opcua::Connection{link, link.get(), link.get(), options.endpoint,
                           opcua::ChannelSecurity{}};
}

base::Instant QtOpcUaLink::now() const {
  return m_impl->now();
}

base::RequestId QtOpcUaLink::read(std::span<const Variable> variables, base::Duration deadline,
                                  Grouping grouping) {
  return m_impl->request(Operation::Read, {variables.begin(), variables.end()}, {}, deadline,
                         grouping);
}

base::RequestId QtOpcUaLink::write(std::span<const Assignment> assignments, base::Duration deadline,
                                   Grouping grouping) {
  opcua::Targets targets = opcua::targetsOf(assignments);
  return m_impl->request(Operation::Write, std::move(targets.variables), std::move(targets.values),
                         deadline, grouping);
}

base::RequestId QtOpcUaLink::store(const std::string& name, const std::string& text,
                                   base::Duration deadline) {
  return m_impl->store(name, text, deadline);
}

base::RequestId QtOpcUaLink::readTrace(const trace::TracePosition& from, base::Duration deadline) {
  return m_impl->readTrace(from, deadline);
}

std::optional<Event> QtOpcUaLink::wait(base::Instant until) {
  return m_impl->wait(until);
}

base::Duration QtOpcUaLink::silence() const {
  return m_impl->silence();
}

base::Result<void> QtOpcUaLink::uploadProgram(const std::string& name, const std::string& text,
                                              bool overwrite) {
  const auto answer =
      m_impl->callFileMethod(opcua::kCopyToServer, {textInput(opcua::programPath(name)),
                                                    bytesInput(text),
                                                    {QVariant(overwrite), QOpcUa::Types::Boolean}});
  return answer ? base::Result<void>() : base::fail(answer.error());
}

base::Result<std::string> QtOpcUaLink::downloadProgram(const std::string& name) {
  const auto answer =
      m_impl->callFileMethod(opcua::kCopyFromServer, {textInput(opcua::programPath(name))});
  return answer ? bytesOutput(*answer, 0, opcua::kCopyFromServer)
                : base::Result<std::string>(base::fail(answer.error()));
}

base::Result<void> QtOpcUaLink::selectProgram(const std::string& name) {
  const auto answer = m_impl->callMethods(
      opcua::kSelect, {textInput(opcua::programPath(name)),
                       {QVariant::fromValue<quint32>(1), QOpcUa::Types::UInt32}});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, opcua::kSelect);
  if (!status) {
    return base::fail(status.error());
  }
  return opcua::commandResult(*status, name);
}

base::Result<opcua::ServerIdentity> QtOpcUaLink::identity() {
  return m_impl->identity();
}

base::Result<std::string> QtOpcUaLink::accessRights() {
  const auto answer = m_impl->callMethods(opcua::kGetMyAccessRights, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  auto rights = textOf(output(*answer, 0));
  return rights ? base::Result<std::string>(std::move(*rights))
                : base::fail(opcua::unknownForm(opcua::kGetMyAccessRights));
}

base::Result<bool> QtOpcUaLink::mayWrite(const Variable& variable) {
  return m_impl->mayWrite(variable);
}

bool QtOpcUaLink::isVirtualMachine() const {
  return m_impl->isVirtual();
}

opcua::Abilities QtOpcUaLink::abilities() const {
  return m_impl->abilities();
}

base::Result<void> QtOpcUaLink::cycleStart() {
  const auto answer = m_impl->callBeyond(opcua::kCycleStart, {});
  if (!answer) {
    return base::fail(answer.error());
  }
  const auto status = statusOutput(*answer, opcua::kCycleStart);
  if (!status) {
    return base::fail(status.error());
  }
  return opcua::commandResult(*status, m_impl->endpoint(),
                              textOf(output(*answer, 1)).value_or(std::string()));
}

base::Result<void> QtOpcUaLink::reset() {
  const auto answer = m_impl->callBeyond(opcua::kReset, {});
  return answer ? base::Result<void>() : base::fail(answer.error());
}

base::Result<trace::TracePiece> QtOpcUaLink::fetchTracePiece(const trace::TracePosition& from) {
  if (!m_impl->givesTracePieces()) {
    return Control::fetchTracePiece(from);
  }
  const auto answer = m_impl->callBeyond(opcua::kFetchTracePiece, traceInputs(from));
  return answer ? tracePieceOf(*answer)
                : base::Result<trace::TracePiece>(base::fail(answer.error()));
}

base::Result<trace::ControlTrace> QtOpcUaLink::fetchTrace() {
  return opcua::joinTrace([this](std::uint64_t from) -> base::Result<opcua::TracePart> {
    const auto answer = m_impl->callBeyond(
        opcua::kFetchTrace, {{QVariant::fromValue<quint64>(from), QOpcUa::Types::UInt64}});
    if (!answer) {
      return base::fail(answer.error());
    }
    auto data = bytesOutput(*answer, 0, opcua::kFetchTrace);
    const auto total = numberOf(output(*answer, 1));
    if (!data || !total) {
      return base::fail(!data ? data.error() : opcua::unknownForm(opcua::kFetchTrace));
    }
    return opcua::TracePart{std::move(*data), static_cast<std::uint64_t>(*total)};
  });
}

}  // namespace rivulet::qtopcua
