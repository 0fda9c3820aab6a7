// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/trace_analysis.h"

#include <algorithm>

#include "gcode/feeds.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

const ControlTrace* controlTraceOf(const TraceSubject& subject) {
  const bool isRecorded = subject.recording != nullptr && subject.recording->controlTrace;
  return isRecorded ? &*subject.recording->controlTrace : subject.controlTrace;
}

/// Live observations are all there is of a control without a trace.
Motion motionOfLive(const Recording& recording) {
  Motion motion;
  motion.hasActual = true;
  for (const LiveSample& live : recording.samples) {
    if (!live.positionMm || (!motion.samples.empty() && live.at <= motion.samples.back().at)) {
      continue;
    }
    MotionSample sample;
    sample.at = live.at;
    sample.actualMm = *live.positionMm;
    sample.feedMmPerS = kNoValue;
    if (!motion.samples.empty()) {
      const MotionSample& before = motion.samples.back();
      sample.pathMmPerS =
          base::distance(sample.actualMm, before.actualMm) / base::toSeconds(sample.at - before.at);
    }
    motion.samples.push_back(sample);
  }
  return motion;
}

/// The points that should have been executed, with their feeds as far as they are known.
std::vector<gcode::StreamPoint> pointsOf(const TraceSubject& subject, base::Vec3 startMm,
                                         const base::RotaryDeg& startDeg) {
  if (subject.recording != nullptr && subject.recording->pointsComplete) {
    std::vector<gcode::StreamPoint> points = subject.recording->points.points;
    if (subject.recording->start.feedOverride == 0.0) {
      for (gcode::StreamPoint& point : points) {
        point.feedMmPerS = subject.recording->start.feedMmPerS;
      }
    }
    return points;
  }
  if (subject.program == nullptr) {
    return {};
  }
  // The feed of rapids is not known.
  constexpr double kNoLimit = 1e9;
  const gcode::ProgramFeeds feeds{1.0, kNoLimit, kNoLimit};
  std::vector<gcode::StreamPoint> points =
      gcode::streamPoints(subject.program->trajectory, startMm, startDeg, &feeds).points;
  for (gcode::StreamPoint& point : points) {
    point.feedMmPerS = point.kind == gcode::MoveKind::Rapid ? 0.0 : point.feedMmPerS;
  }
  return points;
}

base::RotarySet rotaryOf(const TraceSubject& subject) {
  base::RotarySet axes{};
  if (subject.recording != nullptr && subject.recording->pointsComplete) {
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      axes[axis] =
          subject.recording->start.axes.find(base::kRotaryAxisNames[axis]) != std::string::npos;
    }
  } else if (subject.program != nullptr) {
    axes = gcode::turnedAxes(subject.program->trajectory);
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

Motion motionOf(const TraceSubject& subject) {
  if (const ControlTrace* trace = controlTraceOf(subject)) {
    return motionOf(*trace);
  }
  if (subject.imported != nullptr) {
    return motionOf(*subject.imported);
  }
  return subject.recording != nullptr ? motionOfLive(*subject.recording) : Motion{};
}

TraceAnalysis analyseTrace(const TraceSubject& subject) {
  TraceAnalysis analysis;
  analysis.motion = motionOf(subject);
  const Motion& motion = analysis.motion;
  analysis.stops = findStandstills(motion);
  findCauses(analysis.stops, motion, subject.recording);
  if (subject.program != nullptr) {
    findProgrammedDwells(analysis.stops, *subject.program, subject.toleranceMm);
  }
  const ControlTrace* trace = controlTraceOf(subject);
  const base::Vec3 startMm =
      motion.samples.empty() ? base::Vec3{} : motion.placeMm(motion.samples.front());
  const base::RotaryDeg startDeg = trace != nullptr && !trace->samples.empty()
                                       ? trace->samples.front().commandDeg
                                       : base::RotaryDeg{};
  std::vector<gcode::StreamPoint> points = pointsOf(subject, startMm, startDeg);
  if (!points.empty()) {
    if (trace != nullptr) {
      analysis.blocks = judgeRun(points, *trace, rotaryOf(subject));
    }
    analysis.programPath = std::make_shared<const ProgramPath>(std::move(points), startMm);
    analysis.path = matchPath(motion, *analysis.programPath, {subject.toleranceMm});
  }
  analysis.quality =
      judgeMotion(motion, analysis.stops, analysis.programPath.get(), &analysis.path);
  return analysis;
}

}  // namespace rivulet::trace
