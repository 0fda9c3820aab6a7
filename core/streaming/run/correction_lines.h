// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Text of a live source of corrections: one per line, "X 0.01 Y -0.02" or {"x": 0.01, "y": -0.02},
/// in mm. An axis that a line does not name keeps its value. Empty lines and those behind # say
/// nothing. Anything else is left out as a whole and counted.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/axes.h"
#include "base/vec3.h"

namespace rivulet::streaming {

/// What one line says; nothing for an axis it does not name.
using CorrectionLine = std::array<std::optional<double>, base::kAxisCount>;

/// @return nothing if the line is neither a correction nor empty
[[nodiscard]] std::optional<CorrectionLine> parseCorrectionLine(std::string_view line);

/// Puts lines together from what arrives in pieces, and keeps the last value.
class CorrectionLines {
 public:
  /// @param bytes  as they come; a line may be cut anywhere
  /// @return true if a line said something
  bool add(std::string_view bytes);
  /// The source has ended: what has no line end yet is a line.
  bool finishLine() { return add("\n"); }

  [[nodiscard]] base::Vec3 valueMm() const { return m_valueMm; }
  /// Lines that were no correction.
  [[nodiscard]] std::size_t unknownCount() const { return m_unknown; }
  /// The first of them, from 1; 0: none.
  [[nodiscard]] std::size_t firstUnknown() const { return m_firstUnknown; }

 private:
  bool takeLine(std::string_view line);

  std::string m_rest;
  bool m_isTooLong = false;  ///< the line that has begun
  base::Vec3 m_valueMm;
  std::size_t m_lines = 0;
  std::size_t m_unknown = 0;
  std::size_t m_firstUnknown = 0;
};

}  // namespace rivulet::streaming
