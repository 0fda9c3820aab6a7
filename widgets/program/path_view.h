// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The program's path with the tool on it, in space or along an axis, coloured by kind, feed,
/// margin or time, with a slider that walks along it. @threadsafety GUI thread.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "live/agreement.h"
#include "overview/path_classes.h"
#include "widgets/common/page.h"
#include "widgets/program/path_canvas.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace rivulet::widgets {

class LegendStrip;
struct LegendEntry;

class PathView final : public Page {
  Q_OBJECT

 public:
  /// Runs work outside the GUI thread, and then, on the GUI thread, what the work has returned.
  using Elsewhere = std::function<void(std::function<std::function<void()>()>)>;

  explicit PathView(QWidget* parent = nullptr);

  /// Finds the classes of the moves of a long program; without it, they are found at once, here.
  void setElsewhere(Elsewhere elsewhere) { m_elsewhere = std::move(elsewhere); }
  /// In the language of the operator, also for other canvases.
  [[nodiscard]] static PathCanvas::Texts canvasTexts();
  /// @param view  null: none. Forgets progress, selection and times of the previous one.
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// The same program with points for another position of the tool.
  void replaceProgram(std::shared_ptr<const overview::ProgramView> view);
  /// When each point is passed; null: not known (yet).
  void setTimes(std::shared_ptr<const overview::ProgramTimes> times);
  /// Where a run will pause; null: not known (yet).
  void setPauses(std::shared_ptr<const overview::PauseMap> pauses);
  /// Pauses are marked on the path, if they are known.
  void setPausesShown(bool shown);
  /// The settings for which margins are computed.
  /// @param ownFeeds  each move has its own feed; that of `point` is the largest
  void setOperatingPoint(const feasibility::OperatingPoint& point,
                         const feasibility::AccessModel& access = {}, bool ownFeeds = false);
  /// Counts in the streamed points.
  void setExecuted(std::size_t count);
  /// @param point  index of the first point of the run: the path before it is not executed
  void setRunBegin(std::size_t point);
  /// @param positionMm  workpiece frame; nothing hides the tool
  void setToolPosition(const std::optional<base::Vec3>& positionMm);
  /// See `PathCanvas::setBox`.
  void setBox(const std::optional<live::Agreement>& agreed);
  void setView(PathCanvas::View view);
  void setColouring(overview::PathColouring colouring);
  [[nodiscard]] overview::PathColouring colouring() const { return m_colouring; }
  /// The classes of a long program come later.
  [[nodiscard]] overview::PathColouring shownColouring() const { return classes().colouring; }
  /// Marks a point and, if necessary, moves the picture to it. The slider follows; no signal is
  /// emitted.
  void markPoint(std::size_t point);
  /// Shows the moves of these points as selected, and marks the first.
  void selectPoints(const std::vector<std::uint32_t>& points);
  void fit();

  [[nodiscard]] const std::shared_ptr<const overview::PauseMap>& pauses() const { return m_pauses; }
  /// Of the classes, in their order.
  [[nodiscard]] std::vector<QPen> pens() const;
  [[nodiscard]] PathCanvas* canvas() const { return m_canvas; }
  [[nodiscard]] QSlider* slider() const { return m_slider; }

 Q_SIGNALS:
  /// By slider or by a click on the path.
  void pointChosen(std::size_t point);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// By `PathCanvas::View`.
  [[nodiscard]] std::array<QPushButton*, 4> views() const;
  [[nodiscard]] std::size_t pointCount() const;
  [[nodiscard]] bool scrubsByTime() const;
  /// Finds the class of each move anew.
  void recolour();
  void showClasses();
  void showLegend();
  void showJobLegend(std::vector<LegendEntry>& entries) const;
  void setScale();
  void moveSlider();
  void scrub();
  void showPlace();
  void showPauses();
  /// Classes without that of the gaps.
  [[nodiscard]] std::size_t pathClasses() const;
  [[nodiscard]] const overview::PathClasses& classes() const { return m_shown->classes; }
  [[nodiscard]] QPen penOf(std::size_t one) const;
  [[nodiscard]] QString nameOf(std::size_t one) const;

  std::shared_ptr<const overview::ProgramView> m_program;
  std::shared_ptr<const overview::ProgramTimes> m_times;
  std::shared_ptr<const overview::PauseMap> m_pauses;
  feasibility::OperatingPoint m_point;
  feasibility::AccessModel m_access;
  bool m_ownFeeds = false;
  overview::PathColouring m_colouring{overview::PathColouring::Kind};
  std::shared_ptr<const overview::DrawnClasses> m_shown =
      std::make_shared<const overview::DrawnClasses>();
  Elsewhere m_elsewhere;
  /// Number of the latest order for classes: what an older one finds is dropped.
  std::shared_ptr<std::atomic<unsigned>> m_ordered = std::make_shared<std::atomic<unsigned>>(0);
  std::optional<std::size_t> m_marked;

  PathCanvas* m_canvas;
  QPushButton* m_space = button({.text = QT_TR_NOOP("3D"),
                                 .tip = QT_TR_NOOP("Drag or press the arrow keys to turn it; "
                                                   "with Shift, dragging moves it")});
  QPushButton* m_top = button({.text = QT_TR_NOOP("Top"), .tip = QT_TR_NOOP("From above: X, Y")});
  QPushButton* m_front =
      button({.text = QT_TR_NOOP("Front"), .tip = QT_TR_NOOP("From the front: X, Z")});
  QPushButton* m_side =
      button({.text = QT_TR_NOOP("Side"), .tip = QT_TR_NOOP("From the right: Y, Z")});
  QPushButton* m_fit =
      button({.tip = QT_TR_NOOP("Show the whole path (double click does the same)"),
              .name = QT_TR_NOOP("Fit"),
              .icon = "fit"},
             &PathView::fit);
  QComboBox* m_colour = list(
      {.hint = QT_TR_NOOP("Colour by"),
       .items = {QT_TR_NOOP("Kind of move"), QT_TR_NOOP("Feed"), QT_TR_NOOP("Margin of the method"),
                 QT_TR_NOOP("Time"), QT_TR_NOOP("Density of pauses")}});
  QPushButton* m_showPauses =
      button({.text = QT_TR_NOOP("Pauses"), .tip = QT_TR_NOOP("Mark where the run will pause")});
  QBoxLayout* m_tools;
  LegendStrip* m_legend;
  QSlider* m_slider;
  QComboBox* m_scale = list({.items = {QT_TR_NOOP("by point"), QT_TR_NOOP("by time")}});
  QLabel* m_place = label({.wraps = true});
};

}  // namespace rivulet::widgets
