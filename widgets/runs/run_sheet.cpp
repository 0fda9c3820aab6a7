// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/runs/run_sheet.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QSaveFile>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "templates/cells.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/runs/run_texts.h"
#include "widgets/streaming/report_panel.h"

namespace rivulet::widgets {

namespace {

constexpr double kTitlePt = 16.0;
constexpr double kTextPt = 9.0;
constexpr double kLineMm = 4.8;
constexpr double kPathMm = 85.0;
constexpr double kMarginMm = 18.0;

struct Line {
  QString name;
  QString value;
};

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

  static QList<Line> runLines(const RunSheet& sheet) {
    const streaming::RunSummary& run = sheet.summary;
    return {{tr("Program"), orNone(run.programName)},
            {tr("Version (hash)"), orNone(run.programHash)},
            {tr("Machine"), machineText(run)},
            {tr("Start"), startText(run)},
            {tr("Started by"), originText(run.origin)},
            {tr("Run number"), run.runNumber == 0 ? noValue() : QString::number(run.runNumber)}};
  }
  static QList<Line> settingLines(const RunSheet& sheet) {
    const streaming::RunSettings& settings = sheet.report.settings;
    const templates::TemplateParameters& parameters = settings.parameters;
    QList<Line> lines{{tr("Method"), ReportPanel::methodText(parameters.method)},
                      {QStringLiteral("N"), QString::number(parameters.pointsPerLoop)},
                      {tr("Feed"), feedsText(sheet.summary)},
                      {tr("Axes"), QString::fromStdString(templates::axisLetters(parameters))},
                      {tr("Access"), groupingText(settings.grouping)}};
    if (base::hasWindows(parameters.method)) {
      lines.insert(2, {tr("Windows"), QString::number(parameters.windows)});
    } else {
      lines.insert(2, {QStringLiteral("δ"), lengthText(settings.deltaMm)});
    }
    return lines;
  }
  static QList<Line> resultLines(const RunSheet& sheet) {
    const streaming::RunSummary& run = sheet.summary;
    const auto judged = [&run](std::size_t count) {
      return run.judged ? countText(count) : tr("not judged");
    };
    QList<Line> lines{
        {tr("Executed"), tr("%1 of %2").arg(countText(run.executed), countText(run.total))},
        {tr("Repeated"), judged(run.repeated)},
        {tr("Skipped"), judged(run.skipped)},
        {tr("Foreign motion"), judged(run.foreign)},
        {tr("Out of order"), judged(run.outOfOrder)},
        {tr("Duration"), durationText(base::toSeconds(run.duration))}};
    if (const auto& job = run.jobTimes) {
      lines.append({{tr("Streamed"), durationText(base::toSeconds(job->streamed + job->pauses))},
                    {tr("Tool changes"), durationText(base::toSeconds(job->toolChange))},
                    {tr("Other blocks of the control"), durationText(base::toSeconds(job->native))},
                    {tr("Changes between both"), durationText(base::toSeconds(job->handover))}});
    }
    return lines;
  }
  static QList<Line> pauseLines(const RunSheet& sheet) {
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

/// Draws from the top of a page to its end.
class Sheet {
 public:
  Sheet(QPainter& painter, const QRectF& page, double millimetre)
      : m_painter(painter), m_page(page), m_mm(millimetre), m_y(page.top()) {}

  void heading(const QString& text, double sizePt) {
    font(sizePt, true);
    const double height = sizePt * 0.55 * m_mm;
    m_painter.drawText(QRectF(m_page.left(), m_y, m_page.width(), height),
                       Qt::AlignLeft | Qt::AlignVCenter, text);
    m_y += height + m_mm;
  }
  void paragraph(const QString& text) {
    font(kTextPt, false);
    const QRectF room(m_page.left(), m_y, m_page.width(), m_page.height());
    QRectF drawn;
    m_painter.drawText(room, Qt::AlignLeft | Qt::TextWordWrap, text, &drawn);
    m_y += drawn.height() + m_mm;
  }
  void rule() {
    m_painter.setPen(QPen(Qt::gray, 0.2 * m_mm));
    m_painter.drawLine(QPointF(m_page.left(), m_y), QPointF(m_page.right(), m_y));
    m_painter.setPen(Qt::black);
    m_y += 2.0 * m_mm;
  }
  /// Two groups side by side.
  void groups(const QString& left, const QList<Line>& leftLines, const QString& right,
              const QList<Line>& rightLines) {
    const double top = m_y;
    const double width = (m_page.width() - 6.0 * m_mm) / 2.0;
    group(m_page.left(), width, left, leftLines);
    const double bottom = m_y;
    m_y = top;
    group(m_page.left() + width + 6.0 * m_mm, width, right, rightLines);
    m_y = std::max(m_y, bottom) + 2.0 * m_mm;
  }
  void path(const std::vector<gcode::SketchPoint>& sketch) {
    const QRectF frame(m_page.left(), m_y, m_page.width(), kPathMm * m_mm);
    m_painter.setPen(QPen(Qt::lightGray, 0.2 * m_mm));
    m_painter.drawRect(frame);
    m_painter.setPen(Qt::black);
    if (sketch.size() < 2) {
      font(kTextPt, false);
      m_painter.drawText(frame, Qt::AlignCenter, SheetTexts::noPath());
    } else {
      drawPath(frame.adjusted(3.0 * m_mm, 3.0 * m_mm, -3.0 * m_mm, -3.0 * m_mm), sketch);
    }
    m_y += frame.height() + 2.0 * m_mm;
  }
  void signature() {
    const double y = m_page.bottom() - 10.0 * m_mm;
    m_painter.drawLine(QPointF(m_page.left(), y), QPointF(m_page.left() + 80.0 * m_mm, y));
    font(kTextPt - 1.5, false);
    m_painter.drawText(QPointF(m_page.left(), y + 4.0 * m_mm), SheetTexts::signature());
  }
  void footer(const QString& text) {
    font(kTextPt - 1.5, false);
    m_painter.drawText(
        QRectF(m_page.left(), m_page.bottom() - 4.0 * m_mm, m_page.width(), 4.0 * m_mm),
        Qt::AlignRight | Qt::AlignBottom, text);
  }

 private:
  void font(double sizePt, bool isBold) {
    QFont font = m_painter.font();
    // In the units of the page: the same on paper and in a picture.
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(sizePt * 25.4 / 72.0 * m_mm))));
    font.setBold(isBold);
    m_painter.setFont(font);
  }
  void group(double left, double width, const QString& title, const QList<Line>& lines) {
    font(kTextPt + 1.0, true);
    const double line = kLineMm * m_mm;
    m_painter.drawText(QRectF(left, m_y, width, line), Qt::AlignLeft | Qt::AlignVCenter, title);
    m_y += line + 0.5 * m_mm;
    const double nameWidth = 0.42 * width;
    for (const Line& one : lines) {
      font(kTextPt, false);
      m_painter.setPen(QColor(0x4d, 0x55, 0x5d));
      m_painter.drawText(QRectF(left, m_y, nameWidth, line), Qt::AlignLeft | Qt::AlignVCenter,
                         one.name);
      m_painter.setPen(Qt::black);
      const QString value = QFontMetricsF(m_painter.font(), m_painter.device())
                                .elidedText(one.value, Qt::ElideMiddle, width - nameWidth);
      m_painter.drawText(QRectF(left + nameWidth, m_y, width - nameWidth, line),
                         Qt::AlignLeft | Qt::AlignVCenter, value);
      m_y += line;
    }
  }
  void drawPath(const QRectF& room, const std::vector<gcode::SketchPoint>& sketch) {
    QRectF bounds(sketch.front().positionMm.x, sketch.front().positionMm.y, 0.0, 0.0);
    for (const gcode::SketchPoint& point : sketch) {
      bounds.setLeft(std::min(bounds.left(), point.positionMm.x));
      bounds.setRight(std::max(bounds.right(), point.positionMm.x));
      bounds.setTop(std::min(bounds.top(), point.positionMm.y));
      bounds.setBottom(std::max(bounds.bottom(), point.positionMm.y));
    }
    constexpr double kSmallestMm = 1e-6;
    const double scale = std::min(room.width() / std::max(bounds.width(), kSmallestMm),
                                  room.height() / std::max(bounds.height(), kSmallestMm));
    const QPointF shift = room.center();
    const auto place = [&](const gcode::SketchPoint& point) {
      return shift + QPointF((point.positionMm.x - bounds.center().x()) * scale,
                             (bounds.center().y() - point.positionMm.y) * scale);
    };
    QPainterPath cut;
    QPainterPath rapid;
    for (std::size_t i = 1; i < sketch.size(); ++i) {
      QPainterPath& path = sketch[i].isRapid ? rapid : cut;
      if (i == 1 || sketch[i].isRapid != sketch[i - 1].isRapid) {
        path.moveTo(place(sketch[i - 1]));
      }
      path.lineTo(place(sketch[i]));
    }
    m_painter.setPen(QPen(Qt::gray, 0.15 * m_mm, Qt::DashLine));
    m_painter.drawPath(rapid);
    m_painter.setPen(QPen(Qt::black, 0.2 * m_mm));
    m_painter.drawPath(cut);
  }

  QPainter& m_painter;
  QRectF m_page;
  double m_mm;
  double m_y;
};

}  // namespace

void paintRunSheet(QPainter& painter, const QRectF& page, double millimetre,
                   const RunSheet& sheet) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::black);
  Sheet drawn(painter, page, millimetre);
  drawn.heading(SheetTexts::title(), kTitlePt);
  drawn.heading(ReportPanel::resultText(sheet.summary.outcome, sheet.summary.finding), 12.0);
  if (sheet.report.error.code) {
    drawn.paragraph(errorText(sheet.report.error));
  }
  drawn.rule();
  drawn.groups(SheetTexts::run(), SheetTexts::runLines(sheet), SheetTexts::settings(),
               SheetTexts::settingLines(sheet));
  drawn.groups(SheetTexts::result(), SheetTexts::resultLines(sheet), SheetTexts::pauses(),
               SheetTexts::pauseLines(sheet));
  drawn.rule();
  drawn.paragraph(SheetTexts::path());
  drawn.path(sheet.sketch);
  drawn.signature();
  drawn.footer(SheetTexts::footer(sheet));
}

bool writeRunSheet(const QString& path, const RunSheet& sheet) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) {
    return false;
  }
  {
    QPdfWriter writer(&file);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm),
                          QPageLayout::Millimeter);
    writer.setTitle(QString::fromStdString(sheet.summary.programName));
    constexpr int kDotsPerInch = 600;
    constexpr double kMmPerInch = 25.4;
    writer.setResolution(kDotsPerInch);
    QPainter painter(&writer);
    if (!painter.isActive()) {
      return false;
    }
    paintRunSheet(painter, QRectF(0, 0, writer.width(), writer.height()), kDotsPerInch / kMmPerInch,
                  sheet);
  }
  return file.commit();
}

}  // namespace rivulet::widgets
