// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/program_timer.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <algorithm>
#include <limits>

#include "experiments/path_time.h"

namespace rivulet::session {

namespace {

/// No control tells its axes: all are reckoned with those of the machine of the paper.
constexpr const char* kMachine = "dmu75";

/// Fills the times that do not depend on the settings. @return false: given up
bool reckonProgrammed(const widgets::ProgramView& view, const machine::MachineConfig& machine,
                      const std::function<bool(double)>& progress, widgets::ProgramTimes& times) {
  experiments::PathTimeOptions options;
  options.progress = progress;
  const auto time = experiments::pathTime(view.program->trajectory, view.startMm, machine, options);
  if (!time) {
    return false;
  }
  times.programmedS = time->totalS;
  times.machine = machine.name;
  times.atS.reserve(view.trajectoryIndices.size());
  for (const std::uint32_t index : view.trajectoryIndices) {
    times.atS.push_back(time->atS[index]);
  }
  return true;
}

/// Fills the times of a run.
bool reckonStreamed(const widgets::ProgramView& view, const machine::MachineConfig& machine,
                    const TimeSettings& settings, const std::function<bool(double)>& progress,
                    widgets::ProgramTimes& times) {
  experiments::PathTimeOptions options;
  options.feedMmPerS = settings.feedMmPerS;
  options.pauseS = base::toSeconds(machine.standstillMean);
  // A loop of N points has one STOPRE with the method position and two with signal; a window has
  // one; method credit has none.
  const int perPause = settings.method == base::MethodKind::Signal ? settings.pointsPerLoop / 2
                                                                   : settings.pointsPerLoop;
  options.pointsPerPause = settings.method == base::MethodKind::Credit
                               ? std::numeric_limits<std::size_t>::max()
                               : static_cast<std::size_t>(std::max(1, perPause));
  options.progress = progress;
  const auto time = experiments::pathTime(view.program->trajectory, view.startMm, machine, options);
  if (!time) {
    return false;
  }
  times.run = widgets::RunTime{time->totalS, time->standingS, time->pauses};
  return true;
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

void ProgramTimer::start(std::shared_ptr<const widgets::ProgramView> view,
                         const TimeSettings& settings) {
  cancel();
  // The place of the tool changes the first points of a program and hardly its time.
  if (view->program != m_program ||
      (m_times && m_times->atS.size() != view->points.points.size())) {
    m_program = view->program;
    m_times.reset();
  }
  m_stop = std::make_shared<std::atomic<bool>>(false);
  QThreadPool::globalInstance()->start([self = QPointer<ProgramTimer>(this), stop = m_stop,
                                        view = std::move(view), known = m_times, settings] {
    const auto machine = machine::loadPreset(kMachine);
    const auto progress = [&](double) { return !stop->load(); };
    // The context of the call is the application: `self` is only touched on its own thread.
    const auto tell = [&](const std::shared_ptr<const widgets::ProgramTimes>& times) {
      QMetaObject::invokeMethod(
          qApp,
          [self, stop, times, view] {
            if (self && self->m_stop == stop) {
              if (times->run) {
                self->m_stop.reset();
              }
              self->m_times = times;
              Q_EMIT self->reckoned(times, view);
            }
          },
          Qt::QueuedConnection);
    };
    if (!machine) {
      return;
    }
    auto times = known;
    if (!times) {
      auto programmed = std::make_shared<widgets::ProgramTimes>();
      if (!reckonProgrammed(*view, *machine, progress, *programmed)) {
        return;
      }
      times = programmed;
      tell(times);
    }
    auto streamed = std::make_shared<widgets::ProgramTimes>(*times);
    if (reckonStreamed(*view, *machine, settings, progress, *streamed)) {
      tell(streamed);
    }
  });
}

}  // namespace rivulet::session
