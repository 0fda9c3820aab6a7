// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A legend that wraps its texts instead of cutting them off.
/// @threadsafety GUI thread.
#pragma once

#include <QBrush>
#include <QPen>
#include <QWidget>
#include <vector>

namespace rivulet::widgets {

struct LegendEntry {
  enum class Symbol {
    Line,  ///< drawn with `pen`
    Fill,  ///< a rectangle with `brush` and `pen`
    Dot,   ///< a filled circle
    Triangle,
    Square,
    Diamond,
    Marker,  ///< a ring with a dot, as the operating point
  };
  Symbol symbol = Symbol::Line;
  QPen pen;
  QBrush brush;
  QString text;
};

class LegendStrip final : public QWidget {
  Q_OBJECT

 public:
  explicit LegendStrip(QWidget* parent = nullptr);

  void setEntries(std::vector<LegendEntry> entries);
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Places of the entries in a given width.
  [[nodiscard]] std::vector<QRect> places(int width) const;

  std::vector<LegendEntry> m_entries;
};

}  // namespace rivulet::widgets
