// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/found_runs.h"

#include <QFileInfo>
#include <utility>

#include "preparation/judged.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"

namespace rivulet::hmi {

using alarm::Source;
using gcode::Severity;
using widgets::FoundRunView;

FoundRuns::FoundRuns(session::StreamSession& session, Document& document, MachineModel& machine,
                     RunController& runs, Messages& messages)
    : m_session(session),
      m_document(document),
      m_machine(machine),
      m_runs(runs),
      m_messages(messages) {
  connect(&m_session, &session::StreamSession::runsSeen, this, &FoundRuns::takeSeen);
  connect(&m_session, &session::StreamSession::runEnded, this, &FoundRuns::takeEnded);
  connect(&m_machine, &MachineModel::linkChanged, this, [this] {
    if (!m_machine.isConnected()) {
      forget();
    }
  });
  connect(&m_runs, &RunController::started, this, &FoundRuns::forget);
  connect(&m_runs, &RunController::permissionsChanged, this, &FoundRuns::askWhenPossible);
  connect(&m_document, &Document::programLoaded, this, &FoundRuns::takeLoaded);
  connect(&m_document, &Document::readingFailed, this, [this](const base::Error& error) {
    if (m_resuming) {
      m_resuming.reset();
      m_runs.refuseResume([error] { return widgets::errorText(error); });
    }
  });
}

void FoundRuns::tell(Severity severity, const Messages::Text& text) {
  m_messages.show(severity, text);
  m_messages.log(severity, Source::Run, text);
}

const report::SavedRun* FoundRuns::saved() const {
  const std::optional<report::SavedRun>& run =
      m_seen.onControl ? m_seen.onControl->saved : m_seen.left;
  return run ? &*run : nullptr;
}

std::size_t FoundRuns::executedPoints() const {
  const std::size_t windows = m_seen.onControl->onControl.executed;
  return m_seen.pointsAfter && windows < m_seen.pointsAfter->size() ? (*m_seen.pointsAfter)[windows]
                                                                    : 0;
}

std::optional<FoundRunView> FoundRuns::view() const {
  const report::SavedRun* run = saved();
  if (m_runs.isRunning() || (!m_seen.onControl && run == nullptr)) {
    return std::nullopt;
  }
  FoundRunView view;
  view.isStopping = m_session.isEnding();
  view.stopConfirmedAfter = m_stopConfirmedAfter;
  view.isHeld = m_isHeld;
  view.isWatched = m_isWatched;
  view.isKeptHere = run != nullptr;
  std::optional<streaming::RunOrigin> origin;
  if (run != nullptr) {
    view.number = run->checkpoint.runNumber;
    view.program = QString::fromStdString(run->programName);
    origin = run->settings.origin;
  }
  if (m_seen.onControl) {
    const streaming::RunOnControl& found = m_seen.onControl->onControl;
    view.kind = found.hasClient        ? FoundRunView::Kind::Served
                : m_seen.isClientKnown ? FoundRunView::Kind::Waiting
                                       : FoundRunView::Kind::Unclear;
    view.number = found.number != 0 ? found.number : view.number;
    view.executed = found.executed;
    if (m_seen.pointsAfter && !m_seen.pointsAfter->empty()) {
      view.executed = executedPoints();
      view.total = m_seen.pointsAfter->back();
    }
    if (m_seen.ahead && m_machine.view().feedMmPerS.value_or(0.0) > 0.0) {
      view.ahead = widgets::MotionLeft{m_seen.ahead->lengthMm, m_seen.ahead->seconds};
    }
    origin = found.origin ? found.origin : origin;
  } else if (view.number == m_dismissed || m_runs.leftRunNumber() == view.number) {
    return std::nullopt;  // Resume beside Start offers it
  } else {
    view.kind = FoundRunView::Kind::Left;
  }
  if (origin) {
    view.user = QString::fromStdString(origin->user);
    view.computer = QString::fromStdString(origin->computer);
    view.startedAtUtc = QString::fromStdString(origin->startedAtUtc);
  }
  return view;
}

void FoundRuns::takeSeen(const session::RunsSeen& seen) {
  const bool isSame = seen.onControl && m_seen.onControl &&
                      seen.onControl->onControl.isSameAs(m_seen.onControl->onControl);
  const bool isNew = seen.onControl && !isSame;
  if (m_isWatched && m_seen.onControl && !isSame) {
    m_isWatched = false;
    m_messages.show(Severity::Note, [] { return tr("The run that was watched has ended."); });
  }
  m_seen = seen;
  m_isHeld = m_isHeld && seen.onControl;
  if (isNew) {
    m_stopConfirmedAfter.reset();
    m_isHeld = false;
    m_messages.log(Severity::Note, Source::Run, [found = view().value_or(FoundRunView{})] {
      return tr("There is a run on the control: %1").arg(widgets::foundRunText(found));
    });
  }
  if (m_isWatched && m_seen.onControl) {
    Q_EMIT watched(executedPoints());
  }
  Q_EMIT changed();
}

void FoundRuns::takeEnded(const session::RunEnded& ended) {
  if (ended.byReset) {
    return;  // no run
  }
  if (ended.error.code) {
    tell(Severity::Error, [error = ended.error] { return widgets::errorText(error); });
  } else {
    m_stopConfirmedAfter = ended.confirmedAfter;
    m_isHeld = ended.isHeld;
    tell(Severity::Note, [seconds = base::toSeconds(*ended.confirmedAfter), isHeld = ended.isHeld] {
      const QString text =
          isHeld ? tr("The axes of the run on the control are held; they stood after %1.")
                 : tr("The run has been stopped; confirmed after %1.");
      return text.arg(widgets::secondsText(seconds, 2));
    });
  }
  Q_EMIT changed();
}

void FoundRuns::forget() {
  m_seen = {};
  m_isWatched = false;
  m_stopConfirmedAfter.reset();
  m_isHeld = false;
  m_resuming.reset();
  m_asksSoon = false;
  Q_EMIT changed();
}

void FoundRuns::watch(bool watch) {
  const bool wasWatched = std::exchange(m_isWatched, watch && m_seen.onControl);
  if (m_isWatched && !wasWatched) {
    m_messages.didAct(permission::Act::Watch,
                      {{"run", std::to_string(m_seen.onControl->onControl.number)}});
  }
  if (m_isWatched && saved() != nullptr && !isLoaded(*saved())) {
    load(*saved());
  }
  if (m_isWatched) {
    Q_EMIT watched(executedPoints());
  }
  Q_EMIT changed();
}

void FoundRuns::stop() {
  command(true);
}

void FoundRuns::end() {
  command(false);
}

void FoundRuns::command(bool holds) {
  if (m_seen.onControl && !m_session.isEnding()) {
    m_stopConfirmedAfter.reset();
    m_isHeld = false;
    m_session.endRun(m_seen.onControl->onControl, holds);
    m_messages.didAct(permission::Act::Stop,
                      {{"run", std::to_string(m_seen.onControl->onControl.number)}});
    m_messages.log(Severity::Note, Source::Run,
                   [] { return tr("Stop of the run on the control requested."); });
    Q_EMIT changed();
  }
}

void FoundRuns::dismiss() {
  if (const report::SavedRun* run = saved(); run != nullptr && !m_seen.onControl) {
    m_dismissed = run->checkpoint.runNumber;
    Q_EMIT changed();
  }
}

bool FoundRuns::isLoaded(const report::SavedRun& run) const {
  const QString file = QString::fromStdString(run.programFile);
  return m_document.program() && m_document.isJob() == m_seen.isJob &&
         m_document.moveRules() == run.reading.moveRules && !m_document.hasFileChanged() &&
         (m_document.path() == file ||
          (!QFileInfo::exists(file) && m_document.program()->name == run.programName));
}

bool FoundRuns::load(const report::SavedRun& run) {
  const QString file = QString::fromStdString(run.programFile);
  if (!QFileInfo::exists(file)) {
    tell(Severity::Warning, [name =
                                 file.isEmpty() ? QString::fromStdString(run.programName) : file] {
      return tr("The file of the program, %1, cannot be found. Open the program, then try again.")
          .arg(name);
    });
    return false;
  }
  const session::Reading reading{run.reading, false, 0.0, {}};
  if (m_seen.isJob) {
    m_document.open(file, reading);
  } else {
    m_document.openMotion(file, reading, run.reading.moveRules);
  }
  return true;
}

void FoundRuns::resume() {
  const report::SavedRun* run = saved();
  if (run == nullptr || m_runs.isRunning()) {
    return;
  }
  if (m_runs.leftRunNumber() == run->checkpoint.runNumber) {
    m_runs.askResume();
    return;
  }
  m_isWatched = false;
  m_resuming = *run;
  streaming::StreamSettings settings =
      preparation::settingsOfRun(run->settings, m_document.settings());
  settings.wholeJob = settings.wholeJob || m_seen.isJob;
  m_document.setSettings(settings);
  if (isLoaded(*run)) {
    takeLoaded();
  } else if (!load(*run)) {
    m_resuming.reset();
  }
}

void FoundRuns::takeLoaded() {
  if (!m_resuming || !isLoaded(*m_resuming)) {
    if (m_resuming && m_seen.isJob && !m_document.isJob() &&
        m_document.path() == QString::fromStdString(m_resuming->programFile)) {
      tell(Severity::Warning, [] {
        return tr(
            "This run was a whole job, and its program cannot be run as one here now. The "
            "command rivulet-cli job --resume goes on with it.");
      });
    }
    m_resuming.reset();  // or another program has been opened instead
    return;
  }
  session::ResumeQuestion question{m_document.program(), m_resuming->settings,
                                   m_resuming->checkpoint};
  if (m_document.isJob()) {
    question.plan = m_document.view()->plan;
    question.machine = m_document.jobMachine();
    question.job = m_resuming->job;
  }
  m_resuming.reset();
  m_asksSoon = true;
  m_runs.adopt(std::move(question));
  askWhenPossible();
}

void FoundRuns::askWhenPossible() {
  if (!m_asksSoon) {
    return;
  }
  const std::optional<streaming::Blocked> blocked = m_runs.resumeBlocked();
  if (blocked && (blocked->reason == streaming::BlockReason::NotRehearsed ||
                  blocked->reason == streaming::BlockReason::JobNotChecked)) {
    return;  // it will be
  }
  m_asksSoon = false;
  if (blocked) {
    m_runs.refuseResume([blocked] { return widgets::blockedText(blocked); });
  } else {
    m_runs.askResume();
  }
}

}  // namespace rivulet::hmi
