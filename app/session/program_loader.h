// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads NC programs away from the GUI thread, and makes of them what the page shows. Only the
/// request made last is reported. @threadsafety GUI thread; the work itself runs in the global
/// pool.
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
#include "session/file_watch.h"
#include "widgets/program/program_view.h"

namespace rivulet::session {

/// How a text is to be read.
struct Reading {
  std::optional<gcode::Dialect> dialect;  ///< nothing: as detected
  std::vector<std::string> accepted;      ///< see gcode::LoadOptions
  gcode::CentreReading centres = gcode::CentreReading::AsProgrammed;
  double chordToleranceMm = gcode::LoadOptions{}.chordToleranceMm;
};

struct LoadRequest {
  QString path;
  Reading reading;
  base::Vec3 startMm;     ///< present tool position, all finite
  int pointsPerLoop = 2;  ///< N of the distances
};

struct LoadedProgram {
  LoadRequest request;
  FileStamp stamp;  ///< of the file as it was read
  std::shared_ptr<const widgets::ProgramView> view;
};

class ProgramLoader final : public QObject {
  Q_OBJECT

 public:
  explicit ProgramLoader(QObject* parent = nullptr) : QObject(parent) {}
  /// What is under way ends by itself, soon.
  ~ProgramLoader() override;

  /// Begins a request; one that is under way is forgotten.
  void load(LoadRequest request);
  /// Forgets the request that is under way; `cancelled` tells.
  void cancel();
  [[nodiscard]] bool isBusy() const { return m_stop != nullptr; }
  /// Makes the points of a loaded program anew for another place of the tool; `placed` tells. One
  /// at a time: while one is made, others are not begun.
  void place(std::shared_ptr<const widgets::ProgramView> view, base::Vec3 startMm,
             int pointsPerLoop);
  [[nodiscard]] bool isPlacing() const { return m_placing != nullptr; }

 Q_SIGNALS:
  /// At most 20 times a second. @param share  0 to 1
  void progressed(double share);
  void loaded(const rivulet::session::LoadedProgram& program);
  void failed(const rivulet::base::Error& error, const QString& path);
  void cancelled();
  /// @param of  the view it takes the place of
  void placed(const std::shared_ptr<const rivulet::widgets::ProgramView>& view,
              const std::shared_ptr<const rivulet::widgets::ProgramView>& of);

 private:
  void forget();

  std::shared_ptr<std::atomic<bool>> m_stop;  ///< of the request under way; null: none
  std::shared_ptr<std::atomic<bool>> m_placing;
};

}  // namespace rivulet::session
