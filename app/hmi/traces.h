// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The traces on the page Traces: reads files, and makes signals and analysis of them and of runs,
/// outside the GUI thread. Signals come first, the analysis follows. Only the last request counts.
/// @threadsafety GUI thread; the work itself runs in the pool (`session/background.h`).
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
  explicit Traces(Document& document);
  ~Traces() override;

  /// Recordings, traces of controls, tables of other tools. Those that cannot be read are reported;
  /// the others are shown.
  void open(const QStringList& paths);
  /// Remembers what the tables of a layout mean, and reads the present files again.
  [[nodiscard]] base::Result<void> setMapping(const std::string& layout,
                                              const trace::TableMapping& mapping);
  /// Of the run that has just ended.
  void show(const std::shared_ptr<const trace::ControlTrace>& trace);
  /// Of a run that ended earlier.
  void show(const std::shared_ptr<const trace::Recording>& recording);
  /// What is being read is not shown: a run has begun.
  void cancel();

 Q_SIGNALS:
  /// Files are being read.
  void reading(const QStringList& names);
  /// The same traces come twice: with their signals, and with their analysis; and again when
  /// another program is open, compared with that.
  void filesShown(const rivulet::hmi::Traces::List& traces);
  void runShown(const rivulet::hmi::Traces::List& traces);
  /// One of the files; its path is the context.
  void failed(const rivulet::base::Error& error);

 private:
  struct Subject;
  enum class Kind { Files, Run };

  void begin(Kind kind, std::vector<Subject> subjects);
  /// With the present program. @param read  the subjects, as they were read; null: read them first
  void analyse(int request, std::shared_ptr<std::vector<Subject>> read);
  void emitShown(const List& list);
  /// Another program is open.
  void compareAgain();

  Document& m_document;
  int m_request = 0;
  Kind m_kind = Kind::Files;
  std::size_t m_shown = 0;          ///< of the subjects; 0: none yet
  std::vector<Subject> m_subjects;  ///< of the last request; what files contain is not kept
};

}  // namespace rivulet::hmi
