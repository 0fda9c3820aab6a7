// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/text_pane.h"

#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <algorithm>
#include <array>
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
      m_searchRow(new QWidget(this)),
      m_find(say(new QToolButton(this),
                 {.hint = QT_TR_NOOP("Search the text (Ctrl+F), or go to a line (Ctrl+G)"),
                  .icon = "search",
                  .isTouch = true})),
      m_previous(
          say(makeTool(this, Qt::UpArrow), {.hint = QT_TR_NOOP("Previous line with this text")})),
      m_next(say(makeTool(this, Qt::DownArrow), {.hint = QT_TR_NOOP("Next line with this text")})),
      m_previousPart(say(
          makeTool(this, Qt::LeftArrow),
          {.hint =
               QT_TR_NOOP("Previous part, or blocks that the control executes (Ctrl+Page Up)")})),
      m_nextPart(say(
          makeTool(this, Qt::RightArrow),
          {.hint = QT_TR_NOOP("Next part, or blocks that the control executes (Ctrl+Page Down)")})),
      m_follow(say(new QToolButton(this),
                   {.text = QT_TR_NOOP("Follow the run"),
                    .tip = QT_TR_NOOP("The text shows the line that is being executed"),
                    .isTouch = true})),
      m_startHere(
          say(new QToolButton(this),
              {.text = QT_TR_NOOP("Run from here …"),
               .tip = QT_TR_NOOP("Start at the chosen line. First it is shown what would move."),
               .isTouch = true})),
      m_below(new QBoxLayout(QBoxLayout::LeftToRight)),
      m_text(new ProgramTextView(this)) {
  m_search->setClearButtonEnabled(true);
  m_search->setMinimumSize(90, kTouchHeightPx);
  m_line->setValidator(new QIntValidator(1, std::numeric_limits<int>::max(), m_line));
  m_line->setMaximumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00 000 000")) + 16);
  m_follow->setCheckable(true);
  m_follow->setChecked(true);
  m_found->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00 000+")));
  m_below->addLayout(inRow({m_previousPart, m_nextPart, {m_follow, 1}}));
  m_below->addWidget(m_startHere, 1);
  inRow({{m_search, 1},
         m_found,
         m_previous,
         m_next,
         label({.text = QT_TR_NOOP("Line"), .isMuted = true}),
         m_line},
        m_searchRow, QMargins(0, 0, 0, 0));
  m_searchRow->hide();
  m_find->setCheckable(true);
  auto* layout = inColumn({m_searchRow, {m_text, 1}, m_below}, this, QMargins(0, 4, 0, 0));
  layout->setSpacing(4);
  m_startHere->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_startHere->setEnabled(false);
  const std::array<QWidget*, 9> order{m_search,       m_previous, m_next,   m_line,     m_text,
                                      m_previousPart, m_nextPart, m_follow, m_startHere};
  for (std::size_t i = 1; i < order.size(); ++i) {
    setTabOrder(order[i - 1], order[i]);
  }

  connectParts();
  m_previousPart->hide();
  m_nextPart->hide();
  onLanguage(&TextPane::showFound);
}

void TextPane::connectParts() {
  connect(m_find, &QToolButton::toggled, this, [this](bool isShown) {
    m_searchRow->setVisible(isShown);
    if (isShown) {
      showSearch(m_search);
    } else {
      m_search->clear();
    }
  });
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

void TextPane::showSearch(QLineEdit* field) {
  m_find->setChecked(true);
  field->setFocus(Qt::ShortcutFocusReason);
  field->selectAll();
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

void TextPane::resizeEvent(QResizeEvent* event) {
  constexpr int kOneRowPx = 440;
  Page::resizeEvent(event);
  m_below->setDirection(width() < kOneRowPx ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace rivulet::widgets
