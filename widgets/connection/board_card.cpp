// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/board_card.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/page.h"

namespace rivulet::widgets {

BoardCard::BoardCard(const QString& prefix, QWidget* parent)
    : QFrame(parent),
      m_name(new ElidedLabel(1, this)),
      m_question(new QLabel(this)),
      m_open(makeTouchButton(this)),
      m_remove(makeTouchButton(this)),
      m_keep(makeTouchButton(this)),
      m_confirm(makeTouchButton(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  QFont font = m_name->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.3);
  m_name->setFont(font);
  m_question->setWordWrap(true);
  m_open->setObjectName(prefix + QStringLiteral("open"));
  m_remove->setObjectName(prefix + QStringLiteral("remove"));
  m_keep->setObjectName(prefix + QStringLiteral("keep"));
  m_confirm->setObjectName(prefix + QStringLiteral("confirm-remove"));
  connect(m_remove, &QPushButton::clicked, this, [this] { ask(true); });
  connect(m_keep, &QPushButton::clicked, this, [this] { ask(false); });
}

void BoardCard::addRows(std::initializer_list<QWidget*> rows) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_name);
  for (QWidget* row : rows) {
    layout->addWidget(row);
  }
  layout->addWidget(m_question);
  layout->addStretch();
  layout->addLayout(inRow({{m_open, 1}, m_remove, {m_keep, 1}, m_confirm}));
}

void BoardCard::setRemoval(bool isSame, bool canRemove, const QString& question) {
  m_canRemove = canRemove;
  m_isAsking = m_isAsking && isSame && canRemove;
  m_question->setText(question);
  m_remove->setText(tr("Remove …"));
  m_remove->setAccessibleName(m_remove->text() + QLatin1Char(' ') + m_name->text());
  m_keep->setText(tr("Keep it"));
  m_confirm->setText(tr("Remove"));
  showQuestion();
}

void BoardCard::ask(bool isAsking) {
  m_isAsking = isAsking;
  showQuestion();
  (isAsking ? m_keep : m_remove)->setFocus();
}

void BoardCard::showQuestion() {
  m_question->setVisible(m_isAsking);
  m_confirm->setVisible(m_isAsking);
  m_keep->setVisible(m_isAsking);
  m_open->setVisible(!m_isAsking);
  m_remove->setVisible(!m_isAsking && m_canRemove);
}

void showProgress(QProgressBar& bar, double share) {
  constexpr int kSteps = 1000;
  bar.setRange(0, kSteps);
  bar.setValue(static_cast<int>(kSteps * share));
  bar.setFormat(QStringLiteral("%1\u00A0%").arg(numberText(100.0 * share, 1)));
}

}  // namespace rivulet::widgets
