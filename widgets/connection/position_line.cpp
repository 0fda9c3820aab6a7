// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/position_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <limits>

#include "base/units.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kFontPtMin = 9.0;
constexpr double kFontPtMax = 40.0;
constexpr int kHeightPxMin = 52;
constexpr int kHeightPxMax = 88;
constexpr int kGapPx = 8;        ///< between a name and its value
constexpr int kGroupGapPx = 12;  ///< on both sides of the line between two readouts
constexpr int kMarginPx = 12;
/// The longest values that are to fit.
const QString kLongestAxis = QStringLiteral("\u22120000.000");
const QString kLongestFeed = QStringLiteral("00000 mm/min");
const QString kLongestFeeds = QStringLiteral("00,000/00,000 mm/min");  ///< actual and commanded

QFont sized(QFont font, double pointSize) {
  font.setPointSizeF(pointSize);
  font.setBold(true);
  return font;
}

}  // namespace

PositionLine::PositionLine(QWidget* parent)
    : Page(parent), m_freshness(new StatusLabel(this, StatusLabel::Elided{2})) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kMarginPx, 0, kMarginPx, 0);
  layout->setSpacing(0);
  layout->setSizeConstraint(QLayout::SetNoConstraint);  // the digits adapt instead
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    Readout& readout = m_readouts[i];
    readout = {nullptr, new QLabel(this), makeValueLabel(this)};
    if (i < kAxisReadouts) {
      readout.name->setText(QString(
          QLatin1Char(i < base::kAxisCount ? base::kAxisNames[i]
                                           : base::kRotaryAxisNames[i - base::kAxisCount])));
    }
    readout.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    readout.group = new QWidget(this);
    auto* pair = new QHBoxLayout(readout.group);
    pair->setContentsMargins(i == 0 ? 0 : kGroupGapPx, 0, kGroupGapPx, 0);
    pair->setSpacing(kGapPx);
    pair->addWidget(readout.name);
    pair->addWidget(readout.value);
    layout->addWidget(readout.group);
  }
  layout->addSpacing(kGroupGapPx);
  layout->addWidget(m_freshness, 1);
  setFixedHeight(kHeightPxMin);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  retranslate();
  restyle();
}

QSize PositionLine::minimumSizeHint() const {
  return {0, height()};
}

void PositionLine::setMachineState(const MachineView& machine) {
  const bool sameWidth = machine.rotaryAxes == m_machine.rotaryAxes &&
                         machine.feedSetMmPerS.has_value() == m_machine.feedSetMmPerS.has_value();
  m_machine = machine;
  showAll();
  if (!sameWidth) {
    fitFonts();
  }
}

void PositionLine::retranslate() {
  m_readouts[kFeed].name->setText(tr("Feed"));
  showAll();
  fitFonts();
}

void PositionLine::restyle() {
  for (const Readout& readout : m_readouts) {
    setMuted(readout.name, palette());
  }
  showAll();
  update();
}

void PositionLine::showAll() {
  const bool standsIn = m_machine.standsIn();
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  const std::optional<base::Vec3>& positionMm =
      standsIn ? std::optional(m_machine.executed->positionMm) : m_machine.positionMm;
  const bool isPositionOld = !standsIn && !isFresh(m_machine.positionAgeS);
  const auto show = [this](std::size_t readout, const QString& text, bool isOld) {
    QLabel* label = m_readouts[readout].value;
    label->setText(text);
    QFont font = label->font();
    font.setStrikeOut(isOld && text != noValue());
    label->setFont(font);
    QPalette colors = label->palette();
    colors.setColor(QPalette::WindowText,
                    isOld ? themeColors(palette()).mutedText : themeColors(palette()).text);
    label->setPalette(colors);
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    show(axis, numberText(positionMm ? (*positionMm)[axis] : nan, 3), isPositionOld);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const std::size_t readout = base::kAxisCount + axis;
    const QString text = numberText(m_machine.rotaryDeg ? (*m_machine.rotaryDeg)[axis] : nan, 3);
    show(readout, text == noValue() ? text : text + QStringLiteral("°"),
         !isFresh(m_machine.positionAgeS));
    m_readouts[readout].group->setVisible(m_machine.rotaryAxes[axis]);
  }
  show(kFeed, feedLine(), !isFresh(m_machine.feedAgeS));
  showFreshness();
}

QString PositionLine::feedLine() const {
  if (!m_machine.feedMmPerS) {
    return noValue();
  }
  const QString actual = numberText(base::mmPerMinFromMmPerS(*m_machine.feedMmPerS), 0);
  if (!m_machine.feedSetMmPerS) {
    return QStringLiteral("%1\u00A0mm/min").arg(actual);
  }
  return QStringLiteral("%1/%2\u00A0mm/min")
      .arg(actual, numberText(base::mmPerMinFromMmPerS(*m_machine.feedSetMmPerS), 0));
}

void PositionLine::showFreshness() {
  if (!m_machine.positionMm && !m_machine.executed) {
    m_freshness->setStatus(Status::Unknown, tr("No data"));
    return;
  }
  const QString age = m_machine.positionAgeS ? ageText(*m_machine.positionAgeS) : noValue();
  if (isFresh(m_machine.positionAgeS)) {
    m_freshness->setStatus(Status::Good, tr("Live"));
  } else if (m_machine.standsIn()) {
    m_freshness->setStatus(Status::Busy, tr("Last executed point, %1. The axes were read %2 ago.")
                                             .arg(countText(m_machine.executed->number), age));
  } else {
    m_freshness->setStatus(Status::Attention, tr("Old: read %1 ago").arg(age));
  }
}

void PositionLine::fitFonts() {
  // As large as the width permits, measured at one size and scaled.
  constexpr double kProbePt = 10.0;
  const QFontMetrics metrics(sized(font(), kProbePt));
  const QString& longestFeed = m_machine.feedSetMmPerS ? kLongestFeeds : kLongestFeed;
  double atProbe = 0.0;
  double fixed = 2.0 * kMarginPx + kGroupGapPx;
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    if (i >= base::kAxisCount && i < kAxisReadouts && !m_machine.rotaryAxes[i - base::kAxisCount]) {
      continue;
    }
    atProbe += metrics.horizontalAdvance(m_readouts[i].name->text()) +
               metrics.horizontalAdvance(i == kFeed ? longestFeed : kLongestAxis);
    fixed += 2.0 * kGroupGapPx + kGapPx;
  }
  // A fifth of the line says how old it is.
  const double room = 0.8 * width() - fixed;
  const double byHeight = kProbePt * 0.62 * height() / metrics.height();
  const double pointSize =
      std::clamp(std::min(kProbePt * room / atProbe, byHeight), kFontPtMin, kFontPtMax);
  const QFont fitting = sized(font(), pointSize);
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    const Readout& readout = m_readouts[i];
    QFont value = fitting;
    value.setStrikeOut(readout.value->font().strikeOut());
    readout.value->setFont(value);
    // The same width whatever the value is: digits that move cannot be read.
    readout.value->setFixedWidth(
        QFontMetrics(fitting).horizontalAdvance(i == kFeed ? longestFeed : kLongestAxis) + 2);
    readout.name->setFont(fitting);
  }
}

void PositionLine::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  constexpr int kWidthPerHeight = 22;
  constexpr int kWindowPerHeight = 10;
  setFixedHeight(
      std::clamp(std::min(width() / kWidthPerHeight, window()->height() / kWindowPerHeight),
                 kHeightPxMin, kHeightPxMax));
  fitFonts();
}

void PositionLine::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  painter.setPen(colors.line);
  painter.drawLine(0, height() - 1, width(), height() - 1);
  for (const Readout& readout : m_readouts) {
    if (readout.group->isVisible()) {
      const int x = readout.group->geometry().right();
      painter.drawLine(x, height() / 4, x, height() - height() / 4);
    }
  }
}

}  // namespace rivulet::widgets
