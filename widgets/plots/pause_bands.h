// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pauses of a run as bands behind a curve: plain for measured, hatched for inferred, dotted
/// for predicted ones, with duration and origin if there is room for them.
/// @threadsafety GUI thread.
#pragma once

#include <QBrush>
#include <QGraphicsItem>
#include <QPalette>
#include <vector>

#include "trace/pause.h"

namespace rivulet::widgets {

/// "M", "I" or "P" in the language of the operator, and the word for it.
[[nodiscard]] QString pauseOriginLetter(trace::PauseOrigin origin);
[[nodiscard]] QString pauseOriginText(trace::PauseOrigin origin);
/// How the bands of an origin are filled.
[[nodiscard]] QBrush pauseBrush(trace::PauseOrigin origin, const QPalette& palette);

class PauseBands final : public QGraphicsItem {
 public:
  explicit PauseBands(QGraphicsItem* parent);

  /// @param pauses  in time order; may be null; outlives the item
  void setPauses(const std::vector<trace::Pause>* pauses, bool labels);
  void setPalette(const QPalette& palette);
  /// Where the curve is, in the coordinates of the parent, and which times it shows.
  void setArea(const QRectF& area, double fromS, double toS);

  [[nodiscard]] QRectF boundingRect() const override { return m_area; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const std::vector<trace::Pause>* m_pauses = nullptr;
  bool m_labels = false;
  QPalette m_palette;
  QRectF m_area;
  double m_fromS = 0.0;
  double m_toS = 1.0;
};

}  // namespace rivulet::widgets
