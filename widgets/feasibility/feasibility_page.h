// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feasibility region over d_min, N and δ, with what can be read from it.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "widgets/common/page.h"
#include "widgets/feasibility/region_chart.h"

class QTabWidget;

namespace rivulet::widgets {

class LegendStrip;
class StatusLabel;

class FeasibilityPage final : public Page {
  Q_OBJECT

 public:
  explicit FeasibilityPage(QWidget* parent = nullptr);

  /// Shows the region around an operating point; at once, also while it is being dragged.
  void setModel(const FeasibilityModel& model);
  /// While a run lasts the operating point cannot be dragged.
  void setEditable(bool editable);
  [[nodiscard]] RegionChart* chart(feasibility::SweepAxis axis) const;
  void showChart(feasibility::SweepAxis axis);

 Q_SIGNALS:
  void operatingPointRequested(const rivulet::feasibility::OperatingPoint& operatingPoint);

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  void showHint();
  void showLegend();

  std::optional<FeasibilityModel> m_model;
  StatusLabel* m_hint;
  QTabWidget* m_tabs;
  std::array<RegionChart*, 3> m_charts{};
  LegendStrip* m_legend;
};

}  // namespace rivulet::widgets
