// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/learned_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/file.h"
#include "machine/machine.h"
#include "papers/planned_run.h"
#include "trace/motion.h"
#include "training/recorded_run.h"

namespace rivulet::papers {

namespace {

namespace fs = std::filesystem;
using base::Result;
using emulator::AxisParameter;
using emulator::AxisParameters;
using emulator::Emulator;
using emulator::LearnedAxis;
using emulator::ParameterEstimate;
using emulator::TrainingRun;
using machine::MachineConfig;

constexpr double kMovedMm = 1e-3;

/// When the first axis has left its first set point, s; the end if none does.
double firstMotionS(const TrainingRun& run) {
  std::size_t first = run.axes.front().reference.size();
  for (const emulator::AxisTrack& track : run.axes) {
    const auto left = std::ranges::find_if(track.reference, [&](double mm) {
      return std::abs(mm - track.reference.front()) > kMovedMm;
    });
    first = std::min(first, static_cast<std::size_t>(left - track.reference.begin()));
  }
  return run.period * static_cast<double>(first);
}

double lastMotionS(const TrainingRun& run) {
  std::size_t last = 0;
  for (const emulator::AxisTrack& track : run.axes) {
    const auto left =
        std::find_if(track.reference.rbegin(), track.reference.rend(),
                     [&](double mm) { return std::abs(mm - track.reference.back()) > kMovedMm; });
    last = std::max(last, static_cast<std::size_t>(track.reference.rend() - left));
  }
  return run.period * static_cast<double>(last);
}

/// Direction in which a block ends.
base::Vec3 directionAt(const machine::PreparedMotion& block, base::Vec3 fromMm, base::Vec3 atMm) {
  base::Vec3 along = block.targetMm - fromMm;
  if (block.arc) {
    const base::Vec3 radius = atMm - block.arc->centreMm;
    along = block.arc->axis.z > 0.0 ? base::Vec3{-radius.y, radius.x, 0.0}
                                    : base::Vec3{radius.y, -radius.x, 0.0};
  }
  return (1.0 / base::norm(along)) * along;
}

/// The recorded planner stops exactly at corners, not where the path goes on in its direction.
void passWhereItGoesOnStraight(std::vector<machine::PreparedMotion>& blocks, base::Vec3 startMm) {
  constexpr double kTurn = 1e-3;
  base::Vec3 fromMm = startMm;
  for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
    const base::Vec3 atMm = blocks[i].targetMm;
    const base::Vec3 turn =
        directionAt(blocks[i + 1], atMm, atMm) - directionAt(blocks[i], fromMm, atMm);
    if (blocks[i].end == machine::BlockEnd::ExactStop && base::norm(turn) < kTurn) {
      blocks[i].end = machine::BlockEnd::Rounded;
      blocks[i].roundingMm = 0.0;
    }
    fromMm = atMm;
  }
}

/// The recorded run with set points that the virtual machine has planned from its program.
Result<TrainingRun> plannedFrom(const fs::path& program, const TrainingRun& recorded) {
  const auto text = base::readFile(program);
  if (!text) {
    return base::fail(text.error());
  }
  base::Vec3 startMm;
  for (std::size_t axis = 0; axis < recorded.axes.size(); ++axis) {
    startMm.set(axis, recorded.axes[axis].reference.front());
  }
  auto blocks = training::parseRecordedProgram(*text, startMm);
  if (!blocks) {
    return base::fail(blocks.error());
  }
  const bool stops = !blocks->empty() && blocks->front().end == machine::BlockEnd::ExactStop;
  passWhereItGoesOnStraight(*blocks, startMm);
  const MachineConfig config = recordedMachine(stops ? kExactStopShare : 1.0);
  const PlannedRun planned = planRun(*blocks, startMm, config);
  TrainingRun run{recorded.name, base::toSeconds(config.interpolationCycle), {}, {}};
  for (std::size_t axis = 0; axis < recorded.axes.size(); ++axis) {
    emulator::AxisTrack track{recorded.axes[axis].axis, {startMm[axis]}, {}};
    for (const base::Vec3& mm : planned.commandsMm) {
      track.reference.push_back(mm[axis]);
    }
    run.axes.push_back(std::move(track));
  }
  // Both begin to move at the same time; what was seen later than the plan lasts is left out.
  const double shiftS = firstMotionS(run) - firstMotionS(recorded);
  const double endS = run.period * static_cast<double>(planned.commandsMm.size());
  for (std::size_t i = 0; i < recorded.observedAt.size(); ++i) {
    const double atS = recorded.observedAt[i] + shiftS;
    if (atS < 0.0 || atS > endS) {
      continue;
    }
    run.observedAt.push_back(atS);
    for (std::size_t axis = 0; axis < recorded.axes.size(); ++axis) {
      run.axes[axis].observed.push_back(recorded.axes[axis].observed[i]);
    }
  }
  return run;
}

constexpr std::string_view kOtherProgram =
    "G64 G90 G17\nG1 X-15 Y8 F2000\nX10 Y-12 Z47\nG2 X10 Y-12 I8 J0 F5000\nG1 X12 Y30 "
    "F8000\n"
    "X-20 Y-20 Z52\nX-20 Y-19 F100\nX0 Y0 Z50 F3000\nM30\n";

struct KnownMachine {
  std::string name;
  MachineConfig config;
};

std::vector<KnownMachine> knownMachines() {
  return {{"dmu75", *machine::loadPreset(machine::kDefaultPreset)},
          {"dmu75 with cascades", cascadeMachine()}};
}

struct Recovered {
  double parameterShare = 0.0;  ///< largest deviation of a parameter
  double rmsMm = 0.0;           ///< on the other program
};

/// @param table  gets a row for each true or learned parameter
void compareAxis(Table& table, const std::string& machine, const AxisParameters& known,
                 const LearnedAxis& learned, double& worstShare) {
  for (const emulator::AxisParameterFacts& facts : emulator::axisParameterFacts()) {
    const double isTrue = known[facts.parameter];
    const auto found =
        std::ranges::find(learned.estimates, facts.parameter, &ParameterEstimate::parameter);
    const bool isLearned = found != learned.estimates.end();
    if (!isLearned && (isTrue == 0.0 || known[AxisParameter::SpeedGain] == 0.0)) {
      continue;
    }
    table.rows.push_back({machine, std::string(1, learned.axis), std::string(facts.key),
                          fmt::format("{:.5g}", isTrue),
                          isLearned ? fmt::format("{:.5g}", found->value) : "",
                          isLearned && found->hasInterval()
                              ? fmt::format("{:.5g} to {:.5g}", found->low, found->high)
                              : "",
                          std::string(facts.unit)});
    worstShare = std::max(worstShare,
                          isLearned && isTrue > 0.0 ? std::abs(found->value / isTrue - 1.0) : 1.0);
  }
}

Result<Recovered> recover(const KnownMachine& known, Table& parameters, Table& runs) {
  const auto recorded = controlTraceOf(known.config, programToLearnFrom());
  const auto truth = controlTraceOf(known.config, kOtherProgram);
  if (!recorded || !truth) {
    return base::fail(recorded ? truth.error() : recorded.error());
  }
  const auto run = emulator::trainingRunOf(trace::motionOf(*recorded), "learned from");
  if (!run) {
    return base::fail(run.error());
  }
  const auto axes = emulator::learnAxes({&*run, 1});
  if (!axes) {
    return base::fail(axes.error());
  }
  Recovered result;
  MachineConfig config = known.config;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const auto found = std::ranges::find(*axes, base::kAxisNames[axis], &LearnedAxis::axis);
    if (found == axes->end()) {
      continue;
    }
    config.learnedAxes[axis] = found->parameters;
    compareAxis(parameters, known.name, *known.config.axisLaw(axis), *found, result.parameterShare);
  }
  const auto predicted = controlTraceOf(config, kOtherProgram);
  if (!predicted) {
    return base::fail(predicted.error());
  }
  const std::size_t count = std::min(truth->samples.size(), predicted->samples.size());
  double maxMm = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double error = base::distance(truth->samples[i].actualMm, predicted->samples[i].actualMm);
    result.rmsMm += error * error / static_cast<double>(count);
    maxMm = std::max(maxMm, error);
  }
  result.rmsMm = std::sqrt(result.rmsMm);
  const double cycleS = base::toSeconds(truth->cycle);
  runs.rows.push_back(
      {known.name, fmt::format("{:.2f}", cycleS * static_cast<double>(truth->samples.size())),
       fmt::format("{:.2f}", cycleS * static_cast<double>(predicted->samples.size())),
       fmt::format("{:.4f}", 1e3 * result.rmsMm), fmt::format("{:.4f}", 1e3 * maxMm)});
  return result;
}

}  // namespace

MachineConfig cascadeMachine() {
  MachineConfig config = *machine::loadPreset(machine::kDefaultPreset);
  constexpr std::array<double, base::kAxisCount> kGains{45.0, 38.0, 30.0};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    AxisParameters law;
    law[AxisParameter::PositionGain] = kGains[axis];
    law[AxisParameter::FeedForward] = axis == 0 ? 0.8 : 0.0;
    law[AxisParameter::SpeedGain] = 110.0 - 10.0 * static_cast<double>(axis);
    law[AxisParameter::ResetTime] = 0.015;
    law[AxisParameter::Coulomb] = 80.0;
    law[AxisParameter::CoulombSpeed] = 0.5;
    law[AxisParameter::Delay] = axis == 0 ? 0.0 : 0.002;
    config.learnedAxes[axis] = law;
  }
  return config;
}

std::string_view programToLearnFrom() {
  return "G64 G90 G17\nG1 X20 Y0 Z48 F3000\nX20 Y15\nX0 Y15 F1200\nX0 Y0\nX30 Y20 Z50 "
         "F6000\n"
         "G3 X30 Y20 I-10 J0 F3000\nG1 X29 Y19 F300\nX31 Y21\nX29 Y19 Z49\nX0 Y0 Z50 F4000\n"
         "M30\n";
}

Result<trace::ControlTrace> controlTraceOf(const MachineConfig& config, std::string_view program) {
  machine::Machine machine(config, 1);
  if (auto done = machine.storeProgram("P.MPF", std::string(program), true); !done) {
    return base::fail(done.error());
  }
  if (auto done = machine.selectProgram("P.MPF"); !done) {
    return base::fail(done.error());
  }
  if (auto done = machine.cycleStart(); !done) {
    return base::fail(done.error());
  }
  constexpr int kSecondsMax = 600;
  int seconds = 0;
  do {
    machine.advance(machine.now() + std::chrono::seconds{1});
  } while (machine.state().channel == machine::ChannelStatus::Active && ++seconds < kSecondsMax);
  return machine.trace();
}

Result<void> addPredictedDesigns(Experiment& experiment, const fs::path& folder,
                                 const Emulator& emulator, std::span<const TrainingRun> designs) {
  Table table{
      "Designs predicted from their programs alone: set points by the look-ahead of the "
      "virtual machine, positions by the learned emulator",
      {"run", "duration recorded (s)", "predicted (s)", "position RMS (µm)",
       "contour error RMS (µm)", "predicted (µm)"},
      {}};
  double worstDuration = 0.0;
  double worstContourMm = 0.0;
  for (const TrainingRun& recorded : designs) {
    const std::string design = recorded.name.substr(0, recorded.name.find("_250hz"));
    const auto planned = plannedFrom(folder / "programs" / (design + ".ngc"), recorded);
    const auto fit = planned ? emulator::testRun(emulator, *planned)
                             : Result<emulator::RunFit>(base::fail(planned.error()));
    const auto seen = emulator::testRun(emulator, recorded);
    if (!fit || !seen) {
      return base::fail(fit ? seen.error() : fit.error());
    }
    const double recordedS = lastMotionS(recorded) - firstMotionS(recorded);
    const double plannedS = lastMotionS(*planned) - firstMotionS(*planned);
    worstDuration = std::max(worstDuration, std::abs(plannedS / recordedS - 1.0));
    worstContourMm =
        std::max(worstContourMm, std::abs(fit->emulatedContourRmsMm - seen->contourRmsMm));
    table.rows.push_back({design, fmt::format("{:.3f}", recordedS), fmt::format("{:.3f}", plannedS),
                          fmt::format("{:.1f}", 1e3 * fit->positionRmsMm),
                          fmt::format("{:.1f}", 1e3 * seen->contourRmsMm),
                          fmt::format("{:.1f}", 1e3 * fit->emulatedContourRmsMm)});
  }
  experiment.tables.push_back(std::move(table));
  experiment.checks.push_back({.what = "duration predicted from a program, off by, worst design",
                               .unit = "%",
                               .source = "",
                               .ours = 100.0 * worstDuration,
                               .highest = 5.0});
  experiment.checks.push_back(
      {.what = "contour error's RMS predicted from a program, off by, worst design",
       .unit = "mm",
       .source = "",
       .ours = worstContourMm,
       .highest = 0.05});
  return {};
}

Result<void> addKnownMachines(Experiment& experiment) {
  Table parameters{"Virtual machines with known axes: parameters learned from one program",
                   {"machine", "axis", "parameter", "true", "learned", "interval", "unit"},
                   {}};
  Table runs{"The learned emulator as the servo of a virtual machine: another program",
             {"machine", "duration (s)", "predicted (s)", "position RMS (µm)", "max (µm)"},
             {}};
  Recovered worst;
  for (const KnownMachine& known : knownMachines()) {
    const auto recovered = recover(known, parameters, runs);
    if (!recovered) {
      return base::fail(recovered.error());
    }
    worst.parameterShare = std::max(worst.parameterShare, recovered->parameterShare);
    worst.rmsMm = std::max(worst.rmsMm, recovered->rmsMm);
  }
  experiment.tables.push_back(std::move(parameters));
  experiment.tables.push_back(std::move(runs));
  experiment.checks.push_back({.what = "known axes: parameter learned, off by, worst",
                               .unit = "%",
                               .source = "",
                               .ours = 100.0 * worst.parameterShare,
                               .highest = 2.0});
  experiment.checks.push_back({.what = "known axes: position on another program, RMS, worst",
                               .unit = "mm",
                               .source = "",
                               .ours = worst.rmsMm,
                               .highest = 0.001});
  return {};
}

}  // namespace rivulet::papers
