// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A signal over time as a chart needs it: for any range it yields about two points per column of
/// pixels, however long the recording, as unbroken lines between its gaps.
/// @threadsafety GUI thread.
#pragma once

#include <QList>
#include <QPointF>
#include <optional>
#include <vector>

#include "trace/envelope.h"

namespace rivulet::widgets {

class EnvelopeSeries {
 public:
  /// @param atS  seconds, not before the last one @param value  NaN begins a gap
  void append(double atS, double value);
  void clear() { m_envelope.clear(); }
  [[nodiscard]] bool isEmpty() const { return m_envelope.empty(); }

  /// Lines to draw between two times; x in s. @param columns > 0
  [[nodiscard]] std::vector<QList<QPointF>> lines(double fromS, double toS,
                                                  std::size_t columns) const;
  [[nodiscard]] std::optional<trace::ValueRange> range(double fromS, double toS) const;

 private:
  trace::Envelope m_envelope;
};

}  // namespace rivulet::widgets
