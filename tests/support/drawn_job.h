// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whole jobs that are drawn from a seed, interrupted and gone on with, and their judge. The judge
/// knows what the machine has done, and what it does of the same source alone: nothing of the
/// client. @threadsafety the caller's thread; what belongs to another job may be used at the same
/// time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "forecast/job_restart.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "opcua/link.h"
#include "streaming/recovery/job_resume.h"
#include "streaming/run/whole_job.h"
#include "trace/control_trace.h"

namespace rivulet::tests {

/// The virtual machine of these jobs.
[[nodiscard]] machine::MachineConfig mill();

/// A program of it as a job. It is one, so failure is a bug.
[[nodiscard]] job::Plan planOf(const std::string& text);

/// A part with several tools, stretches and drilled holes. @param pointsMax  of a stretch
[[nodiscard]] std::string drawPart(std::uint64_t seed, int pointsMax = 124);

/// What a machine makes of the program alone, in virtual time.
[[nodiscard]] trace::ControlTrace traceOfSource(const std::string& text);

/// Where blocks that moved have ended, in 0.01 mm, machine coordinates.
[[nodiscard]] std::vector<std::string> motions(const trace::ControlTrace& trace);

/// Tools in the order in which they were changed.
[[nodiscard]] std::vector<std::string> toolChanges(const trace::ControlTrace& trace);

/// The tool stands at the end of the source's next motion. The machine lists a block when its set
/// point is at the end: a reset on the last hundredths of a millimetre of a block keeps it out of
/// the list, and nobody needs to make such a rest again.
/// @param zeroAt  of the workpiece frame at a part, machine coordinates
[[nodiscard]] bool isAtNextEnd(
    const trace::ControlTrace& source, std::size_t motionsBefore, const streaming::JobRest& rest,
    const std::function<base::Result<base::Vec3>(std::size_t part)>& zeroAt);

/// What has been done of a source in the parts of a job that was interrupted, in their order.
class JobJudge {
 public:
  /// @param extraMax  of what is done before a part goes on
  JobJudge(std::vector<std::string> source, std::size_t extraMax)
      : m_source(std::move(source)), m_extraMax(extraMax) {}

  /// @param mayBeComplete  the first of the source that is not among these was interrupted when
  ///                       nothing was left of it
  void add(const std::vector<std::string>& part, bool mayBeComplete = false);
  /// The most that can have been done.
  [[nodiscard]] std::size_t done() const { return *m_done.rbegin(); }
  /// What is wrong; empty: each thing of the source was done once.
  [[nodiscard]] std::string verdict() const;

 private:
  std::vector<std::string> m_source;
  std::size_t m_extraMax;
  /// What can have been done: of things that look alike, a part may have repeated the last one, or
  /// made the next one.
  std::set<std::size_t> m_done{0};
  bool m_isFirst = true;
  bool m_mayBeComplete = false;
  std::string m_wrong;
  std::string m_all;
};

/// What a client keeps on disk.
class LastCheckpoint final : public streaming::CheckpointKeeper {
 public:
  base::Result<void> keep(const streaming::Checkpoint& checkpoint, const streaming::RunSettings&,
                          std::span<const gcode::StreamPoint>) override {
    last = checkpoint;
    isOfThisStart = true;
    return {};
  }
  std::optional<streaming::Checkpoint> last;
  bool isOfThisStart = false;  ///< else nothing of the last start was kept, and so nothing executed
};

/// A job that goes on as often as it is interrupted.
struct LeftJob {
  const job::Plan& plan;
  LastCheckpoint keeper{};
  std::optional<forecast::Restart> restart{};  ///< of the next start; nothing: from its beginning
  std::optional<forecast::Restart> kept{};     ///< that `keeper` knows
  int standing = 0;                            ///< programs that were active when somebody asked
  int withinWindow = 0;                        ///< of these, in the middle of windows

  /// Before each start. @return what is started
  const job::Plan& begin();
  [[nodiscard]] base::Result<base::Vec3> zeroAt(std::size_t part) const;
  /// Asks the control where it is, and makes the rest of it. If it stands in blocks of the control
  /// without its client, it is ended first.
  /// @return CannotResume if an operator has to choose where it goes on
  base::Result<void> goOn(opcua::Link& link, opcua::Control& control,
                          const streaming::RunSettings& settings);

 private:
  [[nodiscard]] streaming::JobRest inSource(const streaming::JobRest& rest) const {
    return kept ? forecast::restInSource(*kept, rest) : rest;
  }
};

}  // namespace rivulet::tests
