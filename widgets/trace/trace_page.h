// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The axes over time: X, Y, Z and the path feed on one time axis, the pauses as bands and as a
/// table. During a run it shows the live samples; afterwards the control's own trace, if there is
/// one, replaces them. A line says which of the two is shown.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "trace/control_trace.h"
#include "trace/pause.h"
#include "widgets/common/page.h"

class QGroupBox;
class QLabel;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class LegendStrip;
class PauseModel;
class StatusLabel;
class TimePlot;
class TimeWindow;

/// One live observation; values that were not read stay empty.
struct TraceSample {
  double atS = 0.0;  ///< from the beginning of the run, not before the previous sample
  std::optional<base::Vec3> positionMm;
  std::optional<double> feedMmPerS;
};

class TracePage final : public Page {
  Q_OBJECT

 public:
  explicit TracePage(QWidget* parent = nullptr);
  ~TracePage() override;

  /// Empties everything and goes live.
  void clear();
  void append(const TraceSample& sample);
  /// Adds a pause that has become known; its start counts from the same origin as the samples.
  void addPause(const trace::Pause& pause);
  /// Shows the control's own trace instead of the live samples. Times are shown from its first
  /// sample on; the pauses are on the time line of the trace.
  void showControlTrace(const std::shared_ptr<const trace::ControlTrace>& trace,
                        const std::vector<trace::Pause>& pauses);
  /// What is shown is a run that ended earlier. `clear` ends it.
  void setPastRun(const QString& start, const QString& program);
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  enum class Source { Nothing, Live, Control };
  static constexpr std::size_t kFeedPlot = base::kAxisCount;

  void showNote();
  void showSummary();
  void showLegend();

  Source m_source = Source::Nothing;
  QString m_pastStart;  ///< of a run that ended earlier; empty: the run is the last one
  QString m_pastProgram;
  base::Duration m_cycle{};
  bool m_truncated = false;
  base::Duration m_pauseTotal{};

  TimeWindow* m_window;
  StatusLabel* m_sourceNote;
  QPushButton* m_live;
  QPushButton* m_all;
  std::array<TimePlot*, base::kAxisCount + 1> m_plots{};
  LegendStrip* m_legend;
  QGroupBox* m_pausesGroup;
  PauseModel* m_pauses;
  QTableView* m_table;
  std::array<QLabel*, 3> m_summaryNames{};
  std::array<QLabel*, 3> m_summaryValues{};
};

}  // namespace rivulet::widgets
