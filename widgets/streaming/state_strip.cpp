// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/state_strip.h"

#include <QCoreApplication>
#include <QPainter>
#include <array>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

struct RunStateTexts {
  Q_DECLARE_TR_FUNCTIONS(RunStateTexts)

 public:
  static QString text(streaming::RunState state) {
    using streaming::RunState;
    switch (state) {
      case RunState::Idle:
        return tr("Idle");
      case RunState::Armed:
        return tr("Armed");
      case RunState::Running:
        return tr("Running");
      case RunState::Holding:
        return tr("Holding");
      case RunState::Stopping:
        return tr("Stopping");
      case RunState::Done:
        return tr("Done");
      case RunState::Aborted:
        return tr("Aborted");
    }
    return {};
  }
};

constexpr int kStepCount = 5;  // Done and Aborted share the last step
constexpr int kHeightPx = 40;
constexpr double kTipPx = 10.0;

int stepOf(streaming::RunState state) {
  switch (state) {
    case streaming::RunState::Aborted:
      return kStepCount - 1;
    case streaming::RunState::Holding:  // a way of running
      return static_cast<int>(streaming::RunState::Running);
    default:
      return static_cast<int>(state);
  }
}

}  // namespace

QString runStateText(streaming::RunState state) {
  return RunStateTexts::text(state);
}

StateStrip::StateStrip(QWidget* parent) : Page(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  retranslate();
}

void StateStrip::setState(streaming::RunState state) {
  if (state != m_state) {
    m_state = state;
    retranslate();
  }
}

QSize StateStrip::sizeHint() const {
  return {480, kHeightPx};
}

QSize StateStrip::minimumSizeHint() const {
  return {310, kHeightPx};
}

void StateStrip::retranslate() {
  setAccessibleName(runStateText(m_state));
  setToolTip(runStateText(m_state));
  update();
}

void StateStrip::restyle() {
  update();
}

void StateStrip::paintEvent(QPaintEvent* /*event*/) {
  using streaming::RunState;
  const ThemeColors& colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int current = stepOf(m_state);
  // The present step is as wide as its mark and text need, the others share the rest.
  QFont bold = font();
  bold.setBold(true);
  const QFontMetrics boldMetrics(bold);
  std::array<QString, kStepCount> texts;
  std::array<double, kStepCount> widths{};
  double total = 0.0;
  for (int step = 0; step < kStepCount; ++step) {
    const auto index = static_cast<std::size_t>(step);
    texts[index] = runStateText(step == current ? m_state : static_cast<RunState>(step));
    widths[index] = boldMetrics.horizontalAdvance(texts[index]) + (step == current ? 24.0 : 0.0);
    total += widths[index];
  }
  const double spare = (width() - kTipPx - 2.0 - total) / kStepCount;
  double left = 1.0;
  for (int step = 0; step < kStepCount; ++step) {
    const auto index = static_cast<std::size_t>(step);
    const double right = left + widths[index] + spare;
    const double top = 1.0;
    const double bottom = height() - 1.0;
    const double middle = height() / 2.0;
    QPolygonF arrow;
    arrow << QPointF(left, top) << QPointF(right, top) << QPointF(right + kTipPx, middle)
          << QPointF(right, bottom) << QPointF(left, bottom);
    if (step > 0) {
      arrow << QPointF(left + kTipPx, middle);
    }
    const bool isCurrent = step == current;
    const bool isFault = isCurrent && m_state == RunState::Aborted;
    const QColor fill = isFault ? colors.fault : (isCurrent ? colors.accent : colors.button);
    painter.setPen(QPen(isCurrent ? fill : colors.line, 1.0));
    painter.setBrush(fill);
    painter.drawPolygon(arrow);
    const QColor textColor =
        isCurrent ? (colors.isDark ? QColor(Qt::black) : QColor(Qt::white)) : colors.mutedText;
    QRectF box(left + (step > 0 ? kTipPx : 0.0), top,
               right - left - (step > 0 ? kTipPx : 0.0) + 4.0, bottom - top);
    painter.setFont(isCurrent ? bold : font());
    painter.setPen(textColor);
    if (isCurrent) {
      const QString mark = isFault ? QStringLiteral("dismiss")
                                   : (m_state == RunState::Done ? QStringLiteral("apply")
                                                                : QStringLiteral("current"));
      constexpr int kMarkPx = 14;
      const double textWidth = boldMetrics.horizontalAdvance(texts[index]);
      const double markLeft = box.center().x() - (textWidth + kMarkPx + 5.0) / 2.0;
      painter.drawPixmap(QPointF(markLeft, middle - kMarkPx / 2.0),
                         iconPixmap(mark, textColor, kMarkPx, devicePixelRatioF()));
      painter.drawText(QRectF(markLeft + kMarkPx + 5.0, top, textWidth + 4.0, bottom - top),
                       Qt::AlignLeft | Qt::AlignVCenter, texts[index]);
    } else {
      painter.drawText(box, Qt::AlignCenter, texts[index]);
    }
    left = right;
  }
}

}  // namespace rivulet::widgets
