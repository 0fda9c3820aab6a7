// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A calibration with what it belongs to: which control it was measured on, and when.
/// @threadsafety plain values.
#pragma once

#include <string>

#include "opcua/server_identity.h"
#include "streaming/calibration.h"

namespace rivulet::streaming {

struct CalibrationRecord {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string measuredAtUtc;  ///< "2026-05-04T09:30:00Z"; given by whoever has a clock
  std::string toolVersion;
  Calibration calibration;

  /// The server says of itself something else than it did: what was measured may not hold.
  [[nodiscard]] bool isOutdated(const opcua::ServerIdentity& now) const { return !(server == now); }
};

}  // namespace rivulet::streaming
