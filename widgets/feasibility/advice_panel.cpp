// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/feasibility/advice_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/nice_step.h"
#include "gcode/feeds.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::widgets {

using feasibility::Advice;
using feasibility::AdviceKind;
using feasibility::OperatingPoint;

namespace {

constexpr double kDeltaStepMm = 0.01;
/// A slider has this many places for the feed.
constexpr int kFeedSteps = 500;
constexpr std::size_t kAdviceShown = 6;

bool isSame(const OperatingPoint& a, const OperatingPoint& b) {
  return a.method == b.method && a.pointsPerLoop == b.pointsPerLoop && a.deltaMm == b.deltaMm &&
         a.feedMmPerS == b.feedMmPerS && a.cellsPerPoint == b.cellsPerPoint;
}

/// One advice: what to change and what it brings, and a button that does it.
class AdviceRow final : public QWidget {
 public:
  AdviceRow(const QString& text, const QString& use, QWidget* parent) : QWidget(parent) {
    auto* label = new QLabel(text, this);
    label->setWordWrap(true);
    m_use = makeTouchButton(this);
    m_use->setText(use);
    m_use->setAccessibleName(use + QStringLiteral(": ") + text);
    inRow({{label, 1}, m_use}, this, QMargins(0, 0, 0, 0));
  }
  [[nodiscard]] QPushButton* use() const { return m_use; }

 private:
  QPushButton* m_use;
};

}  // namespace

AdvicePanel::AdvicePanel(QWidget* parent) : Page(parent), m_adviceBox(new QWidget(this)) {
  m_adviceRows = new QVBoxLayout(m_adviceBox);
  m_adviceRows->setContentsMargins(0, 0, 0, 0);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(heading({.text = QT_TR_NOOP("Try")}));
  buildKnobs(layout);
  layout->addWidget(m_verdictLabel);
  layout->addSpacing(12);
  layout->addWidget(heading({.text = QT_TR_NOOP("Advice")}));
  layout->addWidget(m_adviceNote);
  layout->addWidget(m_adviceBox);
  layout->addStretch();
  retranslate();
  restyle();
}

void AdvicePanel::buildKnobs(QVBoxLayout* layout) {
  auto* grid = new QGridLayout;
  for (int knob = 0; knob < KnobCount; ++knob) {
    const auto index = static_cast<std::size_t>(knob);
    m_names[index] = new QLabel(this);
    m_values[index] = makeValueLabel(this);
    m_values[index]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_knobs[index] = new QSlider(Qt::Horizontal, this);
    m_knobs[index]->setMinimumHeight(kTouchHeightPx);
    m_knobs[index]->setMinimumWidth(80);
    // Under the finger: not only when it is released.
    m_knobs[index]->setTracking(true);
    grid->addWidget(m_names[index], knob, 0);
    grid->addWidget(m_knobs[index], knob, 1);
    grid->addWidget(m_values[index], knob, 2);
    connect(m_knobs[index], &QSlider::valueChanged, this, [this, index] {
      if (!m_isPlacing) {
        takeKnobs(!m_knobs[index]->isSliderDown());
      }
    });
    connect(m_knobs[index], &QSlider::sliderReleased, this, [this] { takeKnobs(true); });
  }
  grid->setColumnStretch(1, 1);
  layout->addLayout(grid);
}

void AdvicePanel::setOperatingPoint(const OperatingPoint& point, int pointsPerLoopMax,
                                    const FeedScale& scale) {
  m_point = point;
  if (scale != m_scale) {
    m_scale = scale;
    retranslate();
  }
  m_pointsPerLoopMax = std::max(2, pointsPerLoopMax);
  const bool isTurning = std::any_of(m_knobs.begin(), m_knobs.end(),
                                     [](const QSlider* knob) { return knob->isSliderDown(); });
  if (!isTurning) {
    m_under = point;
    m_turned.reset();
    placeKnobs();
  }
  showKnobs();
  showVerdict();
}

void AdvicePanel::placeKnobs() {
  m_isPlacing = true;
  m_deltaMmMax = base::niceCeil(std::max(2.0 * m_point.deltaMm, 0.1));
  const double feed = m_scale.shown(m_point.feedMmPerS);
  if (m_scale.isOverride()) {
    m_feedShownMax = 100.0 * gcode::kOverrideMax;
    m_feedSteps = static_cast<int>(m_feedShownMax);
  } else {
    const double limit = m_verdict && std::isfinite(m_verdict->feedMmPerSMax)
                             ? std::min(m_scale.shown(m_verdict->feedMmPerSMax), 10.0 * feed)
                             : feed;
    m_feedShownMax = base::niceCeil(1.5 * std::max({feed, limit, 10.0}));
    m_feedSteps = kFeedSteps;
  }
  m_knobs[Points]->setRange(2, std::max(m_pointsPerLoopMax, m_point.pointsPerLoop));
  m_knobs[Points]->setValue(m_point.pointsPerLoop);
  m_knobs[Delta]->setRange(1, static_cast<int>(std::lround(m_deltaMmMax / kDeltaStepMm)));
  m_knobs[Delta]->setValue(static_cast<int>(std::lround(m_point.deltaMm / kDeltaStepMm)));
  m_knobs[Feed]->setRange(1, m_feedSteps);
  m_knobs[Feed]->setValue(static_cast<int>(std::lround(feed / m_feedShownMax * m_feedSteps)));
  m_isPlacing = false;
}

void AdvicePanel::takeKnobs(bool isReleased) {
  OperatingPoint under = m_under;
  under.pointsPerLoop = m_knobs[Points]->value();
  const auto deltaSteps = static_cast<int>(std::lround(m_under.deltaMm / kDeltaStepMm));
  if (m_knobs[Delta]->value() != deltaSteps) {
    under.deltaMm = m_knobs[Delta]->value() * kDeltaStepMm;
  }
  const double shown = m_scale.shown(m_under.feedMmPerS);
  if (m_knobs[Feed]->value() !=
      static_cast<int>(std::lround(shown / m_feedShownMax * m_feedSteps))) {
    under.feedMmPerS =
        m_scale.feedMmPerS(m_scale.typed(m_knobs[Feed]->value() * m_feedShownMax / m_feedSteps));
  }
  if (!isSame(under, m_under)) {
    m_under = under;
    m_turned.reset();
    showKnobs();
    showVerdict();
    Q_EMIT turnRequested(m_under);
  }
  if (isReleased && !isSame(m_under, m_point)) {
    Q_EMIT operatingPointRequested(m_under);
  }
}

void AdvicePanel::setVerdict(const std::optional<feasibility::Verdict>& verdict) {
  m_verdict = verdict;
  showVerdict();
}

void AdvicePanel::setTurned(const OperatingPoint& point,
                            const std::optional<feasibility::Verdict>& verdict) {
  if (isSame(point, m_under)) {
    m_turned = verdict;
    showVerdict();
  }
}

void AdvicePanel::setBusy() {
  m_isBusy = true;
  m_list.clear();
  showAdvice();
}

void AdvicePanel::setAdvice(const std::vector<Advice>& list) {
  m_isBusy = false;
  m_list = list;
  showAdvice();
}

void AdvicePanel::setEditable(bool isEditable) {
  m_isEditable = isEditable;
  for (QSlider* knob : m_knobs) {
    knob->setEnabled(isEditable);
  }
  m_adviceBox->setEnabled(isEditable);
}

QString AdvicePanel::adviceText(const Advice& advice, const FeedScale& scale) {
  const QString feeds = scale.changeText(advice.feedMmPerSMaxBefore, advice.feedMmPerSMaxAfter);
  const QString after = scale.text(advice.after.feedMmPerS);
  const QString before = numberText(scale.shown(advice.before.feedMmPerS), 0);
  const bool isOverride = scale.isOverride();
  switch (advice.kind) {
    case AdviceKind::Feed:
      if (advice.gain() > 1.0) {
        return (isOverride ? tr("Override %1 instead of %2: still without wrong points")
                           : tr("F %1 instead of %2: still without wrong points"))
            .arg(after, before);
      }
      if (isOverride) {
        return tr("Override %1 instead of %2: without waiting").arg(after, before);
      }
      return (base::hasWindows(advice.before.method) ? tr("F %1 instead of %2: without waiting")
                                                     : tr("F %1 instead of %2: feasible"))
          .arg(after, before);
    case AdviceKind::PointsPerLoop:
      return (isOverride ? tr("N %1 instead of %2: largest override %3")
                         : tr("N %1 instead of %2: largest feed %3"))
          .arg(QString::number(advice.after.pointsPerLoop),
               QString::number(advice.before.pointsPerLoop), feeds);
    case AdviceKind::Delta:
      return tr("δ %1 instead of %2: largest feed %3")
          .arg(lengthText(advice.after.deltaMm, 2), numberText(advice.before.deltaMm, 2), feeds);
    case AdviceKind::Method:
      return tr("Method %1 instead of %2: largest feed %3")
          .arg(methodText(advice.after.method), methodText(advice.before.method), feeds);
  }
  return {};
}

void AdvicePanel::showKnobs() {
  const bool usesDelta = base::usesDelta(m_under.method);
  m_names[Delta]->setVisible(usesDelta);
  m_knobs[Delta]->setVisible(usesDelta);
  m_values[Delta]->setVisible(usesDelta);
  m_values[Points]->setText(QString::number(m_under.pointsPerLoop));
  m_values[Delta]->setText(lengthText(m_under.deltaMm, 2));
  m_values[Feed]->setText(m_scale.text(m_under.feedMmPerS));
}

void AdvicePanel::showVerdict() {
  const bool isTurned = !isSame(m_under, m_point);
  const std::optional<feasibility::Verdict>& verdict = isTurned ? m_turned : m_verdict;
  if (!verdict) {
    m_verdictLabel->setStatus(Status::Unknown, isTurned ? tr("Judging …") : tr("No verdict"));
    return;
  }
  const QString largest = m_scale.text(verdict->feedMmPerSMax);
  if (m_scale.isOverride()) {
    m_verdictLabel->setStatus(verdict->waits ? Status::Attention : Status::Good,
                              verdict->waits
                                  ? tr("Safe, with waiting above an override of %1").arg(largest)
                                  : tr("By the equations without waiting up to %1").arg(largest));
  } else if (!verdict->feasible) {
    m_verdictLabel->setStatus(Status::Fault, tr("Not feasible: largest feed %1").arg(largest));
  } else if (verdict->waits) {
    m_verdictLabel->setStatus(Status::Attention, tr("Safe, with waiting above %1").arg(largest));
  } else {
    m_verdictLabel->setStatus(Status::Good, tr("By the equations feasible up to %1").arg(largest));
  }
}

void AdvicePanel::showAdvice() {
  while (QLayoutItem* item = m_adviceRows->takeAt(0)) {
    item->widget()->deleteLater();
    item->widget()->hide();
    delete item;
  }
  for (std::size_t i = 0; i < std::min(m_list.size(), kAdviceShown); ++i) {
    auto* row = new AdviceRow(adviceText(m_list[i], m_scale), tr("Use"), m_adviceBox);
    m_adviceRows->addWidget(row);
    connect(row->use(), &QPushButton::clicked, this,
            [this, after = m_list[i].after] { Q_EMIT operatingPointRequested(after); });
  }
  if (m_isBusy) {
    m_adviceNote->setStatus(Status::Busy, tr("Looking for better settings …"));
  } else if (m_list.empty()) {
    m_adviceNote->setStatus(Status::Plain, tr("No single change makes this program much faster."));
  } else {
    m_adviceNote->setStatus(Status::Plain,
                            tr("Each was simulated with this program and made no wrong point."));
  }
}

void AdvicePanel::retranslate() {
  m_names[Points]->setText(QStringLiteral("N"));
  m_names[Delta]->setText(QStringLiteral("δ"));
  m_names[Feed]->setText(m_scale.isOverride() ? tr("Override") : QStringLiteral("F"));
  m_knobs[Points]->setAccessibleName(tr("Points per loop N"));
  m_knobs[Delta]->setAccessibleName(tr("Distance δ"));
  m_knobs[Feed]->setAccessibleName(m_scale.isOverride() ? tr("Override") : tr("Feed F"));
  // So that the sliders keep their place while one is moved.
  m_values[Feed]->setMinimumWidth(fontMetrics().horizontalAdvance(
      m_scale.isOverride() ? QStringLiteral("0.00 mm") : QStringLiteral("00,000 mm/min")));
  showKnobs();
  showVerdict();
  showAdvice();
}

void AdvicePanel::restyle() {
  for (QLabel* label : m_names) {
    setMuted(label, palette());
  }
}

}  // namespace rivulet::widgets
