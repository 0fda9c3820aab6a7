// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The methods of the server: those of the control (file transfer, selection), and in a separate
/// object and namespace, those that only a virtual machine has. They do not use the variable
/// service.
/// @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "base/result.h"
#include "machine/front/variable_service.h"

namespace rivulet::machine {

/// Largest part program that the file methods accept, as on the control.
inline constexpr std::size_t kFileBytesMax = std::size_t{16} << 20U;
/// Largest number of bytes of the trace that one call of FetchTrace returns.
inline constexpr std::size_t kTraceChunkBytesMax = std::size_t{1} << 20U;

/// A session's identifier as text.
[[nodiscard]] std::string sessionKey(const UA_NodeId* sessionId);

class Methods {
 public:
  /// @param server,service outlive the methods
  Methods(UA_Server* server, VariableService& service, bool fileRights)
      : m_server(server), m_service(service), m_fileRights(fileRights) {}

  /// Creates the objects and their methods.
  /// @param namespaceIndex of the control's variables @return SetUpFailed
  [[nodiscard]] base::Result<void> build(UA_UInt16 namespaceIndex);

  /// Whether clients may use the methods of the control at all, whoever they are.
  [[nodiscard]] bool hasFileRights() const { return m_fileRights; }
  /// Whether the caller has a right of `userRights`. Who has logged in without a name has them all.
  [[nodiscard]] bool mayCaller(const std::string& right) const {
    return m_user == nullptr || m_user->rights.contains(right);
  }
  [[nodiscard]] ServedControl& control() const { return m_service.control(); }
  /// Moves the control to the present; every method begins with it.
  void advance() { m_service.advance(); }
  /// Writing a program takes time: the answer to the present request is due only then.
  void serveProgram(std::size_t bytes) { m_answerDue = m_service.serveProgram(bytes); }
  /// When the answer to the last call is due; nothing: at once. Asked once per call.
  [[nodiscard]] std::optional<base::Instant> takeAnswerDue() {
    return std::exchange(m_answerDue, std::nullopt);
  }

  /// The session that calls a method, and whether the client of a session is still there.
  /// @param user  null: logged in without a name
  void setCaller(std::string session, const User* user) {
    m_caller = std::move(session);
    m_user = user;
  }
  void setSessionCheck(std::function<bool(const std::string&)> isConnected) {
    m_isConnected = std::move(isConnected);
  }
  /// The caller is the one who may reset from now on.
  void rememberStarter() { m_starter = m_caller; }
  /// While a program runs whose client is still connected, only this client may reset it.
  [[nodiscard]] bool mayReset() const {
    return m_service.control().state().channel == ChannelStatus::Reset || m_starter == m_caller ||
           !m_isConnected || !m_isConnected(m_starter);
  }
  /// The trace as text; printed anew when a fetch begins at offset 0.
  [[nodiscard]] const std::string& traceText(bool anew);

 private:
  UA_Server* m_server;
  VariableService& m_service;
  bool m_fileRights;
  std::string m_traceText;
  std::optional<base::Instant> m_answerDue;
  std::string m_caller;
  const User* m_user = nullptr;  ///< of the caller
  std::string m_starter;         ///< session that pressed cycle start
  std::function<bool(const std::string&)> m_isConnected;
};

}  // namespace rivulet::machine
