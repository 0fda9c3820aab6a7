// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/place_tabs.h"

#include <QPainter>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kRailMarginPx = 8;
constexpr int kIconPx = 24;
constexpr int kButtonWidthPxMin = 64;
constexpr int kButtonHeightPx = 64;
constexpr int kButtonPaddingPx = 6;
constexpr qreal kButtonRadiusPx = 8.0;

}  // namespace

// --- pages --------------------------------------------------------------------------------------

PlaceTabs::PlaceTabs(QWidget* parent) : QTabWidget(parent) {
  setDocumentMode(true);
  tabBar()->setDrawBase(false);
  connect(this, &QTabWidget::currentChanged, this, &PlaceTabs::showPlace);
}

int PlaceTabs::addPage(QWidget* page, int place) {
  m_places.push_back(place);
  const auto places = static_cast<std::size_t>(place) + 1;
  if (m_last.size() < places) {
    m_last.resize(places, static_cast<int>(m_places.size()) - 1);
  }
  const int index = addTab(page, QString());
  setTabVisible(index, place == m_place);
  return index;
}

void PlaceTabs::setTitles(const QStringList& titles, const QStringList& toolTips) {
  for (int i = 0; i < count(); ++i) {
    setTabText(i, titles[i]);
    setTabToolTip(i, toolTips[i]);
  }
}

void PlaceTabs::openPlace(int place) {
  setCurrentIndex(m_last[static_cast<std::size_t>(place)]);
}

void PlaceTabs::setBarShown(bool isShown) {
  tabBar()->setVisible(isShown);
}

void PlaceTabs::showPlace() {
  if (currentIndex() < 0) {
    return;
  }
  const int place = m_places[static_cast<std::size_t>(currentIndex())];
  m_last[static_cast<std::size_t>(place)] = currentIndex();
  if (place == m_place) {
    return;
  }
  m_place = place;
  // The current one first, and those of its place before others are hidden: while the current tab
  // is hidden, Qt makes the next one that appears the current one.
  setTabVisible(currentIndex(), true);
  for (const bool isShown : {true, false}) {
    for (int i = 0; i < count(); ++i) {
      if ((m_places[static_cast<std::size_t>(i)] == place) == isShown) {
        setTabVisible(i, isShown);
      }
    }
  }
  Q_EMIT placeChanged(place);
}

// --- rail ---------------------------------------------------------------------------------------

PlaceButton::PlaceButton(const char* icon, QWidget* parent)
    : QAbstractButton(parent), m_icon(QString::fromLatin1(icon)) {
  setObjectName(m_icon);
  setCheckable(true);
  setAutoExclusive(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize PlaceButton::sizeHint() const {
  QFont bold = font();
  bold.setBold(true);  // as the present place is drawn
  const int width = QFontMetrics(bold).horizontalAdvance(text()) + 2 * kButtonPaddingPx;
  return {std::max(width, kButtonWidthPxMin), kButtonHeightPx};
}

void PlaceButton::paintEvent(QPaintEvent* /*event*/) {
  const ThemeColors& colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor text = isEnabled() ? colors.railText : colors.line;
  if (isChecked() || underMouse()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChecked() ? colors.railChosen : colors.railHover);
    painter.drawRoundedRect(rect(), kButtonRadiusPx, kButtonRadiusPx);
  }
  if (isChecked() && isEnabled()) {
    text = colors.onFill;
  }
  QFont font = this->font();
  font.setBold(isChecked());
  painter.setFont(font);
  painter.setPen(text);
  const int rowPx = painter.fontMetrics().height();
  const int topPx = (height() - kIconPx - rowPx) / 2;
  painter.drawPixmap((width() - kIconPx) / 2, topPx,
                     iconPixmap(m_icon, text, kIconPx, devicePixelRatioF()));
  painter.drawText(QRect(0, topPx + kIconPx, width(), rowPx), Qt::AlignCenter, this->text());
}

PlaceRail::PlaceRail(QWidget* parent) : Page(parent), m_rows(new QVBoxLayout(this)) {
  m_rows->setContentsMargins(kRailMarginPx, kRailMarginPx, kRailMarginPx, kRailMarginPx);
  m_rows->setSpacing(kRailMarginPx);
  m_rows->addStretch();
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);  // in a low window it gives way
}

PlaceButton* PlaceRail::addPlace(const char* icon) {
  auto* button = new PlaceButton(icon, this);
  const int place = static_cast<int>(m_buttons.size());
  m_buttons.push_back(button);
  m_rows->insertWidget(place, button);
  connect(button, &QAbstractButton::clicked, this, [this, place] { Q_EMIT placeChosen(place); });
  return button;
}

void PlaceRail::setPlace(int place) {
  m_buttons[static_cast<std::size_t>(place)]->setChecked(true);
}

void PlaceRail::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), themeColors(palette()).rail);
}

}  // namespace rivulet::widgets
