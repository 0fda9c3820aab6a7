// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calibrations as JSON (docs/cli.md names every field). @threadsafety pure, except that
/// `readCalibration` reads a file.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "base/result.h"
#include "feasibility/access_model.h"
#include "streaming/setup/calibration_record.h"

namespace rivulet::report {

[[nodiscard]] nlohmann::ordered_json calibrationJson(const streaming::CalibrationRecord& record);
/// Inverse of `calibrationJson`. @param origin  for the error
/// @return NotAMachineFile, Damaged; OtherVersion: of another version of the format
[[nodiscard]] base::Result<streaming::CalibrationRecord> calibrationOf(const nlohmann::json& json,
                                                                       const std::string& origin);
/// A calibration, or the file of a machine with one in it.
/// @return errors of `readJson`, and as `calibrationOf`
[[nodiscard]] base::Result<streaming::CalibrationRecord> readCalibration(
    const std::filesystem::path& path, const base::Budget& budget = {});

/// The part of a calibration that the equations use. If the form was not measured, lists are used,
/// which every control has. @param grouping  the form the run uses
[[nodiscard]] feasibility::AccessModel accessModel(const streaming::Calibration& calibration,
                                                   opcua::Grouping grouping);

}  // namespace rivulet::report
