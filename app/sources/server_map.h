// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which variables of another OPC UA server bring live points: a TOML file.
///
///     endpoint = "opc.tcp://127.0.0.1:4850"
///
///     [points]                      # each in a variable of its own
///     n = "ns=2;s=Path.Number"      # counts the points; is written last
///     x = "ns=2;s=Path.X"           # y, z, a, b, c, f
///
///     [replies]                     # may be left out
///     accepted = "ns=2;s=Path.Accepted"
///     executed = "ns=2;s=Path.Executed"
///
/// In place of the words, `line` names a text of whole lines.
/// @threadsafety pure.
#pragma once

#include <string>

#include "base/result.h"
#include "opcua/connection.h"

namespace rivulet::sources {

/// Variables of the link, by what they mean here.
inline constexpr opcua::Variable kNumberVariable{opcua::VariableKind::LineNumber};
inline constexpr opcua::Variable kLineVariable{opcua::VariableKind::Message};
inline constexpr opcua::Variable kFeedVariable{opcua::VariableKind::PathFeed};
/// @param axis  X Y Z A B C
[[nodiscard]] constexpr opcua::Variable axisVariable(int axis) {
  return {opcua::VariableKind::ActualPosition, axis};
}
inline constexpr opcua::Variable kAcceptedVariable = opcua::rParameter(0);
inline constexpr opcua::Variable kExecutedVariable = opcua::rParameter(1);

struct ServerMap {
  /// With `nodes` of the variables above: those that are in the file.
  opcua::ConnectRequest request;
  std::string passwordFile;  ///< empty: none

  [[nodiscard]] bool has(const opcua::Variable& variable) const {
    return request.nodes.contains(variable);
  }
};

/// @param path  of the file @return BadSourceFile, with the line where there is one
[[nodiscard]] base::Result<ServerMap> readServerMap(const std::string& path);

}  // namespace rivulet::sources
