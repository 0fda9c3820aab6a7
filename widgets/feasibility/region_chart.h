// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feasibility region over one quantity: the limits of the equations, with safety factor
/// (solid) and as published (dashed), the area below them, the program's own points and the
/// operating point, which can be dragged.
/// @threadsafety GUI thread.
#pragma once

#include <QChartView>
#include <array>
#include <optional>
#include <vector>

#include "widgets/calibration/access_source.h"
#include "widgets/feasibility/feed_scale.h"
#include "widgets/feasibility/simulated_region.h"

class QAreaSeries;
class QLineSeries;
class QScatterSeries;
class QValueAxis;

namespace rivulet::widgets {

class RegionOverlay;

/// Everything the region is computed from.
struct FeasibilityModel {
  feasibility::OperatingPoint operatingPoint;
  feasibility::ProgramDistances distances;
  FeedScale scale{};  ///< with the feeds of the program, all distances are those in time
  std::vector<double> smallestDistancesMm;  ///< of neighbouring points, ascending, at most 200
  feasibility::AccessModel access;
  AccessSource source;  ///< of `access`, to be shown
  feasibility::SafetyFactors safety;
  int pointsPerLoopMax = 2;  ///< largest N that fits
  std::optional<feasibility::Verdict> verdict{};
  QString limitedBy{};  ///< with the feeds of the program: the largest override and its block
};

class RegionChart final : public QChartView {
  Q_OBJECT

 public:
  explicit RegionChart(feasibility::SweepAxis axis, QWidget* parent = nullptr);

  /// The base class wants what the chart has had: a page would never become lower again.
  [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }

  void setModel(const FeasibilityModel& model);
  /// Simulated points and the band of the extended model; none removes them.
  void setRegion(const std::optional<SimulatedRegion>& region);
  [[nodiscard]] const std::optional<SimulatedRegion>& region() const { return m_region; }
  /// Colours of simulated points that ran, failed sometimes, failed always; and of the band.
  [[nodiscard]] static std::array<QColor, 3> pointColors(const QPalette& palette);
  [[nodiscard]] static QBrush bandBrush(const QPalette& palette);
  /// A grid over the picture, with the operating point's own abscissa; empty without a model.
  [[nodiscard]] SimulationWanted simulationWanted() const;
  /// During a run the operating point cannot be moved.
  void setEditable(bool editable) { m_editable = editable; }
  /// Sets titles and numbers in the present language.
  void retranslate();
  /// @param palette  of the page, which gets a new theme before its children
  void restyle(const QPalette& palette);

  /// Where the operating point is, in pixels of the chart.
  [[nodiscard]] QPointF operatingPixel() const;
  /// Equations with a limit in this chart.
  [[nodiscard]] const std::vector<feasibility::Border>& borders() const { return m_borders; }
  /// A limit that counts for the verdict, not one shown for information.
  [[nodiscard]] bool decides(const feasibility::Border& border) const;

 Q_SIGNALS:
  /// The marker was dragged here. Quantities this chart does not sweep keep their values.
  void operatingPointRequested(const rivulet::feasibility::OperatingPoint& operatingPoint);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  friend class RegionOverlay;
  friend class RegionFailures;

  void rebuild();
  void draw();
  [[nodiscard]] FeedScale scale() const { return m_model ? m_model->scale : FeedScale(); }
  /// On the axes: mm, ms or N, and mm/min or %.
  [[nodiscard]] double shownX(double abscissa) const;
  [[nodiscard]] feasibility::SweepRange sweepRange() const;
  /// The areas below all limits that decide, with safety factor and as published.
  void drawAreas();
  void drawBorders();
  /// The smallest distances of the program, as marks at the feed.
  void drawDistances();
  void divideAxes();
  void showRegion();
  void chooseRanges();
  [[nodiscard]] double abscissa() const;
  [[nodiscard]] QPointF pixel(double abscissa, double feedMmPerS) const;
  void dragTo(QPointF pixel);

  feasibility::SweepAxis m_axis;
  QPalette m_palette;
  std::optional<FeasibilityModel> m_model;
  std::optional<SimulatedRegion> m_region;
  std::vector<feasibility::Border> m_borders;
  bool m_editable = true;
  bool m_dragging = false;
  bool m_isStale = false;          ///< the picture is not of the present model
  double m_xMax = 1.0;             ///< mm or N
  double m_feedShownMax = 1000.0;  ///< as `FeedScale::shown`

  QValueAxis* m_xAxis;
  QValueAxis* m_yAxis;
  QLineSeries* m_anchor;  ///< empty; gives the chart its coordinates
  QLineSeries* m_safeUpper;
  QLineSeries* m_safeLower;
  QLineSeries* m_bandUpper;
  QLineSeries* m_bandLower;
  QAreaSeries* m_safeArea;
  QAreaSeries* m_bandArea;
  std::vector<QLineSeries*> m_lines;  ///< one per limit shown
  QScatterSeries* m_points;
  QLineSeries* m_half;
  QLineSeries* m_rare;
  QAreaSeries* m_probability;                    ///< between both
  std::array<QScatterSeries*, 3> m_simulated{};  ///< ran, failed sometimes, failed always
  RegionOverlay* m_overlay;
};

}  // namespace rivulet::widgets
