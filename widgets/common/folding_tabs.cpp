// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/folding_tabs.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QTabBar>
#include <QTabWidget>

#include "widgets/common/folding_columns.h"
#include "widgets/common/parts.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

FoldingTabs::FoldingTabs(QWidget* parent)
    : QWidget(parent), m_list(new QComboBox(this)), m_tabs(new QTabWidget(this)) {
  m_list->setObjectName(QStringLiteral("tabList"));
  m_list->setMinimumHeight(kTouchHeightPx);
  inColumn({m_list, {m_tabs, 1}}, this, QMargins(0, 0, 0, 0));
  connect(m_list, &QComboBox::activated, m_tabs, &QTabWidget::setCurrentIndex);
  connect(m_tabs, &QTabWidget::currentChanged, m_list, &QComboBox::setCurrentIndex);
}

void FoldingTabs::addPage(QWidget* page) {
  m_tabs->addTab(makeScrolling(page, this), QString());
}

void FoldingTabs::setTexts(const QStringList& texts, const QString& name) {
  {
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    m_list->addItems(texts);
    m_list->setCurrentIndex(m_tabs->currentIndex());
  }
  m_list->setAccessibleName(name);
  for (int i = 0; i < texts.size(); ++i) {
    m_tabs->setTabText(i, texts[i]);
  }
  fold();
}

void FoldingTabs::setIcon(int index, const QIcon& icon) {
  m_tabs->setTabIcon(index, icon);
  m_list->setItemIcon(index, icon);
  fold();
}

void FoldingTabs::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fold();
}

void FoldingTabs::fold() {
  const bool fits = m_tabs->tabBar()->sizeHint().width() <= width();
  m_tabs->tabBar()->setVisible(fits);
  m_list->setVisible(!fits);
}

}  // namespace rivulet::widgets
