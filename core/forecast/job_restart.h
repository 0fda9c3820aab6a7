// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A job that begins in the middle, like a block search with calculation: the state that the
/// program has there is computed, and re-established before anything else; or compared with what
/// the control reports, where nobody re-establishes it. @threadsafety pure.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "job/plan.h"
#include "machine/config.h"
#include "streaming/recovery/job_resume.h"
#include "streaming/run/equipment_watch.h"

namespace rivulet::forecast {

struct Restart {
  job::Plan plan;  ///< re-establishes the state, then goes on with the part
  /// What is done first, one NC text each, in order: shown to the operator, who confirms.
  std::vector<std::string> steps;
  /// Blocks before the part whose effect cannot be computed, as "line 5: M123".
  std::vector<std::string> notRestored;
  streaming::JobRest rest;  ///< what `plan` goes on with: enough to make it again
};

/// Zero of the workpiece frame when the part begins, with work offset and tool length.
/// @return CannotResume: a block before it does what only the control knows
[[nodiscard]] base::Result<base::Vec3> zeroAt(const job::Plan& plan,
                                              const machine::MachineConfig& machine,
                                              std::size_t part);

/// From the beginning of the plan: the plan itself, and nothing is done first.
/// Else the work offset is set, and the tool rises to the greatest height of the program's points,
/// unless it is above, and so does the tool of the program when it is in; dynamics, spindle and
/// coolant are set; the tool goes over the place where the part begins, and down to it. Before the
/// program has moved an axis, none is moved.
/// @return CannotResume, see `zeroAt`  @pre plan.isWhole(); rest.part is a part
[[nodiscard]] base::Result<Restart> restartAt(const job::Plan& plan,
                                              const machine::MachineConfig& machine,
                                              const streaming::JobRest& rest);

/// Where a job goes on that was a restart itself. @param rest  in its plan
/// @return the same in the plan that it was made of
[[nodiscard]] streaming::JobRest restInSource(const Restart& job, const streaming::JobRest& rest);

/// From the beginning of a stretch.
/// @return CannotResume if there is no such stretch, or it is not known where the tool stands
///         before it; or as `zeroAt`
[[nodiscard]] base::Result<Restart> restartAtStretch(const job::Plan& plan,
                                                     const machine::MachineConfig& machine,
                                                     int stretch);

/// What a program sets up before it moves for the first time; what it does not set is empty.
struct SetUp {
  std::string tool;              ///< as the program names it: "5", "MILL_10"
  std::string workOffset;        ///< "G54"
  std::optional<double> perMin;  ///< of the spindle, negative: counterclockwise, 0: it stands

  [[nodiscard]] bool isEmpty() const { return tool.empty() && workOffset.empty() && !perMin; }
};
/// @param plan  its own program is not needed
/// @return empty: it sets nothing up, or a block before does what only the control knows
[[nodiscard]] SetUp setUpOf(const job::Plan& plan, const machine::MachineConfig& machine);
/// What of it is not so at the control. What the control does not report is left out.
[[nodiscard]] SetUp missingOf(const SetUp& wanted, const streaming::EquipmentSeen& seen);

}  // namespace rivulet::forecast
