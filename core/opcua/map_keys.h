// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the file of a control map names variables, units and states: for its reader and writer.
/// @threadsafety constants.
#pragma once

#include <array>
#include <string_view>

#include "opcua/variable.h"

namespace rivulet::opcua {

struct MapKey {
  std::string_view section;
  std::string_view key;
  Variable variable;
};

inline constexpr std::array kMapKeys{
    MapKey{"position", "x", {VariableKind::ActualPosition, 0}},
    MapKey{"position", "y", {VariableKind::ActualPosition, 1}},
    MapKey{"position", "z", {VariableKind::ActualPosition, 2}},
    MapKey{"position", "a", {VariableKind::ActualPosition, 3}},
    MapKey{"position", "b", {VariableKind::ActualPosition, 4}},
    MapKey{"position", "c", {VariableKind::ActualPosition, 5}},
    MapKey{"distance_to_go", "x", {VariableKind::DistanceToGo, 0}},
    MapKey{"distance_to_go", "y", {VariableKind::DistanceToGo, 1}},
    MapKey{"distance_to_go", "z", {VariableKind::DistanceToGo, 2}},
    MapKey{"distance_to_go", "a", {VariableKind::DistanceToGo, 3}},
    MapKey{"distance_to_go", "b", {VariableKind::DistanceToGo, 4}},
    MapKey{"distance_to_go", "c", {VariableKind::DistanceToGo, 5}},
    MapKey{"feed", "path", {VariableKind::PathFeed, 0}},
    MapKey{"channel", "status", {VariableKind::ChannelStatus, 0}},
    MapKey{"alarm", "number", {VariableKind::Alarm, 0}},
    MapKey{"program", "name", {VariableKind::ProgramName, 0}},
    MapKey{"program", "status", {VariableKind::ProgramStatus, 0}},
    MapKey{"program", "line", {VariableKind::LineNumber, 0}},
    MapKey{"program", "message", {VariableKind::Message, 0}},
    MapKey{"tool", "number", {VariableKind::ToolNumber, 0}},
    MapKey{"tool", "name", {VariableKind::ToolName, 0}},
    MapKey{"tool", "edge", {VariableKind::EdgeNumber, 0}},
    MapKey{"spindle", "speed", {VariableKind::SpindleSpeed, 0}},
    MapKey{"spindle", "speed_set", {VariableKind::SpindleSpeedSet, 0}},
    MapKey{"spindle", "turn", {VariableKind::SpindleTurn, 0}},
    MapKey{"work_offset", "name", {VariableKind::GFunction, kWorkOffsetGroup}},
    MapKey{"coolant", "flood", {VariableKind::MFunction, kFloodGroup}},
    MapKey{"coolant", "mist", {VariableKind::MFunction, kMistGroup}},
};

/// A list of the values that mean one state.
struct MapState {
  std::string_view section;
  std::string_view key;
  VariableKind kind;
  int state;
  bool isNeeded;  ///< if any state of its section is given
};

inline constexpr std::array kMapStates{
    MapState{"channel", "reset", VariableKind::ChannelStatus, kChannelReset, true},
    MapState{"channel", "active", VariableKind::ChannelStatus, 1, true},
    MapState{"channel", "interrupted", VariableKind::ChannelStatus, kChannelInterrupted, false},
    MapState{"alarm", "none", VariableKind::Alarm, 0, true},
    MapState{"program", "interrupted", VariableKind::ProgramStatus, 1, false},
    MapState{"program", "stopped", VariableKind::ProgramStatus, 2, false},
    MapState{"program", "running", VariableKind::ProgramStatus, 3, true},
    MapState{"program", "waiting", VariableKind::ProgramStatus, 4, false},
    MapState{"program", "aborted", VariableKind::ProgramStatus, 5, false},
    MapState{"spindle", "clockwise", VariableKind::SpindleTurn,
             static_cast<int>(SpindleTurn::Clockwise), true},
    MapState{"spindle", "counterclockwise", VariableKind::SpindleTurn,
             static_cast<int>(SpindleTurn::Counterclockwise), true},
    MapState{"spindle", "stands", VariableKind::SpindleTurn, static_cast<int>(SpindleTurn::Stands),
             true},
};

/// A unit of the server, for the key "unit" of a section.
struct MapUnit {
  std::string_view section;
  VariableKind kind;
  std::string_view name;
  double scale;  ///< into the unit of the variable
};

inline constexpr double kMmPerInch = 25.4;
inline constexpr std::array kMapUnits{
    MapUnit{"position", VariableKind::ActualPosition, "mm", 1.0},
    MapUnit{"position", VariableKind::ActualPosition, "um", 0.001},
    MapUnit{"position", VariableKind::ActualPosition, "m", 1000.0},
    MapUnit{"position", VariableKind::ActualPosition, "inch", kMmPerInch},
    MapUnit{"distance_to_go", VariableKind::DistanceToGo, "mm", 1.0},
    MapUnit{"distance_to_go", VariableKind::DistanceToGo, "um", 0.001},
    MapUnit{"distance_to_go", VariableKind::DistanceToGo, "m", 1000.0},
    MapUnit{"distance_to_go", VariableKind::DistanceToGo, "inch", kMmPerInch},
    MapUnit{"feed", VariableKind::PathFeed, "mm/min", 1.0},
    MapUnit{"feed", VariableKind::PathFeed, "mm/s", 60.0},
    MapUnit{"feed", VariableKind::PathFeed, "m/min", 1000.0},
    MapUnit{"feed", VariableKind::PathFeed, "m/s", 60'000.0},
    MapUnit{"feed", VariableKind::PathFeed, "inch/min", kMmPerInch},
};

}  // namespace rivulet::opcua
