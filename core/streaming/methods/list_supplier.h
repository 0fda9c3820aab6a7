// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The points of a program, all known before the run. @threadsafety one object, one thread.
#pragma once

#include <utility>
#include <vector>

#include "live/point_supplier.h"
#include "streaming/methods/pause_placement.h"

namespace rivulet::streaming {

class ListSupplier : public live::PointSupplier {
 public:
  /// @param points  at least one  @param cut  see `cutWindows`
  ListSupplier(std::vector<gcode::StreamPoint> points, std::size_t pointsPerWindow, WindowCut cut)
      : m_points(std::move(points)), m_begins(cutWindows(m_points, pointsPerWindow, cut).begins) {
    m_begins.push_back(m_points.size());
  }

  [[nodiscard]] std::optional<std::size_t> takeWindow(base::Instant /*now*/) override {
    if (isDry()) {
      return std::nullopt;
    }
    ++m_taken;
    return m_begins[m_taken] - m_begins[m_taken - 1];
  }
  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const override { return m_points; }
  [[nodiscard]] const std::vector<std::size_t>& windowBegins() const override { return m_begins; }
  [[nodiscard]] bool isDry() const override { return m_taken + 1 == m_begins.size(); }
  [[nodiscard]] bool isComplete() const override { return true; }

 private:
  std::vector<gcode::StreamPoint> m_points;
  std::vector<std::size_t> m_begins;
  std::size_t m_taken = 0;
};

}  // namespace rivulet::streaming
