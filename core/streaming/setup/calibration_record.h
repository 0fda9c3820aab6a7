// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A calibration, the control on which it was measured, and when.
/// @threadsafety plain values.
#pragma once

#include <string>

#include "opcua/server_identity.h"
#include "streaming/setup/calibration.h"

namespace rivulet::streaming {

struct CalibrationRecord {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string measuredAtUtc;  ///< "2026-05-04T09:30:00Z"; given by a caller that has a clock
  std::string toolVersion;
  Calibration calibration;

  /// The server no longer reports the same identity: the measurement may not be valid.
  [[nodiscard]] bool isOutdated(const opcua::ServerIdentity& now) const { return !(server == now); }
};

}  // namespace rivulet::streaming
