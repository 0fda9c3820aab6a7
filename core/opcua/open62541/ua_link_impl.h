// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The inside of `UaLink`. Its functions are in several files: how it connects (`ua_link_connect`),
/// the addresses of a map (`ua_link_map`), what a server has (`ua_link_browse`), has recorded
/// (`ua_link_history`), what it tells by
/// itself (`ua_link_watch`), its methods (`ua_link_call`), and requests (`ua_link`).
/// @threadsafety as `UaLink`.
#pragma once

#include <open62541/client.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "opcua/control_map.h"
#include "opcua/node_map.h"
#include "opcua/open62541/client_wire.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/monotonic_clock.h"
#include "opcua/open62541/quiet_logger.h"
#include "opcua/open62541/secure_endpoint.h"
#include "opcua/open62541/status.h"
#include "opcua/open62541/ua_link.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using CallResponse = Handle<UA_CallResponse, UA_TYPES_CALLRESPONSE>;
using ReadResponse = Handle<UA_ReadResponse, UA_TYPES_READRESPONSE>;
using HistoryResponse = Handle<UA_HistoryReadResponse, UA_TYPES_HISTORYREADRESPONSE>;
using NodeId = Handle<UA_ExpandedNodeId, UA_TYPES_EXPANDEDNODEID>;

/// Longest single wait inside the library; its timers run in between.
inline constexpr base::Duration kIterationMax = std::chrono::milliseconds(200);

/// A unit of a request: a variable, or consecutive R-parameters.
struct Node {
  Variable first;
  std::size_t length = 1;
  Grouping form = Grouping::List;  ///< an array form if the length is above 1, else List

  friend bool operator==(const Node&, const Node&) = default;
};

/// A control has far fewer variables of one kind than fit below the kind's bits.
struct NodeHash {
  [[nodiscard]] std::size_t operator()(const Node& node) const {
    constexpr unsigned kIndexBits = 20;
    constexpr unsigned kLengthBits = 20;
    constexpr unsigned kKindBits = 8;
    std::size_t hash = static_cast<std::size_t>(node.form);
    hash = (hash << kKindBits) ^ static_cast<std::size_t>(node.first.kind);
    hash = (hash << kLengthBits) ^ node.length;
    return (hash << kIndexBits) ^ static_cast<std::size_t>(node.first.index);
  }
};

class UaLink::Impl {
 public:
  explicit Impl(ConnectOptions options) : m_options(std::move(options)) {}
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] base::Result<void> open();

  [[nodiscard]] base::Instant now() const { return m_clock.now(); }
  [[nodiscard]] base::Result<ServerIdentity> identity();
  [[nodiscard]] bool isVirtual() const { return m_isVirtual; }
  [[nodiscard]] Abilities abilities() const {
    return m_commands ? m_commands->abilities : Abilities{};
  }
  [[nodiscard]] const std::string& endpoint() const { return m_options.endpoint; }
  [[nodiscard]] const ChannelSecurity& security() const { return m_security; }
  [[nodiscard]] const std::optional<CertificateFacts>& serverCertificate() const {
    return m_certificate;
  }
  [[nodiscard]] base::Result<bool> mayWrite(const Variable& variable);
  [[nodiscard]] base::Result<std::vector<BrowsedNode>> children(const std::string& address);
  [[nodiscard]] base::Result<std::vector<NodeFacts>> examine(
      std::span<const std::string> addresses);
  [[nodiscard]] base::Result<NodeValues> history(const std::string& address,
                                                 const HistorySpan& span);
  /// Of a program in the control's file system.
  [[nodiscard]] std::string pathOf(std::string_view name) const {
    return isMapped() ? mappedProgramPath(m_map->methods, name) : programPath(name);
  }

  base::RequestId request(Operation operation, std::vector<Variable> variables,
                          std::vector<double> values, base::Duration deadline, Grouping grouping);
  base::RequestId store(const std::string& name, const std::string& text, base::Duration deadline);
  [[nodiscard]] bool givesTracePieces() const { return m_commands && m_commands->tracePieces; }
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline);
  std::optional<Event> wait(base::Instant until);
  [[nodiscard]] base::Duration silence() const;

  /// Calls a method and waits for its answer. @return its output arguments
  [[nodiscard]] base::Result<CallResponse> call(UA_UInt16 namespaceIndex, std::string_view object,
                                                std::string_view method,
                                                std::span<UA_Variant> inputs);
  /// Calls a method of the control's file system, wherever this edition keeps it.
  [[nodiscard]] base::Result<CallResponse> callFileMethod(std::string_view method,
                                                          std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<CallResponse> callMethods(std::string_view method,
                                                       std::span<UA_Variant> inputs) {
    return isMapped() ? callMapped(method, inputs)
                      : call(m_namespace, kMethodsObject, method, inputs);
  }
  [[nodiscard]] base::Result<CallResponse> callBeyond(std::string_view method,
                                                      std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<void> watch(std::span<const std::string> addresses,
                                         base::Duration interval);
  [[nodiscard]] std::vector<NodeChange> takeChanges() { return std::exchange(m_changes, {}); }
  [[nodiscard]] base::Result<std::vector<NodeValue>> callMethod(
      const std::string& object, const std::string& method, std::span<const std::string> inputs);

 private:
  struct Pending : PendingRequest {
    std::size_t nodesSent = 0;  ///< of the service call in progress
  };

  /// One call of `exchange`.
  struct Exchange {
    std::uint64_t serial = 0;
    void* response = nullptr;
    const UA_DataType* responseType = nullptr;
    bool answered = false;
  };

  static void onAnswer(UA_Client* client, void* serial, UA_UInt32 requestId,
                       void* response) noexcept;
  static void onState(UA_Client* client, UA_SecureChannelState channel, UA_SessionState session,
                      UA_StatusCode status) noexcept;
  void answered(std::uint64_t serial, void* response);
  void takeRead(Pending& pending, const UA_ReadResponse& response);
  void takeWrite(Pending& pending, const UA_WriteResponse& response);
  static void takeCall(Pending& pending, const UA_CallResponse& response);
  void takePublish(const UA_PublishResponse& response);
  /// Asks for what the subscription has to tell next; the server answers when there is something.
  void publish();

  [[nodiscard]] base::Error error(LinkError code) const;
  [[nodiscard]] base::Error connectError(UA_StatusCode status) const {
    return opcua::connectError(status, endpoint());
  }

  /// A client that is not connected yet, in place of the present one.
  /// @param endpoint  null: without encryption, whatever the server names
  [[nodiscard]] base::Result<void> createClient(const SecureEndpoint* endpoint);
  void deleteClient();
  [[nodiscard]] base::Result<SecureEndpoint> discover();
  [[nodiscard]] base::Result<void> checkServer(const SecureEndpoint& endpoint);
  [[nodiscard]] base::Result<void> handshake();
  /// After the server has closed the connection while connecting. @return the new status
  [[nodiscard]] UA_StatusCode reconnect(bool wasOpen, base::Instant deadline);
  [[nodiscard]] bool pauseBefore(base::Instant deadline);
  void close();
  /// Notes that a service call is about to be made.
  [[nodiscard]] std::uint64_t nextSerial();
  /// Calls that nobody waits for any more and that the server may still answer.
  [[nodiscard]] std::size_t unanswered() const;
  void noticeState();
  [[nodiscard]] base::Error lossError() const;
  void step(base::Instant until);
  void settle();
  void finishAnswered();
  void expire(base::Instant now);
  [[nodiscard]] Pending newPending(Operation operation, base::Duration deadline) {
    return {newRequest(++m_lastId, operation, now(), deadline)};
  }
  /// Takes the call of a method. @param hasMethod  false: the server has none
  base::RequestId begin(Pending pending, bool hasMethod);
  void sendDue();
  void send(Pending& pending);
  [[nodiscard]] UA_StatusCode sendCall(Pending& pending, void* serial);
  void fail(Pending& pending, base::Error error);
  void noticeLoss();
  /// Where a variable is on a server that is no SINUMERIK.
  struct Address {
    NodeId id;          ///< null: nowhere; every server refuses it
    std::string range;  ///< elements of an array; empty: the whole value

    [[nodiscard]] bool isNowhere() const { return UA_NodeId_isNull(&id->nodeId); }
  };
  struct MethodAddress {
    NodeId object;
    NodeId method;
  };

  /// Whether variables have the addresses of a map, be it of a control or of anything else.
  [[nodiscard]] bool isMapped() const { return m_map != nullptr; }
  [[nodiscard]] const std::string& identifier(const Node& node);
  /// Borrows; valid as long as the connection. @param range  set for elements of an array
  [[nodiscard]] UA_NodeId nodeId(const Node& node, UA_String& range);
  [[nodiscard]] const Address& addressOf(const Node& node);
  [[nodiscard]] Reading nowhere(const Variable& variable) const;
  /// Why the values cannot be written into cells of type Float; nothing: they can.
  [[nodiscard]] std::optional<base::Error> lostByFloat(const Pending& pending) const;
  void restoreMeant(const Variable& variable, Reading& reading) const;
  void noteFloats(const Pending& pending);
  /// In the type of the cells; valid until the next request.
  [[nodiscard]] void* numberToSend(Pending& pending, std::size_t item);
  [[nodiscard]] base::Result<void> resolveMap();
  [[nodiscard]] base::Result<void> resolveVariables();
  [[nodiscard]] base::Result<void> resolveMethods();
  [[nodiscard]] base::Result<void> checkAddresses();
  [[nodiscard]] base::Result<NodeId> resolve(const std::string& address, const std::string& key);
  [[nodiscard]] base::Result<NodeId> resolvePath(const std::string& path, const std::string& key);
  /// Nothing for a text that is no node id of this server.
  [[nodiscard]] std::optional<NodeId> parsed(const std::string& address) const;
  /// @param isLast  the server may forget the rest; there is no answer then
  [[nodiscard]] UA_StatusCode askForHistory(const UA_HistoryReadValueId& item,
                                            const HistorySpan& span, bool isLast,
                                            HistoryResponse& response);
  [[nodiscard]] base::Error historyRefusal(UA_StatusCode status, const std::string& address);
  [[nodiscard]] std::string addressText(const UA_NodeId& id) const;
  [[nodiscard]] base::Error wrongAddress(const std::string& key, const std::string& what) const;
  [[nodiscard]] base::Result<CallResponse> callMapped(std::string_view method,
                                                      std::span<UA_Variant> inputs);
  [[nodiscard]] base::Result<CallResponse> callNode(const UA_NodeId& object,
                                                    const UA_NodeId& method,
                                                    const std::string& name,
                                                    std::span<UA_Variant> inputs);
  void appendChildren(const UA_BrowseResult& result, std::vector<BrowsedNode>& nodes) const;

  [[nodiscard]] UA_StatusCode exchange(const void* request, const UA_DataType* requestType,
                                       void* response, const UA_DataType* responseType,
                                       base::Instant deadline);
  [[nodiscard]] base::Result<void> resolveNamespaces(base::Instant deadline);
  [[nodiscard]] base::Result<bool> exists(const UA_NodeId& node, base::Instant deadline);
  [[nodiscard]] base::Result<ReadResponse> readAttribute(const UA_NodeId& node,
                                                         UA_AttributeId attribute,
                                                         base::Instant deadline);

  ConnectOptions m_options;
  ChannelSecurity m_security;
  std::optional<CertificateFacts> m_certificate;
  OwnCertificate m_own;
  std::optional<SecureEndpoint> m_secureEndpoint;  ///< the library refers to it
  MonotonicClock m_clock;
  QuietLogger m_logger;
  std::optional<ClientWire> m_wire;  ///< of `m_client`
  UA_Client* m_client = nullptr;
  UA_UInt16 m_namespace = 0;
  /// Where the methods are that a SINUMERIK does not have.
  struct Commands {
    UA_UInt16 nameSpace = 0;
    std::string_view object;
    Abilities abilities;
    bool tracePieces = false;  ///< `kFetchTracePiece`
  };
  bool m_isVirtual = false;
  std::optional<Commands> m_commands;
  std::string_view m_fileMethods = kMethodsObject;  ///< where this edition keeps them

  /// Requests borrow from both: their elements stay where they are.
  std::unordered_map<Node, std::string, NodeHash> m_identifiers;
  std::shared_ptr<const ControlMap> m_map;  ///< null: names of a SINUMERIK
  std::map<Variable, Address> m_addressed;
  std::unordered_map<Node, Address, NodeHash> m_blocks;  ///< of several cells
  /// Cells of type Float.
  struct FloatCells {
    bool exist = false;
    std::map<int, double> meant;  ///< last value sent, by R number
  };
  FloatCells m_floatCells;
  /// Of `send`.
  struct Scratch {
    std::vector<float> floats;
    std::vector<Node> nodes;
    std::vector<UA_ReadValueId> readItems;
    std::vector<UA_WriteValue> writeItems;
  };
  Scratch m_scratch;
  std::map<std::string_view, MethodAddress> m_methods;        ///< by the SINUMERIK's names
  std::map<std::string, std::vector<BrowsedNode>> m_browsed;  ///< while paths are resolved
  std::vector<std::string> m_namespaces;

  std::deque<Pending> m_pending;
  std::deque<Event> m_events;
  Exchange m_exchange;
  struct Subscription {
    UA_UInt32 id = 0;
    std::uint64_t serial = 0;              ///< of the request that is open; 0: none
    std::optional<UA_UInt32> unconfirmed;  ///< number of the message that was heard last
    std::size_t items = 0;
  };
  std::optional<Subscription> m_subscription;
  std::vector<NodeChange> m_changes;
  base::RequestId m_lastId;
  struct Asked {
    std::uint64_t serial = 0;
    base::Instant at{};
  };
  struct Calls {
    std::uint64_t last = 0;   ///< serial number
    std::deque<Asked> asked;  ///< not answered by the server, in the order in which they were made
  };
  Calls m_calls;
  /// What became of the connection.
  struct Connection {
    base::Instant heardAt{};  ///< the last answer, be it late
    int handshakes = 0;
    int retries = 0;
    bool isSilent = false;        ///< the reason of the loss
    bool isSessionEnded = false;  ///< the same: by the server
    bool isEstablished = false;   ///< from now on a bad state is a loss
    bool hasActivity = false;     ///< a callback has run
    bool isLost = false;
    bool isLossReported = false;
  };
  Connection m_connection;
};

}  // namespace rivulet::opcua
