// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The methods of the server: those of the control (file transfer, selection), and in a separate
/// object and namespace, those that only a virtual machine has. They do not use the variable
/// service.
/// @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <string>

#include "base/result.h"
#include "machine/front/variable_service.h"

namespace rivulet::machine {

/// Largest part program that the file methods accept, as on the control.
inline constexpr std::size_t kFileBytesMax = std::size_t{16} << 20U;
/// Largest number of bytes of the trace that one call of FetchTrace returns.
inline constexpr std::size_t kTraceChunkBytesMax = std::size_t{1} << 20U;

class Methods {
 public:
  /// @param server,service outlive the methods
  Methods(UA_Server* server, VariableService& service, bool fileRights)
      : m_server(server), m_service(service), m_fileRights(fileRights) {}

  /// Creates the objects and their methods.
  /// @param namespaceIndex of the control's variables @return SetUpFailed
  [[nodiscard]] base::Result<void> build(UA_UInt16 namespaceIndex);

  /// Whether clients may use the methods of the control; those of the virtual machine are always
  /// allowed.
  [[nodiscard]] bool hasFileRights() const { return m_fileRights; }
  [[nodiscard]] Machine& machine() const { return m_service.machine(); }
  /// Moves the machine to the present; every method begins with it.
  void advance() { m_service.advance(); }
  /// Waits as long as writing a program takes.
  void serveProgram(std::size_t bytes) { m_service.serveProgram(bytes); }
  /// The trace as text; printed anew when a fetch begins at offset 0.
  [[nodiscard]] const std::string& traceText(bool anew);

 private:
  UA_Server* m_server;
  VariableService& m_service;
  bool m_fileRights;
  std::string m_traceText;
};

}  // namespace rivulet::machine
