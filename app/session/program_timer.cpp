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

/// Points that are followed of a longer program: for a first figure, and for the last one
/// (`forecast::PathTimeOptions::followedMax`).
constexpr std::size_t kFollowedFirst = 2'000;
constexpr std::size_t kFollowed = 50'000;

/// Of the points that are streamed. @param atS  one per point of the trajectory
std::vector<float> ofStreamed(const overview::ProgramView& view, std::vector<float> atS) {
  // In place, for millions of points: none of them moves back.
  const std::vector<std::uint32_t>& indices = view.trajectoryIndices;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    atS[i] = atS[indices[i]];
  }
  atS.resize(indices.size());
  return atS;
}

/// Computes the times that do not depend on the settings. @return false: cancelled
bool reckonProgrammed(const overview::ProgramView& view, const machine::MachineConfig& machine,
                      std::size_t followedMax, const std::function<bool(double)>& progress,
                      overview::ProgramTimes& times) {
  forecast::PathTimeOptions options;
  options.followedMax = followedMax;
  options.progress = progress;
  auto time = forecast::pathTime(view.program->trajectory, view.startMm, machine, options);
  if (!time) {
    return false;
  }
  times.programmedS = time->totalS;
  times.machine = machine.name;
  times.atS = ofStreamed(view, std::move(time->atS));
  return true;
}

/// The time of a run. @return nothing: cancelled
std::optional<forecast::PathTime> reckonStreamed(const overview::ProgramView& view,
                                                 const machine::MachineConfig& machine,
                                                 const TimeSettings& settings,
                                                 const overview::PauseMap& pauses,
                                                 std::size_t followedMax,
                                                 const std::function<bool(double)>& progress) {
  forecast::PathTimeOptions options;
  options.followedMax = followedMax;
  options.feedMmPerS = settings.feedMmPerS;
  options.programFeeds = settings.programFeeds;
  options.pauseS = base::toSeconds(machine.standstillMean);
  options.pausesBehind.resize(pauses.count());
  std::merge(pauses.offCut.begin(), pauses.offCut.end(), pauses.inCut.begin(), pauses.inCut.end(),
             options.pausesBehind.begin());
  options.progress = progress;
  return forecast::pathTime(view.program->trajectory, view.startMm, machine, options);
}

/// @param withoutPausesS  if it is known  @return nothing: cancelled
std::optional<overview::RunTime> reckonRun(
    const overview::ProgramView& view, const machine::MachineConfig& machine,
    const TimeSettings& settings, const overview::PauseMap& pauses, std::size_t followedMax,
    std::optional<double> withoutPausesS, const std::function<bool(double)>& progress) {
  if (!withoutPausesS) {
    const auto time = reckonStreamed(view, machine, settings, {}, followedMax, progress);
    if (!time) {
      return std::nullopt;
    }
    withoutPausesS = time->totalS;
  }
  auto time = reckonStreamed(view, machine, settings, pauses, followedMax, progress);
  if (!time) {
    return std::nullopt;
  }
  return overview::RunTime{ofStreamed(view, std::move(time->atS)), time->totalS, time->standingS,
                           time->pauses, *withoutPausesS};
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
    const auto isKnown = [&settings, &view](const Unpaused& of) {
      return of.feedMmPerS == settings.feedMmPerS && of.programFeeds == settings.programFeeds &&
             of.startMm == view->startMm;
    };
    const std::optional<double> withoutPausesS =
        unpaused && isKnown(*unpaused) ? std::optional(unpaused->totalS) : std::nullopt;
    auto times =
        std::make_shared<overview::ProgramTimes>(known ? *known : overview::ProgramTimes());
    // Each figure is told as soon as there is one: a copy, for the next ones change it.
    const auto estimate = [&](bool isProgrammed) {
      tell([isProgrammed, told = std::make_shared<const overview::ProgramTimes>(*times)](
               ProgramTimer& timer, const auto& of) {
        timer.m_times = isProgrammed ? told : timer.m_times;
        Q_EMIT timer.estimated(told, of);
      });
    };
    const auto run = [&](std::size_t followedMax, std::optional<double> without) {
      times->run.reset();
      times->run = reckonRun(*view, machine, settings, *pauses, followedMax, without, progress);
      return times->run.has_value();
    };
    const bool isLong = view->program->trajectory.points.size() > kFollowedFirst;
    if (isLong) {
      if ((!known && !reckonProgrammed(*view, machine, kFollowedFirst, progress, *times)) ||
          !run(kFollowedFirst, withoutPausesS)) {
        return;
      }
      estimate(false);
    }
    if (!known) {
      times->atS = std::vector<float>();  // of millions of points, only one list at a time
      if (!reckonProgrammed(*view, machine, kFollowed, progress, *times)) {
        return;
      }
      estimate(true);
    }
    if (!run(kFollowed, withoutPausesS)) {
      return;
    }
    unpaused = Unpaused{settings.feedMmPerS, settings.programFeeds, view->startMm,
                        times->run->withoutPausesS};
    tell([unpaused](ProgramTimer& timer, const auto& /*of*/) { timer.m_unpaused = unpaused; });
    estimate(true);
    tell([](ProgramTimer& timer, const auto& /*of*/) { timer.m_stop.reset(); });
  });
}

}  // namespace rivulet::session
