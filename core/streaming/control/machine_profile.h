// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The limits of one machine as its engineer has entered them. No control reports them to a client
/// in a way that all versions share, so nothing of it is read. @threadsafety plain values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.h"
#include "base/vec3.h"
#include "opcua/server_identity.h"
#include "templates/cells.h"

namespace rivulet::streaming {

/// In mm for X, Y and Z, in degrees for A, B and C.
struct AxisProfile {
  double positionMin = 0.0;  ///< machine coordinates
  double positionMax = 0.0;
  double speedPerSMax = 0.0;
  double accelerationPerS2Max = 0.0;
  double jerkPerS3Max = 0.0;

  friend bool operator==(const AxisProfile&, const AxisProfile&) = default;
};

struct ToolProfile {
  int number = 0;
  std::string name;
  double lengthMm = 0.0;
  double radiusMm = 0.0;

  friend bool operator==(const ToolProfile&, const ToolProfile&) = default;
};

struct MachineProfile {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string enteredAtUtc;  ///< "2026-05-04T09:30:00Z"
  std::string enteredBy;

  std::string name;    ///< as people call it; may be empty
  std::string preset;  ///< of the virtual machine that stands for it in simulations
  std::array<AxisProfile, base::kAxisCount> axes;
  std::array<std::optional<AxisProfile>, base::kRotaryAxisCount> rotaryAxes;  ///< A B C
  double rapidMmPerS = 0.0;
  double spindlePerMinMax = 0.0;                     ///< 0: no spindle
  double silenceLimitS = templates::kSilenceLimitS;  ///< see `templates::WindowSettings`
  /// See `stopLimitS` below.
  double stopLimitS = 5.0;
  std::vector<ToolProfile> tools;

  friend bool operator==(const MachineProfile&, const MachineProfile&) = default;
};

/// The first value that cannot be.
struct ProfileProblem {
  enum class What {
    Travel,  ///< the end of the travel is not above its beginning
    Speed,   ///< not above zero, as the next three
    Acceleration,
    Jerk,
    Rapid,
    Silence,     ///< neither zero nor within the limits
    Stop,        ///< not within the limits
    ToolNumber,  ///< not above zero, or given twice
  };
  What what = What::Travel;
  std::size_t axis = 0;  ///< 0 to 5: X Y Z A B C; of the first four
  int tool = 0;          ///< of the last
};

[[nodiscard]] std::optional<ProfileProblem> problemOf(const MachineProfile& profile);

/// Without a sign of the client for so long, the axes of this machine stand, s; 0: not at all.
/// @param profile  null: nobody has entered its limits
[[nodiscard]] double silenceLimitS(const MachineProfile* profile);

/// Where a stop acts only before the next window, no window takes longer, s: see
/// `RunSettings::windowSMax`.
inline constexpr double kStopLimitSMin = 0.5;
inline constexpr double kStopLimitSMax = 600.0;
/// @param profile  null: nobody has entered its limits
[[nodiscard]] double stopLimitS(const MachineProfile* profile);

}  // namespace rivulet::streaming
