// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/tampering.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "emulator/monitor.h"
#include "machine/servo_model.h"
#include "papers/catalogue.h"
#include "papers/figures.h"
#include "papers/learned_machine.h"
#include "trace/motion.h"

namespace rivulet::papers {

namespace {

using base::Result;
using base::Vec3;
using emulator::Emulator;
using emulator::TrainingRun;
using machine::MachineConfig;

constexpr double kShiftMm = 0.05;
constexpr double kNoiseMm = 0.002;  ///< of each position that is reported, standard deviation
constexpr double kHoldS = 0.1;      ///< between two random values of a watermark
constexpr double kRampS = 0.1;      ///< in which an axis is shifted
constexpr double kWatermarkFalseAlarm = 0.001;
constexpr std::array<double, 4> kWatermarksMm{0.0001, 0.0002, 0.0005, 0.001};

/// A rounded figure of eight in short blocks, twice.
std::string guardedProgram() {
  std::string text = "G64 G90 G1 F3000\n";
  constexpr int kBlocks = 1200;
  for (int i = 0; i <= kBlocks; ++i) {
    const double t = 4.0 * 3.14159265358979323846 * i / kBlocks;
    text += fmt::format("X{:.4f} Y{:.4f}\n", 40.0 * std::sin(t), 25.0 * std::sin(2.0 * t));
  }
  return text + "M30\n";
}

using SetPoints = std::vector<Vec3>;  ///< or positions; one each interpolation cycle

SetPoints setPointsOf(const trace::ControlTrace& trace) {
  SetPoints course;
  for (const trace::ControlSample& sample : trace.samples) {
    course.push_back(sample.commandMm);
  }
  return course;
}

/// Random values every kHoldS, straight between them.
SetPoints watermarkOf(std::size_t count, double cycleS, double deviationMm, base::Random random) {
  SetPoints watermark;
  const auto hold = static_cast<std::size_t>(kHoldS / cycleS + 0.5);
  const auto draw = [&] {
    const double x = random.normal();
    const double y = random.normal();
    return deviationMm * Vec3{x, y, 0.0};
  };
  Vec3 from;
  Vec3 to = draw();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && i % hold == 0) {
      from = std::exchange(to, draw());
    }
    const double share = static_cast<double>(i % hold) / static_cast<double>(hold);
    watermark.push_back(from + share * (to - from));
  }
  return watermark;
}

/// 0, and from the middle on kShiftMm in X.
SetPoints shiftOf(std::size_t count, double cycleS) {
  SetPoints shift;
  for (std::size_t i = 0; i < count; ++i) {
    const double afterS = (static_cast<double>(i) - 0.5 * static_cast<double>(count)) * cycleS;
    shift.push_back({kShiftMm * std::clamp(afterS / kRampS, 0.0, 1.0), 0.0, 0.0});
  }
  return shift;
}

SetPoints sum(SetPoints course, const SetPoints& other) {
  for (std::size_t i = 0; i < course.size(); ++i) {
    course[i] = course[i] + other[i];
  }
  return course;
}

/// What the axes of the machine do, as it is reported.
SetPoints reported(const MachineConfig& machine, const SetPoints& setPoints, base::Random random) {
  base::AxisPosition start;
  start.mm = setPoints.front();
  machine::ServoModel servo(machine, start);
  SetPoints course;
  for (std::size_t i = 0; i < setPoints.size(); ++i) {
    const Vec3 actual = servo.follow(setPoints[i > 0 ? i - 1 : 0], setPoints[i]);
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    course.push_back(actual + kNoiseMm * Vec3{x, y, z});
  }
  return course;
}

TrainingRun runOf(const SetPoints& setPoints, const SetPoints& seen, double cycleS) {
  TrainingRun run{"guarded", cycleS, {}, {}};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    emulator::AxisTrack track{base::kAxisNames[axis], {}, {}};
    for (std::size_t i = 0; i < setPoints.size(); ++i) {
      track.reference.push_back(setPoints[i][axis]);
      track.observed.push_back(seen[i][axis]);
    }
    run.axes.push_back(std::move(track));
  }
  for (std::size_t i = 0; i < setPoints.size(); ++i) {
    run.observedAt.push_back(cycleS * static_cast<double>(i));
  }
  return run;
}

/// The machine, what was learned of it, and the program that is guarded.
struct Guard {
  MachineConfig machine;
  double cycleS = 0.0;
  SetPoints setPoints;
  Emulator emulator;
};

Result<Guard> learnGuard() {
  Guard guard{cascadeMachine(), 0.0, {}, {}};
  const auto recorded = controlTraceOf(guard.machine, programToLearnFrom());
  const auto program = controlTraceOf(guard.machine, guardedProgram());
  if (!recorded || !program) {
    return base::fail(recorded ? program.error() : recorded.error());
  }
  guard.cycleS = base::toSeconds(guard.machine.interpolationCycle);
  guard.setPoints = setPointsOf(*program);
  const base::Random random(16);
  const SetPoints learned = setPointsOf(*recorded);
  const TrainingRun run =
      runOf(learned, reported(guard.machine, learned, random.fork(0)), guard.cycleS);
  auto axes = emulator::learnAxes({&run, 1});
  if (!axes) {
    return base::fail(axes.error());
  }
  guard.emulator.axes = std::move(*axes);
  std::vector<TrainingRun> inGoodOrder;
  for (std::uint64_t i = 1; i <= 10; ++i) {
    inGoodOrder.push_back(runOf(
        guard.setPoints, reported(guard.machine, guard.setPoints, random.fork(i)), guard.cycleS));
  }
  if (auto done = emulator::measurePeaks(guard.emulator, inGoodOrder); !done) {
    return base::fail(done.error());
  }
  return guard;
}

/// The statistic of X and Y together: their shares, weighted by what each can tell.
emulator::MissingShare missingOf(const Guard& guard, const TrainingRun& run,
                                 const SetPoints& watermark) {
  std::vector<double> residuals;
  std::vector<double> answers;
  std::vector<double> atS;
  const auto ofRun = emulator::residualsOf(guard.emulator, run);
  if (!ofRun) {
    return {};
  }
  double beginS = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const emulator::LearnedAxis* const learned = guard.emulator.find(base::kAxisNames[axis]);
    emulator::AxisTrack without = run.axes[axis];
    for (std::size_t i = 0; i < without.reference.size(); ++i) {
      without.reference[i] -= watermark[i][axis];
    }
    const auto answerOf = [&](const emulator::AxisTrack& track) {
      return emulator::predict(learned->parameters,
                               emulator::setPointGrid(track, run.period, learned->goesStraight),
                               run.observedAt);
    };
    const auto with = answerOf(run.axes[axis]);
    const auto bare = answerOf(without);
    for (std::size_t i = 0; i < with.size(); ++i) {
      answers.push_back(with[i].mm - bare[i].mm);
      atS.push_back(beginS + run.observedAt[i]);
    }
    residuals.insert(residuals.end(), (*ofRun)[axis].mm.begin(), (*ofRun)[axis].mm.end());
    beginS += run.observedAt.back() + 1.0;
  }
  return emulator::missingWatermark(residuals, answers, atS);
}

std::string sharesText(std::size_t hits, std::size_t trials) {
  const Share share = shareOf(hits, trials);
  return fmt::format("{} of {}: {:.2f} % ({:.2f} to {:.2f})", hits, trials, 100.0 * share.seen,
                     100.0 * share.low, 100.0 * share.high);
}

/// What was noticed of one watermark.
struct Noticed {
  std::size_t falseAlarms = 0;
  std::size_t hidden = 0;
  double shareHonest = 0.0;  ///< that is missing, mean of all runs
  double shareHidden = 0.0;
  double standardError = 0.0;
};

/// Runs on the machine, and what the monitor and the test for the watermark make of them.
struct Trials {
  std::size_t falseMarks = 0;
  std::size_t openNoticed = 0;
  std::size_t hiddenMarked = 0;
  std::array<Noticed, kWatermarksMm.size()> watermarks;

  /// One run of each kind per watermark. @param draws  of all, for the means
  void draw(const Guard& guard, const SetPoints& shift, const base::Random& random, double draws);
};

void Trials::draw(const Guard& guard, const SetPoints& shift, const base::Random& random,
                  double draws) {
  const auto marks = [&](const TrainingRun& run) {
    const auto found = emulator::findDeviations(guard.emulator, run);
    return found ? found->size() : 0;
  };
  for (std::size_t i = 0; i < kWatermarksMm.size(); ++i) {
    const SetPoints watermark =
        watermarkOf(guard.setPoints.size(), guard.cycleS, kWatermarksMm[i], random.fork(10 * i));
    const SetPoints asked = sum(guard.setPoints, watermark);
    const TrainingRun honest =
        runOf(asked, reported(guard.machine, asked, random.fork(10 * i + 1)), guard.cycleS);
    // Who shifts the axes knows program and machine, but not the watermark.
    const TrainingRun hidden = runOf(
        asked, reported(guard.machine, guard.setPoints, random.fork(10 * i + 2)), guard.cycleS);
    const emulator::MissingShare ofHonest = missingOf(guard, honest, watermark);
    const emulator::MissingShare ofHidden = missingOf(guard, hidden, watermark);
    const double threshold = emulator::watermarkThreshold(ofHonest.windows, kWatermarkFalseAlarm);
    Noticed& of = watermarks[i];
    of.falseAlarms += ofHonest.statistic() > threshold ? 1 : 0;
    of.hidden += ofHidden.statistic() > threshold ? 1 : 0;
    of.shareHonest += ofHonest.share / draws;
    of.shareHidden += ofHidden.share / draws;
    of.standardError += ofHonest.standardError / draws;
    if (kWatermarksMm[i] == kWatermarksMm.back()) {
      falseMarks += marks(honest);
      hiddenMarked += marks(hidden) > 0 ? 1 : 0;
      openNoticed +=
          marks(runOf(asked, reported(guard.machine, sum(asked, shift), random.fork(10 * i + 3)),
                      guard.cycleS)) > 0
              ? 1
              : 0;
    }
  }
}

Table peaksTable(const Guard& guard) {
  const emulator::MonitorOptions monitor;
  Table peaks{"Residual monitor", {"axis", "threshold (µm)", "location (µm)", "scale (µm)"}, {}};
  for (const emulator::LearnedAxis& axis : guard.emulator.axes) {
    peaks.rows.push_back(
        {std::string(1, axis.axis),
         fmt::format("{:.2f}",
                     1e3 * emulator::peakThresholdMm(axis, guard.emulator.axes.size(), monitor)),
         fmt::format("{:.2f}", 1e3 * axis.peaks.locationMm),
         fmt::format("{:.2f}", 1e3 * axis.peaks.scaleMm)});
  }
  return peaks;
}

Table ratesTable(const Trials& trials, std::size_t draws, double hours) {
  Table rates{
      "What is noticed; in parentheses 95 % intervals", {"test", "false alarms", "noticed"}, {}};
  rates.rows.push_back({"residual monitor, positions reported as they are",
                        fmt::format("{} in {:.2f} h", trials.falseMarks, hours),
                        sharesText(trials.openNoticed, draws)});
  rates.rows.push_back(
      {"residual monitor, positions made up", "", sharesText(trials.hiddenMarked, draws)});
  for (std::size_t i = 0; i < kWatermarksMm.size(); ++i) {
    rates.rows.push_back(
        {fmt::format("watermark of {} µm, positions made up", 1e3 * kWatermarksMm[i]),
         sharesText(trials.watermarks[i].falseAlarms, draws),
         sharesText(trials.watermarks[i].hidden, draws)});
  }
  return rates;
}

Table sharesTable(const Trials& trials) {
  Table shares{"Share of the watermark that is missing, mean of all runs",
               {"watermark (µm)", "honest", "made up", "standard error of one run"},
               {}};
  for (std::size_t i = 0; i < kWatermarksMm.size(); ++i) {
    const Noticed& of = trials.watermarks[i];
    shares.rows.push_back(
        {fmt::format("{}", 1e3 * kWatermarksMm[i]), fmt::format("{:.3f}", of.shareHonest),
         fmt::format("{:.3f}", of.shareHidden), fmt::format("{:.3f}", of.standardError)});
  }
  return shares;
}

std::vector<Check> checksOf(const Trials& trials, std::size_t draws, double hours) {
  const auto percent = [&](std::size_t hits) { return 100.0 * shareOf(hits, draws).seen; };
  return {
      {.what = "residual monitor: false alarms in an hour",
       .unit = "",
       .source = "asked for",
       .reference = emulator::MonitorOptions().falseAlarmsPerHour,
       .ours = static_cast<double>(trials.falseMarks) / hours,
       .highest = 2.0},
      {.what = "residual monitor: shifts noticed",
       .unit = "%",
       .source = "",
       .ours = percent(trials.openNoticed),
       .lowest = 99.0},
      {.what = fmt::format("watermark of {} µm: false alarms", 1e3 * kWatermarksMm.back()),
       .unit = "%",
       .source = "asked for",
       .reference = 100.0 * kWatermarkFalseAlarm,
       .ours = percent(trials.watermarks.back().falseAlarms),
       .highest = 1.0},
      {.what =
           fmt::format("watermark of {} µm: made-up positions noticed", 1e3 * kWatermarksMm.back()),
       .unit = "%",
       .source = "",
       .ours = percent(trials.watermarks.back().hidden),
       .lowest = 99.0},
  };
}

}  // namespace

Result<Experiment> runTampering(const TamperingOptions& options) {
  const Result<Guard> guard = learnGuard();
  if (!guard) {
    return base::fail(guard.error());
  }
  const std::size_t count = guard->setPoints.size();
  const double runS = guard->cycleS * static_cast<double>(count);
  const SetPoints shift = shiftOf(count, guard->cycleS);
  const auto draws = static_cast<double>(options.draws);
  Trials trials;
  const base::Random random(17);
  for (std::size_t draw = 0; draw < options.draws; ++draw) {
    if (options.progress && !options.progress(static_cast<double>(draw) / draws)) {
      return base::fail(ExperimentError::Cancelled, "The experiment was cancelled.");
    }
    trials.draw(*guard, shift, random.fork(draw), draws);
  }
  Experiment result;
  result.name = "monitor";
  result.title = "A learned emulator notices that somebody shifts the axes";
  result.setup = fmt::format(
      "Virtual machine dmu75 with axes as cascades; positions are reported with a noise of {} µm "
      "(standard deviation). The emulator is learned from one program, and its peaks are measured "
      "in ten runs of another one. This one then runs {} times honestly, {} times with X shifted "
      "by "
      "{} mm from the middle on, and {} times shifted while positions are reported that somebody "
      "made up without the watermark. A run takes {:.1f} s.",
      1e3 * kNoiseMm, options.draws, options.draws, kShiftMm, options.draws, runS);
  const double hours = runS * draws / 3600.0;
  result.tables = {ratesTable(trials, options.draws, hours), peaksTable(*guard),
                   sharesTable(trials)};
  result.checks = checksOf(trials, options.draws, hours);
  result.notes = {
      "Positions that are made up follow the program as well as an honest trace does: the residual "
      "monitor cannot notice them, whatever the axes do. Only the watermark can.",
      "A watermark is a standard deviation per axis, of random set points every 0.1 s. It is much "
      "smaller than the noise of a position; the test adds up the whole run."};
  return result;
}

}  // namespace rivulet::papers
