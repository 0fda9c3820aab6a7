// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The cells of the online correction: the values requested, sent and confirmed. This class decides
/// when a write is due; the driver decides when there is time for it.
/// @threadsafety one object, one thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/instant.h"
#include "opcua/variable.h"
#include "streaming/run/run.h"
#include "templates/cells.h"

namespace rivulet::streaming {

class CorrectionCells {
 public:
  /// @param cells  of the program; it may have none
  CorrectionCells(const templates::CellMap& cells, const templates::TemplateParameters& parameters);

  /// False: the program has no correction, and no other function may be called.
  [[nodiscard]] bool exists() const { return !m_axes.empty(); }
  /// It is the lift of the tool, of axes that are held.
  [[nodiscard]] bool lifts() const { return m_lifts; }
  [[nodiscard]] int nodeCount() const { return static_cast<int>(m_axes.size()); }
  [[nodiscard]] const Correction& value() const { return m_value; }

  /// The requested correction, clamped to the limit. A value that is not a number, or an axis
  /// without a cell, changes nothing.
  void want(base::Vec3 wantedMm, base::Instant now);
  /// There is something to write, and the last write was long enough ago.
  [[nodiscard]] bool isDue(base::Instant now) const;
  /// It has waited for the longest allowed time: it goes next, whether there is slack or not.
  [[nodiscard]] bool isOverdue(base::Instant now) const;
  /// The values to write now, valid until the next call. Call either `confirm` or `lost`
  /// afterwards.
  [[nodiscard]] std::span<const opcua::Assignment> take(base::Instant now);
  void confirm();
  /// The confirmed values, if they have not been noted and the last note was long enough ago.
  /// @param atOnce  however short ago it was
  [[nodiscard]] std::optional<base::Vec3> toNote(base::Instant now, bool atOnce);
  /// No answer: whether it was carried out is not known. It is written again.
  void lost();

 private:
  std::vector<std::size_t> m_axes;
  std::vector<opcua::Assignment> m_writes;
  double m_limitMm;
  bool m_lifts;
  Correction m_value;
  base::Vec3 m_sentMm;
  bool m_isUnsure = false;       ///< the control may have another value than `confirmedMm`
  base::Instant m_waitsSince{};  ///< since when the requested value differs from the one sent
  base::Instant m_nextWrite{};
  base::Vec3 m_notedMm;
  base::Instant m_notedAt{};
};

}  // namespace rivulet::streaming
