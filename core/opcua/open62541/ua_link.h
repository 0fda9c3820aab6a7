// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The connection to a real control: OPC UA with the open62541 library. Wall time.
/// @threadsafety one object, one thread at a time. Starts no thread: the network is served only
/// inside `wait` and inside the calls of `Control`.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "opcua/connection.h"
#include "opcua/node_browser.h"
#include "opcua/node_history.h"
#include "opcua/node_map.h"
#include "opcua/node_watch.h"
#include "opcua/security.h"
#include "opcua/user_certificate.h"

namespace rivulet::opcua {

struct ConnectOptions {
  std::string endpoint;  ///< as typed, e.g. "opc.tcp://192.168.214.1:4840"; used as it stands
  /// For each answer while connecting; altogether six times as long.
  base::Duration connectDeadline = std::chrono::seconds(5);
  /// Of each method of `Control`; longer than a silence that the connection survives.
  base::Duration commandDeadline = std::chrono::seconds(12);
  /// A connection whose other side is silent for longer, although it was asked, is lost.
  base::Duration silenceMax = kSilenceMax;
  std::string name = "Rivulet";  ///< session name the server shows

  /// What the user allows. Unless it is `unencrypted()` without a user, the server is first asked
  /// what it offers.
  SecurityChoice security;
  /// The certificate of this computer, asked for when the first encrypted connection needs it.
  std::function<base::Result<OwnCertificate>()> own;
  /// Told what the server offers, if it is asked. May be empty.
  std::function<void(std::span<const EndpointOffer>)> offered;
  /// Asked before an encrypted connection is opened; without it no server is trusted.
  TrustCheck trust;
  std::string user;  ///< empty: anonymous
  std::string password;
  std::optional<UserCertificate> userCertificate;  ///< instead of user and password
  /// Of a server that is no SINUMERIK. Only these variables are there, and no method is.
  NodeAddresses nodes;
  /// Of a control that is no SINUMERIK; null: `nodes` says what there is, or it is one. An empty
  /// map is for browsing only.
  std::shared_ptr<const ControlMap> map;
};

/// As whom the options log in.
[[nodiscard]] LoginKind loginKindOf(const ConnectOptions& options);

class UaLink final : public Link,
                     public Control,
                     public NodeBrowser,
                     public NodeHistory,
                     public NodeWatch {
 public:
  /// Connects, opens a session and resolves the namespaces. A server that closes the connection is
  /// tried again, each time after a longer pause.
  /// @return HostUnknown, NoHandles, NotReachable, Rejected, NamespaceMissing, EncryptionMissing,
  /// LoginRefused, ClientNotTrusted, VariableMissing for an address that is none,
  /// `MapError::WrongAddress` for one of a map that the server does not have, and what
  /// `ConnectOptions::trust` returns
  [[nodiscard]] static base::Result<std::unique_ptr<UaLink>> connect(const ConnectOptions& options);

  /// Closes the session; blocks a second at most, whatever the other side does.
  ~UaLink() override;
  UaLink(const UaLink&) = delete;
  UaLink& operator=(const UaLink&) = delete;

  /// Time since `connect`.
  [[nodiscard]] base::Instant now() const override;
  base::RequestId read(std::span<const Variable> variables, base::Duration deadline,
                       Grouping grouping) override;
  base::RequestId write(std::span<const Assignment> assignments, base::Duration deadline,
                        Grouping grouping) override;
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override;
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override;
  /// Never returns before `until` without an event, also after the connection is lost.
  /// An answer found in time is reported even if this call came after the request's deadline.
  std::optional<Event> wait(base::Instant until) override;
  [[nodiscard]] base::Duration silence() const override;

  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool overwrite) override;
  base::Result<std::string> downloadProgram(const std::string& name) override;
  base::Result<void> selectProgram(const std::string& name) override;
  base::Result<ServerIdentity> identity() override;
  base::Result<std::string> accessRights() override;
  base::Result<bool> mayWrite(const Variable& variable) override;
  /// How this connection is protected.
  [[nodiscard]] const ChannelSecurity& security() const;
  /// The certificate of the server; nothing without encryption.
  [[nodiscard]] const std::optional<CertificateFacts>& serverCertificate() const;
  [[nodiscard]] bool isVirtualMachine() const override;
  [[nodiscard]] Abilities abilities() const override;
  base::Result<void> cycleStart() override;
  base::Result<void> reset() override;
  base::Result<trace::ControlTrace> fetchTrace() override;
  base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from) override;
  base::Result<std::vector<BrowsedNode>> children(const std::string& address) override;
  base::Result<std::vector<NodeFacts>> examine(std::span<const std::string> addresses) override;
  base::Result<NodeValues> history(const std::string& address, const HistorySpan& span) override;
  base::Result<void> watch(std::span<const std::string> addresses,
                           base::Duration interval) override;
  std::vector<NodeChange> takeChanges() override;
  base::Result<std::vector<NodeValue>> callMethod(const std::string& object,
                                                  const std::string& method,
                                                  std::span<const std::string> inputs) override;

 private:
  class Impl;
  explicit UaLink(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

/// `UaLink::connect`, as a connection that hides which kind of link it has.
[[nodiscard]] base::Result<Connection> openConnection(const ConnectOptions& options);

}  // namespace rivulet::opcua
