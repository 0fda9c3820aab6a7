// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calibrations as JSON (docs/cli.md names every field), and the file of each machine. Command line
/// and HMI share the files. @threadsafety pure, but for the files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/result.h"
#include "feasibility/access_model.h"
#include "streaming/calibration_record.h"

namespace rivulet::report {

[[nodiscard]] nlohmann::ordered_json calibrationJson(const streaming::CalibrationRecord& record);
/// Inverse of `calibrationJson`. @param origin  for the error
/// @return NotATrace; NewerVersion: of another version of the format
[[nodiscard]] base::Result<streaming::CalibrationRecord> calibrationOf(const nlohmann::json& json,
                                                                       const std::string& origin);
/// @return FileUnreadable, and as `calibrationOf`
[[nodiscard]] base::Result<streaming::CalibrationRecord> readCalibration(
    const std::filesystem::path& path);

/// The folder of the machines' files: in $XDG_DATA_HOME, or else ~/.local/share.
[[nodiscard]] std::filesystem::path calibrationFolder();
/// The file of a machine. It is told from others by its endpoint and its server's application URI.
[[nodiscard]] std::filesystem::path calibrationPath(const std::filesystem::path& folder,
                                                    const std::string& endpoint,
                                                    const opcua::ServerIdentity& server);
/// Makes the folder where there is none. @return FileNotWritable
[[nodiscard]] base::Result<void> saveCalibration(const std::filesystem::path& path,
                                                 const streaming::CalibrationRecord& record);
/// What was measured on this machine; nothing if nothing was. Whether it still holds, `isOutdated`
/// tells. @return as `readCalibration`
[[nodiscard]] base::Result<std::optional<streaming::CalibrationRecord>> findCalibration(
    const std::filesystem::path& folder, const std::string& endpoint,
    const opcua::ServerIdentity& server);

/// What the equations take from a calibration. Where the form was not measured, lists count, and
/// every control has those. @param grouping  the form the run uses
[[nodiscard]] feasibility::AccessModel accessModel(const streaming::Calibration& calibration,
                                                   opcua::Grouping grouping);

}  // namespace rivulet::report
