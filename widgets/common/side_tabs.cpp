// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/side_tabs.h"

#include <QCursor>
#include <QPainter>
#include <QTabBar>
#include <algorithm>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kMarkPx = 5;  ///< bar at the left of the present page
constexpr int kPaddingPx = 10;
/// In a low window. It is one on a screen scaled to 200 %, where this is more than enough.
constexpr int kHeightPxMin = 30;

class SideTabBar final : public QTabBar {
 public:
  explicit SideTabBar(QWidget* parent) : QTabBar(parent) {
    setMouseTracking(true);
    setDrawBase(false);
    setUsesScrollButtons(true);
  }

  void setTitles(const QStringList& titles) {
    measure(titles);
    for (int i = 0; i < count(); ++i) {
      setTabText(i, titles[i]);
    }
  }

 protected:
  [[nodiscard]] QSize tabSizeHint(int /*index*/) const override {
    int shown = 0;
    for (int i = 0; i < count(); ++i) {
      shown += isTabVisible(i) ? 1 : 0;
    }
    const int room = parentWidget()->height() / std::max(1, shown);
    return {m_widthPx + kMarkPx + 2 * kPaddingPx, std::clamp(room, kHeightPxMin, kTouchHeightPx)};
  }

  [[nodiscard]] QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }

  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::FontChange) {
      QStringList titles;
      for (int i = 0; i < count(); ++i) {
        titles.push_back(tabText(i));
      }
      measure(titles);
    }
    QTabBar::changeEvent(event);
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    const ThemeColors& colors = themeColors(palette());
    for (int i = 0; i < count(); ++i) {
      if (!isTabVisible(i)) {
        continue;
      }
      const QRect place = tabRect(i);
      const bool isCurrent = i == currentIndex();
      QFont textFont = font();
      if (isCurrent) {
        painter.fillRect(place, colors.surface);
        painter.fillRect(QRect(place.topLeft(), QSize(kMarkPx, place.height())), colors.accent);
        textFont.setBold(true);
      } else if (place.contains(mapFromGlobal(QCursor::pos()))) {
        painter.fillRect(place, colors.button);
      }
      painter.setPen(colors.line);
      painter.drawLine(place.bottomLeft(), place.bottomRight());
      painter.setFont(textFont);
      painter.setPen(colors.text);
      painter.drawText(place.adjusted(kMarkPx + kPaddingPx, 0, 0, 0),
                       Qt::AlignLeft | Qt::AlignVCenter, tabText(i));
    }
  }

 private:
  void measure(const QStringList& titles) {
    QFont bold = font();
    bold.setBold(true);  // as the present one is drawn
    const QFontMetrics metrics(bold);
    m_widthPx = 0;
    for (int i = 0; i < count(); ++i) {
      if (isTabVisible(i)) {
        m_widthPx = std::max(m_widthPx, metrics.horizontalAdvance(titles[i]));
      }
    }
  }

  int m_widthPx = 0;  ///< of the widest title
};

}  // namespace

SideTabs::SideTabs(QWidget* parent) : QTabWidget(parent) {
  setTabBar(new SideTabBar(this));
  setTabPosition(West);
  setDocumentMode(true);
}

void SideTabs::setTitles(const QStringList& titles, const QStringList& toolTips) {
  static_cast<SideTabBar*>(tabBar())->setTitles(titles);
  for (int i = 0; i < count(); ++i) {
    setTabToolTip(i, toolTips[i]);
  }
  setTabText(0, titles.first());  // the bar alone does not tell the widget its new width
}

void SideTabs::resizeEvent(QResizeEvent* event) {
  tabBar()->setElideMode(Qt::ElideNone);  // asks for the sizes of the tabs again
  QTabWidget::resizeEvent(event);
}

}  // namespace rivulet::widgets
