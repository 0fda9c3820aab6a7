// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/program_timer.h"

#include <algorithm>

#include "base/units.h"
#include "forecast/path_time.h"
#include "report/known_machine.h"
#include "session/background.h"
#include "streaming/methods/pause_placement.h"

namespace rivulet::session {

namespace {

/// Of the points that are streamed. @param atS  one per point of the trajectory
std::vector<float> ofStreamed(const overview::ProgramView& view, const std::vector<float>& atS) {
  std::vector<float> streamed;
  streamed.reserve(view.trajectoryIndices.size());
  for (const std::uint32_t index : view.trajectoryIndices) {
    streamed.push_back(atS[index]);
  }
  return streamed;
}

/// Computes the times that do not depend on the settings. @return false: cancelled
bool reckonProgrammed(const overview::ProgramView& view, const machine::MachineConfig& machine,
                      const std::function<bool(double)>& progress, overview::ProgramTimes& times) {
  forecast::PathTimeOptions options;
  options.progress = progress;
  const auto time = forecast::pathTime(view.program->trajectory, view.startMm, machine, options);
  if (!time) {
    return false;
  }
  times.programmedS = time->totalS;
  times.machine = machine.name;
  times.atS = ofStreamed(view, time->atS);
  return true;
}

/// The time of a run. @return nothing: cancelled
std::optional<forecast::PathTime> reckonStreamed(const overview::ProgramView& view,
                                                 const machine::MachineConfig& machine,
                                                 const TimeSettings& settings,
                                                 const overview::PauseMap& pauses,
                                                 const std::function<bool(double)>& progress) {
  forecast::PathTimeOptions options;
  options.feedMmPerS = settings.feedMmPerS;
  options.programFeeds = settings.programFeeds;
  options.pauseS = base::toSeconds(machine.standstillMean);
  options.pausesBehind.resize(pauses.count());
  std::merge(pauses.offCut.begin(), pauses.offCut.end(), pauses.inCut.begin(), pauses.inCut.end(),
             options.pausesBehind.begin());
  options.progress = progress;
  return forecast::pathTime(view.program->trajectory, view.startMm, machine, options);
}

std::shared_ptr<const overview::PauseMap> planPauses(const overview::ProgramView& view,
                                                     const TimeSettings& settings) {
  auto map = std::make_shared<overview::PauseMap>();
  const auto perLoop = static_cast<std::size_t>(std::max(1, settings.pointsPerLoop));
  // With one feed for all moves, windows do not end where that of the program changes.
  streaming::WindowCut cut;
  cut.feedPerPoint = !settings.programFeeds || settings.feedPerPoint;
  for (const streaming::PlannedPause& pause :
       streaming::plannedPauses(view.points.points, settings.method, perLoop, cut)) {
    (pause.inCut ? map->inCut : map->offCut).push_back(pause.point);
  }
  return map;
}

}  // namespace

ProgramTimer::~ProgramTimer() {
  cancel();
}

void ProgramTimer::cancel() {
  if (m_stop) {
    m_stop->store(true);
    m_stop.reset();
  }
}

void ProgramTimer::start(std::shared_ptr<const overview::ProgramView> view,
                         const TimeSettings& settings) {
  cancel();
  // The position of the tool changes the first points of a program, but hardly its time.
  if (view->program != m_program || settings.machine != m_machine ||
      (m_times && m_times->atS.size() != view->points.points.size())) {
    m_program = view->program;
    m_machine = settings.machine;
    m_times.reset();
    m_unpaused.reset();
  }
  m_stop = std::make_shared<std::atomic<bool>>(false);
  startInPool([self = QPointer<ProgramTimer>(this), stop = m_stop, view = std::move(view),
               known = m_times, unpaused = m_unpaused, settings]() mutable {
    const machine::MachineConfig machine =
        settings.machine ? *settings.machine : report::configOf(nullptr);
    const auto progress = [&](double) { return !stop->load(); };
    const auto tell = [&](auto change) {
      callLater(self, [stop, change, view](ProgramTimer& timer) {
        if (timer.m_stop == stop) {
          change(timer, view);
        }
      });
    };
    const auto pauses = planPauses(*view, settings);
    tell([pauses](ProgramTimer& timer, const auto& of) { Q_EMIT timer.planned(pauses, of); });
    auto times = known;
    if (!times) {
      auto programmed = std::make_shared<overview::ProgramTimes>();
      if (!reckonProgrammed(*view, machine, progress, *programmed)) {
        return;
      }
      times = programmed;
      tell([times](ProgramTimer& timer, const auto& of) {
        timer.m_times = times;
        Q_EMIT timer.estimated(times, of);
      });
    }
    if (!unpaused || unpaused->feedMmPerS != settings.feedMmPerS ||
        unpaused->programFeeds != settings.programFeeds || !(unpaused->startMm == view->startMm)) {
      const auto time = reckonStreamed(*view, machine, settings, {}, progress);
      if (!time) {
        return;
      }
      unpaused = Unpaused{settings.feedMmPerS, settings.programFeeds, view->startMm, time->totalS};
    }
    const auto time = reckonStreamed(*view, machine, settings, *pauses, progress);
    if (!time) {
      return;
    }
    auto streamed = std::make_shared<overview::ProgramTimes>(*times);
    streamed->run = overview::RunTime{ofStreamed(*view, time->atS), time->totalS, time->standingS,
                                      time->pauses, unpaused->totalS};
    tell([streamed, unpaused](ProgramTimer& timer, const auto& of) {
      timer.m_stop.reset();
      timer.m_times = streamed;
      timer.m_unpaused = unpaused;
      Q_EMIT timer.estimated(streamed, of);
    });
  });
}

}  // namespace rivulet::session
