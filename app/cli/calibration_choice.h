// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which calibration a command uses, and what it prints about it. @threadsafety main thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "base/result.h"
#include "cli/connection.h"
#include "feasibility/access_model.h"
#include "feasibility/verdict.h"
#include "streaming/setup/calibration_record.h"

namespace rivulet::cli {

/// A calibration of the machine, or why there is none.
struct CalibrationChoice {
  std::optional<streaming::CalibrationRecord> record;
  bool outdated = false;    ///< made with another version of the server: must not be used
  std::string unreadable;   ///< why the machine's file cannot be used; empty: it can
  std::string otherServer;  ///< what the server now reports about itself, if `outdated`

  /// Null if there is no valid one.
  [[nodiscard]] const streaming::CalibrationRecord* usable() const;
};

/// The file of the machine, as `calibrate` has left it. @return what the server's answer says
[[nodiscard]] base::Result<CalibrationChoice> calibrationOf(const Connection& connection);

/// "calibrated on 2026-05-04T09:30:00Z …", "assumed [P1]: 4.3 ms per cell".
[[nodiscard]] std::string accessSourceText(const CalibrationChoice& choice, opcua::Grouping form,
                                           const feasibility::Verdict& verdict);
[[nodiscard]] nlohmann::ordered_json accessSourceJson(const CalibrationChoice& choice,
                                                      opcua::Grouping form,
                                                      const feasibility::Verdict& verdict);

/// The present time, "2026-05-04T09:30:00Z".
[[nodiscard]] std::string utcNow();

}  // namespace rivulet::cli
