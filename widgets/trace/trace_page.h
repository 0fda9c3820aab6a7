// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The page of the traces: signals over time in panes, the stops as bands and as a table, cursors.
/// During a run it shows the live samples, afterwards the control's own trace, if there is one;
/// and any files that the operator opens. A line says what is shown.
/// @threadsafety GUI thread.
#pragma once

#include <QPointer>
#include <QStringList>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "overview/program_view.h"
#include "trace/pause.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/scope_layout.h"
#include "widgets/scope/stop_row.h"

class QLabel;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class ColumnsDialog;
class ComparePanel;
class CursorPanel;
class FoldingTabs;
class LayoutMenu;
class LegendStrip;
class PathPanel;
class ScopeCursors;
class ScopeView;
class SignalPanel;
class SpectrumPanel;
class StatusLabel;
class StopModel;
class TimeWindow;
class TriggerPanel;

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

  /// Where calculations are done; without it, at once.
  void setRunner(WorkRunner runner);

  /// Empties everything and follows a run.
  void clear();
  void append(const TraceSample& sample);
  /// Adds a pause that has become known; its start counts from the same origin as the samples.
  void addPause(const trace::Pause& pause);

  /// An alarm has come: a trigger may wait for it.
  void noticeAlarm();
  /// The run has ended: no more samples will come.
  void finishLive();

  enum class Source { Nothing, Live, Control, Files };
  /// Shows whole traces instead of what was shown, on one time axis. The same traces again, now
  /// analysed, leave the view as it is. @param source  Control or Files
  void showTraces(const ScopeCurves::Traces& traces, Source source);
  /// Files are being read. `showTraces` or `showProblem` ends it.
  void showReading(const QStringList& names);
  /// One sentence; what was shown stays.
  void showProblem(const QString& sentence);
  /// What is shown is a run that ended earlier. `clear` ends it.
  void setPastRun(const QString& start, const QString& program);
  /// The program that the traces are compared with. @param view  null: none
  void setProgram(std::shared_ptr<const overview::ProgramView> view);
  /// Those that are offered by name.
  void setLayouts(ScopeLayouts layouts);
  [[nodiscard]] const ScopeLayouts& layouts() const;
  void showLayout(const QString& name);
  void keepLayout(const QString& name);

  /// What the panes show, into a file: .csv the samples of the time that is seen, .h5 these and the
  /// events, .png, .svg and .pdf the picture. A sentence on the page says whether it is there.
  void save(const QString& path);
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();

  [[nodiscard]] ScopeView* view() const { return m_view; }
  [[nodiscard]] TimeWindow* timeWindow() const { return m_window; }

 Q_SIGNALS:
  void openRequested(const QStringList& paths);
  /// The operator says what the columns of a table mean. @param layout  of the table
  void mappingChosen(const std::string& layout, const rivulet::trace::TableMapping& mapping);
  /// The operator changed them: they are to be kept.
  void layoutsChanged(const rivulet::widgets::ScopeLayouts& layouts);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeStopPanel();
  void layOut();
  void chooseFiles();
  void chooseFileToSave();
  void saveSignals(const QString& path);
  /// @param problem  empty: it was written
  void showSaved(const QString& path, const QString& problem);
  [[nodiscard]] static QString cannotBeWritten(const QString& path);
  void changeLayouts(ScopeLayouts layouts);
  [[nodiscard]] bool canShow(const QString& formula) const;
  [[nodiscard]] QStringList traceNames() const;
  void arrange();
  /// Bands and cursors of another axis.
  void followAxis();
  /// Asks what the columns of a table mean. @param table  among the traces that are tables
  void askForColumns(int table);
  void showTables();
  void setStops(std::vector<StopRow> stops);
  void appendValue(const QString& formula, double atS, double value);
  void goToStop(int row);
  void showNote();
  [[nodiscard]] QString liveText() const;
  [[nodiscard]] QString tracesText() const;
  void showSummary();
  void showLegend();
  void showPanel();

  Source m_source = Source::Nothing;
  struct PastRun {
    QString start;  ///< of a run that ended earlier; empty: the run is the last one
    QString program;
  };
  PastRun m_past;
  /// What the note says.
  struct News {
    QStringList reading;
    QString problem;
    QString saved;  ///< file that was written last; empty: none since the traces changed
  };
  News m_news;
  QStringList m_asked;  ///< layouts of tables that were asked for of themselves
  base::Duration m_stopTotal{};
  std::optional<bool> m_wantsPanel;  ///< nothing: as there is room

  TimeWindow* m_window;
  ScopeCurves* m_curves;
  ScopeCursors* m_cursors;
  StopModel* m_stops;
  ScopeView* m_view;
  StatusLabel* m_note = status({.id = "traceNote", .wraps = true});
  QPushButton* m_open =
      button({.tip = QT_TR_NOOP("Open recordings and traces; several are shown on one time axis"),
              .name = QT_TR_NOOP("Open…"),
              .icon = "open",
              .id = "traceOpen"},
             &TracePage::chooseFiles);
  QPushButton* m_live = button({.tip = QT_TR_NOOP("Follow the newest samples"),
                                .name = QT_TR_NOOP("Live"),
                                .icon = "live",
                                .id = "traceLive"});
  QPushButton* m_all =
      button({.tip = QT_TR_NOOP("Wheel: zoom. Drag: move. Ctrl and drag: zoom into a range. Click: "
                                "cursor A. Shift and click: cursor B. Home: show all."),
              .name = QT_TR_NOOP("Show all"),
              .icon = "fit",
              .id = "traceAll"});
  QPushButton* m_list = button({.tip = QT_TR_NOOP("Stops, signals and cursors beside the curves"),
                                .name = QT_TR_NOOP("List"),
                                .icon = "list",
                                .id = "traceList"});
  QPushButton* m_layout = button({.tip = QT_TR_NOOP("Arrangements of panes that are kept by name"),
                                  .name = QT_TR_NOOP("Panes"),
                                  .icon = "panes",
                                  .id = "traceLayout"});
  QPointer<ColumnsDialog> m_columns;  ///< in which a table's columns are being named
  LayoutMenu* m_layoutMenu;
  QPushButton* m_save = button(
      {.tip = QT_TR_NOOP(
           "Save what the panes show: the samples as a table (CSV), or a picture (PNG, SVG, PDF)"),
       .name = QT_TR_NOOP("Save…"),
       .icon = "save",
       .id = "traceSave"},
      &TracePage::chooseFileToSave);
  LegendStrip* m_legend;
  FoldingTabs* m_panel;
  SignalPanel* m_signals;
  CursorPanel* m_cursorPanel;
  PathPanel* m_pathPanel;
  ComparePanel* m_comparePanel;
  SpectrumPanel* m_spectrumPanel;
  TriggerPanel* m_triggerPanel;
  QTableView* m_table;
  std::array<QLabel*, 3> m_summaryValues{};
};

}  // namespace rivulet::widgets
