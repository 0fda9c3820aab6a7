// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feasibility region over d_min, N and δ, with its explanation.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "widgets/common/page.h"
#include "widgets/feasibility/region_chart.h"

class QBoxLayout;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace rivulet::widgets {

class AdvicePanel;
class LegendStrip;
class StatusLabel;

class FeasibilityPage final : public Page {
  Q_OBJECT

 public:
  explicit FeasibilityPage(QWidget* parent = nullptr);

  /// Shows the region around an operating point; at once, also while it is being dragged.
  void setModel(const FeasibilityModel& model);
  /// Shows simulated points together with the limits, on the chart they belong to.
  void setRegion(const SimulatedRegion& region);
  /// The program has changed: the simulation no longer applies.
  void clearRegions();
  /// @param percent  of the simulation in progress; none: there is none
  void setSimulationProgress(std::optional<int> percent);
  /// During a run the operating point cannot be dragged and nothing can be simulated.
  void setEditable(bool editable);
  [[nodiscard]] RegionChart* chart(feasibility::SweepAxis axis) const;
  void showChart(feasibility::SweepAxis axis);
  [[nodiscard]] AdvicePanel* advice() const { return m_advice; }

 Q_SIGNALS:
  void operatingPointRequested(const rivulet::feasibility::OperatingPoint& operatingPoint);
  void simulationRequested(const rivulet::widgets::SimulationWanted& wanted);
  void simulationCancelRequested();

 protected:
  void retranslate() override;
  void restyle() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTitles();
  void showHint();
  void showAccess();
  void showLegend();
  void showSimulation();
  void dropStaleRegions();

  std::optional<FeasibilityModel> m_model;
  std::optional<int> m_percent;
  bool m_editable = true;
  StatusLabel* m_hint = status({.wraps = true});
  StatusLabel* m_access = status({.wraps = true});
  QPushButton* m_simulate;
  QProgressBar* m_progress;
  QPushButton* m_cancel;
  QTabWidget* m_tabs;
  std::array<RegionChart*, 3> m_charts{};
  LegendStrip* m_legend;
  AdvicePanel* m_advice;
  QBoxLayout* m_columns;
};

}  // namespace rivulet::widgets
