// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The result of a run: was the motion right, how long did it take, where were the pauses.
/// @threadsafety GUI thread.
#pragma once

#include <optional>
#include <vector>

#include "streaming/run/job_times.h"
#include "streaming/run/run.h"
#include "trace/analysis/tool_use.h"
#include "widgets/common/page.h"
#include "widgets/common/status_label.h"

class QGroupBox;
class QLabel;

namespace rivulet::widgets {

/// "Lists", "Arrays by count", … in the language of the operator.
[[nodiscard]] QString groupingText(opcua::Grouping grouping);

class ReportPanel final : public Page {
  Q_OBJECT

 public:
  explicit ReportPanel(QWidget* parent = nullptr);

  /// @param report    nothing: no run yet
  /// @param jobTimes  of a whole job @param tools  of a whole job
  void setReport(const std::optional<streaming::RunReport>& report,
                 const std::optional<streaming::JobTimes>& jobTimes = {},
                 const std::vector<trace::ToolUse>& tools = {});

  [[nodiscard]] static Status resultStatus(streaming::Outcome outcome,
                                           streaming::RunFinding finding);

 private:
  enum Row {
    Program,
    Method,
    Feed,
    Delta,
    Duration,
    TimeSpent,
    Tools,
    LiveLines,
    LiveDelay,
    Executed,
    Repeated,
    Skipped,
    Foreign,
    PauseCount,
    PauseMean,
    PauseTotal,
    AccessForm,
    Requests,
    AccessMean,
    AccessP50,
    AccessP95,
    AccessP99,
    AccessMax,
    StopConfirmed,
    RowCount
  };

  void showReport();
  void showOutcome(const streaming::RunReport& report);
  void showRun(const streaming::RunReport& report);
  void showIntegrity(const streaming::RunReport& report);
  void showPauses(const streaming::RunReport& report);
  void showAccess(const streaming::RunReport& report);
  /// Figures carry no icon of their own unless they are abnormal.
  void show(Row row, const QString& text, Status status = Status::Plain);

  std::optional<streaming::RunReport> m_report;
  std::optional<streaming::JobTimes> m_jobTimes;
  std::vector<trace::ToolUse> m_tools;
  StatusLabel* m_outcome = status();
  QLabel* m_detail = value({.wraps = true});
  QGroupBox* m_runGroup = group({.text = QT_TR_NOOP("Run")});
  QGroupBox* m_integrityGroup = group({.text = QT_TR_NOOP("Points")});
  QGroupBox* m_pausesGroup = group({.text = QT_TR_NOOP("Pauses")});
  QGroupBox* m_accessGroup = group({.text = QT_TR_NOOP("Access time per variable")});
  std::vector<QLabel*> m_names;
  std::vector<StatusLabel*> m_values;
};

}  // namespace rivulet::widgets
