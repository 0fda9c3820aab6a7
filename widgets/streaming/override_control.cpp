// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/override_control.h"

#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kProgrammedPercent = 100;
constexpr int kDetentPercent = 4;  ///< to each side of the detent
constexpr int kSliderPx = 150;

}  // namespace

OverrideControl::OverrideControl(QWidget* parent)
    : Page(parent),
      m_text(label({.hint = QT_TR_NOOP(
                        "Path override of this run, in percent of the programmed feed. The "
                        "override of the machine's own switch multiplies. Ctrl++ and Ctrl+- are a "
                        "step of 5 %.")})),
      m_slider(say(new QSlider(Qt::Horizontal, this),
                   {.hint = QT_TR_NOOP("Override"), .id = "override"})),
      m_less(button({.hint = QT_TR_NOOP("Override: 5 % less"), .id = "override-less"},
                    [this] { step(-1); })),
      m_more(button({.hint = QT_TR_NOOP("Override: 5 % more"), .id = "override-more"},
                    [this] { step(1); })) {
  m_less->setText(QStringLiteral("−"));
  m_more->setText(QStringLiteral("+"));
  for (QPushButton* button : {m_less, m_more}) {
    button->setFixedSize(kTouchHeightPx, kTouchHeightPx);
  }
  m_text->setAlignment(Qt::AlignCenter);
  m_slider->setRange(0, kProgrammedPercent);
  m_slider->setSingleStep(kStepPercent);
  m_slider->setPageStep(2 * kStepPercent);
  m_slider->setTickInterval(kProgrammedPercent);
  m_slider->setTickPosition(QSlider::TicksBelow);
  m_slider->setFixedWidth(kSliderPx);
  auto* middle = inColumn({m_text, m_slider}, nullptr, QMargins(0, 0, 0, 0));
  middle->setSpacing(0);
  inRow({m_less, middle, m_more}, this, QMargins(0, 0, 0, 0));
  connect(m_slider, &QSlider::valueChanged, this, [this](int percent) {
    const int stepped =
        kStepPercent * static_cast<int>(std::lround(percent / double{kStepPercent}));
    request(std::abs(percent - kProgrammedPercent) <= kDetentPercent ? kProgrammedPercent
                                                                     : stepped);
  });
  const auto onKey = [this](Qt::Key key, int steps) {
    connect(new QShortcut(QKeySequence(Qt::CTRL | key), this), &QShortcut::activated, this,
            [this, steps] { step(steps); });
  };
  onKey(Qt::Key_Plus, 1);
  onKey(Qt::Key_Minus, -1);
  onLanguage(&OverrideControl::showPercent);
}

void OverrideControl::setMax(double percent) {
  const QSignalBlocker silent(m_slider);
  m_slider->setMaximum(static_cast<int>(percent));
  showPercent();
}

void OverrideControl::setPercent(double percent) {
  if (m_slider->isSliderDown()) {
    return;  // what a hand is setting comes next
  }
  m_percent = static_cast<int>(std::lround(percent));
  showPercent();
}

void OverrideControl::setNarrow(bool isNarrow) {
  m_slider->setVisible(!isNarrow);
}

void OverrideControl::step(int steps) {
  // From a value between two steps, as another client may set it, to the next one.
  const double place = m_percent / double{kStepPercent};
  request(kStepPercent *
          static_cast<int>(steps > 0 ? std::floor(place) + steps : std::ceil(place) + steps));
}

void OverrideControl::request(int percent) {
  const int allowed = std::clamp(percent, 0, m_slider->maximum());
  if (allowed != m_percent) {
    m_percent = allowed;
    Q_EMIT percentRequested(allowed);
  }
  showPercent();
}

void OverrideControl::showPercent() {
  const QSignalBlocker silent(m_slider);
  m_slider->setValue(m_percent);
  m_text->setText(tr("Override %1 %").arg(m_percent));
  m_less->setEnabled(m_percent > 0);
  m_more->setEnabled(m_percent < m_slider->maximum());
}

}  // namespace rivulet::widgets
