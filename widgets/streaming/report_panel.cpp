// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/report_panel.h"

#include <QCoreApplication>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>

#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/live/live_text.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::widgets {

namespace {

struct GroupingTexts {
  Q_DECLARE_TR_FUNCTIONS(GroupingTexts)

 public:
  static QString text(opcua::Grouping grouping) {
    switch (grouping) {
      case opcua::Grouping::List:
        return tr("Lists");
      case opcua::Grouping::Single:
        return tr("One by one");
      case opcua::Grouping::ArrayCount:
        return tr("Arrays by count");
      case opcua::Grouping::ArrayRange:
        return tr("Arrays by range");
    }
    return {};
  }
};

}  // namespace

QString groupingText(opcua::Grouping grouping) {
  return GroupingTexts::text(grouping);
}

Status ReportPanel::resultStatus(streaming::Outcome outcome, streaming::RunFinding finding) {
  if (outcome == streaming::Outcome::Failed || finding == streaming::RunFinding::Faulty) {
    return Status::Fault;
  }
  return finding == streaming::RunFinding::Faultless ? Status::Good : Status::Unknown;
}

ReportPanel::ReportPanel(QWidget* parent) : Page(parent) {
  m_outcome->setEmphasis(16.0, true);
  constexpr std::array<const char*, RowCount> kNames{QT_TR_NOOP("Program"),
                                                     QT_TR_NOOP("Method"),
                                                     QT_TR_NOOP("Feed"),
                                                     "δ",
                                                     QT_TR_NOOP("Duration"),
                                                     QT_TR_NOOP("Time spent"),
                                                     QT_TR_NOOP("Tools"),
                                                     QT_TR_NOOP("Live lines"),
                                                     QT_TR_NOOP("Delay from arrival to motion"),
                                                     QT_TR_NOOP("Executed"),
                                                     QT_TR_NOOP("Repeated"),
                                                     QT_TR_NOOP("Skipped"),
                                                     QT_TR_NOOP("Off the program"),
                                                     QT_TR_NOOP("Number"),
                                                     QT_TR_NOOP("Mean"),
                                                     QT_TR_NOOP("Total"),
                                                     QT_TR_NOOP("Form"),
                                                     QT_TR_NOOP("Requests"),
                                                     QT_TR_NOOP("Mean"),
                                                     QT_TR_NOOP("Median"),
                                                     QT_TR_NOOP("95th percentile"),
                                                     QT_TR_NOOP("99th percentile"),
                                                     QT_TR_NOOP("Largest"),
                                                     QT_TR_NOOP("Stop confirmed")};
  for (const char* name : kNames) {
    m_names.push_back(label({.text = name, .isMuted = true}));
    m_values.push_back(status({.wraps = true}));
  }
  const auto fill = [this](QGroupBox* group, int first, int last) {
    auto* form = new QFormLayout(group);
    form->setLabelAlignment(Qt::AlignLeft);
    form->setHorizontalSpacing(16);
    for (int row = first; row <= last; ++row) {
      form->addRow(m_names[static_cast<std::size_t>(row)], m_values[static_cast<std::size_t>(row)]);
    }
  };
  fill(m_runGroup, Program, LiveDelay);
  fill(m_integrityGroup, Executed, Foreign);
  fill(m_pausesGroup, PauseCount, PauseTotal);
  fill(m_accessGroup, AccessForm, AccessMax);
  static_cast<QFormLayout*>(m_runGroup->layout())
      ->addRow(m_names[StopConfirmed], m_values[StopConfirmed]);

  auto* groups = new QGridLayout;
  groups->addWidget(m_runGroup, 0, 0);
  groups->addWidget(m_integrityGroup, 0, 1);
  groups->addWidget(m_pausesGroup, 1, 0);
  groups->addWidget(m_accessGroup, 1, 1);
  groups->setColumnStretch(0, 1);
  groups->setColumnStretch(1, 1);
  inColumn({m_outcome, m_detail, groups, spring()}, this);
  onLanguage(&ReportPanel::showReport);
}

void ReportPanel::setReport(const std::optional<streaming::RunReport>& report,
                            const std::optional<streaming::JobTimes>& jobTimes,
                            const std::vector<trace::ToolUse>& tools) {
  m_report = report;
  m_jobTimes = jobTimes;
  m_tools = tools;
  showReport();
}

void ReportPanel::showReport() {
  for (QGroupBox* group : {m_runGroup, m_integrityGroup, m_pausesGroup, m_accessGroup}) {
    group->setVisible(m_report.has_value());
  }
  m_detail->setVisible(false);
  if (!m_report) {
    m_outcome->setStatus(Status::Unknown, tr("No run yet"));
    return;
  }
  showOutcome(*m_report);
  showRun(*m_report);
  showIntegrity(*m_report);
  showPauses(*m_report);
  showAccess(*m_report);
}

void ReportPanel::show(Row row, const QString& text, Status status) {
  m_values[static_cast<std::size_t>(row)]->setStatus(status, text);
}

void ReportPanel::showOutcome(const streaming::RunReport& report) {
  m_outcome->setStatus(resultStatus(report.outcome, report.finding()),
                       resultText(report.outcome, report.finding()));
  if (report.outcome == streaming::Outcome::Failed) {
    m_detail->setText(errorText(report.error));
    m_detail->setVisible(!m_detail->text().isEmpty());
  }
}

void ReportPanel::showRun(const streaming::RunReport& report) {
  show(Program,
       report.programName.empty() ? noValue() : QString::fromStdString(report.programName));
  const bool position = base::usesDelta(report.settings.parameters.method);
  show(Method, QStringLiteral("%1, N = %2")
                   .arg(methodText(report.settings.parameters.method),
                        QString::number(report.settings.parameters.pointsPerLoop)));
  show(Feed, feedsText(report.settings));
  show(Delta, position ? lengthText(report.settings.deltaMm) : noValue());
  show(Duration, secondsText(base::toSeconds(report.duration), 2));
  static_cast<QFormLayout*>(m_runGroup->layout())
      ->setRowVisible(m_names[TimeSpent], m_jobTimes.has_value());
  show(TimeSpent, m_jobTimes ? jobTimesText(*m_jobTimes) : QString());
  static_cast<QFormLayout*>(m_runGroup->layout())->setRowVisible(m_names[Tools], !m_tools.empty());
  QStringList tools;
  for (const trace::ToolUse& use : m_tools) {
    tools.append(toolUseText(use));
  }
  show(Tools, tools.join(QLatin1Char('\n')));
  for (const Row row : {LiveLines, LiveDelay}) {
    static_cast<QFormLayout*>(m_runGroup->layout())
        ->setRowVisible(m_names[static_cast<std::size_t>(row)], report.live.has_value());
  }
  show(LiveLines, report.live ? linesText(*report.live) : QString());
  show(LiveDelay, report.live ? delayText(*report.live) : QString());
}

void ReportPanel::showIntegrity(const streaming::RunReport& report) {
  const trace::Integrity& integrity = report.integrity;
  if (integrity.judged) {
    const auto fault = [](std::size_t count) { return count > 0 ? Status::Fault : Status::Good; };
    const QString executed =
        tr("%1 of %2").arg(countText(integrity.executed), countText(report.counters.total));
    show(
        Executed,
        report.settings.resume
            ? tr("%1, from point %2 on").arg(executed, countText(report.settings.resume->point + 1))
            : executed);
    show(Repeated, countText(integrity.repeated), fault(integrity.repeated));
    show(Skipped, countText(integrity.skipped), fault(integrity.skipped));
    show(Foreign, countText(integrity.foreign), fault(integrity.foreign));
  } else {
    const QString text = report.controlTrace
                             ? tr("%1 of %2 (not judged: longer than the trace of the control)")
                             : tr("%1 of %2 (not judged: no trace of the control)");
    show(Executed, text.arg(countText(report.counters.executed), countText(report.counters.total)),
         Status::Unknown);
    for (const Row row : {Repeated, Skipped, Foreign}) {
      show(row, tr("not judged"), Status::Unknown);
    }
  }
}

void ReportPanel::showPauses(const streaming::RunReport& report) {
  base::Duration total{};
  for (const trace::Pause& pause : report.pauses) {
    total += pause.duration;
  }
  show(PauseCount, countText(report.pauses.size()));
  show(PauseMean, report.pauses.empty()
                      ? noValue()
                      : millisecondsText(base::toMilliseconds(total) /
                                         static_cast<double>(report.pauses.size())));
  show(PauseTotal, secondsText(base::toSeconds(total), 2));
}

void ReportPanel::showAccess(const streaming::RunReport& report) {
  const QString form = groupingText(report.settings.grouping);
  show(AccessForm, report.accessForms ? tr("%1 (proved)").arg(form) : form);
  const streaming::AccessStatistics& access = report.access;
  show(Requests, countText(access.requests));
  const trace::DurationStatistics& perNode = access.perNode;
  const auto time = [&perNode](base::Duration duration) {
    return perNode.count == 0 ? noValue() : millisecondsText(duration, 2);
  };
  show(AccessMean, time(perNode.mean));
  show(AccessP50, time(perNode.p50));
  show(AccessP95, time(perNode.p95));
  show(AccessP99, time(perNode.p99));
  show(AccessMax, time(perNode.max));
  if (report.stopConfirmedAfter) {
    show(StopConfirmed,
         tr("after %1").arg(secondsText(base::toSeconds(*report.stopConfirmedAfter), 2)));
  } else if (report.outcome == streaming::Outcome::Stopped) {
    show(StopConfirmed, tr("NOT confirmed: check the machine"), Status::Fault);
  } else {
    show(StopConfirmed, noValue());
  }
}

}  // namespace rivulet::widgets
