// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/program_loader.h"

#include <chrono>
#include <filesystem>
#include <utility>

#include "preparation/split_program.h"
#include "session/background.h"

namespace rivulet::session {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kReportInterval = std::chrono::milliseconds{50};
/// Reading takes most of the time, the view for the page the rest.
constexpr double kReadShare = 0.4;
constexpr double kSplitShare = 0.3;

}  // namespace

ProgramLoader::~ProgramLoader() {
  forget();
  if (m_placing) {
    m_placing->store(true);
  }
}

void ProgramLoader::forget() {
  if (m_stop) {
    m_stop->store(true);
    m_stop.reset();
  }
}

void ProgramLoader::cancel() {
  if (m_stop) {
    forget();
    Q_EMIT cancelled();
  }
}

void ProgramLoader::load(LoadRequest request) {
  forget();
  m_stop = std::make_shared<std::atomic<bool>>(false);
  startInPool([self = QPointer<ProgramLoader>(this), stop = m_stop, request = std::move(request)] {
    const auto tell = [&self, &stop](auto what) {
      callLater(self, [stop, what = std::move(what)](ProgramLoader& loader) {
        if (loader.m_stop == stop) {
          what(loader);
        }
      });
    };
    Clock::time_point told{};
    const auto progress = [&](double share) {
      if (const Clock::time_point now = Clock::now(); now - told >= kReportInterval) {
        told = now;
        tell([share](ProgramLoader& loader) { Q_EMIT loader.progressed(share); });
      }
      return !stop->load();
    };
    gcode::LoadOptions options;
    options.setReading(request.reading);
    request.reading.machine.tell(options);
    options.progress = [&](double share) { return progress(kReadShare * share); };
    // Taken before the text is read: anything written meanwhile counts as a change.
    const FileStamp stamp = fileStamp(request.path);
    auto program = gcode::loadProgram(std::filesystem::path(request.path.toStdString()), options);
    if (!program) {
      tell([error = program.error(), path = request.path](ProgramLoader& loader) {
        loader.m_stop.reset();
        if (error.code == gcode::GcodeError::Cancelled) {
          Q_EMIT loader.cancelled();
        } else {
          Q_EMIT loader.failed(error, path);
        }
      });
      return;
    }
    options.progress = [&](double share) { return progress(kReadShare + kSplitShare * share); };
    preparation::SplitProgram read = preparation::splitProgram(
        *std::move(program), options, request.path.toStdString(), request.reading.asJob,
        request.reading.dryRunMm, request.reading.machine.words);
    const bool isJob = read.plan && read.program.get() == &read.plan->program;
    LoadRequest done = request;
    done.moveRules = isJob ? gcode::MoveRules{} : request.moveRules;
    auto view = overview::makeProgramView(
        preparation::programByRules(read.program, done.moveRules), request.startMm,
        request.pointsPerLoop,
        [&](double share) {
          const double before = kReadShare + kSplitShare;
          return progress(before + (1.0 - before) * share);
        },
        request.feeds, std::move(read.plan));
    if (view) {
      tell([loaded = LoadedProgram{std::move(done), stamp, std::move(view), std::move(read.program),
                                   read.dryRunError}](ProgramLoader& loader) {
        loader.m_stop.reset();
        Q_EMIT loader.loaded(loaded);
      });
    }
  });
}

void ProgramLoader::place(PlaceRequest request) {
  if (m_placing) {
    return;
  }
  m_placing = std::make_shared<std::atomic<bool>>(false);
  inBackground(
      this,
      [stop = m_placing, request] {
        return overview::makeProgramView(
            preparation::programByRules(request.program, request.moveRules), request.startMm,
            request.pointsPerLoop, [&stop](double) { return !stop->load(); }, request.view->feeds,
            request.view->plan);
      },
      [request](ProgramLoader& self, const std::shared_ptr<const overview::ProgramView>& placed) {
        if (placed) {
          self.m_placing.reset();
          Q_EMIT self.placed(placed, request);
        }
      });
}

}  // namespace rivulet::session
