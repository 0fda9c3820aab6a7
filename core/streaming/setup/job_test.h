// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test of whole jobs. A job relies on the control executing its own blocks once, in order and
/// only when the client lets it, on stretches being called by their number, and on hold, stop and
/// silence acting in both. That is documented, but has to be seen on each control.
///
/// The test is a job like any other (`runWholeJob`) along a move of one axis that the operator has
/// agreed to. It is started five times: stopped and left alone, in a block of the control and in a
/// stretch; then it goes through, is held in both, and the control executes the blocks that the
/// operator wants to be tried. What has not been tried is not released.
/// @threadsafety runs on the calling thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "job/plan.h"
#include "opcua/link.h"
#include "streaming/run/run.h"
#include "streaming/setup/feed_test.h"

namespace rivulet::streaming {

/// R-parameters in a row that the test needs.
inline constexpr int kJobTestCells = 36;
/// The job is started so many times, each by the operator.
inline constexpr int kJobTestStarts = 5;

struct JobTestPlan : CommissioningPlan {
  /// Made by blocks of the control and by stretches, in turns; it is not lifted.
  AirMove move;
  /// Blocks that the control is to execute, each with nothing in its way: one or more lines of a
  /// SINUMERIK. Only after the last one the axes may stand elsewhere.
  std::vector<std::string> blocks;
};

/// What the program of the test is called for the user.
[[nodiscard]] std::string jobTestName();

/// How it is known that a block was executed.
enum class Witness {
  Nobody,    ///< the control shows nothing of it, and nobody has said so
  Control,   ///< it showed what the block does, of each kind of its lines
  Operator,  ///< he has seen it
};
/// "nobody", "control", "operator".
[[nodiscard]] std::string_view witnessName(Witness witness);
/// Inverse of `witnessName`; nothing for an unknown name.
[[nodiscard]] std::optional<Witness> witnessFromName(std::string_view name);

/// One of the plan's blocks, executed.
struct TriedBlock {
  std::string text;
  std::vector<job::NativeReason> kinds;  ///< of its lines
  Witness witness = Witness::Nobody;
  std::string message;  ///< what was seen

  friend bool operator==(const TriedBlock&, const TriedBlock&) = default;
};

struct JobCommissioning : ChecksOfControl {
  AirMove move;
  std::vector<TriedBlock> tried;

  /// Whether a job there may have this block: its kind has been seen to be executed. Of kinds that
  /// differ from machine to machine (other functions, subprograms, measuring) the very text.
  [[nodiscard]] bool releases(const job::NativeBlock& block) const;
};

/// What the test may ask of the operator while it runs.
struct JobTestTalk {
  /// Called with what the test is waiting for; false ends it. Empty: it goes on.
  std::function<bool(CommissioningStep)> progress;
  /// Whether he has seen the control execute this block; nothing: nobody is there. Asked when the
  /// job has ended.
  std::function<std::optional<bool>(const std::string& block)> hasSeen;
  /// Told where the axes are while the job runs, as a run tells it. Empty: nobody is.
  std::function<void(const LiveUpdate& update)> watch;
};

/// Whether the test can be made: the move, and that each block is one that the control of a job
/// executes itself. @return BadAirMove, BadTestBlock
[[nodiscard]] base::Result<void> requireJobTestPlan(const JobTestPlan& plan);

/// A control that fails is a result, not an error: the test ends with the first check that fails,
/// and the axes stand.
/// @return BadAirMove, BadTestBlock, ChannelBusy, ControlAlarm before the first start or in a block
/// that is tried, NotStarted, TransferRefused, Cancelled, or the error of the link
[[nodiscard]] base::Result<JobCommissioning> testJobs(opcua::Link& link, opcua::Control& control,
                                                      const JobTestPlan& plan,
                                                      const JobTestTalk& talk = {});

}  // namespace rivulet::streaming
