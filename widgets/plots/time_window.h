// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The time range that several plots show together. Live, it follows the newest sample; a pan or a
/// zoom leaves live until the operator asks for it again.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>

namespace rivulet::widgets {

class TimeWindow final : public QObject {
  Q_OBJECT

 public:
  explicit TimeWindow(QObject* parent = nullptr);

  [[nodiscard]] double fromS() const { return m_fromS; }
  [[nodiscard]] double toS() const { return m_toS; }
  [[nodiscard]] bool isLive() const { return m_isLive; }

  [[nodiscard]] double endS() const { return m_endS; }

  /// The data now extends to this time.
  void setEnd(double endS);
  /// All of the data is there: shows it, and no longer follows.
  void setLength(double lengthS);
  void clear();
  void goLive();
  /// The whole range of the data.
  void showAll();
  void pan(double byS);
  /// @param factor < 1 magnifies  @param aroundS stays where it is on the screen
  void zoom(double factor, double aroundS);
  /// Ends following.
  void showRange(double fromS, double toS);
  /// Moves, without a change of scale, until an instant is in the middle third.
  void reveal(double atS);

 Q_SIGNALS:
  void changed();

 private:
  void show(double fromS, double toS);

  double m_fromS = 0.0;
  double m_toS;
  double m_endS = 0.0;
  double m_liveSpanS;
  bool m_isLive = true;
};

}  // namespace rivulet::widgets
