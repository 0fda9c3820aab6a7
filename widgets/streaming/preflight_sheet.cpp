// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/preflight_sheet.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "overview/path_classes.h"
#include "widgets/common/theme.h"
#include "widgets/program/path_view.h"

namespace rivulet::widgets {

namespace {

constexpr int kFold = -1;  ///< among the remedies, which are others' own
constexpr int kPictureWidthPxMin = 300;
constexpr int kPictureWidthPxMax = 640;
constexpr int kTextsWidthPx = 760;    ///< narrower, they would be more lines than there is room for
constexpr int kBesidePicturePx = 56;  // margins and gap
constexpr int kRowGapPx = 8;
constexpr int kCardPx = 8;  ///< around what is on the card
constexpr double kCardRadiusPx = 10.0;

/// The path, quiet: the way to it is what is looked at.
PathCanvas::Style quietStyle(const overview::ProgramView& program, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  PathCanvas::Style style{program.kinds, {}};
  style.pens.assign(style.classes->classes.count, QPen(colors.path, 1.2));
  QPen& rapid = style.pens[static_cast<std::size_t>(overview::KindClass::Rapid)];
  rapid.setColor(colors.rapid);
  rapid.setDashPattern({5.0, 4.0});
  if (style.classes->classes.hasGaps) {
    style.pens.back() = Qt::NoPen;
  }
  return style;
}

}  // namespace

PreflightSheet::PreflightSheet(QWidget* parent)
    : Page(parent), m_rows(new QGridLayout), m_picture(new PathCanvas(this)) {
  QFont font = m_title->font();
  font.setPointSizeF(16.0);
  m_title->setFont(font);
  m_outcome->setEmphasis(12.0, true);
  m_rows->setHorizontalSpacing(16);
  m_rows->setVerticalSpacing(kRowGapPx);
  m_rows->setColumnStretch(1, 1);
  m_picture->setView(PathCanvas::View::Space);
  m_picture->setFocusPolicy(Qt::NoFocus);
  m_picture->hide();
  inColumn(
      {inRow({{m_title, 1}, m_close}),
       m_outcome,
       {inRow({{inColumn({m_rows, spring()}, nullptr, QMargins(kCardPx, kCardPx, kCardPx, kCardPx)),
                1},
               m_picture}),
        1}},
      this, QMargins(16, 8, 16, 8));
  retranslate();
  onTheme(&PreflightSheet::showItems);
  onTheme(&PreflightSheet::showPicture);
}

void PreflightSheet::setFirstMove(const FirstMove& move) {
  const bool isNew = move.program != m_firstMove.program;
  if (isNew) {
    m_picture->setProgram(move.program);
  }
  m_firstMove = move;
  m_picture->setToolPosition(move.wayMm.empty() ? std::nullopt : std::optional(move.wayMm.front()));
  m_picture->setFirstWay(move.wayMm);
  if (isNew) {
    showPicture();
  }
}

void PreflightSheet::showPicture() {
  placePicture();
  if (const auto& program = m_firstMove.program) {
    m_picture->setStyle(quietStyle(*program, palette()));
  }
}

void PreflightSheet::placePicture() {
  const int textsPx = std::max(m_rows->minimumSize().width(), kTextsWidthPx);
  const int widthPx =
      std::min({width() * 2 / 5, kPictureWidthPxMax, width() - textsPx - kBesidePicturePx});
  m_picture->setVisible(m_firstMove.program && widthPx >= kPictureWidthPxMin);
  m_picture->setFixedWidth(std::max(widthPx, kPictureWidthPxMin));
}

void PreflightSheet::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  placePicture();
}

/// One card, with a line between two rows.
void PreflightSheet::paintEvent(QPaintEvent* /*event*/) {
  const ThemeColors& colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colors.line);
  painter.setBrush(colors.surface);
  const int top = m_rows->geometry().top() - kCardPx;
  const int left = m_rows->geometry().left() - kCardPx;
  painter.drawRoundedRect(
      QRectF(left, top, width() - 2.0 * left, height() - top - 8.0).adjusted(0.5, 0.5, -0.5, -0.5),
      kCardRadiusPx, kCardRadiusPx);
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int row = 1; row < m_rows->rowCount(); ++row) {
    if (const QLayoutItem* name = m_rows->itemAtPosition(row, 0)) {
      const int y = name->geometry().top() - kRowGapPx / 2;
      painter.drawLine(left + 1, y, m_rows->geometry().right() + kCardPx, y);
    }
  }
}

void PreflightSheet::setItems(const std::vector<PreflightItem>& items, bool passed, Kind kind) {
  if (items == m_items && passed == m_passed && kind == m_kind) {
    return;  // a button that is being pressed must stay there
  }
  m_items = items;
  m_passed = passed;
  m_kind = kind;
  retranslate();
}

void PreflightSheet::showItems() {
  while (QLayoutItem* item = m_rows->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  // What is not right comes first.
  std::vector<PreflightItem> shown = m_items;
  const auto passed = std::stable_partition(shown.begin(), shown.end(), [](const auto& item) {
    return item.isKept || !item.remedy.isEmpty() ||
           (item.status != Status::Good && item.status != Status::Plain);
  });
  std::stable_partition(shown.begin(), passed, [](const PreflightItem& item) {
    return item.status == Status::Attention || item.status == Status::Fault;
  });
  const std::vector<PreflightItem> folded(passed, shown.end());
  shown.erase(passed, shown.end());
  int row = 0;
  for (const PreflightItem& item : shown) {
    addItem(item, row++);
  }
  if (!folded.empty()) {
    addPassed(folded, row++);
  }
  if (m_isUnfolded) {
    for (const PreflightItem& item : folded) {
      addItem(item, row++);
    }
  }
  if (isVisible()) {
    m_rows->activate();  // a new button is never seen at the corner, over the title
  }
  placePicture();
  if (m_kind == Kind::StartHere || m_kind == Kind::Resume) {
    m_outcome->setStatus(m_passed ? Status::Good : Status::Attention,
                         m_passed ? tr("Nothing has moved yet. Hold the button below for one "
                                       "second: then the machine moves.")
                         : m_kind == Kind::StartHere ? tr("Start is not possible yet.")
                                                     : tr("Resuming is not possible yet."));
    return;
  }
  m_outcome->setStatus(m_passed ? Status::Good : Status::Attention,
                       m_passed && m_kind == Kind::Raise
                           ? tr("Nothing has moved yet. Hold Start for one second: then the tool "
                                "is raised, and nothing else.")
                       : m_passed && m_kind == Kind::Back
                           ? tr("Nothing has moved yet. Hold Start for one second: then the tool "
                                "goes back along the path, and nothing else.")
                       : m_passed ? tr("Nothing has moved yet. Hold Start for one second: then the "
                                       "machine moves.")
                                  : tr("Start is not possible yet."));
}

void PreflightSheet::addItem(const PreflightItem& item, int row) {
  auto* name = new QLabel(item.name, this);
  setMuted(name, palette());
  auto* text = new StatusLabel(this);
  text->setWordWrap(true);
  text->setStatus(item.status, item.text);
  m_rows->addWidget(name, row, 0, Qt::AlignTop);
  m_rows->addWidget(text, row, 1);
  std::vector<QWidget*> shown{name, text};
  if (!item.remedy.isEmpty()) {
    QPushButton* button = makeTouchButton(this);
    button->setText(item.remedy);
    m_rows->addWidget(button, row, 2, Qt::AlignTop | Qt::AlignRight);
    connect(
        button, &QPushButton::clicked, this,
        [this, id = item.remedyId] {
          if (id == kFold) {
            fold();
          } else {
            Q_EMIT remedyRequested(id);
          }
        },
        Qt::QueuedConnection);
    if (item.remedyId == kFold) {
      m_foldButton = button;
    }
    shown.push_back(button);
  }
  if (isVisible()) {  // else they are shown with the sheet
    for (QWidget* widget : shown) {
      widget->show();
    }
  }
}

void PreflightSheet::addPassed(const std::vector<PreflightItem>& passed, int row) {
  QStringList names;
  for (const PreflightItem& item : passed) {
    names.append(item.name);
  }
  addItem({Status::Good, tr("Passed"),
           tr("%Ln checks: %1", nullptr, static_cast<int>(passed.size()))
               .arg(names.join(QStringLiteral(", "))),
           m_isUnfolded ? tr("Fold") : tr("Show"), kFold},
          row);
}

void PreflightSheet::fold() {
  m_isUnfolded = !m_isUnfolded;
  showItems();
  if (m_foldButton) {
    m_foldButton->setFocus();
  }
}

void PreflightSheet::retranslate() {
  m_title->setText(m_kind == Kind::Raise    ? tr("Before the tool is raised")
                   : m_kind == Kind::Back   ? tr("Before the tool goes back")
                   : m_kind == Kind::Resume ? tr("Before the run is resumed")
                                            : tr("Before the start"));
  m_picture->setTexts(PathView::canvasTexts());
  m_picture->setAccessibleName(tr("First move"));
  showItems();
}

}  // namespace rivulet::widgets
