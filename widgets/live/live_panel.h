// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The source of live points beside its growing path: its state, the level of the buffer, points in
/// and out, the delay from arrival to motion, and what was agreed. @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "live/setup.h"
#include "streaming/run/run.h"
#include "widgets/common/page.h"

class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class StatusLabel;

class LivePanel final : public Page {
  Q_OBJECT

 public:
  explicit LivePanel(QWidget* parent = nullptr);

  /// @param name  of the source that is open @param obstacle  why it is not; empty: it is
  void setSource(const live::Setup& setup, const QString& name, const QString& obstacle);
  /// A run begins: nothing of the one before is shown.
  void begin();
  void setUpdate(const streaming::LiveUpdate& update);
  void setReport(const streaming::RunReport& report);
  /// During a run no other source can be opened.
  void setEditable(bool editable);

 Q_SIGNALS:
  /// Another source, or another agreement.
  void changeRequested();
  /// A program is to take its place.
  void programRequested();

 private:
  enum Figure { In, Out, Accepted, Executed, Merged, Median, Percentile, Theory, FigureCount };
  enum Fact { BoxX, BoxY, BoxZ, First, Step, Feed, Merge, Silence, FactCount };

  void showAll();
  void showState();
  void showStateOf(const live::Level& level);
  void showBuffer();
  void showFigures();
  void showAgreed();
  void showFigure(Figure figure, const QString& value);

  live::Setup m_setup;
  QString m_name;
  QString m_obstacle;
  std::optional<live::Level> m_level;  ///< nothing: no run since the source was opened
  std::optional<live::Summary> m_summary;
  bool m_isRunning = false;

  QLabel* m_title = heading({});
  StatusLabel* m_state = status({.id = "live-state", .wraps = true});
  QLabel* m_hint = label({.isMuted = true, .wraps = true});
  QProgressBar* m_buffer;
  QGroupBox* m_run = group({.text = QT_TR_NOOP("Points")});
  QGroupBox* m_agreed = group({.text = QT_TR_NOOP("Agreed with the source")});
  std::array<QLabel*, FigureCount> m_values{};
  std::array<QLabel*, FactCount> m_facts{};
  QPushButton* m_change =
      button({.text = QT_TR_NOOP("Live points …"),
              .tip = QT_TR_NOOP("Another source, or something else agreed with it"),
              .icon = "live",
              .id = "live-change"},
             &LivePanel::changeRequested);
  QPushButton* m_open = button({.text = QT_TR_NOOP("Open program …"),
                                .tip = QT_TR_NOOP("A program takes the place of the live source."),
                                .icon = "open",
                                .id = "live-program"},
                               &LivePanel::programRequested);
};

}  // namespace rivulet::widgets
