// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/job_test_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/axes.h"
#include "base/text.h"
#include "base/units.h"

namespace rivulet::streaming {

namespace {

using base::Result;

constexpr int kPointsPerWindow = 3;
/// After each trial: a spindle comes to its speed.
constexpr double kAfterTrialS = 1.0;
/// Before the first trial.
constexpr std::size_t kStretchesOfTest = 4;
constexpr double kFirstDwellS = 0.5;
/// The program has its numbers with three decimals.
constexpr double kAgreedMm = 0.001;

struct Written {
  std::string text;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> trials;  ///< first line and the one behind
};

Written programOf(const JobTestPlan& plan, base::Vec3 startMm) {
  const auto axis = static_cast<std::size_t>(plan.move.axis);
  const char name = base::kAxisNames[axis];
  const std::string near = fmt::format("{}{:.3f}", name, startMm[axis]);
  const std::string middle = fmt::format("{}{:.3f}", name, startMm[axis] + plan.move.mm / 2.0);
  const std::string far = fmt::format("{}{:.3f}", name, startMm[axis] + plan.move.mm);
  // Whatever a tried block has set. With a word for the control the block is the control's; this
  // one changes nothing that matters.
  const std::string mode = fmt::format("G17 G71 G90 G94 G1 F{:g}", plan.move.feedMmPerMin);
  const auto native = [](const std::string& to) { return fmt::format("COMPOF G1 {}\n", to); };
  const auto streamed = [&mode](const std::string& to) { return fmt::format("{} {}\n", mode, to); };
  Written written;
  std::string& text = written.text;
  text = mode + '\n';
  text += fmt::format("G4 F{:g}\n", kFirstDwellS) + streamed(near) + native(far) + streamed(near) +
          native(far) + native(middle) + streamed(far);
  text += fmt::format("MSG(\"RIVULET: TEST OF WHOLE JOBS\")\nG4 F{:g}\n", kTestDwellS);
  text += streamed(near);
  bool isNear = true;
  for (const std::string& block : plan.blocks) {
    const auto first = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n') + 1);
    text += block + '\n';
    const auto behind = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n') + 1);
    written.trials.emplace_back(first, behind);
    isNear = !isNear;
    text += fmt::format("G4 F{:g}\n", kAfterTrialS) + streamed(isNear ? near : far);
  }
  text += (isNear ? std::string() : streamed(near)) + "M30\n";
  return written;
}

base::Error badBlock(const std::string& block, std::string_view why) {
  return base::makeError(
      StreamError::BadTestBlock,
      fmt::format(
          "\"{}\" cannot be tried: {} Name blocks as a program has them, as in \"S500 M3\".", block,
          why));
}

/// Every line of a trial is a block of the control, and of such a kind that the job goes on.
Result<std::vector<job::NativeReason>> kindsOf(const job::Plan& plan, const std::string& block,
                                               std::pair<std::uint32_t, std::uint32_t> lines) {
  std::vector<job::NativeReason> kinds;
  for (const job::Part& part : plan.parts) {
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      const std::uint32_t line = native->place.line.value;
      if (line >= lines.first && line < lines.second) {
        kinds.push_back(native->reason);
      }
      continue;
    }
    for (const nc::Place& place : std::get<job::Stretch>(part).blocks.all()) {
      if (place.line.value >= lines.first && place.line.value < lines.second) {
        return base::fail(badBlock(block, "Rivulet streams it itself, the control gets points."));
      }
    }
  }
  if (kinds.empty()) {
    return base::fail(badBlock(block, "nothing of it is executed by the control."));
  }
  if (std::find(kinds.begin(), kinds.end(), job::NativeReason::End) != kinds.end()) {
    return base::fail(badBlock(block, "it ends the program."));
  }
  return kinds;
}

/// Nothing is streamed but the move that was agreed to, whatever the blocks have set.
bool isAgreed(const JobTestJob& test, std::size_t axis) {
  for (const job::Part& part : test.plan.parts) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    for (std::size_t i = 0; stretch != nullptr && i < stretch->pointCount; ++i) {
      const base::Vec3& to =
          test.plan.program.trajectory.points[stretch->firstPoint + i].positionMm;
      for (std::size_t each = 0; each < base::kAxisCount; ++each) {
        const double from = stretch->startMm[each];
        const bool stands = to[each] == from || (std::isnan(to[each]) && std::isnan(from));
        const bool isEnd = std::abs(to[each] - test.nearMm) < kAgreedMm ||
                           std::abs(to[each] - test.farMm) < kAgreedMm;
        if (each == axis ? !isEnd : !stands) {
          return false;
        }
      }
    }
  }
  return true;
}

RunSettings settingsOf(const JobTestPlan& plan) {
  RunSettings settings;
  settings.parameters.baseCell = plan.firstCell;
  settings.parameters.pointsPerLoop = kPointsPerWindow;
  settings.parameters.rParameterCount = plan.firstCell + kJobTestCells;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(plan.move.feedMmPerMin);
  settings.startDeadline = plan.startDeadline;
  return settings;
}

}  // namespace

bool isOfTest(job::NativeReason reason) {
  using job::NativeReason;
  return reason == NativeReason::Dwell || reason == NativeReason::Message ||
         reason == NativeReason::Mode || reason == NativeReason::End ||
         reason == NativeReason::UnknownPosition;
}

Result<JobTestJob> makeJobTestJob(const JobTestPlan& plan, base::Vec3 startMm) {
  const Written written = programOf(plan, startMm);
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  auto made = job::makePlan(std::string(kJobTestSource), written.text, options);
  if (!made) {
    return base::fail(made.error());
  }
  JobTestJob test;
  test.plan = std::move(*made);
  test.nearMm = startMm[static_cast<std::size_t>(plan.move.axis)];
  test.farMm = test.nearMm + plan.move.mm;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    auto kinds = kindsOf(test.plan, plan.blocks[i], written.trials[i]);
    if (!kinds) {
      return base::fail(kinds.error());
    }
    test.kinds.push_back(std::move(*kinds));
  }
  // Each way is a stretch with one point; a way back that is left belongs to the last one.
  const std::size_t ways = kStretchesOfTest + plan.blocks.size();
  const bool isInTurns =
      test.plan.stretchCount() == ways &&
      test.plan.program.trajectory.points.size() == ways + plan.blocks.size() % 2;
  if (!isInTurns || !isAgreed(test, static_cast<std::size_t>(plan.move.axis))) {
    return base::fail(StreamError::BadTestBlock,
                      "After these blocks the test would not make the move that was agreed to. "
                      "Leave out what sets coordinates or the plane, and positions of other axes.");
  }
  const auto dwell =
      std::find_if(test.plan.parts.begin(), test.plan.parts.end(), [](const job::Part& part) {
        const auto* const native = std::get_if<job::NativeBlock>(&part);
        return native != nullptr && native->source == fmt::format("G4 F{:g}", kTestDwellS);
      });
  test.dwellPart = static_cast<std::size_t>(dwell - test.plan.parts.begin());
  test.settings = settingsOf(plan);
  auto programs = job::makePrograms(test.plan, test.settings.parameters);
  if (!programs) {
    return base::fail(programs.error());
  }
  test.programs = std::move(*programs);
  return test;
}

}  // namespace rivulet::streaming
