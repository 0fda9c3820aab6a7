// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The runs that have ended on this computer, and what can be done with them again. Files are read
/// and written in the pool of threads; an answer that is no longer wanted is dropped.
/// @threadsafety GUI thread.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "hmi/document.h"
#include "hmi/messages.h"
#include "hmi/run_controller.h"
#include "report/run_history.h"
#include "trace/recording.h"

namespace rivulet::hmi {

class PastRuns final : public QObject {
  Q_OBJECT

 public:
  PastRuns(Document& document, RunController& runs, Messages& messages,
           report::RunHistory history = report::RunHistory());

  /// `listed` answers. Called by itself when a run ends, here or on the command line.
  void refresh();
  /// `read` or `unreadable` answers.
  void readRun(const QString& id);
  /// The report of a run from a file that is not in the history: `read` with an empty id.
  void readFile(const QString& path);
  /// `recordingRead` answers. @param run  with a recording
  void openRecording(const report::FinishedRun& run);
  /// Loads the program of a run, compares it with the one that was run, and sets the settings.
  /// Nothing starts.
  void repeat(const report::FinishedRun& run);

  [[nodiscard]] report::HistoryLimits limits() const { return m_history.limits(); }
  void setLimits(const report::HistoryLimits& limits);
  [[nodiscard]] std::filesystem::path reportFile(const QString& id) const {
    return m_history.reportFile(id.toStdString());
  }

 Q_SIGNALS:
  void listed(const std::shared_ptr<const rivulet::report::HistoryList>& list);
  void read(const QString& id, const std::shared_ptr<const rivulet::report::FinishedRun>& run);
  void unreadable(const QString& id, const rivulet::base::Error& error);
  void recordingRead(const std::shared_ptr<const rivulet::trace::Recording>& recording,
                     const std::shared_ptr<const rivulet::report::FinishedRun>& run);

 private:
  void readFinished(const QString& id, const std::filesystem::path& file);
  void takeRecording(base::Result<trace::Recording> recording,
                     const std::shared_ptr<const report::FinishedRun>& run);
  void applyRepeat();

  Document& m_document;
  RunController& m_runs;
  Messages& m_messages;
  report::RunHistory m_history;
  QFileSystemWatcher m_watcher;
  QTimer m_refreshTimer;  ///< several files of one run change
  int m_listRequest = 0;
  int m_readRequest = 0;
  int m_recordingRequest = 0;
  std::optional<report::FinishedRun> m_repeat;  ///< its program is being loaded
};

}  // namespace rivulet::hmi
