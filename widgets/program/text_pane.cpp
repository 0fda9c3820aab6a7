// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/text_pane.h"

#include <QHBoxLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/program/program_text_view.h"
#include "widgets/program/text_search.h"

namespace rivulet::widgets {

namespace {

QToolButton* makeTool(QWidget* parent, Qt::ArrowType arrow) {
  auto* button = new QToolButton(parent);
  button->setArrowType(arrow);
  button->setMinimumSize(kTouchHeightPx, kTouchHeightPx);
  return button;
}

}  // namespace

TextPane::TextPane(QWidget* parent)
    : Page(parent),
      m_finder(new TextSearch(this)),
      m_search(new QLineEdit(this)),
      m_previous(makeTool(this, Qt::UpArrow)),
      m_next(makeTool(this, Qt::DownArrow)),
      m_found(new QLabel(this)),
      m_lineName(new QLabel(this)),
      m_line(new QLineEdit(this)),
      m_previousPart(makeTool(this, Qt::LeftArrow)),
      m_nextPart(makeTool(this, Qt::RightArrow)),
      m_follow(new QToolButton(this)),
      m_startHere(new QToolButton(this)),
      m_text(new ProgramTextView(this)) {
  m_search->setClearButtonEnabled(true);
  m_search->setMinimumSize(90, kTouchHeightPx);
  m_line->setMinimumHeight(kTouchHeightPx);
  m_line->setValidator(new QIntValidator(1, std::numeric_limits<int>::max(), m_line));
  m_line->setMaximumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00 000 000")) + 16);
  m_follow->setCheckable(true);
  m_follow->setChecked(true);
  m_follow->setMinimumHeight(kTouchHeightPx);
  m_found->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00 000+")));
  auto* finding = new QHBoxLayout;
  finding->addWidget(m_search, 1);
  finding->addWidget(m_found);
  finding->addWidget(m_previous);
  finding->addWidget(m_next);
  auto* places = new QHBoxLayout;
  places->addWidget(m_lineName);
  places->addWidget(m_line);
  places->addWidget(m_previousPart);
  places->addWidget(m_nextPart);
  places->addStretch();
  places->addWidget(m_follow);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(finding);
  layout->addLayout(places);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_startHere);
  m_startHere->setMinimumHeight(kTouchHeightPx);
  m_startHere->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_startHere->setEnabled(false);
  setTabOrder(m_text, m_startHere);

  connect(m_search, &QLineEdit::textChanged, this, [this](const QString& wanted) {
    m_text->setHighlighted(wanted);
    m_wantsFirst = !wanted.isEmpty();
    m_finder->start(wanted);
  });
  connect(m_search, &QLineEdit::returnPressed, this, [this] { findNext(true); });
  connect(m_next, &QToolButton::clicked, this, [this] { findNext(true); });
  connect(m_previous, &QToolButton::clicked, this, [this] { findNext(false); });
  connect(m_finder, &TextSearch::changed, this, &TextPane::showFound);
  connect(m_previousPart, &QToolButton::clicked, this, [this] { goToPart(false); });
  connect(m_nextPart, &QToolButton::clicked, this, [this] { goToPart(true); });
  connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp), this), &QShortcut::activated, this,
          [this] { goToPart(false); });
  connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown), this), &QShortcut::activated,
          this, [this] { goToPart(true); });
  connect(m_line, &QLineEdit::returnPressed, this, &TextPane::goToLine);
  connect(m_startHere, &QToolButton::clicked, this,
          [this] { Q_EMIT startHereRequested(m_text->currentLine()); });
  connect(m_follow, &QToolButton::toggled, this, &TextPane::showRunLine);
  // Who looks elsewhere is not pulled back.
  connect(m_text, &ProgramTextView::lineChosen, this, [this] { m_follow->setChecked(false); });
  connect(m_text, &ProgramTextView::scrolledByHand, this, [this] { m_follow->setChecked(false); });
  const auto onKey = [this](const QKeySequence& key, QLineEdit* field) {
    connect(new QShortcut(key, this), &QShortcut::activated, field, [field] {
      field->setFocus(Qt::ShortcutFocusReason);
      field->selectAll();
    });
  };
  onKey(QKeySequence::Find, m_search);
  onKey(QKeySequence(Qt::CTRL | Qt::Key_G), m_line);
  m_previousPart->hide();
  m_nextPart->hide();
  retranslate();
  restyle();
}

void TextPane::setProgram(const std::shared_ptr<const overview::ProgramView>& view) {
  m_program = view;
  m_runLine = 0;
  m_text->setProgram(view);
  for (QToolButton* button : {m_previousPart, m_nextPart}) {
    button->setVisible(view != nullptr && view->outline.partLines().size() > 1);
  }
  m_wantsFirst = false;
  m_finder->setProgram(view);
  m_line->setEnabled(view != nullptr);
  m_startHere->setEnabled(view != nullptr);
}

void TextPane::setRunLine(std::size_t line) {
  if (line != m_runLine) {
    m_runLine = line;
    showRunLine();
  }
}

void TextPane::followRun() {
  m_follow->setChecked(true);
}

void TextPane::showRunLine() {
  m_text->setRunLine(m_runLine, m_follow->isChecked());
}

void TextPane::findNext(bool isForward) {
  const std::size_t line = m_finder->next(m_text->currentLine(), isForward);
  if (line > 0) {
    m_follow->setChecked(false);
    Q_EMIT lineChosen(line);
    showFound();
  }
}

void TextPane::goToLine() {
  bool isNumber = false;
  const auto line = m_line->text().toULongLong(&isNumber);
  if (isNumber && line > 0) {
    m_follow->setChecked(false);
    Q_EMIT lineChosen(std::min<std::size_t>(static_cast<std::size_t>(line), m_text->lineCount()));
    m_text->setFocus(Qt::OtherFocusReason);
  }
}

void TextPane::goToPart(bool isForward) {
  const std::size_t line =
      m_program ? m_program->outline.partBeyond(m_text->currentLine(), isForward) : 0;
  if (line > 0) {
    m_follow->setChecked(false);
    Q_EMIT lineChosen(line);
  }
}

void TextPane::showFound() {
  const auto& lines = m_finder->lines();
  m_next->setEnabled(!lines.empty());
  m_previous->setEnabled(!lines.empty());
  if (m_finder->isEmpty()) {
    m_found->setText(QString());
    return;
  }
  if (m_wantsFirst && !lines.empty()) {
    m_wantsFirst = false;
    const std::size_t current = m_text->currentLine();
    const bool isThere = std::binary_search(lines.begin(), lines.end(), current);
    if (!isThere) {
      m_follow->setChecked(false);
      Q_EMIT lineChosen(m_finder->next(current, true));
    }
  }
  const bool hasMore = m_finder->isBusy() || lines.size() >= TextSearch::kFoundMax;
  m_found->setText(countText(lines.size()) + (hasMore ? QStringLiteral("+") : QString()));
  m_found->setToolTip(tr("Lines with this text"));
}

void TextPane::retranslate() {
  m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
  m_search->setAccessibleName(tr("Search the program text"));
  m_previous->setToolTip(tr("Previous line with this text"));
  m_previous->setAccessibleName(m_previous->toolTip());
  m_next->setToolTip(tr("Next line with this text"));
  m_next->setAccessibleName(m_next->toolTip());
  m_lineName->setText(tr("Line"));
  m_line->setToolTip(tr("Go to a line (Ctrl+G)"));
  m_line->setAccessibleName(tr("Go to line"));
  m_previousPart->setToolTip(
      tr("Previous stretch, or blocks that the control executes (Ctrl+Page Up)"));
  m_previousPart->setAccessibleName(m_previousPart->toolTip());
  m_nextPart->setToolTip(tr("Next stretch, or blocks that the control executes (Ctrl+Page Down)"));
  m_nextPart->setAccessibleName(m_nextPart->toolTip());
  m_startHere->setText(tr("Run from here …"));
  m_startHere->setToolTip(tr("Start at the chosen line. First it is shown what would move."));
  m_follow->setText(tr("Follow the run"));
  m_follow->setToolTip(tr("The text shows the line that is being executed"));
  showFound();
}

void TextPane::restyle() {
  setMuted(m_found, palette());
  setMuted(m_lineName, palette());
}

}  // namespace rivulet::widgets
