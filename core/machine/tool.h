// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A tool and its cutting edges. @threadsafety plain values.
#pragma once

#include <string>
#include <vector>

namespace rivulet::machine {

struct ToolEdge {
  double lengthMm = 0.0;
  double radiusMm = 0.0;
};

struct Tool {
  int number = 0;  ///< 0: it has only a name, or there is no tool
  std::string name;
  std::vector<ToolEdge> edges;  ///< D1 and on
  bool isAssumed = false;       ///< not in the table: all its edges have length and radius 0

  [[nodiscard]] bool exists() const { return number != 0 || !name.empty(); }
  /// @param edge  from 1
  [[nodiscard]] bool hasEdge(int edge) const {
    return edge > 0 && static_cast<std::size_t>(edge) <= edges.size();
  }
};

}  // namespace rivulet::machine
