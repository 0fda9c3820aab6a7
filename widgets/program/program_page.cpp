// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/program_page.h"

#include <QLineEdit>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>

#include "widgets/common/folding_columns.h"
#include "widgets/live/live_panel.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/program_text_view.h"
#include "widgets/program/reading_bar.h"
#include "widgets/program/start_steps.h"
#include "widgets/program/text_pane.h"

namespace rivulet::widgets {

namespace {

/// Weights, larger than any least width: a splitter raises smaller ones to that.
constexpr int kPathShare = 30'000;
constexpr int kTextShare = 20'000;
constexpr const char* kMoved = "movedByHand";
constexpr int kStackedPx = 660;
/// Narrower than its buttons: the halves are stacked before that matters.
constexpr int kPathPx = 280;

}  // namespace

ProgramPage::ProgramPage(QWidget* parent)
    : Page(parent),
      m_path(new PathView(this)),
      m_text(new TextPane),
      m_panel(new ProgramPanel(this)),
      m_live(new LivePanel(this)),
      m_reading(new ReadingBar(this)),
      m_steps(new StartSteps(this)),
      m_all(new QStackedWidget(this)),
      m_side(new QStackedWidget(this)),
      m_halves(new QSplitter(Qt::Horizontal, this)) {
  m_panel->setTextPage(m_text, m_text->find());
  m_path->setMinimumWidth(kPathPx);
  m_halves->addWidget(m_path);
  m_side->addWidget(m_panel);
  m_side->addWidget(m_live);
  m_halves->addWidget(m_side);
  m_halves->setSizes({kPathShare, kTextShare});
  m_halves->setChildrenCollapsible(false);
  connect(m_halves, &QSplitter::splitterMoved, m_halves,
          [this] { m_halves->setProperty(kMoved, true); });
  m_all->addWidget(makeScrolling(m_steps));  // else the path would need their height, too
  m_all->addWidget(m_halves);
  auto* layout = inColumn({m_reading, {m_all, 1}}, this, QMargins(0, 0, 0, 0));
  layout->setSpacing(0);
  connect(m_path, &PathView::pointChosen, this, &ProgramPage::showPoint);
  connect(m_text, &TextPane::lineChosen, this, &ProgramPage::showLine);
  connect(text(), &ProgramTextView::lineChosen, this, &ProgramPage::showLine);
  connect(m_panel, &ProgramPanel::lineChosen, this, &ProgramPage::showLine);
  for (const auto& [key, field] :
       {std::pair(QKeySequence(QKeySequence::Find), m_text->search()),
        std::pair(QKeySequence(Qt::CTRL | Qt::Key_G), m_text->lineField())}) {
    connect(new QShortcut(key, this), &QShortcut::activated, field, [this, field = field] {
      m_panel->showTab(ProgramPanel::Text);
      m_text->showSearch(field);
    });
  }
  retranslate();
}

void ProgramPage::setProgram(const std::shared_ptr<const overview::ProgramView>& view) {
  m_program = view;
  m_hasTimes = false;
  m_path->setProgram(view);
  m_text->setProgram(view);
  m_panel->setProgram(view);
  m_reading->setProgram(view ? view->program : nullptr);
  showSteps(view == nullptr);
}

void ProgramPage::showSteps(bool areShown) {
  m_all->setCurrentIndex(areShown ? 0 : m_all->indexOf(m_halves));
}

void ProgramPage::replaceProgram(const std::shared_ptr<const overview::ProgramView>& view) {
  m_program = view;
  m_path->replaceProgram(view);
}

void ProgramPage::setLive(const std::optional<live::Agreement>& agreed) {
  m_path->setBox(agreed);
  m_side->setCurrentWidget(agreed ? static_cast<QWidget*>(m_live) : m_panel);
  showSteps(!agreed && m_program == nullptr);
}

void ProgramPage::setTimes(const std::shared_ptr<const overview::ProgramTimes>& times) {
  m_hasTimes = times && times->run;
  m_path->setTimes(times);
  m_panel->setTimes(times);
}

void ProgramPage::showLine(std::size_t line) {
  text()->setCurrentLine(line);
  if (m_program) {
    m_path->selectPoints(m_program->pointsOfLine({static_cast<std::uint32_t>(line)}));
  }
}

void ProgramPage::showPoint(std::size_t point) {
  if (m_program) {
    text()->setCurrentLine(m_program->points.points.at(point).line.value);
  }
}

ProgramTextView* ProgramPage::text() const {
  return m_text->text();
}

void ProgramPage::setExecuted(std::size_t count, std::size_t runLine) {
  m_path->setExecuted(count);
  const bool isKnown = m_program && count > 0 && count <= m_program->points.points.size();
  m_text->setRunLine(runLine > 0 ? runLine
                     : isKnown   ? m_program->points.points[count - 1].line.value
                                 : 0);
}

void ProgramPage::setRunBegin(std::size_t point) {
  m_path->setRunBegin(point);
}

void ProgramPage::followRun() {
  m_text->followRun();
}

void ProgramPage::setLarge(bool isLarge) {
  m_side->setVisible(!isLarge);
}

void ProgramPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // Two halves side by side need room for the figures and for a path that can be read.
  const Qt::Orientation wanted = width() < kStackedPx ? Qt::Vertical : Qt::Horizontal;
  const bool isTurned = m_halves->orientation() != wanted;
  m_halves->setOrientation(wanted);
  if (isTurned || !m_halves->property(kMoved).toBool()) {
    // Queued: a splitter that has just been turned lays itself out first.
    QMetaObject::invokeMethod(
        m_halves,
        [this] {
          m_halves->setSizes({kPathShare, kTextShare});
        },
        Qt::QueuedConnection);
  }
}

void ProgramPage::retranslate() {
  text()->setAccessibleName(tr("Program text"));
}

}  // namespace rivulet::widgets
