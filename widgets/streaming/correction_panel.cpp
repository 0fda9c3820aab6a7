// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/correction_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kStepsPerMm = 1000.0;

int stepsOf(double valueMm) {
  return static_cast<int>(std::lround(valueMm * kStepsPerMm));
}

}  // namespace

CorrectionPanel::CorrectionPanel(QWidget* parent)
    : Page(parent),
      m_port(whole(1024, 65535)),
      m_silence(number({.min = 0.1, .max = 60.0, .decimals = 1, .unit = "s"})) {
  setMinimumWidth(330);

  inColumn({makeAxes(), m_zero, makeSource(), m_status}, m_group);
  inColumn({m_group, spring()}, this);

  onEdit({m_source, m_port, m_silence}, &CorrectionPanel::takeInput);
  hide();
  retranslate();
}

QLayout* CorrectionPanel::makeAxes() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->addWidget(label({.text = QT_TR_NOOP("confirmed by the control"), .isMuted = true}), 0, 2, 1,
                  2, Qt::AlignRight);
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    Axis& axis = m_axes[i];
    axis = {new QLabel(QString(QLatin1Char(base::kAxisNames[i])), this),
            new QSlider(Qt::Horizontal, this), new NumberField(this), makeValueLabel(this)};
    axis.slider->setMinimumHeight(kTouchHeightPx);
    axis.slider->setTickPosition(QSlider::TicksBelow);  // the ends and zero
    axis.field->setDecimals(3);
    axis.field->setSingleStep(0.001);
    axis.field->setKeyboardTracking(false);  // half a number is not a value
    axis.field->setSuffix(QStringLiteral("\u00A0mm"));
    axis.name->setBuddy(axis.field);
    axis.confirmed->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    axis.confirmed->setMinimumWidth(
        fontMetrics().horizontalAdvance(QStringLiteral("\u22120.000\u00A0mm")));
    const int row = static_cast<int>(i) + 1;
    grid->addWidget(axis.name, row, 0);
    grid->addWidget(axis.slider, row, 1);
    grid->addWidget(axis.field, row, 2);
    grid->addWidget(axis.confirmed, row, 3);
    connect(axis.slider, &QSlider::valueChanged, this,
            [this, i](int steps) { takeValue(i, steps / kStepsPerMm); });
    connect(axis.field, &QDoubleSpinBox::valueChanged, this,
            [this, i](double valueMm) { takeValue(i, valueMm); });
    for (QWidget* widget :
         {static_cast<QWidget*>(axis.slider), static_cast<QWidget*>(axis.field)}) {
      widget->setFocusPolicy(Qt::StrongFocus);
      widget->installEventFilter(this);
    }
  }
  grid->setColumnStretch(1, 1);
  return grid;
}

QLayout* CorrectionPanel::makeSource() {
  m_sourceForm = new Form(this, nullptr, Form::Height::Touch);
  m_sourceForm->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_sourceForm->row({.text = QT_TR_NOOP("Source")}, m_source);
  m_sourceForm->row({.text = QT_TR_NOOP("Port")}, m_port);
  m_sourceForm->row({.text = QT_TR_NOOP("Silent after")}, m_silence);
  for (QWidget* field : std::initializer_list<QWidget*>{m_source, m_port, m_silence}) {
    field->setFocusPolicy(Qt::StrongFocus);
    field->installEventFilter(this);
  }
  return m_sourceForm;
}

void CorrectionPanel::setLimit(double limitMm, const std::array<bool, base::kAxisCount>& axes) {
  m_limitMm = limitMm;
  m_isShowing = true;
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    const Axis& axis = m_axes[i];
    axis.slider->setRange(-stepsOf(limitMm), stepsOf(limitMm));
    axis.slider->setTickInterval(std::max(stepsOf(limitMm), 1));
    axis.field->setRange(-limitMm, limitMm);
    for (QWidget* widget :
         {static_cast<QWidget*>(axis.name), static_cast<QWidget*>(axis.slider),
          static_cast<QWidget*>(axis.field), static_cast<QWidget*>(axis.confirmed)}) {
      widget->setVisible(axes[i]);
    }
  }
  m_isShowing = false;
  setVisible(limitMm > 0.0);
  showValues();
}

void CorrectionPanel::setRunning(bool running) {
  m_isRunning = running;
  m_valueMm = {};
  m_correction.reset();
  m_live.hasValue = false;
  showValues();
}

void CorrectionPanel::setCorrection(const std::optional<streaming::Correction>& correction) {
  if (correction != m_correction) {  // it is told with each update of a run
    m_correction = correction;
    showValues();
  }
}

void CorrectionPanel::setLiveSource(const LiveSourceView& view) {
  m_live = view;
  showValues();
}

void CorrectionPanel::takeValue(std::size_t axis, double valueMm) {
  if (m_isShowing || m_input.isLive) {
    return;
  }
  m_valueMm.set(axis, std::clamp(valueMm, -m_limitMm, m_limitMm));
  showValues();
  Q_EMIT correctionRequested(m_valueMm);
}

void CorrectionPanel::setZero() {
  // An operator who presses Zero does not want values of the source any more.
  if (m_input.isLive) {
    m_source->setCurrentIndex(0);
  }
  m_valueMm = {};
  showValues();
  Q_EMIT correctionRequested(m_valueMm);
}

void CorrectionPanel::takeInput() {
  if (m_isShowing) {
    return;
  }
  const CorrectionInput input{m_source->currentIndex() == 1, m_port->value(), m_silence->value()};
  if (input == m_input) {
    return;
  }
  if (m_input.isLive && !input.isLive && m_correction) {
    m_valueMm = m_correction->askedMm;  // the hand goes on where the source was
  }
  m_input = input;
  m_live.hasValue = false;
  showValues();
  Q_EMIT inputChanged(m_input);
}

void CorrectionPanel::showValues() {
  const bool wasShowing = std::exchange(m_isShowing, true);
  m_source->setCurrentIndex(m_input.isLive ? 1 : 0);
  m_port->setValue(m_input.port);
  m_silence->setValue(m_input.silenceS);
  base::Vec3 askedMm = m_valueMm;
  if (m_input.isLive) {
    askedMm = m_correction ? m_correction->askedMm : base::Vec3{};
  }
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    const Axis& axis = m_axes[i];
    axis.slider->setValue(stepsOf(askedMm[i]));
    axis.field->setValue(askedMm[i]);
    axis.slider->setEnabled(m_isRunning && !m_input.isLive);
    axis.field->setEnabled(m_isRunning && !m_input.isLive);
    axis.confirmed->setText(m_correction ? lengthText(m_correction->confirmedMm[i]) : noValue());
  }
  m_zero->setEnabled(m_isRunning);
  m_sourceForm->setRowVisible(m_port, m_input.isLive);
  m_sourceForm->setRowVisible(m_silence, m_input.isLive);
  m_isShowing = wasShowing;
  showStatus();
}

void CorrectionPanel::showStatus() {
  const QString limit = lengthText(m_limitMm);
  if (m_input.isLive && !m_live.isOpen) {
    m_status->setStatus(
        Status::Fault,
        tr("UDP port %1 cannot be opened: choose another.").arg(QString::number(m_input.port)));
  } else if (!m_isRunning) {
    m_status->setStatus(Status::Unknown, tr("Up to ±%1 per axis, during a run.").arg(limit));
  } else if (!m_input.isLive) {
    m_status->setStatus(Status::Plain, tr("By hand, up to ±%1 per axis.").arg(limit));
  } else if (m_live.isSilent && m_live.hasValue) {
    m_status->setStatus(Status::Attention, tr("The source is silent: its last value is held."));
  } else if (!m_live.hasValue) {
    m_status->setStatus(Status::Busy, tr("Nothing has been received from the source yet."));
  } else if (m_live.unknown > 0) {
    m_status->setStatus(Status::Attention,
                        tr("Receiving from the source. Lines that are not corrections: %1")
                            .arg(countText(m_live.unknown)));
  } else {
    m_status->setStatus(Status::Good, tr("Receiving from the source."));
  }
}

void CorrectionPanel::retranslate() {
  for (const Axis& axis : m_axes) {
    axis.slider->setAccessibleName(tr("Correction of %1").arg(axis.name->text()));
    axis.field->setAccessibleName(axis.slider->accessibleName());
  }
  showValues();
}

bool CorrectionPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel) {
    event->ignore();
    return true;
  }
  return Page::eventFilter(watched, event);
}

}  // namespace rivulet::widgets
