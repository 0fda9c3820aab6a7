// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/past_runs.h"

#include <utility>

#include "base/file.h"
#include "session/background.h"
#include "widgets/common/error_text.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::hmi {

using gcode::Severity;

namespace {

constexpr int kRefreshMs = 300;

}  // namespace

PastRuns::PastRuns(Document& document, RunController& runs, Messages& messages,
                   report::RunHistory history)
    : m_document(document), m_runs(runs), m_messages(messages), m_history(std::move(history)) {
  std::error_code ignored;  // without the folder there is nothing to watch
  std::filesystem::create_directories(m_history.folder(), ignored);
  m_watcher.addPath(QString::fromStdString(m_history.folder().string()));
  m_refreshTimer.setSingleShot(true);
  m_refreshTimer.setInterval(kRefreshMs);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_refreshTimer,
          qOverload<>(&QTimer::start));
  connect(&m_refreshTimer, &QTimer::timeout, this, &PastRuns::refresh);
  connect(&m_runs, &RunController::finished, this, &PastRuns::refresh);
  // Queued: what is said of the program itself comes first.
  connect(
      &m_document, &Document::programLoaded, this,
      [this] {
        // It may still be the one before that was loaded.
        if (m_repeat && m_document.path().toStdString() == m_repeat->summary.programFile) {
          applyRepeat();
        }
      },
      Qt::QueuedConnection);
  connect(&m_document, &Document::readingFailed, this, [this] { m_repeat.reset(); });
  connect(&m_document, &Document::readingCancelled, this, [this] { m_repeat.reset(); });
}

void PastRuns::refresh() {
  const int request = ++m_listRequest;
  session::inBackground(
      this, [history = m_history] { return history.list(); },
      [request](PastRuns& self, report::HistoryList list) {
        if (request == self.m_listRequest) {
          Q_EMIT self.listed(std::make_shared<const report::HistoryList>(std::move(list)));
        }
      });
}

void PastRuns::readRun(const QString& id) {
  readFinished(id, m_history.reportFile(id.toStdString()));
}

void PastRuns::readFile(const QString& path) {
  readFinished({}, path.toStdString());
}

void PastRuns::readFinished(const QString& id, const std::filesystem::path& file) {
  const int request = ++m_readRequest;
  session::inBackground(
      this, [file] { return report::readFinishedRun(file); },
      [request, id](PastRuns& self, base::Result<report::FinishedRun> run) {
        if (request != self.m_readRequest) {
          return;
        }
        if (!run) {
          Q_EMIT self.unreadable(id, run.error());
          return;
        }
        run->summary.id = id.toStdString();
        Q_EMIT self.read(id, std::make_shared<const report::FinishedRun>(std::move(*run)));
      });
}

void PastRuns::openRecording(const report::FinishedRun& run) {
  const int request = ++m_recordingRequest;
  const auto opened = std::make_shared<const report::FinishedRun>(run);
  session::inBackground(
      this,
      [file = run.summary.recording] {
        const auto text = base::readFile(file);
        return text ? trace::parseRecording(*text)
                    : base::Result<trace::Recording>(base::fail(text.error()));
      },
      [request, opened](PastRuns& self, base::Result<trace::Recording> recording) {
        if (request == self.m_recordingRequest) {
          self.takeRecording(std::move(recording), opened);
        }
      });
}

void PastRuns::takeRecording(base::Result<trace::Recording> recording,
                             const std::shared_ptr<const report::FinishedRun>& run) {
  if (!recording) {
    m_messages.show(Severity::Warning,
                    [error = recording.error()] { return widgets::errorText(error); });
    return;
  }
  if (m_runs.isRunning()) {
    m_messages.show(Severity::Warning, [] {
      return tr("A run is in progress: the Traces page shows it until it has ended.");
    });
    return;
  }
  Q_EMIT recordingRead(std::make_shared<const trace::Recording>(std::move(*recording)), run);
}

void PastRuns::setLimits(const report::HistoryLimits& limits) {
  session::inBackground(
      this, [history = m_history, limits] { return history.setLimits(limits); },
      [](PastRuns& self, const base::Result<void>& done) {
        if (!done) {
          self.m_messages.show(Severity::Warning,
                               [error = done.error()] { return widgets::errorText(error); });
        }
        self.refresh();
      });
}

void PastRuns::repeat(const report::FinishedRun& run) {
  if (m_runs.isRunning()) {
    m_messages.show(Severity::Warning, [] {
      return tr("A run is in progress. Open another program after it has ended.");
    });
    return;
  }
  if (!m_runs.canChangeSettings()) {
    return;
  }
  const QString path = QString::fromStdString(run.summary.programFile);
  const auto program = m_document.program();
  const bool isLoaded = program && program->hash == run.summary.programHash;
  m_repeat = run;
  if (isLoaded || path.isEmpty()) {
    applyRepeat();
  } else {
    m_document.open(path);
  }
}

void PastRuns::applyRepeat() {
  const std::optional<report::FinishedRun> wanted = std::exchange(m_repeat, std::nullopt);
  // Meanwhile the window may have been locked.
  if (!wanted || !m_runs.canChangeSettings()) {
    return;
  }
  const report::FinishedRun& run = *wanted;
  const auto program = m_document.program();
  const QString was = QString::fromStdString(run.summary.programHash);
  streaming::StreamSettings settings = m_document.settings();
  settings.parameters = run.report.settings.parameters;
  settings.deltaMm = run.report.settings.deltaMm;
  settings.feedMmPerS = run.report.settings.feedMmPerS;
  const auto& feeds = run.report.settings.programFeeds;
  settings.programFeeds = feeds.has_value();
  settings.overrideFactor = feeds ? feeds->overrideFactor : settings.overrideFactor;
  // A run that left out the blocks for the control is repeated without them.
  settings.wholeJob = run.summary.jobTimes.has_value();
  settings.dryRunMm = run.summary.dryRunMm;
  m_document.setSettings(settings);
  if (!program) {
    m_messages.show(Severity::Warning, [was] {
      return tr("The settings of the run have been taken over. Where its program was is not known: "
                "open the program with version %1.")
          .arg(was);
    });
  } else if (program->hash != run.summary.programHash) {
    m_messages.show(Severity::Warning, [was, name = QString::fromStdString(program->name),
                                        now = QString::fromStdString(program->hash)] {
      return tr("%1 is not the program of that run: version %2 then, %3 now. Its settings are set. "
                "Check the path before you start.")
          .arg(name, was, now);
    });
  } else {
    m_messages.show(Severity::Note, [start = widgets::startText(run.summary)] {
      return tr("Program and settings are those of the run of %1. Nothing has started.").arg(start);
    });
  }
}

}  // namespace rivulet::hmi
