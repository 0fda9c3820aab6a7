// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An open connection to a control, whatever made it. @threadsafety that of `Link`.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/result.h"
#include "opcua/link.h"
#include "opcua/node_map.h"
#include "opcua/security.h"
#include "opcua/user_certificate.h"

namespace rivulet::opcua {

class NodeBrowser;
class NodeHistory;
struct ControlMap;

/// Which library makes the connection.
enum class LinkKind {
  Open62541,  ///< `UaLink`
  QtOpcUa,    ///< Qt OPC UA, where it was found when Rivulet was built
};

enum class LinkKindError {
  NotBuilt = 1,  ///< this build does not have the library
  NotAble,       ///< the library cannot make such a connection
};
[[nodiscard]] std::error_code make_error_code(LinkKindError code);

struct Connection {
  std::shared_ptr<void> owner;  ///< keeps both interfaces alive
  Link* link = nullptr;
  Control* control = nullptr;
  std::string name;  ///< the endpoint, or how the simulation was made
  /// Of a connection over a network; nothing in virtual time.
  std::optional<ChannelSecurity> security = std::nullopt;
  /// Of the server; nothing without encryption.
  std::optional<CertificateFacts> certificate = std::nullopt;
  NodeBrowser* browser = nullptr;  ///< of a connection with `LinkKind::Open62541`
  /// That the connection was made with; null: the control is a SINUMERIK.
  std::shared_ptr<const ControlMap> map = nullptr;
  NodeHistory* history = nullptr;  ///< of a connection with `LinkKind::Open62541`

  explicit operator bool() const { return link != nullptr; }
};

/// What a connection is asked for.
struct ConnectRequest {
  std::string endpoint;
  std::string sessionName = "Rivulet";
  /// Chosen now; remembered for this server once the connection is open. Nothing: as it was
  /// allowed before; else the strongest. A server on this computer that has never been connected
  /// encrypted is then connected without encryption, if it offers that and no user is given: what
  /// is sent does not leave the computer.
  std::optional<SecurityChoice> security = std::nullopt;
  /// A certificate that is accepted now, whatever was accepted before.
  std::string fingerprint = {};
  std::string user = {};  ///< empty: anonymous
  std::string password = {};
  /// Instead of user and password.
  std::optional<UserCertificate> userCertificate = std::nullopt;
  /// Of a server that is no SINUMERIK; empty: the nodes have the names of `node_map`.
  NodeAddresses nodes = {};
  /// Of a control that is no SINUMERIK; null: it is one, or `nodes` says what it has.
  std::shared_ptr<const ControlMap> map = nullptr;
  LinkKind link = LinkKind::Open62541;
};

/// What a person can decide after an attempt was refused. The answer is another attempt.
struct TrustQuestion {
  enum class Kind {
    NewServer,      ///< its certificate has never been accepted; answer: `fingerprint`
    ChangedServer,  ///< another one has been accepted; answer: `fingerprint`
    Protection,     ///< the strongest is not offered; answer: `security`, one of `choices`
    Login,          ///< user or password are missing, wrong or not taken; answer: both
  };
  Kind kind = Kind::NewServer;
  std::string endpoint;
  CertificateFacts shown{};           ///< by the server that is new or changed
  bool isValidNow = false;            ///< `shown` has begun and not ended
  std::string acceptedFingerprint{};  ///< of the server that has changed
  std::optional<CertificateFacts> accepted = std::nullopt;  ///< nothing: not kept
  std::vector<SecurityChoice> choices{};                    ///< from strong to weak; may be empty
  bool wasEncrypted = false;  ///< a certificate of this server is known
};

/// How an attempt to connect has ended.
struct Attempt {
  // NOLINTNEXTLINE(google-explicit-constructor): most makers of connections ask nothing
  Attempt(base::Result<Connection> result, std::shared_ptr<const TrustQuestion> asked = nullptr)
      : connection(std::move(result)), question(std::move(asked)) {}

  base::Result<Connection> connection;
  std::shared_ptr<const TrustQuestion> question;  ///< null: a person can decide nothing
};

/// Opens a connection. The error is that of the maker of the link: NotReachable, Rejected, ...
using Connector = std::function<Attempt(const ConnectRequest&)>;

}  // namespace rivulet::opcua

template <>
struct std::is_error_code_enum<rivulet::opcua::LinkKindError> : std::true_type {};
