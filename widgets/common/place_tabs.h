// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Pages in a few places. A rail at the left of the window has an icon and a word for each place;
/// the pages of the present place have tabs. A page keeps its index, whichever place is present;
/// making it the current page opens its place. Arrow keys and Ctrl+Tab change the page within the
/// place, as in any tab widget.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractButton>
#include <QTabWidget>
#include <vector>

#include "widgets/common/page.h"

class QVBoxLayout;

namespace rivulet::widgets {

class PlaceTabs final : public QTabWidget {
  Q_OBJECT

 public:
  explicit PlaceTabs(QWidget* parent = nullptr);

  /// @param place  from 0 @return index of the page
  int addPage(QWidget* page, int place);
  void setTitles(const QStringList& titles, const QStringList& toolTips);
  /// Shows the page that was shown there last, at first the first one.
  void openPlace(int place);
  void setBarShown(bool isShown);
  [[nodiscard]] int place() const { return m_place; }

 Q_SIGNALS:
  void placeChanged(int place);

 private:
  void showPlace();

  std::vector<int> m_places;  ///< by page
  std::vector<int> m_last;    ///< page that was shown last, by place
  int m_place = -1;
};

/// One place of the rail.
class PlaceButton final : public QAbstractButton {
  Q_OBJECT

 public:
  /// @param icon  of resources/icons
  PlaceButton(const char* icon, QWidget* parent);

  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString m_icon;
};

class PlaceRail final : public Page {
  Q_OBJECT

 public:
  explicit PlaceRail(QWidget* parent = nullptr);

  /// @return so that it can be given what it says
  PlaceButton* addPlace(const char* icon);
  void setPlace(int place);

 Q_SIGNALS:
  void placeChosen(int place);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<PlaceButton*> m_buttons;
  QVBoxLayout* m_rows;
};

}  // namespace rivulet::widgets
