// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/program_page.h"

#include <QHBoxLayout>
#include <QSplitter>

#include "widgets/program/path_view.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/program_text_view.h"

namespace rivulet::widgets {

ProgramPage::ProgramPage(QWidget* parent)
    : Page(parent),
      m_path(new PathView(this)),
      m_text(new ProgramTextView),
      m_panel(new ProgramPanel(this)) {
  m_panel->placeAboveTabs(m_text);
  auto* columns = new QSplitter(Qt::Horizontal, this);
  columns->addWidget(m_path);
  columns->addWidget(m_panel);
  columns->setStretchFactor(0, 1);
  columns->setStretchFactor(1, 0);
  columns->setSizes({390, 350});
  columns->setChildrenCollapsible(false);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(columns);
  connect(m_path, &PathView::pointChosen, this, &ProgramPage::showPoint);
  connect(m_text, &ProgramTextView::lineChosen, this, &ProgramPage::showLine);
  connect(m_panel, &ProgramPanel::lineChosen, this, &ProgramPage::showLine);
  retranslate();
}

void ProgramPage::setProgram(const std::shared_ptr<const ProgramView>& view) {
  m_program = view;
  m_hasTimes = false;
  m_path->setProgram(view);
  m_text->setProgram(view);
  m_panel->setProgram(view);
}

void ProgramPage::replaceProgram(const std::shared_ptr<const ProgramView>& view) {
  m_program = view;
  m_path->replaceProgram(view);
}

void ProgramPage::setTimes(const std::shared_ptr<const ProgramTimes>& times) {
  m_hasTimes = times && times->run;
  m_path->setTimes(times);
  m_panel->setTimes(times);
}

void ProgramPage::showLine(std::size_t line) {
  m_text->setCurrentLine(line);
  if (m_program) {
    m_path->selectPoints(m_program->pointsOfLine({static_cast<std::uint32_t>(line)}));
  }
}

void ProgramPage::showPoint(std::size_t point) {
  if (m_program) {
    m_text->setCurrentLine(m_program->points.points.at(point).line.value);
  }
}

void ProgramPage::retranslate() {
  m_text->setAccessibleName(tr("Program text"));
}

}  // namespace rivulet::widgets
