// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the columns of a trace mean: guessed from their names and units, or as the user says.
/// @threadsafety pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rivulet::trace {

/// What a signal is for the analysis.
enum class SignalRole {
  Time,
  XSet,  ///< set point of the axis
  YSet,
  ZSet,
  XActual,  ///< actual position
  YActual,
  ZActual,
  XSpeed,  ///< speed of the axis
  YSpeed,
  ZSpeed,
  PathSpeed,
  ProgrammedFeed,
  Line,      ///< of the NC program
  Override,  ///< of the feed; 0: the machine holds
};
inline constexpr std::size_t kSignalRoleCount = 14;

/// Set point or actual position of an axis.
[[nodiscard]] constexpr bool isPosition(SignalRole role) {
  return role >= SignalRole::XSet && role <= SignalRole::ZActual;
}

/// The same role of another axis. @param ofX  of the axis X  @param axis  0, 1, 2: X, Y, Z
[[nodiscard]] constexpr SignalRole roleForAxis(SignalRole ofX, std::size_t axis) {
  return static_cast<SignalRole>(static_cast<std::size_t>(ofX) + axis);
}

/// "time", "x_set", "x_act", "x_speed", "path_speed", "programmed_feed", "line", "override".
[[nodiscard]] std::string_view signalRoleName(SignalRole role);

/// Which column has a role. Of each role there is one, except Time: a column of time belongs to the
/// columns that follow it, up to the next one.
struct ColumnRole {
  SignalRole role = SignalRole::Time;
  std::string column;  ///< its name, or "#3": the third
  std::string unit;    ///< empty: as the file says, or the usual one

  friend bool operator==(const ColumnRole&, const ColumnRole&) = default;
};

/// "x_set=Pos1:um,time=t".
[[nodiscard]] std::string printColumnRoles(const std::vector<ColumnRole>& roles);

/// What a table means: its columns, and what it does not say itself.
struct TableMapping {
  std::vector<ColumnRole> columns;
  std::optional<double> rateHz{};  ///< of a table without a column of time, > 0
  double offsetS = 0.0;            ///< place of its first sample on a time axis that traces share
  bool isComplete = false;         ///< all other columns have no role; false: they are guessed

  friend bool operator==(const TableMapping&, const TableMapping&) = default;
};

/// "time=t,x_set=Pos1:um,rate=500,offset=1.5,guess=no": what follows the last colon is the unit if
/// it is one. @return error ImportError::BadMapping, also if a role but Time is given twice
[[nodiscard]] base::Result<TableMapping> parseTableMapping(std::string_view text);
[[nodiscard]] std::string printTableMapping(const TableMapping& mapping);

/// By what a mapping names a column: its name, or its number ("#3") where the name has signs that
/// mean something in a mapping. @param index  from 0
[[nodiscard]] std::string columnReference(std::string_view name, std::size_t index);
/// Units that can be said of a role, the usual one first; empty: it has none.
[[nodiscard]] std::vector<std::string_view> unitsOf(SignalRole role);

/// A name with its unit taken off: "X [mm]", "X (mm)", "X/mm", "x_mm".
struct NameAndUnit {
  std::string name;
  std::string unit;
};
[[nodiscard]] NameAndUnit splitUnit(std::string_view heading);

/// True if the text is a unit, with or without brackets.
[[nodiscard]] bool isUnit(std::string_view text);

/// Factor from a unit to s, mm or mm/s; nothing: the unit is not known, or is no unit of this role.
[[nodiscard]] std::optional<double> unitFactor(std::string_view unit, SignalRole role);

/// What a column of this name is, as far as the name tells.
[[nodiscard]] std::optional<SignalRole> guessRole(std::string_view name);

}  // namespace rivulet::trace
