// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/parallel_page.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/folding_tabs.h"
#include "widgets/pipeline/net_panel.h"
#include "widgets/pipeline/task_panel.h"

namespace rivulet::widgets {

ParallelPage::ParallelPage(QWidget* parent)
    : Page(parent),
      m_tabs(new FoldingTabs(this)),
      m_net(new NetPanel(this)),
      m_tasks(new TaskPanel(this)) {
  m_tabs->tabs()->setObjectName(QStringLiteral("parallelTabs"));
  m_tabs->tabs()->setDocumentMode(true);
  m_tabs->addPage(m_net);
  m_tabs->addPage(m_tasks);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_tabs);
  retranslate();
}

void ParallelPage::retranslate() {
  m_tabs->setTexts({tr("Petri net"), tr("Tasks")}, tr("Part of the page"));
}

}  // namespace rivulet::widgets
