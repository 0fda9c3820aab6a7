// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/emulator.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/text.h"
#include "base/vec3.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator {

namespace {

constexpr int kFileVersion = 1;
/// The path is searched for the nearest point so long before and after an observation.
constexpr double kNearS = 0.4;

/// Position of the set points, and of what follows them, as a path in space.
using Path = std::vector<base::Vec3>;

double toPath(base::Vec3 point, const Path& path, double place, double reach) {
  const auto last = static_cast<double>(path.size() - 1);
  const auto from = static_cast<std::size_t>(std::clamp(place - reach, 0.0, last));
  const auto to = static_cast<std::size_t>(std::clamp(place + reach, 0.0, last));
  double nearest = base::distance(point, path[from]);
  for (std::size_t i = from; i < to; ++i) {
    nearest = std::min(nearest, base::distanceToSegment(point, path[i], path[i + 1]));
  }
  return nearest;
}

/// The run and its emulation, as far as they are compared.
struct Comparison {
  double stepS = 0.0;
  Path setPoints;
  Path observed;
  Path emulated;
  Path emulatedMmPerS;
};

/// A text of TOML: ASCII without control characters, DEL among them.
std::string inQuotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const bool isPlain = c >= ' ' && c < 0x7F;
    result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, isPlain ? c : '_');
  }
  return result + '"';
}

/// Of an axis, besides its parameters.
constexpr std::array<std::string_view, 5> kOtherKeys{"fitRmsMm", "heldOutRmsMm", "interval",
                                                     "setPoints", "peaks"};

/// A key of an axis that says nothing; empty if there is none.
std::string unknownKey(const toml::table& servo) {
  for (const auto& [key, node] : servo) {
    const std::string_view name = key.str();
    const bool isKnown = std::ranges::count(kOtherKeys, name) > 0 ||
                         std::ranges::find(axisParameterFacts(), name, &AxisParameterFacts::key) !=
                             axisParameterFacts().end();
    if (!isKnown) {
      return std::string(name);
    }
  }
  return {};
}

base::Result<Comparison> compare(const Emulator& emulator, const TrainingRun& run) {
  Comparison result;
  result.observed.resize(run.observedAt.size());
  result.emulated.resize(run.observedAt.size());
  result.emulatedMmPerS.resize(run.observedAt.size());
  for (const AxisTrack& track : run.axes) {
    const auto axis = static_cast<std::size_t>(std::ranges::find(base::kAxisNames, track.axis) -
                                               base::kAxisNames.begin());
    if (axis >= base::kAxisCount) {
      continue;
    }
    const LearnedAxis* const learned = emulator.find(track.axis);
    const SetPointGrid grid =
        setPointGrid(track, run.period, learned != nullptr && learned->goesStraight);
    result.stepS = grid.stepS;
    result.setPoints.resize(grid.mm.size());
    for (std::size_t i = 0; i < grid.mm.size(); ++i) {
      result.setPoints[i].set(axis, grid.mm[i]);
    }
    std::vector<AxisState> states(run.observedAt.size());
    if (learned != nullptr) {
      states = predict(learned->parameters, grid, run.observedAt);
    } else {
      if (auto stands = requireToStand(track, run.name); !stands) {
        return base::fail(stands.error());
      }
      std::ranges::fill(states, AxisState{track.reference.front(), 0.0});
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      result.observed[i].set(axis, track.observed[i]);
      result.emulated[i].set(axis, states[i].mm);
      result.emulatedMmPerS[i].set(axis, states[i].mmPerS);
    }
  }
  return result;
}

/// For every set point: true where the path turns or changes its speed, and shortly after.
std::vector<bool> corners(const Comparison& of) {
  std::vector<double> acceleration(of.setPoints.size(), 0.0);
  double largest = 0.0;
  for (std::size_t i = 1; i + 1 < of.setPoints.size(); ++i) {
    acceleration[i] = base::norm((of.setPoints[i + 1] - of.setPoints[i]) -
                                 (of.setPoints[i] - of.setPoints[i - 1]));
    largest = std::max(largest, acceleration[i]);
  }
  std::vector<bool> isCorner(of.setPoints.size(), false);
  const auto length = static_cast<std::size_t>(kCornerS / of.stepS);
  std::size_t until = 0;
  for (std::size_t i = 0; i < isCorner.size(); ++i) {
    if (acceleration[i] > kCornerShare * largest) {
      until = i + length;
    }
    isCorner[i] = i < until;
  }
  return isCorner;
}

double speedRmsShare(const Comparison& of, const std::vector<double>& atS) {
  double fastest = 0.0;
  for (std::size_t i = 1; i < of.setPoints.size(); ++i) {
    fastest = std::max(fastest, base::distance(of.setPoints[i], of.setPoints[i - 1]) / of.stepS);
  }
  const std::vector<bool> isCorner = corners(of);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 1; i + 1 < atS.size(); ++i) {
    const auto place = static_cast<std::size_t>(std::max(0.0, atS[i] / of.stepS));
    if (place >= isCorner.size() || isCorner[place] || atS[i + 1] - atS[i - 1] > 0.02) {
      continue;  // a speed cannot be told from positions that far apart
    }
    const base::Vec3 seen =
        (1.0 / (atS[i + 1] - atS[i - 1])) * (of.observed[i + 1] - of.observed[i - 1]);
    const double error = base::distance(seen, of.emulatedMmPerS[i]);
    squares += error * error;
    count += 1.0;
  }
  return count > 0.0 && fastest > 0.0 ? std::sqrt(squares / count) / fastest : 0.0;
}

base::Result<LearnedAxis> parseAxis(const toml::table& servo, char letter,
                                    const std::string& origin) {
  LearnedAxis axis;
  axis.axis = letter;
  axis.fitRmsMm = servo.at_path("fitRmsMm").value_or(0.0);
  axis.heldOutRmsMm = servo.at_path("heldOutRmsMm").value_or(0.0);
  axis.peaks = {
      servo.at_path("peaks.locationMm").value_or(0.0), servo.at_path("peaks.scaleMm").value_or(0.0),
      servo.at_path("peaks.seconds").value_or(0), servo.at_path("peaks.mmPerSMost").value_or(0.0)};
  axis.goesStraight = servo.at_path("setPoints").value_or(std::string()) == "straight";
  axis.parameters[AxisParameter::CoulombSpeed] = 1.0;
  for (const AxisParameterFacts& facts : axisParameterFacts()) {
    const std::optional<double> value = servo.at_path(facts.key).value<double>();
    if (!value) {
      continue;
    }
    if (!(*value >= 0.0 && *value <= facts.max)) {
      return base::fail(EmulatorError::BadFile,
                        fmt::format("{} of axis {} is {} but must be between 0 and {}.", facts.key,
                                    letter, *value, facts.max),
                        origin);
    }
    axis.parameters[facts.parameter] = *value;
    axis.estimates.push_back(
        {facts.parameter, *value,
         servo.at_path(fmt::format("interval.{}[0]", facts.key)).value_or(*value),
         servo.at_path(fmt::format("interval.{}[1]", facts.key)).value_or(*value)});
  }
  if (const std::string unknown = unknownKey(servo); !unknown.empty()) {
    return base::fail(EmulatorError::BadFile,
                      fmt::format("{} of axis {} is not a parameter of an axis.", unknown, letter),
                      origin);
  }
  const bool hasSpeedLoop = axis.parameters[AxisParameter::SpeedGain] > 0.0;
  if (!(axis.parameters[AxisParameter::PositionGain] > 0.0 &&
        hasSpeedLoop == (axis.parameters[AxisParameter::ResetTime] > 0.0))) {
    return base::fail(EmulatorError::BadFile,
                      fmt::format("Axis {} needs position_gain, and both or none of speed_gain and "
                                  "reset_time.",
                                  letter),
                      origin);
  }
  return axis;
}

}  // namespace

const LearnedAxis* Emulator::find(char letter) const {
  const auto found = std::ranges::find(axes, letter, &LearnedAxis::axis);
  return found == axes.end() ? nullptr : &*found;
}

base::Result<void> requireToStand(const AxisTrack& track, const std::string& run) {
  const auto [low, high] = std::ranges::minmax(track.reference);
  if (high - low < 1e-6) {
    return {};
  }
  return base::fail(EmulatorError::NoMotion,
                    fmt::format("This run moves axis {}, which the emulator has not learned: "
                                "learn it from a program that moves it.",
                                track.axis),
                    run);
}

base::Result<TrainingRun> trainingRunOf(const trace::Motion& motion, const std::string& name) {
  if (motion.samples.size() < 2) {
    return base::fail(EmulatorError::TooShort, "This trace has no positions: record a program.",
                      name);
  }
  if (!motion.hasSet || !motion.hasActual) {
    return base::fail(
        EmulatorError::WrongProgram,
        fmt::format("This trace has no {}: record set points and actual positions, or "
                    "give the program of the trace.",
                    motion.hasSet ? "actual positions" : "set points"),
        name);
  }
  TrainingRun run{name, base::toSeconds(motion.step), {}, {}};
  const base::Instant begin = motion.samples.front().at;
  for (const trace::MotionSample& sample : motion.samples) {
    run.observedAt.push_back(base::toSeconds(sample.at - begin));
  }
  const auto count = static_cast<std::size_t>(run.observedAt.back() / run.period + 0.5) + 1;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    AxisTrack track{base::kAxisNames[axis], {}, {}};
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const double atS = static_cast<double>(i) * run.period;
      while (next + 1 < run.observedAt.size() && run.observedAt[next] < atS) {
        ++next;
      }
      const double share = std::clamp(
          (atS - run.observedAt[next - 1]) / (run.observedAt[next] - run.observedAt[next - 1]), 0.0,
          1.0);
      const double before = motion.samples[next - 1].setMm[axis];
      track.reference.push_back(before + share * (motion.samples[next].setMm[axis] - before));
    }
    for (const trace::MotionSample& sample : motion.samples) {
      track.observed.push_back(sample.actualMm[axis]);
    }
    run.axes.push_back(std::move(track));
  }
  return run;
}

base::Result<RunFit> testRun(const Emulator& emulator, const TrainingRun& run) {
  if (auto checked = checkRun(run); !checked) {
    return base::fail(checked.error());
  }
  const auto compared = compare(emulator, run);
  if (!compared) {
    return base::fail(compared.error());
  }
  if (compared->setPoints.empty() || run.observedAt.empty()) {
    return base::fail(EmulatorError::TooShort, "This run has no set points or no observations.",
                      run.name);
  }
  const auto known = std::ranges::lower_bound(run.observedAt, knownFromS(run));
  const auto first = static_cast<std::size_t>(known - run.observedAt.begin());
  if (first == run.observedAt.size()) {
    return base::fail(EmulatorError::TooShort,
                      "This run has no observations after its axes have begun to move.", run.name);
  }
  RunFit fit{run.name};
  const auto count = static_cast<double>(run.observedAt.size() - first);
  const double reach = kNearS / compared->stepS;
  for (std::size_t i = first; i < run.observedAt.size(); ++i) {
    const double error = base::distance(compared->emulated[i], compared->observed[i]);
    fit.positionRmsMm += error * error / count;
    fit.positionMaxMm = std::max(fit.positionMaxMm, error);
    const double place = run.observedAt[i] / compared->stepS;
    const double machine = toPath(compared->observed[i], compared->setPoints, place, reach);
    const double emulated = toPath(compared->emulated[i], compared->setPoints, place, reach);
    fit.contourRmsMm += machine * machine / count;
    fit.emulatedContourRmsMm += emulated * emulated / count;
  }
  fit.positionRmsMm = std::sqrt(fit.positionRmsMm);
  fit.contourRmsMm = std::sqrt(fit.contourRmsMm);
  fit.emulatedContourRmsMm = std::sqrt(fit.emulatedContourRmsMm);
  fit.speedRmsShare = speedRmsShare(*compared, run.observedAt);
  return fit;
}

double bestTimeShift(const Emulator& emulator, const TrainingRun& run, double reachS) {
  struct Answer {
    std::vector<double> mm;
    double stepS;
    const AxisTrack* track;
  };
  std::vector<Answer> answers;
  for (const LearnedAxis& axis : emulator.axes) {
    const auto track = std::ranges::find(run.axes, axis.axis, &AxisTrack::axis);
    if (track == run.axes.end() || track->reference.empty()) {
      continue;
    }
    const SetPointGrid grid = setPointGrid(*track, run.period, axis.goesStraight);
    Answer& answer = answers.emplace_back(Answer{{}, grid.stepS, &*track});
    for (const AxisState& state : simulateAxis(axis.parameters, grid.stepS, grid.mm)) {
      answer.mm.push_back(state.mm);
    }
  }
  const auto squares = [&](double shiftS) {
    double sum = 0.0;
    for (const Answer& answer : answers) {
      for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
        const double error = cubicAt(answer.mm, (run.observedAt[i] + shiftS) / answer.stepS) -
                             answer.track->observed[i];
        sum += error * error;
      }
    }
    return sum;
  };
  double best = 0.0;
  double stepS = 0.01;
  for (double from = -reachS, to = reachS; stepS > 1e-7; stepS *= 0.2) {
    double least = squares(best);
    for (double shiftS = from; shiftS <= to; shiftS += stepS) {
      if (const double sum = squares(shiftS); sum < least) {
        least = sum;
        best = shiftS;
      }
    }
    from = best - stepS;
    to = best + stepS;
  }
  return best;
}

std::string printEmulator(const Emulator& emulator) {
  std::string text =
      fmt::format("\n[emulator]\nversion = {}\ndate = {}\ndataSha256 = {}\nruns = [", kFileVersion,
                  inQuotes(emulator.date), inQuotes(emulator.dataHash));
  for (std::size_t i = 0; i < emulator.runs.size(); ++i) {
    text += (i == 0 ? "" : ", ") + inQuotes(emulator.runs[i]);
  }
  text += "]\n";
  if (!emulator.preset.empty()) {
    text += fmt::format(
        "# What is not said here is as in this preset of the virtual machine.\n"
        "preset = {}\n",
        inQuotes(emulator.preset));
  }
  for (const LearnedAxis& axis : emulator.axes) {
    text += fmt::format("\n[axes.{}.servo]\nfitRmsMm = {:.6g}\nheldOutRmsMm = {:.6g}\n", axis.axis,
                        axis.fitRmsMm, axis.heldOutRmsMm);
    text += axis.goesStraight ? "setPoints = \"straight\"\n" : "";
    if (axis.peaks.windows > 0) {
      text += fmt::format(
          "# Largest deviation within a second: Gumbel distribution, from so many seconds, up to "
          "this speed.\n"
          "peaks = {{ locationMm = {:.6e}, scaleMm = {:.6e}, seconds = {}, "
          "mmPerSMost = {:.6e} }}\n",
          axis.peaks.locationMm, axis.peaks.scaleMm, axis.peaks.windows, axis.peaks.mmPerSMost);
    }
    for (const ParameterEstimate& estimate : axis.estimates) {
      const AxisParameterFacts& facts = factsOf(estimate.parameter);
      text += fmt::format("# {}{}\n{} = {:.12e}\n", facts.meaning,
                          facts.unit.empty() ? "" : fmt::format(", {}", facts.unit), facts.key,
                          estimate.value);
    }
    if (std::ranges::none_of(axis.estimates, &ParameterEstimate::hasInterval)) {
      text += fmt::format("# No intervals: {}\n", kNoIntervals);
      continue;
    }
    text += fmt::format("[axes.{}.servo.interval]\n", axis.axis);
    for (const ParameterEstimate& estimate : axis.estimates) {
      text += fmt::format("{} = [{:.12e}, {:.12e}]\n", factsOf(estimate.parameter).key,
                          estimate.low, estimate.high);
    }
  }
  return text;
}

base::Result<Emulator> parseEmulator(std::string_view text, const std::string& origin) {
  if (base::hasEndlessKey(text)) {
    return base::fail(EmulatorError::BadFile, "This is no emulator: a key has too many parts.",
                      origin);
  }
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return base::fail(
        EmulatorError::BadFile,
        fmt::format("The file cannot be read at line {}: {}. Correct it, or learn the "
                    "emulator again.",
                    error.source().begin.line, error.description()),
        origin);
  }
  const std::optional<int> version = root.at_path("emulator.version").value<int>();
  if (version != kFileVersion) {
    return base::fail(EmulatorError::BadFile,
                      version ? fmt::format("This emulator has version {} and needs a newer "
                                            "Rivulet.",
                                            *version)
                              : "This is not an emulator: learn one with \"rivulet-cli emulator "
                                "learn\".",
                      origin);
  }
  Emulator emulator;
  emulator.date = root.at_path("emulator.date").value_or(std::string());
  emulator.dataHash = root.at_path("emulator.dataSha256").value_or(std::string());
  emulator.preset = root.at_path("emulator.preset").value_or(std::string());
  if (const toml::array* runs = root.at_path("emulator.runs").as_array()) {
    for (const toml::node& run : *runs) {
      emulator.runs.push_back(run.value_or(std::string()));
    }
  }
  for (const char letter : base::kAxisNames) {
    const toml::table* servo = root.at_path(fmt::format("axes.{}.servo", letter)).as_table();
    if (servo == nullptr) {
      continue;
    }
    auto axis = parseAxis(*servo, letter, origin);
    if (!axis) {
      return base::fail(axis.error());
    }
    emulator.axes.push_back(std::move(*axis));
  }
  if (emulator.axes.empty()) {
    return base::fail(EmulatorError::BadFile, "This emulator has no axes.", origin);
  }
  return emulator;
}

}  // namespace rivulet::emulator
