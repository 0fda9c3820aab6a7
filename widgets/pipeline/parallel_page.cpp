// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/parallel_page.h"

#include <QVBoxLayout>

#include "widgets/pipeline/net_panel.h"

namespace rivulet::widgets {

ParallelPage::ParallelPage(QWidget* parent) : Page(parent), m_net(new NetPanel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_net);
}

}  // namespace rivulet::widgets
