// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/overlay.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "emulator/identification.h"
#include "emulator/monitor.h"
#include "trace/analysis/program_path.h"
#include "trace/motion.h"

namespace rivulet::emulator {

namespace {

/// Set points nearer to each other are one point of the path.
constexpr double kSamePlaceMm = 1e-4;
/// An axis is on the part of the path where its set point was up to so long ago.
constexpr double kBehindS = 0.4;
constexpr double kAheadS = 0.05;
constexpr double kMicrometres = 1000.0;

/// The set points as a path, and how far along it they are.
struct Course {
  std::shared_ptr<const trace::ProgramPath> path;
  std::vector<double> lengthMm;  ///< one for each set point
};

std::size_t axisIndex(char letter) {
  return static_cast<std::size_t>(std::ranges::find(base::kAxisNames, letter) -
                                  base::kAxisNames.begin());
}

Course courseOf(const TrainingRun& run) {
  std::vector<base::Vec3> places;
  for (const AxisTrack& track : run.axes) {
    places.resize(std::max(places.size(), track.reference.size()));
    for (std::size_t i = 0; i < track.reference.size(); ++i) {
      places[i].set(axisIndex(track.axis), track.reference[i]);
    }
  }
  std::vector<gcode::StreamPoint> points;
  Course course;
  base::Vec3 last = places.front();
  double lengthMm = 0.0;
  for (const base::Vec3& place : places) {
    const double step = base::distance(place, last);
    if (step > kSamePlaceMm) {
      points.push_back({place, base::LineNumber{}});
      lengthMm += step;
      last = place;
    }
    course.lengthMm.push_back(lengthMm);
  }
  if (!points.empty()) {
    course.path = std::make_shared<const trace::ProgramPath>(std::move(points), places.front());
  }
  return course;
}

/// The place on the path of the set points that is nearest to what was seen.
void addLengths(trace::ShownTrace& shown, const Course& course, const TrainingRun& run,
                const trace::Motion& motion) {
  auto lengths = std::make_shared<trace::Envelope>();
  const auto lengthAt = [&](double atS) {
    const double mm = cubicAt(course.lengthMm, std::max(0.0, atS) / run.period);
    return std::clamp(mm, 0.0, course.path->lengthMm());
  };
  trace::MotionReader samples(motion.samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double atS = run.observedAt[i];
    const double toMm = lengthAt(atS + kAheadS);
    const trace::PathPlace place =
        course.path->nearest(samples[i].actualMm, std::min(lengthAt(atS - kBehindS), toMm), toMm);
    lengths->append(base::Instant{samples[i].at - motion.samples.front().at}, place.lengthMm);
  }
  shown.signalSet.add({"program_length_act", "mm", std::move(lengths)});
  shown.programPath = course.path;
}

std::shared_ptr<trace::ShownTrace> shownOf(const trace::Motion& motion, const Course& course,
                                           const TrainingRun& run, const std::string& name) {
  auto shown = std::make_shared<trace::ShownTrace>(trace::makeShownTrace(motion));
  shown->name = name;
  if (course.path) {
    addLengths(*shown, course, run, motion);
  }
  return shown;
}

}  // namespace

base::Result<Overlay> overlayOf(const Emulator& emulator, const TrainingRun& run,
                                const OverlayNames& names) {
  const auto residuals = residualsOf(emulator, run);
  if (!residuals) {
    return base::fail(residuals.error());
  }
  const std::size_t count = run.observedAt.size();
  trace::Motion machine;
  machine.hasSet = true;
  machine.hasActual = true;
  std::vector<trace::MotionSample> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    samples[i].at = base::Instant{base::fromSeconds(run.observedAt[i])};
  }
  if (count > 1) {
    machine.step =
        (samples.back().at - samples.front().at) / static_cast<base::Duration::rep>(count - 1);
  }
  for (const AxisTrack& track : run.axes) {
    const std::size_t axis = axisIndex(track.axis);
    for (std::size_t i = 0; i < count; ++i) {
      samples[i].setMm.set(axis, cubicAt(track.reference, run.observedAt[i] / run.period));
      samples[i].actualMm.set(axis, track.observed[i]);
    }
  }
  std::vector<trace::MotionSample> emulatedSamples = samples;
  for (const AxisResiduals& one : *residuals) {
    const std::size_t axis = axisIndex(one.axis);
    for (std::size_t i = 0; i < count; ++i) {
      emulatedSamples[i].actualMm.set(axis, samples[i].actualMm[axis] - one.mm[i]);
    }
  }
  for (std::size_t i = 1; i < count; ++i) {
    const double stepS = run.observedAt[i] - run.observedAt[i - 1];
    for (std::vector<trace::MotionSample>* of : {&samples, &emulatedSamples}) {
      (*of)[i].pathMmPerS = base::distance((*of)[i].actualMm, (*of)[i - 1].actualMm) / stepS;
    }
  }
  trace::Motion emulated = machine;
  machine.samples = trace::MotionSamples(samples);
  emulated.samples = trace::MotionSamples(emulatedSamples);
  const Course course = courseOf(run);
  auto shown = shownOf(machine, course, run, names.machine);
  for (const AxisResiduals& one : *residuals) {
    auto departures = std::make_shared<trace::Envelope>();
    for (std::size_t i = 0; i < count; ++i) {
      departures->append(base::Instant{samples[i].at - samples.front().at},
                         kMicrometres * one.mm[i]);
    }
    shown->signalSet.add({names.departure[axisIndex(one.axis)], "µm", std::move(departures)});
  }
  return Overlay{std::move(shown), shownOf(emulated, course, run, names.emulator)};
}

}  // namespace rivulet::emulator
