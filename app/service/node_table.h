// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The nodes of the service: variables and methods with their names and descriptions, as data. The
/// names are those of OPC 40501-1 (Machine Tools) and OPC 40001-1 (Machinery) where these have one.
/// @threadsafety constants.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "opcua/node_watch.h"
#include "service/service_session.h"

namespace rivulet::service {

/// Where a service on this computer is expected: beside that of a machine, which is the standard's.
inline constexpr std::uint16_t kPort = 4841;
/// Namespace of all nodes of the service, and its product as discovery servers know it.
inline constexpr std::string_view kNamespaceUri = "urn:rivulet:service";
/// As a service presents itself, also in its certificate.
inline constexpr std::string_view kProductName = "Rivulet service";
/// The object that holds the others; a node is "ns=…;s=<object>/<name>".
inline constexpr std::string_view kMethodsObject = "Session";

using NodeValue = std::variant<bool, std::uint32_t, double, std::string, std::vector<double>>;

/// Who may read a variable, where users are set up.
enum class Readers {
  Everybody,  ///< the state of the machine and of its run: whoever stands beside it
  LoggedIn,   ///< which program, its settings and files
};

struct VariableRow {
  std::string_view identifier;  ///< "Production/ActiveProgram/Name": folders and browse name
  std::string_view description;
  std::variant<bool Snapshot::*, std::uint32_t Snapshot::*, double Snapshot::*,
               std::string Snapshot::*, std::vector<double> Snapshot::*, std::string_view>
      member;  ///< or a text that never changes
  Readers readers = Readers::Everybody;
};
[[nodiscard]] std::span<const VariableRow> variableRows();
/// Of the server.
[[nodiscard]] NodeValue valueOf(const VariableRow& row, const Snapshot& seen);
/// The inverse, of a client: a value that is not known makes the member empty.
void take(const VariableRow& row, const opcua::NodeValue& value, Snapshot& seen);
/// Node id in text form. @param identifier  of a variable, a method or an object
[[nodiscard]] std::string nodeAddress(std::string_view identifier);
[[nodiscard]] std::string methodIdentifier(std::string_view method);

struct MethodRow {
  std::string_view name;  ///< below `kMethodsObject`
  std::string_view description;
  std::vector<std::string_view> inputs;  ///< texts
  Answer (*call)(ServiceSession&, const Caller&, const std::vector<std::string>& inputs);
};
/// Each answers Accepted (Boolean), Message and Confirmation (String).
[[nodiscard]] const std::vector<MethodRow>& methodRows();

}  // namespace rivulet::service
