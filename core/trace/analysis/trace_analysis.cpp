// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/trace_analysis.h"

#include <algorithm>

#include "gcode/feeds.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

/// Live observations are all there is of a control without a trace.
Motion motionOfLive(const Recording& recording) {
  Motion motion;
  motion.hasActual = true;
  MotionSample before;
  for (const LiveSample& live : recording.samples) {
    if (!live.positionMm || (!motion.samples.empty() && live.at <= before.at)) {
      continue;
    }
    MotionSample sample;
    sample.at = live.at;
    sample.actualMm = *live.positionMm;
    sample.feedMmPerS = kNoValue;
    if (!motion.samples.empty()) {
      sample.pathMmPerS =
          base::distance(sample.actualMm, before.actualMm) / base::toSeconds(sample.at - before.at);
    }
    motion.samples.push_back(sample);
    before = sample;
  }
  return motion;
}

/// The points that should have been executed, with their feeds as far as they are known.
std::vector<gcode::StreamPoint> pointsOf(const Recording* recording, const gcode::Program* program,
                                         base::Vec3 startMm, const base::RotaryDeg& startDeg) {
  if (recording != nullptr && recording->pointsComplete) {
    std::vector<gcode::StreamPoint> points = recording->points.points;
    if (recording->start.feedOverride == 0.0) {
      for (gcode::StreamPoint& point : points) {
        point.feedMmPerS = recording->start.feedMmPerS;
      }
    }
    return points;
  }
  if (program == nullptr) {
    return {};
  }
  // The feed of rapids is not known.
  constexpr double kNoLimit = 1e9;
  const gcode::ProgramFeeds feeds{1.0, kNoLimit, kNoLimit};
  std::vector<gcode::StreamPoint> points =
      gcode::streamPoints(program->trajectory, startMm, startDeg, &feeds).points;
  for (gcode::StreamPoint& point : points) {
    point.feedMmPerS = point.kind == gcode::MoveKind::Rapid ? 0.0 : point.feedMmPerS;
  }
  return points;
}

base::RotarySet rotaryOf(const Recording* recording, const gcode::Program* program) {
  base::RotarySet axes{};
  if (recording != nullptr && recording->pointsComplete) {
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      axes[axis] = recording->start.axes.find(base::kRotaryAxisNames[axis]) != std::string::npos;
    }
  } else if (program != nullptr) {
    axes = gcode::turnedAxes(program->trajectory);
  }
  return axes;
}

/// A dwell of the program at the place of the stop.
void findProgrammedDwells(std::vector<Standstill>& stops, const gcode::Program& program,
                          double toleranceMm) {
  for (Standstill& stop : stops) {
    for (const gcode::PathEvent& event : program.trajectory.events) {
      if (event.kind != nc::MachineWord::Dwell || event.point == 0 ||
          stop.cause == StopCause::Dwell) {
        continue;
      }
      const base::Vec3 place = program.trajectory.points[event.point - 1].positionMm;
      const double seconds = base::toSeconds(stop.duration + stop.uncertainty);
      // Coordinates that the program leaves open are no reason to reject a place.
      const bool isThere = !(base::distance(place, stop.placeMm) > toleranceMm);
      if (isThere && seconds >= 0.9 * event.value) {
        stop.cause = StopCause::Dwell;
        stop.evidence = "line " + std::to_string(event.line.value) + " of the program dwells there";
      }
    }
  }
}

}  // namespace

Motion motionOf(const Trace& trace) {
  if (const ControlTrace* control = trace.control()) {
    return motionOf(*control);
  }
  return trace.imported() != nullptr ? motionOf(*trace.imported())
                                     : motionOfLive(*trace.recording());
}

TraceAnalysis analyseTrace(const Trace& trace, const AnalysisOptions& options) {
  TraceAnalysis analysis;
  analysis.motion = motionOf(trace);
  const Motion& motion = analysis.motion;
  const Recording* recording = trace.recording();
  analysis.stops = findStandstills(motion);
  findCauses(analysis.stops, motion, recording);
  if (options.program != nullptr) {
    findProgrammedDwells(analysis.stops, *options.program, options.toleranceMm);
  }
  const ControlTrace* control = trace.control();
  const base::Vec3 startMm =
      motion.samples.empty() ? base::Vec3{} : motion.placeMm(motion.samples.front());
  const base::RotaryDeg startDeg = control != nullptr && !control->samples.empty()
                                       ? control->samples.front().commandDeg
                                       : base::RotaryDeg{};
  std::vector<gcode::StreamPoint> points = pointsOf(recording, options.program, startMm, startDeg);
  if (!points.empty()) {
    if (control != nullptr) {
      analysis.blocks = judgeRun(points, *control, rotaryOf(recording, options.program));
    }
    analysis.programPath = std::make_shared<const ProgramPath>(std::move(points), startMm);
    analysis.path = matchPath(motion, *analysis.programPath, {options.toleranceMm});
  }
  analysis.quality =
      judgeMotion(motion, analysis.stops, analysis.programPath.get(), &analysis.path);
  return analysis;
}

}  // namespace rivulet::trace
