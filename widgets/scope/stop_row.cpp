// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/stop_row.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

struct PauseTexts {
  Q_DECLARE_TR_FUNCTIONS(PauseTexts)

 public:
  static QString letter(trace::PauseOrigin origin) {
    switch (origin) {
      case trace::PauseOrigin::Measured:
        return tr("M", "letter for a measured pause");
      case trace::PauseOrigin::Inferred:
        return tr("I", "letter for an inferred pause");
      case trace::PauseOrigin::Predicted:
        return tr("P", "letter for a predicted pause");
    }
    return {};
  }

  static QString text(trace::PauseOrigin origin) {
    switch (origin) {
      case trace::PauseOrigin::Measured:
        return tr("measured");
      case trace::PauseOrigin::Inferred:
        return tr("inferred");
      case trace::PauseOrigin::Predicted:
        return tr("predicted");
    }
    return {};
  }
};

}  // namespace

QString pauseOriginLetter(trace::PauseOrigin origin) {
  return PauseTexts::letter(origin);
}

QString pauseOriginText(trace::PauseOrigin origin) {
  return PauseTexts::text(origin);
}

StopRow stopRow(const trace::Pause& pause) {
  StopRow row{pause.start, pause.duration, pause.origin};
  row.fromAxis = base::toSeconds(pause.start);
  row.toAxis = base::toSeconds(pause.start + pause.duration);
  return row;
}

StopRow stopRow(const trace::Standstill& stop) {
  return {stop.start,
          stop.duration,
          trace::PauseOrigin::Measured,
          stop.cause,
          stop.line,
          stop.evidence,
          base::toSeconds(stop.start),
          base::toSeconds(stop.start + stop.duration)};
}

QBrush pauseBrush(trace::PauseOrigin origin, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  switch (origin) {
    case trace::PauseOrigin::Measured:
      return QBrush(colors.pauseFill);
    case trace::PauseOrigin::Inferred:
      return QBrush(colors.mutedText, Qt::BDiagPattern);
    case trace::PauseOrigin::Predicted:
      return QBrush(colors.mutedText, Qt::Dense6Pattern);
  }
  return {};
}

void paintStopBands(QPainter& painter, const TimeArea& area, const std::vector<StopRow>& stops,
                    bool labels, const QPalette& palette) {
  if (stops.empty() || !(area.toS > area.fromS)) {
    return;
  }
  const double pixelsPerS = area.rect.width() / (area.toS - area.fromS);
  // Pauses are in time order and do not overlap: the visible ones are one range of the list.
  const auto first =
      std::lower_bound(stops.begin(), stops.end(), area.fromS,
                       [](const StopRow& pause, double from) { return pause.toAxis < from; });
  const QFontMetricsF metrics(painter.font());
  const double lineHeight = metrics.height();
  painter.setClipRect(area.rect);
  // Either all visible bands are labelled or none: labels on some of them would look like a
  // selection. Zooming in makes room; the table next to the plots always has every duration.
  bool hasRoom = true;
  for (auto pause = first; pause != stops.end(); ++pause) {
    const double left = area.xOf(pause->fromAxis);
    if (left > area.rect.right()) {
      break;
    }
    const bool isCrowded =
        pause != first && left - area.xOf((pause - 1)->fromAxis) < lineHeight + 2.0;
    hasRoom = hasRoom && !isCrowded;
  }
  double lastBandRight = area.rect.left() - 1.0;
  double lastLabelRight = area.rect.left() - 1.0;
  for (auto pause = first; pause != stops.end(); ++pause) {
    const double left = area.xOf(pause->fromAxis);
    if (left > area.rect.right()) {
      break;
    }
    const double width = std::max((pause->toAxis - pause->fromAxis) * pixelsPerS, 1.5);
    if (left + width <= lastBandRight) {
      continue;  // hidden behind the one before at this zoom
    }
    lastBandRight = left + width;
    painter.fillRect(QRectF(left, area.rect.top(), width, area.rect.height()),
                     pauseBrush(pause->origin, palette));
    if (!labels || !hasRoom) {
      continue;
    }
    const QString label =
        millisecondsText(pause->duration, 0) + QLatin1Char(' ') + pauseOriginLetter(pause->origin);
    const double middle = left + width / 2.0;
    const double textWidth = metrics.horizontalAdvance(label);
    painter.setPen(themeColors(palette).text);
    if (width >= textWidth + 6.0 && middle - textWidth / 2.0 > lastLabelRight) {
      painter.drawText(QPointF(middle - textWidth / 2.0, area.rect.center().y()), label);
      lastLabelRight = middle + textWidth / 2.0 + 4.0;
    } else if (left - lineHeight - 1.0 > lastLabelRight - lineHeight &&
               left - lineHeight > area.rect.left()) {
      // Upright beside its band: narrow bands stand close together.
      painter.save();
      // At half height, where there is neither the line of full feed nor that of standstill.
      painter.translate(left - 3.0, area.rect.center().y() + textWidth / 2.0);
      painter.rotate(-90.0);
      painter.drawText(QPointF(0.0, 0.0), label);
      painter.restore();
      lastLabelRight = left + lineHeight;
    }
  }
}

}  // namespace rivulet::widgets
