// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/back_dialog.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPushButton>
#include <algorithm>

#include "widgets/common/number_field.h"
#include "widgets/common/page.h"

namespace rivulet::widgets {

namespace {

constexpr double kLengthMmMin = 0.1;
constexpr double kLengthMmMax = 10000.0;
constexpr double kUsualMm = 10.0;

}  // namespace

BackDialog::BackDialog(double feedMmPerMin, double feedMmPerMinMax, QWidget* parent)
    : QDialog(parent),
      m_toRapid(new QCheckBox(tr("To where the last rapid ended"), this)),
      m_lengthMm(new NumberField(this)),
      m_feedMmPerMin(new NumberField(this)) {
  setWindowTitle(tr("Back along the path"));
  m_lengthMm->setRange(kLengthMmMin, kLengthMmMax);
  m_lengthMm->setDecimals(1);
  m_lengthMm->setSuffix(tr(" mm"));
  m_lengthMm->setValue(kUsualMm);
  m_feedMmPerMin->setRange(1.0, feedMmPerMinMax);
  m_feedMmPerMin->setDecimals(0);
  m_feedMmPerMin->setSuffix(tr(" mm/min"));
  m_feedMmPerMin->setValue(std::min(feedMmPerMin, feedMmPerMinMax));
  for (QWidget* field : {static_cast<QWidget*>(m_toRapid), static_cast<QWidget*>(m_lengthMm),
                         static_cast<QWidget*>(m_feedMmPerMin)}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* show = makeTouchButton(this);
  show->setText(tr("Show the way"));
  show->setDefault(true);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Length of the way"), m_lengthMm);
  form->addRow(m_toRapid);
  form->addRow(tr("Feed"), m_feedMmPerMin);
  form->addRow(show);
  auto* cancel = makeTouchButton(this);
  cancel->setText(tr("Not now"));
  form->addRow(cancel);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_toRapid, &QCheckBox::toggled, m_lengthMm, &QWidget::setDisabled);
  connect(show, &QPushButton::clicked, this, [this] {
    Q_EMIT chosen(m_toRapid->isChecked() ? 0.0 : m_lengthMm->value(), m_feedMmPerMin->value());
    accept();
  });
}

}  // namespace rivulet::widgets
