// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The cells of the online correction: what is wanted, what is on its way, what the control has.
/// It says when a write is worth its time; the driver says when there is room for one.
/// @threadsafety one object, one thread.
#pragma once

#include <span>
#include <vector>

#include "base/instant.h"
#include "opcua/variable.h"
#include "streaming/run.h"
#include "templates/cells.h"

namespace rivulet::streaming {

class CorrectionCells {
 public:
  /// @param cells  of the program; it may have none
  CorrectionCells(const templates::CellMap& cells, const templates::TemplateParameters& parameters);

  /// False: the program has no correction, and nothing of the rest is to be called.
  [[nodiscard]] bool exists() const { return !m_axes.empty(); }
  [[nodiscard]] int nodeCount() const { return static_cast<int>(m_axes.size()); }
  [[nodiscard]] const Correction& value() const { return m_value; }

  /// What the axes are to be corrected by. Cut off at the limit; what is no number, and an axis
  /// without a cell, changes nothing.
  void want(base::Vec3 wantedMm, base::Instant now);
  /// There is something to write, and the last write was long enough ago.
  [[nodiscard]] bool isDue(base::Instant now) const;
  /// It has waited for as long as it may: it goes next, whether there is slack or not.
  [[nodiscard]] bool isOverdue(base::Instant now) const;
  /// What to write now, valid until the next call. Then either `confirm` or `lost`.
  [[nodiscard]] std::span<const opcua::Assignment> take(base::Instant now);
  void confirm();
  /// No answer: whether it was carried out is not known. It is written again.
  void lost();

 private:
  std::vector<std::size_t> m_axes;
  std::vector<opcua::Assignment> m_writes;
  double m_limitMm;
  Correction m_value;
  base::Vec3 m_sentMm;
  bool m_isUnsure = false;       ///< what the control has may be another value than `confirmedMm`
  base::Instant m_waitsSince{};  ///< since when something else is wanted than was sent
  base::Instant m_nextWrite{};
};

}  // namespace rivulet::streaming
