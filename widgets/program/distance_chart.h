// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How often each distance of neighbouring points occurs, as bars over a logarithmic axis. Every
/// class that holds a point has a visible bar. @threadsafety GUI thread.
#pragma once

#include <QWidget>

#include "feasibility/path_statistics.h"

namespace rivulet::widgets {

class DistanceChart final : public QWidget {
  Q_OBJECT

 public:
  explicit DistanceChart(QWidget* parent = nullptr);

  void setHistogram(feasibility::DistanceHistogram histogram);
  [[nodiscard]] QSize sizeHint() const override { return {320, 120}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF plot() const;
  [[nodiscard]] double placeOf(double distanceMm) const;
  [[nodiscard]] QRectF bar(std::size_t one) const;

  feasibility::DistanceHistogram m_histogram;
};

}  // namespace rivulet::widgets
