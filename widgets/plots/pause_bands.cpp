// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/pause_bands.h"

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

PauseBands::PauseBands(QGraphicsItem* parent) : QGraphicsItem(parent) {
}

void PauseBands::setPauses(const std::vector<trace::Pause>* pauses, bool labels) {
  m_pauses = pauses;
  m_labels = labels;
  update();
}

void PauseBands::setPalette(const QPalette& palette) {
  m_palette = palette;
  update();
}

void PauseBands::setArea(const QRectF& area, double fromS, double toS) {
  if (area != m_area) {
    prepareGeometryChange();
    m_area = area;
  }
  m_fromS = fromS;
  m_toS = toS;
  update();
}

void PauseBands::paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/,
                       QWidget* /*widget*/) {
  if (m_pauses == nullptr || m_pauses->empty() || !(m_toS > m_fromS)) {
    return;
  }
  const double pixelsPerS = m_area.width() / (m_toS - m_fromS);
  const auto xOf = [&](double seconds) { return m_area.left() + (seconds - m_fromS) * pixelsPerS; };
  // Pauses are in time order and do not overlap: the visible ones are one range of the list.
  const auto first = std::lower_bound(
      m_pauses->begin(), m_pauses->end(), m_fromS, [](const trace::Pause& pause, double fromS) {
        return base::toSeconds(pause.start + pause.duration) < fromS;
      });
  const QFontMetricsF metrics(painter->font());
  const double lineHeight = metrics.height();
  painter->setClipRect(m_area);
  // Either all visible bands are labelled or none: labels on some of them would look like a
  // selection. Zooming in makes room; the table next to the plots always has every duration.
  bool hasRoom = true;
  for (auto pause = first; pause != m_pauses->end(); ++pause) {
    const double left = xOf(base::toSeconds(pause->start));
    if (left > m_area.right()) {
      break;
    }
    const bool isCrowded =
        pause != first && left - xOf(base::toSeconds((pause - 1)->start)) < lineHeight + 2.0;
    hasRoom = hasRoom && !isCrowded;
  }
  double lastBandRight = m_area.left() - 1.0;
  double lastLabelRight = m_area.left() - 1.0;
  for (auto pause = first; pause != m_pauses->end(); ++pause) {
    const double left = xOf(base::toSeconds(pause->start));
    if (left > m_area.right()) {
      break;
    }
    const double width = std::max(base::toSeconds(pause->duration) * pixelsPerS, 1.5);
    if (left + width <= lastBandRight) {
      continue;  // hidden behind the one before at this zoom
    }
    lastBandRight = left + width;
    painter->fillRect(QRectF(left, m_area.top(), width, m_area.height()),
                      pauseBrush(pause->origin, m_palette));
    if (!m_labels || !hasRoom) {
      continue;
    }
    const QString label =
        millisecondsText(pause->duration, 0) + QLatin1Char(' ') + pauseOriginLetter(pause->origin);
    const double middle = left + width / 2.0;
    const double textWidth = metrics.horizontalAdvance(label);
    painter->setPen(themeColors(m_palette).text);
    if (width >= textWidth + 6.0 && middle - textWidth / 2.0 > lastLabelRight) {
      painter->drawText(QPointF(middle - textWidth / 2.0, m_area.center().y()), label);
      lastLabelRight = middle + textWidth / 2.0 + 4.0;
    } else if (left - lineHeight - 1.0 > lastLabelRight - lineHeight &&
               left - lineHeight > m_area.left()) {
      // Upright beside its band: narrow bands stand close together.
      painter->save();
      // At half height, where there is neither the line of full feed nor that of standstill.
      painter->translate(left - 3.0, m_area.center().y() + textWidth / 2.0);
      painter->rotate(-90.0);
      painter->drawText(QPointF(0.0, 0.0), label);
      painter->restore();
      lastLabelRight = left + lineHeight;
    }
  }
}

}  // namespace rivulet::widgets
