// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The growing path of a live run as the program page shows it: a view is made of all points so
/// far, again and again, but the longer it takes, the more seldom. @threadsafety GUI thread; the
/// work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "overview/program_view.h"
#include "session/session_event.h"

namespace rivulet::session {

/// A program without a text: points that have come from elsewhere. @param hash  of what was agreed
[[nodiscard]] std::shared_ptr<const gcode::Program> liveProgram(
    std::string name, std::string hash, const std::vector<gcode::StreamPoint>& points = {});

class LivePath final : public QObject {
  Q_OBJECT

 public:
  explicit LivePath(QObject* parent = nullptr);

  /// Forgets the points of the path before.
  void begin(std::string name, std::string hash);
  void append(const LivePoints& more);
  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const { return m_points; }

 Q_SIGNALS:
  /// Of the points at some moment after `begin`; there may be more by now.
  void grown(const std::shared_ptr<const rivulet::overview::ProgramView>& view);

 private:
  void make();

  std::string m_name;
  std::string m_hash;
  std::vector<gcode::StreamPoint> m_points;
  QTimer m_timer;
  int m_path = 0;           ///< number of the path; views of another one are dropped
  std::size_t m_shown = 0;  ///< points of the view that was made last
  bool m_isBusy = false;
};

}  // namespace rivulet::session
