// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The flexible program as a subprogram: a whole job calls it once for each stretch. It differs
/// from the program of its method in its beginning and its end only. @threadsafety pure.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "templates/flexible_program.h"

namespace rivulet::templates {

/// The numbers on which main program, loop and client agree, in addition to `WindowProtocol`.
///
/// The main program calls the loop with the number of the job, of the stretch (0: the beginning,
/// which waits for the client and moves nothing), and of the run that the loop obeys. The loop
/// writes `callNumber` into its call cell when it is ready for the client. Each stretch has a run
/// number of its own, which is part of the check number of each window: no window of another
/// stretch is executed. When a stretch has been executed, the loop waits until the client writes
/// `goOn` of this stretch, then writes the negative call number and returns.
struct JobProtocol {
  /// Value of the run cell: the control goes on with the native blocks after a stretch. Another one
  /// for each, so that a late write never ends the next stretch.
  [[nodiscard]] static constexpr int goOn(int stretch) { return 3 + stretch; }
  static constexpr int kStretchesMax = 9'999;
  static constexpr int kJobMax = 1 << 24;
  /// @param job  from 1 to 2^24  @param stretch  from 0
  [[nodiscard]] static constexpr double callNumber(int job, int stretch) {
    return static_cast<double>(job) * (kStretchesMax + 1) + stretch;
  }
  /// Stretch of a number in the call cell.
  [[nodiscard]] static int stretchOf(double callNumber) {
    return static_cast<int>(std::fmod(std::abs(callNumber), kStretchesMax + 1));
  }
  /// Job of a number in the call cell; not one of a job: 0.
  [[nodiscard]] static int jobOf(double callNumber) {
    const double job = std::floor(std::abs(callNumber) / (kStretchesMax + 1));
    return job <= kJobMax ? static_cast<int>(job) : 0;  // NaN: none
  }
  /// Of the call number.
  [[nodiscard]] static constexpr int callCell(const CellMap& cells) {
    return cells.layout - WindowProtocol::Layout + WindowProtocol::Asked;
  }
  /// Of the run of a stretch. @param first  of the beginning
  [[nodiscard]] static constexpr int runNumber(int first, int stretch) { return first + stretch; }
};

/// The program on the control during each stretch. Its layout number is that of the program of its
/// method, of which it is a variant.
struct JobLoop : FlexibleProgram {
  /// False: the main program begins with its text, so that both count the same lines.
  bool isOwnFile = true;
  int callCell = 0;  ///< NC: `JobProtocol::callNumber`, negative: executed
  /// Lines of `text` that move to a point, ascending, from 1.
  std::vector<std::uint32_t> motionLines;
  /// Line of `text` in which it waits for the client after a stretch.
  std::uint32_t handoverLine = 0;
};

/// The name of a loop as a subprogram: that of its file, if it has one, without ending.
[[nodiscard]] std::string_view subprogramName(const JobLoop& loop);

/// @param parameters  method window or credit, without online correction
/// @return the errors of `requireProgram`, BadCorrection, BadCells for another method
[[nodiscard]] base::Result<JobLoop> makeJobLoop(const TemplateParameters& parameters);

}  // namespace rivulet::templates
