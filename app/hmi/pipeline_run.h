// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The six tasks of a CNC at work, for the page CNC tasks. `rivulet-cnc` executes the program,
/// in a process of its own: whatever happens to it, a run on a machine goes on. Its events are read
/// while it runs; those of an earlier run are read from a file. @threadsafety GUI thread.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <optional>

#include "base/result.h"
#include "cnc/event_file.h"
#include "pipeline/event_records.h"
#include "widgets/pipeline/pipeline_view.h"

namespace rivulet::hmi {

class PipelineRun final : public QObject {
  Q_OBJECT

 public:
  explicit PipelineRun(QObject* parent = nullptr);
  /// Ends the run.
  ~PipelineRun() override;

  /// Ends a run in progress first. @param program  file; empty: the example
  void start(const widgets::PipelineChoice& choice, const QString& program);
  void stop();
  /// Shows a file of events.
  void open(const QString& path);
  /// Copies the events of the last run.
  void save(const QString& path);

  [[nodiscard]] bool isRunning() const { return m_process.state() != QProcess::NotRunning; }
  [[nodiscard]] const widgets::PipelineView& view() const { return m_view; }

 Q_SIGNALS:
  void changed();

 private:
  void begin(const QString& name);
  void readEvents();
  /// Takes what the reader has.
  void takeEvents();
  void finish(int exitCode, QProcess::ExitStatus status);
  void fail(const QString& sentence);
  [[nodiscard]] static QString cncMissing();
  [[nodiscard]] QString eventFile() const { return m_folder.filePath(QStringLiteral("events")); }

  QTemporaryDir m_folder;
  QProcess m_process;
  QByteArray m_rest;    ///< of a line
  QByteArray m_errors;  ///< what the process said
  bool m_isStopped = false;
  cnc::EventReader m_reader;
  std::optional<pipeline::EventRecords> m_records;
  widgets::PipelineView m_view;
};

}  // namespace rivulet::hmi
