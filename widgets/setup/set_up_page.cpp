// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/setup/set_up_page.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/folding_tabs.h"
#include "widgets/common/icons.h"

namespace rivulet::widgets {

SetUpPage::SetUpPage(QWidget* parent) : Page(parent), m_steps(new FoldingTabs(this)) {
  steps()->setDocumentMode(true);
  steps()->setIconSize(QSize(16, 16));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_steps);
  retranslate();
  restyle();
}

QTabWidget* SetUpPage::steps() const {
  return m_steps->tabs();
}

void SetUpPage::addStep(QWidget* step, std::function<QString()> title) {
  m_steps->addPage(step);
  m_list.push_back({step, std::move(title)});
  retranslate();
}

void SetUpPage::setStatus(const QWidget* step, Status status) {
  for (Step& one : m_list) {
    if (one.page == step && one.status != status) {
      one.status = status;
      restyle();
    }
  }
}

void SetUpPage::retranslate() {
  QStringList titles;
  for (const Step& step : m_list) {
    titles.append(step.title());
  }
  m_steps->setTexts(titles, tr("Step"));
  restyle();
}

void SetUpPage::restyle() {
  for (std::size_t i = 0; i < m_list.size(); ++i) {
    const Status status = m_list[i].status;
    m_steps->setIcon(static_cast<int>(i),
                     status == Status::Plain
                         ? QIcon()
                         : themedIcon(statusIconName(status), statusColor(status, palette())));
  }
}

}  // namespace rivulet::widgets
