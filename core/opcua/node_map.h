// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Names as on a SINUMERIK OPC UA server: variable ↔ node identifier, methods, program paths. The
/// link uses them in requests; the virtual machine's front answers to them. On other servers a
/// table of addresses takes their place.
/// @threadsafety pure.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "opcua/grouping.h"
#include "opcua/variable.h"

namespace rivulet::opcua {

/// The port that is registered for OPC UA; an endpoint without a port means this one.
inline constexpr int kPort = 4840;
/// Where a server on this computer is expected.
inline constexpr std::string_view kLocalEndpoint = "opc.tcp://127.0.0.1:4840";

/// Namespace of the variables and of the control's methods. Its index differs between servers:
/// always resolve it by this URI.
inline constexpr std::string_view kNamespaceUri = "SinumerikVarProvider";

/// Namespace of what only a virtual machine offers. A server that has it is not a real control.
inline constexpr std::string_view kVirtualNamespaceUri = "urn:rivulet:virtual-machine";

/// Node of each variable on a server that is no SINUMERIK, in the text form of the standard
/// (Part 6, 5.3.1.10): "ns=2;s=Robot.X", "i=2258", or "nsu=urn:robot;s=X" by the namespace's URI.
using NodeAddresses = std::map<Variable, std::string>;

/// Object of the control's methods, and the object newer controls keep the file methods in.
inline constexpr std::string_view kMethodsObject = "/Methods";
inline constexpr std::string_view kFileMethodsObject = "/Methods/Filehandling";
inline constexpr std::string_view kCopyToServer = "CopyFileToServer";
inline constexpr std::string_view kCopyFromServer = "CopyFileFromServer";
inline constexpr std::string_view kSelect = "Select";
/// The rights of the user who asks, separated by semicolons.
inline constexpr std::string_view kGetMyAccessRights = "GetMyAccessRights";

/// Namespace of what a bridge to a real control offers beyond a SINUMERIK.
inline constexpr std::string_view kBridgeNamespaceUri = "urn:rivulet:bridge";
/// The object of a bridge, in its namespace. It has those members of a virtual machine that the
/// control is able to do.
inline constexpr std::string_view kBridgeObject = "Bridge";

/// Object of the virtual machine and its members, in `kVirtualNamespaceUri`.
inline constexpr std::string_view kVirtualObject = "VirtualMachine";
inline constexpr std::string_view kCycleStart = "CycleStart";
inline constexpr std::string_view kReset = "Reset";
inline constexpr std::string_view kFetchTrace = "FetchTrace";
inline constexpr std::string_view kFetchTracePiece = "FetchTracePiece";
inline constexpr std::string_view kSimulated = "Simulated";
inline constexpr std::string_view kPresetName = "PresetName";

/// Identifier of a member of an object: "/Methods" and "Select" give "/Methods/Select".
[[nodiscard]] std::string memberIdentifier(std::string_view object, std::string_view member);

/// Identifier of the variable's node, e.g. "/Channel/Parameter/R[u1,11]".
/// @param variable index as documented at `VariableKind`, not negative
[[nodiscard]] std::string nodeIdentifier(const Variable& variable);

/// The variable behind an identifier. The unit may be left out ("R[11]"), and so may the index
/// of the first element ("/Channel/Parameter/R" is R1). Upper and lower case matter.
/// @return nothing for another node, another channel or a malformed index
[[nodiscard]] std::optional<Variable> variableOf(std::string_view identifier);

/// Consecutive R-parameters, addressed as one node.
struct ParameterArray {
  int first = 0;
  int count = 0;                         ///< at least 1
  Grouping form = Grouping::ArrayCount;  ///< one of the array forms
  friend bool operator==(const ParameterArray&, const ParameterArray&) = default;
};

/// Identifier of the array's node: "/Channel/Parameter/R[u1,10,#5]" or "…/R[u1,10,14]".
[[nodiscard]] std::string arrayIdentifier(const ParameterArray& array);

/// The array behind an identifier; the unit may be left out where that is not ambiguous
/// ("R[10,#5]"). @return nothing for anything else, an empty array included
[[nodiscard]] std::optional<ParameterArray> arrayOf(std::string_view identifier);

/// Whether this is the name of a subprogram: it ends in SPF.
[[nodiscard]] bool isSubprogramName(std::string_view name);

/// Path of a part program in the control's file system.
[[nodiscard]] std::string programPath(std::string_view name);

/// Inverse of `programPath`; nothing for a path outside "Part Program" or an unusable name.
[[nodiscard]] std::optional<std::string> programNameOf(std::string_view path);

}  // namespace rivulet::opcua
