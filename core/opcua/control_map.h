// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a control keeps what Rivulet reads and writes, if its OPC UA server is no SINUMERIK: a
/// TOML file of an integrator (docs/mapping.md). An address is the text form of a node id
/// ("ns=2;s=X", "nsu=urn:cell;i=5") or a path of browse names from the folder Objects
/// ("/Cell/Axes/X"). The link resolves addresses when it connects; the SINUMERIK's own names are a
/// map, too.
/// @threadsafety pure, except `readControlMap`, which reads a file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include "base/result.h"
#include "opcua/node_map.h"
#include "opcua/variable.h"

namespace rivulet::opcua {

enum class MapError {
  BadFile = 1,   ///< the file is no map
  WrongAddress,  ///< the server has no such node, or one that cannot be what the map says
};
[[nodiscard]] std::error_code make_error_code(MapError code);

/// What a server shows as a state; true and false are 1 and 0.
using StateValue = std::variant<double, std::string>;
struct StateMeaning {
  StateValue value;
  int state = 0;  ///< as documented at the `VariableKind`
  friend bool operator==(const StateMeaning&, const StateMeaning&) = default;
};

/// The R-parameters, each a `Double`, or each a `Float` if there is a `resolution`.
struct CellNodes {
  int first = 0;  ///< R number
  int last = -1;  ///< R number; below `first`: there are no cells
  /// Address in which {} stands for R number + `offset`; of an array: without {}.
  std::string node;
  bool isArray = false;  ///< `node` has all cells; the element is R number + `offset`
  int offset = 0;
  /// Smallest increment of the axes, mm and degrees; 0: not known. See `asFloat`.
  double resolution = 0.0;
  /// Addresses of several consecutive cells in one node, which need not exist: {first} and
  /// {count}, or {first} and {last}, are R numbers without offset. Empty: there are none.
  std::string byCount;
  std::string byLast;

  [[nodiscard]] bool has(int number) const { return first <= number && number <= last; }
  friend bool operator==(const CellNodes&, const CellNodes&) = default;
};

/// Methods with the arguments of a SINUMERIK; each may be empty.
struct MethodNodes {
  std::string object;  ///< whose methods they are
  std::string write;   ///< (path: String, content: ByteString, overwrite: Boolean)
  std::string read;    ///< (path: String) → content: ByteString
  std::string select;  ///< (path: String, channel: UInt32) → status: integer, `SelectStatus`
  std::string mainPath = "{}";  ///< of a part program; {} stands for its name
  std::string subPath = "{}";   ///< of a subprogram
  friend bool operator==(const MethodNodes&, const MethodNodes&) = default;
};

struct ControlMap {
  NodeAddresses nodes;  ///< of everything but the cells
  CellNodes cells;
  /// Units of `Variable` per unit of the server; 1 where there is none. Of rotary axes it is not
  /// used.
  std::map<VariableKind, double> scales;
  /// Of states; a kind that is not here has the numbers of `Variable`.
  std::map<VariableKind, std::vector<StateMeaning>> states;
  MethodNodes methods;

  friend bool operator==(const ControlMap&, const ControlMap&) = default;
};

/// The names of a SINUMERIK, as `nodeIdentifier` gives them.
/// @param last  R number of its last parameter @param axes  how many of X Y Z A B C it has
[[nodiscard]] ControlMap sinumerikMap(int last, int axes);

/// @return BadFile, with file and line, or `base::FileError`
[[nodiscard]] base::Result<ControlMap> readControlMap(const std::string& path);
/// @param path  for messages
[[nodiscard]] base::Result<ControlMap> parseControlMap(std::string_view text,
                                                       const std::string& path);
/// A file that `parseControlMap` reads as the same map.
[[nodiscard]] std::string controlMapText(const ControlMap& map);

/// "position.x", as the file names it; empty for what is in no file. R-parameters: "cells".
[[nodiscard]] std::string mapKeyOf(const Variable& variable);
/// All variables that a file can name, in its order; not the cells.
[[nodiscard]] std::vector<Variable> mappableVariables();

/// A value as a cell of type `Float` carries it.
/// @param resolution  positive @return nothing: it would become another one. A whole number must be
/// exact, because numbers of windows and the like are compared; anything else may be off by half
/// the resolution.
[[nodiscard]] std::optional<float> asFloat(double value, double resolution);

/// Address of one cell that the map has; of an array its own.
[[nodiscard]] std::string cellAddress(const CellNodes& cells, int number);
/// Address of several cells as one node; empty if there is none.
[[nodiscard]] std::string blockAddress(const CellNodes& cells, const ParameterArray& block);
/// Path of a program for the methods of this map.
[[nodiscard]] std::string mappedProgramPath(const MethodNodes& methods, std::string_view name);

/// What a value of the server means. @return nothing: the map does not say; never assume then
[[nodiscard]] std::optional<double> meaningOf(const ControlMap& map, const Variable& variable,
                                              const StateValue& value);
/// The letter of an axis that the map has, as `VariableKind::AxisName` shows it; else nothing.
[[nodiscard]] std::optional<std::string> axisLetterOf(const ControlMap& map,
                                                      const Variable& variable);

/// Something that a map does not name.
struct MapGap {
  std::string_view key;
  std::string_view consequence;  ///< main clause, without a full stop
  bool stopsRuns = false;        ///< no run is started without it
};
[[nodiscard]] std::vector<MapGap> gapsOf(const ControlMap& map);

/// Whether this may be an address: a node id in text form, or a path from Objects.
[[nodiscard]] bool isAddress(std::string_view text);
[[nodiscard]] inline bool isBrowsePath(std::string_view address) {
  return address.starts_with('/');
}

/// A step of a browse path.
struct BrowseStep {
  std::optional<int> nameSpace;  ///< "2:Name"; nothing: of any namespace
  std::string name;
};
/// @param path  "/Cell/2:Axes/A&/B": & takes the next character as it is
/// @return empty for a text that is no path
[[nodiscard]] std::vector<BrowseStep> browseSteps(std::string_view path);
/// The name as a step of a path.
[[nodiscard]] std::string escapedStep(std::string_view name);

}  // namespace rivulet::opcua

template <>
struct std::is_error_code_enum<rivulet::opcua::MapError> : std::true_type {};
