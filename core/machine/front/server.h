// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The virtual machine as an OPC UA server that looks like a SINUMERIK: same namespace, same
/// identifiers, same file methods, same cost of access. A separate namespace has what a SINUMERIK
/// does not offer: cycle start, reset, and the control's own trace. Another control, behind a
/// `ServedControl`, is shown in the same way; its own namespace says that its axes are real.
///
/// Machine time is the wall time since the server was started. While a variable is served, the
/// whole server waits: one service for all clients, one node after another, as on the control.
/// @threadsafety one object, one thread at a time, except the counters. Starts no thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/instant.h"
#include "base/result.h"
#include "machine/front/login_failure.h"
#include "machine/front/served_control.h"
#include "machine/machine.h"
#include "opcua/revocation.h"
#include "opcua/security.h"

namespace rivulet::machine {

enum class FrontError {
  PortTaken = 1,    ///< another program listens there
  AddressUnusable,  ///< no address of this computer, or the port is not allowed
  TooFewHandles,    ///< this program may not open enough connections
  SetUpFailed,      ///< the OPC UA library failed; the message contains its text
};

[[nodiscard]] std::error_code make_error_code(FrontError code);

struct ServerOptions {
  std::string host = "127.0.0.1";  ///< where to listen; by default only this computer
  std::uint16_t port = 0;          ///< 0: a free one
  /// False: clients may not write, read and select part programs, as on a control whose OPC UA user
  /// has not been given these rights.
  bool fileRights = true;

  /// With it, clients can connect encrypted: Basic256Sha256, Aes128_Sha256_RsaOaep and
  /// Aes256_Sha256_RsaPss, each with Sign and SignAndEncrypt.
  std::optional<opcua::OwnCertificate> certificate;
  /// Clients may connect without encryption. Needed if there is no certificate.
  bool unencrypted = true;
  /// Fingerprints of the clients that may connect encrypted; nothing: every client.
  std::optional<std::set<std::string>> trustedClients;
  /// Certificates of clients and users that they name are refused.
  std::vector<opcua::RevocationList> revocations;
  /// Told about every client certificate that was refused. Called within `iterate`.
  std::function<void(const opcua::CertificateFacts& facts, std::string_view der)> onRefusedClient;
  /// Told about every wrong password or name, but not while they are locked. Called within
  /// `iterate`.
  std::function<void(const LoginFailure& failure)> onFailedLogin;
};

class Server {
 public:
  /// Listens from now on; requests are answered only in `iterate` or `run`.
  /// @param machine outlives the server; nothing else may touch it while the server runs
  [[nodiscard]] static base::Result<std::unique_ptr<Server>> start(Machine& machine,
                                                                   const ServerOptions& options);
  /// The same for another control than the virtual machine.
  [[nodiscard]] static base::Result<std::unique_ptr<Server>> start(ServedControl& control,
                                                                   const ServerOptions& options);
  /// Closes all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Address for clients, e.g. "opc.tcp://127.0.0.1:4840", with the real port.
  [[nodiscard]] const std::string& endpoint() const;

  /// Advances the machine to the present and serves what has arrived; waits for it no longer than
  /// `timeout`. A request takes the time of its variables, whatever the timeout.
  void iterate(base::Duration timeout);

  /// Iterates until `stop` becomes true.
  void run(const std::atomic<bool>& stop);

  /// What the variable service has done so far. @threadsafety any thread.
  [[nodiscard]] std::uint64_t requestsServed() const;
  [[nodiscard]] std::uint64_t nodesServed() const;

 private:
  class Impl;
  explicit Server(std::unique_ptr<Impl> impl);
  [[nodiscard]] static base::Result<std::unique_ptr<Server>> start(std::unique_ptr<Impl> impl,
                                                                   const ServerOptions& options);
  std::unique_ptr<Impl> m_impl;
};

}  // namespace rivulet::machine

template <>
struct std::is_error_code_enum<rivulet::machine::FrontError> : std::true_type {};
