// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Paints a program's path, its executed part, and the tool. A frame draws a bounded number of
/// points, whatever the program: the level of detail is as fine as the screen can show if these are
/// few enough, otherwise coarser. The fine picture is then drawn in slices while nothing moves. A
/// move of the tool costs one copy of the picture, and newly executed points are added to it.
///
/// Pauses are marks in a separate picture on top. A bounded number of the visible ones is examined,
/// and of marks that would overlap only one is drawn, a pause in the cut first.
/// @threadsafety GUI thread.
#pragma once

#include <QImage>
#include <QPen>
#include <QPointF>
#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "overview/path_classes.h"
#include "overview/program_view.h"

namespace rivulet::widgets {

class PathCanvas final : public QWidget {
  Q_OBJECT

 public:
  /// The planes are seen along an axis; a picture of the space can be turned.
  enum class View : unsigned char { Space, Top, Front, Side };

  /// Largest number of moves of the path drawn in one event, and of its executed part: this bounds
  /// the time of one event of the GUI thread.
  static constexpr std::size_t kPathMoves = 12'000;
  static constexpr std::size_t kFrameMoves = 2 * kPathMoves;
  /// Largest number of pauses of each kind that are examined for a picture, at some nanoseconds
  /// each.
  static constexpr std::size_t kPausesSeen = 200'000;

  /// Texts on the canvas, in the language of the operator.
  struct Texts {
    QString empty;
    QString emptyBox;  ///< while there is a box and no path
    QString start;
    QString tool;
    QString pauseOffCut;  ///< %1: number of the point after which it is, %2: its line
    QString pauseInCut;
    QString grid;  ///< %1: the width of its meshes
  };

  /// How the moves of each class are drawn.
  struct Style {
    std::shared_ptr<const overview::DrawnClasses>
        classes;             ///< of the program; null: no path is drawn
    std::vector<QPen> pens;  ///< one per class
  };

  explicit PathCanvas(QWidget* parent = nullptr);

  void setTexts(const Texts& texts);
  /// @param view  null: none. The picture is fitted to it.
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// The program's points for another position of the tool; the picture stays as it is.
  void replaceProgram(std::shared_ptr<const overview::ProgramView> view);
  void setStyle(Style style);
  [[nodiscard]] bool hasClasses() const { return m_style.classes != nullptr; }
  /// What the path cannot leave, drawn around it; the picture is then fitted to it, not to the
  /// path.
  struct Box {
    base::Vec3 lowestMm;
    base::Vec3 highestMm;
    friend bool operator==(const Box&, const Box&) = default;
  };
  /// @param box  nothing: none
  void setBox(const std::optional<Box>& box);
  /// How many of the points the tool has passed.
  void setExecuted(std::size_t count);
  /// The run has begun at this point, so the path before it is not executed. @param point  an index
  void setRunBegin(std::size_t point);
  void setToolPosition(const std::optional<base::Vec3>& positionMm);
  /// The way of the tool to the path, drawn over it; the picture is fitted to both.
  /// @param placesMm  from where it stands; fewer than two: none
  void setFirstWay(std::vector<base::Vec3> placesMm);
  /// Points whose moves are shown as selected.
  void setSelected(std::vector<std::uint32_t> points);
  /// The point at the slider's position.
  void setMarked(std::optional<std::size_t> point);
  /// Marks where a run will pause. @param pauses  null: no marks
  void setPauses(std::shared_ptr<const overview::PauseMap> pauses);
  /// Moves the picture if a point is not in it.
  void reveal(std::size_t point);
  void setView(View view);
  [[nodiscard]] View view() const { return m_view; }
  /// Turns the picture of the space about the middle of the path. The other views do not turn.
  void turn(double byDeg, double tiltByDeg);
  /// Where one looks from.
  [[nodiscard]] overview::Projection::Angles angles() const;
  void fit();

  /// The point whose move passes nearest to a place of the widget; nothing within a finger's width.
  [[nodiscard]] std::optional<std::size_t> pointNear(QPointF place) const;
  struct Pause {
    std::size_t point = 0;
    bool inCut = false;
  };
  /// The marked pause nearest to a place of the widget; nothing within a finger's width.
  [[nodiscard]] std::optional<Pause> pauseNear(QPointF place) const;
  /// Where a point is drawn.
  [[nodiscard]] QPointF placeOf(std::size_t point) const;

  [[nodiscard]] QSize sizeHint() const override { return {520, 400}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
  /// Moves of the path in the picture, and the most drawn in one event since the last call: for
  /// tests of speed.
  [[nodiscard]] std::size_t drawnMoves() const { return m_drawn.moves; }
  [[nodiscard]] std::size_t takeMostAtOnce() { return std::exchange(m_drawn.mostAtOnce, 0); }
  /// Marks of pauses in the picture, and pauses examined for it: for tests of speed.
  [[nodiscard]] std::size_t drawnPauses() const { return m_drawn.pauses; }
  /// Of gaps and tool changes in sight, the most that are drawn.
  static constexpr std::size_t kGapsDrawn = 2'000;
  [[nodiscard]] std::size_t pausesSeen() const { return m_drawn.pausesSeen; }
  /// The picture is as fine as the screen can show.
  [[nodiscard]] bool isFine() const { return !m_picture.isNull() && m_isFine; }

 Q_SIGNALS:
  /// A click on the path.
  void pointClicked(std::size_t point);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Polylines of one class each, collected before they are stroked.
  struct Strokes {
    std::vector<std::vector<QPolygonF>> lines;  ///< by class
    std::size_t moves = 0;
    double lengthPx = 0.0;
  };

  [[nodiscard]] const std::vector<overview::PathLevel>& levels() const {
    return m_program->levels.levels();
  }
  [[nodiscard]] bool hasPath() const { return m_program && !m_program->points.points.empty(); }
  void dropPicture();
  void makePicture();
  void refine();
  [[nodiscard]] QImage emptyPicture() const;
  [[nodiscard]] bool isVisible(std::size_t level, std::size_t chunk) const;
  [[nodiscard]] std::size_t visibleMoves(std::size_t level) const;
  /// The coarsest level in which nothing the screen could show is missing.
  [[nodiscard]] std::size_t wantedLevel() const;
  /// Collects the moves [from, to) of a level; `isExecuted`: as class 0 (rapid) and 1.
  void collect(std::size_t level, std::size_t from, std::size_t to, bool isExecuted,
               Strokes& strokes) const;
  /// @param isSlice  of a picture that is drawn in slices
  void stroke(QImage& picture, const Strokes& strokes, const std::vector<QPen>& pens, bool isSlice);
  void drawExecuted(QImage& picture, std::size_t from, std::size_t to);
  void makeMarks();
  /// Places of pauses that may be in sight, at most `kPausesSeen`.
  [[nodiscard]] std::vector<QPointF> placesOf(const std::vector<std::uint32_t>& pauses) const;
  void drawGrid(QPainter& painter) const;
  void drawFloor(QPainter& painter) const;
  void drawBox(QPainter& painter) const;
  /// What the picture is fitted to.
  [[nodiscard]] overview::PlaneBox fitted() const;
  [[nodiscard]] overview::SpaceBox spaceBox() const;
  void pan(QPointF byPx);
  /// What is at the place stays there.
  void zoom(double factor, QPointF place);
  void drawScaleBar(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  /// What the control moves between the stretches of a job, as far as it is known.
  void drawGaps(QPainter& painter) const;
  void drawToolChanges(QPainter& painter) const;
  void drawStart(QPainter& painter) const;
  void drawFirstWay(QPainter& painter) const;
  void drawChosen(QPainter& painter) const;
  void drawTool(QPainter& painter) const;
  struct ToolMark {
    QPointF place;
    QString label;
    QRectF box;  ///< of the label
  };
  /// Of a position that is known.
  [[nodiscard]] ToolMark toolMark() const;
  /// What the mark of the tool covers.
  [[nodiscard]] QRegion toolRegion() const;
  [[nodiscard]] QPointF onScreen(overview::PlanePoint place) const;
  /// Whether something in the box may be within a finger's width.
  [[nodiscard]] bool isNear(const overview::PlaneBox& box, QPointF place) const;
  [[nodiscard]] double gridStepMm() const;

  Texts m_texts;
  std::shared_ptr<const overview::ProgramView> m_program;
  Style m_style;
  std::size_t m_executed = 0;
  std::size_t m_runBegin = 0;
  std::optional<base::Vec3> m_toolMm;
  std::vector<base::Vec3> m_firstWayMm;
  std::optional<Box> m_box;
  std::vector<std::uint32_t> m_selected;
  std::optional<std::size_t> m_marked;
  View m_view = View::Top;
  overview::Projection::Angles m_turned = overview::Projection::isometric();
  overview::Projection m_projection{overview::Projection::Angles{}};
  std::shared_ptr<const overview::PauseMap> m_pauses;

  bool m_fits = true;  ///< the whole path is shown; stays so when the widget is resized
  overview::PlanePoint m_centreMm;
  double m_pixelsPerMm = 10.0;
  struct Drag {
    std::optional<QPointF> from;
    QPointF pressedAt;
    bool moved = false;
  };
  Drag m_drag;

  QImage m_picture;  ///< null: to be drawn
  std::size_t m_executedInPicture = 0;
  /// For tests of speed.
  struct Drawn {
    std::size_t moves = 0;
    std::size_t now = 0;  ///< moves drawn by the present event
    std::size_t mostAtOnce = 0;
    std::size_t pauses = 0;
    std::size_t pausesSeen = 0;
  };
  Drawn m_drawn;

  QImage m_marks;  ///< over the picture; null: to be made, or none

  QTimer m_refineTimer{this};
  /// The finer picture that is being made.
  struct FinePicture {
    QImage picture;
    std::size_t level = 0;
    std::size_t chunk = 0;  ///< the next to be drawn into it
    std::size_t moves = 0;
  };
  FinePicture m_fine;
  bool m_isFine = false;
};

}  // namespace rivulet::widgets
