// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/design_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "machine/servo_model.h"
#include "papers/catalogue.h"
#include "papers/figures.h"
#include "papers/learned_machine.h"
#include "papers/planned_run.h"

namespace rivulet::papers {

namespace {

using base::Result;
using base::Vec3;
using emulator::DesignMove;
using emulator::Emulator;
using emulator::LearnedAxis;
using emulator::PlannedMoves;
using emulator::TrainingRun;

constexpr double kDurationS = 25.0;  ///< that of G1 as it was recorded
constexpr double kDesignNoiseMm = 0.002;
constexpr double kStairMm = 12.0;
constexpr double kRestS = 0.3;
/// Extent of G1 and G3.
constexpr Vec3 kDesignBoxMm{60.0, 48.0, 0.0};

/// Steps of a staircase: as many as there is time for.
std::vector<DesignMove> stairs(const std::vector<double>& feeds, bool isDiamond) {
  std::vector<DesignMove> moves;
  Vec3 at;
  double seconds = 0.0;
  for (int i = 0;; ++i) {
    const double feed = feeds[static_cast<std::size_t>(i / 2) % feeds.size()];
    seconds += kStairMm / feed + 0.05;
    if (seconds > kDurationS - 0.5) {
      return moves;
    }
    // A diamond has two steps on each of its sides.
    const int side = isDiamond ? (i / 4) % 4 : 0;
    const double x = side == 0 || side == 3 ? 1.0 : -1.0;
    const double y = side < 2 ? 1.0 : -1.0;
    at = at + (i % 2 == 0 ? Vec3{kStairMm * x, 0.0, 0.0} : Vec3{0.0, kStairMm * y, 0.0});
    moves.push_back({at, feed, 0.0});
  }
}

struct StudiedProgram {
  std::string name;
  PlannedMoves run;
  double logDeterminant = 0.0;
  double parameterShare = 0.0;  ///< RMS relative error of the parameters
  double heldOutMm = 0.0;       ///< RMS error of positions on another program
};

TrainingRun observed(const machine::MachineConfig& machine, const PlannedMoves& planned,
                     double noiseMm, base::Random random) {
  base::AxisPosition start;
  start.mm = planned.setPointsMm.front();
  machine::ServoModel servo(machine, start);
  TrainingRun run{"studied", planned.periodS, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
  for (std::size_t i = 0; i < planned.setPointsMm.size(); ++i) {
    const Vec3 actual =
        servo.follow(planned.setPointsMm[i > 0 ? i - 1 : 0], planned.setPointsMm[i]);
    run.observedAt.push_back(planned.periodS * static_cast<double>(i));
    for (std::size_t axis = 0; axis < run.axes.size(); ++axis) {
      run.axes[axis].reference.push_back(planned.setPointsMm[i][axis]);
      run.axes[axis].observed.push_back(actual[axis] + noiseMm * random.normal());
    }
  }
  return run;
}

/// Of the structure that the axes have.
Result<Emulator> learnKnown(const machine::MachineConfig& machine, const TrainingRun& run) {
  Emulator emulator;
  for (std::size_t axis = 0; axis < run.axes.size(); ++axis) {
    emulator::AxisParameters structure = *machine.axisLaw(axis);
    for (const emulator::AxisParameterFacts& facts : emulator::axisParameterFacts()) {
      if (structure[facts.parameter] > 0.0) {
        structure[facts.parameter] = facts.typical;
      }
    }
    auto learned =
        emulator::learnAxis({&run, 1}, base::kAxisNames[axis], {.structure = &structure});
    if (!learned) {
      return base::fail(learned.error());
    }
    emulator.axes.push_back(std::move(*learned));
  }
  return emulator;
}

/// Squares of the relative errors, by their logarithms.
double parameterShare(const machine::MachineConfig& machine, const Emulator& learned) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t axis = 0; axis < learned.axes.size(); ++axis) {
    for (const emulator::ParameterEstimate& one : learned.axes[axis].estimates) {
      const double off = std::log(one.value / (*machine.axisLaw(axis))[one.parameter]);
      squares += off * off;
      count += 1.0;
    }
  }
  return std::sqrt(squares / count);
}

/// A program of corners, slow turns and fast lines that none of the others is.
std::vector<DesignMove> heldOutMoves() {
  return {{{50.0, 0.0, 0.0}, 40.0, 0.0},  {{50.0, 2.0, 0.0}, 1.0, 0.0},
          {{20.0, 30.0, 0.0}, 25.0, 0.0}, {{20.0, 30.0, 0.0}, 20.0, 10.0},
          {{19.0, 29.0, 0.0}, 2.0, 0.0},  {{21.0, 31.0, 0.0}, 2.0, 0.0},
          {{0.0, 40.0, 0.0}, 12.0, 0.0},  {{55.0, 45.0, 0.0}, 50.0, 0.0},
          {{0.0, 0.0, 0.0}, 30.0, 0.0}};
}

Result<void> study(StudiedProgram& program, const machine::MachineConfig& machine,
                   const Emulator& known, const TrainingRun& heldOut, std::size_t draws) {
  program.logDeterminant =
      emulator::informationOf(known, program.run,
                              {.noiseMm = kDesignNoiseMm, .usesIntervals = false})
          .logDeterminant;
  const base::Random random(18);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const auto learned =
        learnKnown(machine, observed(machine, program.run, kDesignNoiseMm, random.fork(draw + 1)));
    if (!learned) {
      return base::fail(learned.error());
    }
    const auto fit = emulator::testRun(*learned, heldOut);
    if (!fit) {
      return base::fail(fit.error());
    }
    const double share = parameterShare(machine, *learned);
    program.parameterShare += share * share / static_cast<double>(draws);
    program.heldOutMm += fit->positionRmsMm * fit->positionRmsMm / static_cast<double>(draws);
  }
  program.parameterShare = std::sqrt(program.parameterShare);
  program.heldOutMm = std::sqrt(program.heldOutMm);
  return {};
}

/// Two axes of the known machine.
machine::MachineConfig studiedMachine() {
  machine::MachineConfig config = cascadeMachine();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    (*config.learnedAxes[axis])[emulator::AxisParameter::Delay] = 0.0;
  }
  return config;
}

Result<Experiment> judge(const std::vector<StudiedProgram>& programs,
                         const DesignStudyOptions& options) {
  Table table{"Learned from each program, with noise",
              {"program", "duration (s)", "logarithm of the determinant of the information",
               "parameters, RMS error (%)", "positions on another program, RMS error (µm)"},
              {}};
  StudiedProgram best = programs.front();
  best.parameterShare = best.heldOutMm = 1e9;
  StudiedProgram worst;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const StudiedProgram& one = programs[i];
    table.rows.push_back(
        {one.name,
         fmt::format("{:.1f}", one.run.periodS * static_cast<double>(one.run.setPointsMm.size())),
         fmt::format("{:.1f}", one.logDeterminant),
         fmt::format("{:.2f}", 100.0 * one.parameterShare),
         fmt::format("{:.3f}", 1e3 * one.heldOutMm)});
    if (i < 3) {
      best.parameterShare = std::min(best.parameterShare, one.parameterShare);
      best.heldOutMm = std::min(best.heldOutMm, one.heldOutMm);
    } else {
      worst.parameterShare = std::max(worst.parameterShare, one.parameterShare);
      worst.heldOutMm = std::max(worst.heldOutMm, one.heldOutMm);
    }
  }
  Experiment result;
  result.name = "design";
  result.title = "Proposed programs against the designs of [P2]";
  result.setup = fmt::format(
      "Virtual machine with two axes as cascades, positions with a noise of {} µm every 4 ms. G1 "
      "to "
      "G3 are cut to {} s, which the proposed programs also take. The proposals are searched with "
      "what was learned from G1. Learned {} times from each program, with the structure that the "
      "axes have.",
      1e3 * kDesignNoiseMm, kDurationS, options.draws);
  result.tables = {std::move(table)};
  result.checks = {{.what = "parameters, RMS error: the worse proposal",
                    .unit = "%",
                    .source = "the best of G1 to G3",
                    .reference = 100.0 * best.parameterShare,
                    .ours = 100.0 * worst.parameterShare,
                    .highest = 100.0 * best.parameterShare},
                   {.what = "positions on another program, RMS error: the worse proposal",
                    .unit = "mm",
                    .source = "the best of G1 to G3",
                    .reference = best.heldOutMm,
                    .ours = worst.heldOutMm,
                    .highest = best.heldOutMm}};
  return result;
}

}  // namespace

emulator::PlanMoves planMovesOn(const machine::MachineConfig& config) {
  return [config](Vec3 startMm, std::span<const DesignMove> moves) {
    std::vector<machine::PreparedMotion> blocks;
    Vec3 at = startMm;
    for (const DesignMove& move : moves) {
      machine::PreparedMotion block;
      block.end = machine::BlockEnd::Rounded;
      block.roundingMm = config.roundingMm;
      block.feedMmPerS = move.feedMmPerS;
      block.targetMm = move.radiusMm > 0.0 ? at : move.toMm;
      if (move.radiusMm > 0.0) {
        machine::ArcPath arc;
        arc.centreMm = at + Vec3{move.radiusMm, 0.0, 0.0};
        arc.axis = {0.0, 0.0, 1.0};
        arc.sweepRad = 2.0 * std::numbers::pi;
        block.arc = arc;
      }
      at = block.targetMm;
      blocks.push_back(block);
    }
    // The axes stand first, so that their state is known when they begin to move.
    PlannedMoves planned{base::toSeconds(config.interpolationCycle), {}};
    planned.setPointsMm.assign(static_cast<std::size_t>(kRestS / planned.periodS), startMm);
    const PlannedRun run = planRun(blocks, startMm, config);
    planned.setPointsMm.insert(planned.setPointsMm.end(), run.commandsMm.begin(),
                               run.commandsMm.end());
    return planned;
  };
}

Result<Experiment> runDesignStudy(const DesignStudyOptions& options) {
  const machine::MachineConfig machine = studiedMachine();
  const emulator::PlanMoves plan = planMovesOn(machine);
  std::vector<StudiedProgram> programs;
  const auto add = [&](const std::string& name, const std::vector<DesignMove>& moves) {
    PlannedMoves run = plan({}, moves);
    run.setPointsMm.resize(static_cast<std::size_t>(kDurationS / run.periodS),
                           run.setPointsMm.back());
    programs.push_back({name, std::move(run)});
  };
  add("G1", stairs({6.0}, false));
  add("G2", stairs({6.0}, true));
  add("G3", stairs({3.0, 6.0, 16.0}, false));
  const base::Random random(19);
  auto known =
      learnKnown(machine, observed(machine, programs.front().run, kDesignNoiseMm, random.fork(0)));
  if (!known) {
    return base::fail(known.error());
  }
  for (const double feedMax : {16.0, 50.0}) {
    const auto proposed = emulator::proposeProgram(
        *known, {{}, kDesignBoxMm, 3.0, feedMax, kDurationS}, plan,
        {.noiseMm = kDesignNoiseMm, .exchanges = options.exchanges, .usesIntervals = false});
    if (!proposed) {
      return base::fail(proposed.error());
    }
    add(fmt::format("proposed, 3 to {} mm/s", feedMax), proposed->moves);
  }
  PlannedMoves heldOutMoved = plan({}, heldOutMoves());
  const TrainingRun heldOut = observed(machine, heldOutMoved, 0.0, random.fork(1));
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (options.progress &&
        !options.progress(static_cast<double>(i) / static_cast<double>(programs.size()))) {
      return base::fail(ExperimentError::Cancelled, "The experiment was cancelled.");
    }
    if (auto done = study(programs[i], machine, *known, heldOut, options.draws); !done) {
      return base::fail(done.error());
    }
  }
  return judge(programs, options);
}

}  // namespace rivulet::papers
