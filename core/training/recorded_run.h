// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Recorded runs of another motion controller: its programs and the set points of its planner, to
/// be compared with the look-ahead of the virtual machine. @threadsafety pure.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/vec3.h"
#include "machine/prepared.h"

namespace rivulet::training {

enum class RecordedRunError { FileUnreadable = 1, Malformed };

[[nodiscard]] std::error_code make_error_code(RecordedRunError code);

struct RecordedSample {
  double timeS = 0.0;
  base::Vec3 commandMm;
  double pathMmPerS = 0.0;  ///< speed of the planner
};

struct RecordedRun {
  std::string name;
  /// Lines and arcs of the program; dwells are left out (each is between two blocks of
  /// `ExactStop`). Block ends and rounding as programmed (G61, G64 P).
  std::vector<machine::PreparedMotion> blocks;
  std::vector<RecordedSample> samples;
};

/// Straight and circular blocks of a program in the XY plane: G1, G2, G3 with X Y Z I J F, G61,
/// G64 P, comments in parentheses.
/// @param startMm  the tool's position before it
[[nodiscard]] base::Result<std::vector<machine::PreparedMotion>> parseRecordedProgram(
    std::string_view text, base::Vec3 startMm);

/// Columns t_s, x_cmd, y_cmd, z_cmd and v_path of a table with a heading.
[[nodiscard]] base::Result<std::vector<RecordedSample>> parseRecordedSamples(std::string_view text);

/// What a client saw of the axes X and Y.
struct ObservedSample {
  double timeS = 0.0;
  double xMm = 0.0;
  double yMm = 0.0;
  double xMmPerS = 0.0;
  double yMmPerS = 0.0;
};

/// Columns t_s, x, y, vx and vy of a table with a heading.
[[nodiscard]] base::Result<std::vector<ObservedSample>> parseObservedSamples(std::string_view text);

/// `data/opcua/NAME.csv` of a folder.
[[nodiscard]] base::Result<std::vector<ObservedSample>> loadObservedSamples(
    const std::filesystem::path& folder, const std::string& name);

/// `programs/NAME.ngc` and `data/NAME*.csv.zst` of a folder.
[[nodiscard]] base::Result<RecordedRun> loadRecordedRun(const std::filesystem::path& folder,
                                                        const std::string& name);

}  // namespace rivulet::training

template <>
struct std::is_error_code_enum<rivulet::training::RecordedRunError> : std::true_type {};
