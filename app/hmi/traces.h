// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The traces on the page Traces: reads files, and makes signals and analysis of them and of runs,
/// outside the GUI thread. Signals come first, the analysis follows. Only the last request counts.
/// @threadsafety GUI thread; the work itself runs in the global pool.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <vector>

#include "base/error.h"
#include "hmi/document.h"
#include "trace/control_trace.h"
#include "trace/recording.h"
#include "trace/signal_set.h"

namespace rivulet::hmi {

class Traces final : public QObject {
  Q_OBJECT

 public:
  using List = std::vector<std::shared_ptr<const trace::ShownTrace>>;

  /// @param document  whose program the traces are compared with
  explicit Traces(Document& document) : m_document(document) {}

  /// Recordings, traces of controls, tables of other tools. Those that cannot be read are reported;
  /// the others are shown.
  void open(const QStringList& paths);
  /// Of the run that has just ended.
  void show(const std::shared_ptr<const trace::ControlTrace>& trace);
  /// Of a run that ended earlier.
  void show(const std::shared_ptr<const trace::Recording>& recording);
  /// What is being read is not shown: a run has begun.
  void cancel() { ++m_request; }

 Q_SIGNALS:
  /// Files are being read.
  void reading(const QStringList& names);
  /// The same traces come twice: with their signals, and with their analysis.
  void filesShown(const rivulet::hmi::Traces::List& traces);
  void runShown(const rivulet::hmi::Traces::List& traces);
  /// One of the files; its path is the context.
  void failed(const rivulet::base::Error& error);

 private:
  struct Subject;
  enum class Kind { Files, Run };

  void begin(Kind kind, std::vector<Subject> subjects);

  Document& m_document;
  int m_request = 0;
};

}  // namespace rivulet::hmi
