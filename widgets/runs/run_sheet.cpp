// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/runs/run_sheet.h"

#include <QCoreApplication>
#include <QLocale>

#include "base/units.h"
#include "templates/cells.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/live/live_text.h"
#include "widgets/runs/run_texts.h"
#include "widgets/streaming/report_panel.h"

namespace rivulet::widgets {

namespace {

using paper::Table;

struct SheetTexts {
  Q_DECLARE_TR_FUNCTIONS(SheetTexts)

 public:
  static QString title() { return tr("Report of a run"); }
  static QString run() { return tr("Run"); }
  static QString settings() { return tr("Settings"); }
  static QString result() { return tr("Result"); }
  static QString pauses() { return tr("Pauses and access"); }
  static QString path() { return tr("Path, seen from above; rapids dashed"); }
  static QString noPath() { return tr("The path was not kept."); }
  static QString signature() { return tr("Date, name, signature"); }
  static QString footer(const RunSheet& sheet) {
    return tr("Rivulet %1; run made with version %2")
        .arg(sheet.appVersion, QString::fromStdString(sheet.summary.toolVersion));
  }

  static QList<paper::Fact> runLines(const RunSheet& sheet) {
    const streaming::RunSummary& run = sheet.summary;
    const QString program = orNone(run.programName);
    return {
        {tr("Program"), run.dryRunMm > 0.0
                            ? tr("%1, dry run %2 higher").arg(program, lengthText(run.dryRunMm, 1))
                            : program},
        {tr("Version (hash)"), orNone(run.programHash)},
        {tr("Machine"), machineText(run)},
        {tr("Start"), startText(run)},
        {tr("Started by"), originText(run.origin)},
        {tr("Run number"), run.runNumber == 0 ? noValue() : QString::number(run.runNumber)}};
  }
  static QList<paper::Fact> settingLines(const RunSheet& sheet) {
    const streaming::RunSettings& settings = sheet.report.settings;
    const templates::TemplateParameters& parameters = settings.parameters;
    QList<paper::Fact> facts{
        {tr("Method"), methodText(parameters.method)},
        {QStringLiteral("N"), QString::number(parameters.pointsPerLoop)},
        {tr("Feed"), feedsText(sheet.summary)},
        {tr("Axes"), QString::fromStdString(templates::axisLetters(parameters))},
        {tr("Access"), groupingText(settings.grouping)}};
    if (base::hasWindows(parameters.method)) {
      facts.insert(2, {tr("Windows"), QString::number(parameters.windows)});
    } else {
      facts.insert(2, {QStringLiteral("δ"), lengthText(settings.deltaMm)});
    }
    return facts;
  }
  static QList<paper::Fact> resultLines(const RunSheet& sheet) {
    const streaming::RunSummary& run = sheet.summary;
    const auto judged = [&run](std::size_t count) {
      return run.judged ? countText(count) : tr("not judged");
    };
    QList<paper::Fact> lines{
        {tr("Executed"), tr("%1 of %2").arg(countText(run.executed), countText(run.total))},
        {tr("Repeated"), judged(run.repeated)},
        {tr("Skipped"), judged(run.skipped)},
        {tr("Off the program"), judged(run.foreign)},
        {tr("Out of order"), judged(run.outOfOrder)},
        {tr("Duration"), durationText(base::toSeconds(run.duration))}};
    if (const auto& job = run.jobTimes) {
      lines.append({{tr("Streamed"), durationText(base::toSeconds(job->streamed + job->pauses))},
                    {tr("Tool changes"), durationText(base::toSeconds(job->toolChange))},
                    {tr("Other blocks of the control"), durationText(base::toSeconds(job->native))},
                    {tr("Changes between both"), durationText(base::toSeconds(job->handover))}});
    }
    if (const auto& live = sheet.report.live) {
      lines.append({{tr("Live lines"), linesText(*live)},
                    {tr("Delay from arrival to motion"), delayText(*live)}});
    }
    return lines;
  }
  static Table tools(const RunSheet& sheet) {
    Table table{tr("Tools"),
                {tr("Tool"), tr("In the spindle"), tr("Change"), tr("Speed, 1/min"), tr("Turning"),
                 tr("Coolant")},
                {3.0, 2.0, 1.5, 2.0, 1.5, 1.5},
                {}};
    const auto time = [](base::Duration duration) {
      return duration > base::Duration{} ? durationText(base::toSeconds(duration)) : noValue();
    };
    for (const trace::ToolUse& use : sheet.summary.tools) {
      const QString perMin = perMinText(use);
      table.rows.append({toolText(use), time(use.inSpindle), time(use.change),
                         perMin.isEmpty() ? noValue() : perMin, time(use.turning),
                         time(use.cooling)});
    }
    return table;
  }
  static QList<paper::Fact> pauseLines(const RunSheet& sheet) {
    const streaming::RunSummary& run = sheet.summary;
    const trace::DurationStatistics& access = sheet.report.access.perNode;
    const double pausedS = base::toSeconds(run.paused);
    const double durationS = base::toSeconds(run.duration);
    return {{tr("Pauses"), countText(run.pauses)},
            {tr("Pauses in all"), durationText(pausedS)},
            {tr("Share of the duration"),
             durationS > 0.0 ? numberText(100.0 * pausedS / durationS, 1) + QStringLiteral(" %")
                             : noValue()},
            {tr("Requests"), countText(sheet.report.access.requests)},
            {tr("Access, median"), access.count == 0 ? noValue() : millisecondsText(access.p50, 2)},
            {tr("Access, 99th percentile"),
             access.count == 0 ? noValue() : millisecondsText(access.p99, 2)}};
  }

 private:
  static QString orNone(const std::string& text) {
    return text.empty() ? noValue() : QString::fromStdString(text);
  }
};

/// Rapids dashed, each stretch of one kind a line.
paper::Picture pathPicture(const std::vector<gcode::SketchPoint>& sketch) {
  paper::Picture picture;
  picture.caption = SheetTexts::path();
  picture.note = SheetTexts::noPath();
  picture.isMap = true;
  const auto place = [](const gcode::SketchPoint& point) {
    return QPointF(point.positionMm.x, point.positionMm.y);
  };
  for (std::size_t i = 1; i < sketch.size(); ++i) {
    if (i == 1 || sketch[i].isRapid != sketch[i - 1].isRapid) {
      const bool isRapid = sketch[i].isRapid;
      picture.lines.push_back({QPolygonF{place(sketch[i - 1])},
                               isRapid ? QColor(Qt::gray) : QColor(Qt::black), isRapid ? 0.15 : 0.2,
                               isRapid});
    }
    picture.lines.back().points.append(place(sketch[i]));
  }
  return picture;
}

paper::Rating ratingOf(const streaming::RunSummary& run) {
  if (run.outcome == streaming::Outcome::Failed || run.finding == streaming::RunFinding::Faulty) {
    return paper::Rating::Bad;
  }
  return run.finding == streaming::RunFinding::Faultless ? paper::Rating::Good
                                                         : paper::Rating::Unknown;
}

}  // namespace

paper::Page runPage(const RunSheet& sheet) {
  paper::Page page;
  page.language = QLocale().bcp47Name();
  page.title = SheetTexts::title();
  page.result = resultText(sheet.summary.outcome, sheet.summary.finding);
  page.rating = ratingOf(sheet.summary);
  if (sheet.report.error.code) {
    page.sentences = {errorText(sheet.report.error)};
  }
  page.groups = {{SheetTexts::run(), SheetTexts::runLines(sheet)},
                 {SheetTexts::settings(), SheetTexts::settingLines(sheet)},
                 {SheetTexts::result(), SheetTexts::resultLines(sheet)},
                 {SheetTexts::pauses(), SheetTexts::pauseLines(sheet)}};
  page.pictures = {pathPicture(sheet.sketch)};
  if (!sheet.summary.tools.empty()) {
    page.table = SheetTexts::tools(sheet);
  }
  page.signature = SheetTexts::signature();
  page.footer = {SheetTexts::footer(sheet)};
  return page;
}

}  // namespace rivulet::widgets
