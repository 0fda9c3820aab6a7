// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The state of the machine at a moment, as the HMI shows it. Values that were not read stay empty.
/// @threadsafety plain values.
#pragma once

#include <QString>
#include <optional>

#include "base/axes.h"
#include "base/vec3.h"

namespace rivulet::widgets {

enum class ConnectionState {
  Disconnected,
  Connecting,
  Connected,
  Lost,  ///< it was there and is gone; the operator has to connect again
};

struct MachineView {
  std::optional<int> channelStatus;  ///< opcua::VariableKind::ChannelStatus
  std::optional<int> programStatus;  ///< opcua::VariableKind::ProgramStatus
  std::optional<QString> programName;
  std::optional<int> alarmNumber;  ///< 0: no alarm
  QString alarmText;               ///< may be empty: the number alone is shown
  std::optional<QString> message;  ///< what MSG("…") of the program on the control shows
  std::optional<base::Vec3> positionMm;
  base::RotarySet rotaryAxes{};  ///< those that the machine is known to have
  std::optional<base::RotaryDeg> rotaryDeg;
  std::optional<double> feedMmPerS;
  bool isStale = false;        ///< the values are older than they should be
  std::optional<double> ageS;  ///< how old, if known
  bool isVirtualMachine = false;
};

}  // namespace rivulet::widgets
