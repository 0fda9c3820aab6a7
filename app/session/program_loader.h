// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads NC programs outside the GUI thread and creates the views for the page. Only the last
/// request is reported. @threadsafety GUI thread; the work itself runs in the pool
/// (`session/background.h`).
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gcode/program.h"
#include "overview/program_view.h"
#include "report/load_machine.h"
#include "session/file_watch.h"

namespace rivulet::session {

/// Settings for reading a text.
struct Reading : gcode::TextReading {
  /// Stream what is left beside the blocks that the control executes itself; false: all motion.
  /// Programs without such blocks, and those that cannot be a job, are the same with both.
  bool asJob = false;
  double dryRunMm = 0.0;        ///< > 0: a job is to run dry, so much higher (`job::dryPlan`)
  report::LoadMachine machine;  ///< that is to run it
};

struct LoadRequest {
  QString path;
  Reading reading;
  base::Vec3 startMm;     ///< present tool position, all finite
  int pointsPerLoop = 2;  ///< N of the distances
  /// Limits of the feeds of the program, at 100 %.
  std::optional<gcode::ProgramFeeds> feeds{};
  gcode::MoveRules moveRules{};  ///< long moves are divided; not those of a whole job
};

struct LoadedProgram {
  LoadRequest request;
  FileStamp stamp;  ///< of the file as it was read
  std::shared_ptr<const overview::ProgramView> view;
  std::shared_ptr<const gcode::Program> whole;  ///< that of the view before moves were divided
  std::optional<base::Error> dryRunError{};     ///< why the job cannot run dry
};

/// Other points of a program that is loaded.
struct PlaceRequest {
  std::shared_ptr<const overview::ProgramView> view;  ///< to be replaced
  std::shared_ptr<const gcode::Program> program;  ///< as it was read; of a job, that of the view
  gcode::MoveRules moveRules{};
  base::Vec3 startMm;     ///< present tool position, all finite
  int pointsPerLoop = 2;  ///< N of the distances
};

class ProgramLoader final : public QObject {
  Q_OBJECT

 public:
  explicit ProgramLoader(QObject* parent = nullptr) : QObject(parent) {}
  /// Work in progress ends by itself, soon.
  ~ProgramLoader() override;

  /// Begins a request; one in progress is dropped.
  void load(LoadRequest request);
  /// Drops the request in progress; `cancelled` reports it.
  void cancel();
  [[nodiscard]] bool isBusy() const { return m_stop != nullptr; }
  /// Computes the points of a loaded program for another position of the tool, or for another limit
  /// of its moves; `placed` reports the result. One at a time: while one is in progress, no other
  /// begins.
  void place(PlaceRequest request);
  [[nodiscard]] bool isPlacing() const { return m_placing != nullptr; }

 Q_SIGNALS:
  /// At most 20 times a second. @param share  0 to 1
  void progressed(double share);
  void loaded(const rivulet::session::LoadedProgram& program);
  void failed(const rivulet::base::Error& error, const QString& path);
  void cancelled();
  void placed(const std::shared_ptr<const rivulet::overview::ProgramView>& view,
              const rivulet::session::PlaceRequest& request);

 private:
  void forget();

  std::shared_ptr<std::atomic<bool>> m_stop;  ///< of the request in progress; null: none
  std::shared_ptr<std::atomic<bool>> m_placing;
};

}  // namespace rivulet::session
