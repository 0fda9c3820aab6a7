// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The assumed cost of access to the control: the one figure of [P1], or a measurement.
/// @threadsafety pure.
#pragma once

#include <optional>

#include "base/instant.h"
#include "feasibility/client_turn.h"

namespace rivulet::feasibility {

/// Duration of a request with n cells: a + b·n.
struct AccessLine {
  base::Duration overhead{};  ///< a
  base::Duration perNode{};   ///< b, per cell; of an array that costs as much as one cell: zero
  /// Never below a microsecond: a fitted line may pass through zero where nothing was measured.
  [[nodiscard]] base::Duration of(int nodes) const;
};

/// Of the form of access a run uses (a list, arrays, one by one).
struct MeasuredAccess {
  AccessLine read;
  AccessLine write;
};

struct AccessModel {
  base::Duration accessTime = std::chrono::microseconds{4300};  ///< [P1] Table I, per node
  /// A calibration of the control; replaces `accessTime`.
  std::optional<MeasuredAccess> measured = std::nullopt;

  /// t of the equations. Assumed: `accessTime`. Measured: what the requests of one turn of the
  /// client take, divided by the number of their cells, so that each equation, which multiplies t
  /// by that number, has just the measured time of the turn in it:
  ///
  /// | method   | one turn                                   | cells     | t                      |
  /// |----------|--------------------------------------------|-----------|------------------------|
  /// | position | read X Y Z, write A axes                   | 3+A       | (r(3) + w(A)) / (3+A)  |
  /// | signal   | read the signal, write half a loop         | A⌊N/2⌋+1  | (r(1) + w(A⌊N/2⌋)) / … |
  /// | window   | write a window, write its number, read     | A·N+5     | (w(A·N+3)+w(1)+r(1))/ …|
  ///
  /// A is the number of axes that are streamed. Method credit is as method window, but reads two
  /// cells: r(2).
  /// r(n), w(n) = a + b·n of reads and writes. With a = 0 and b = t for both, t comes out: [P1] is
  /// the special case. With arrays that cost as much as one cell (b = 0) the time for a window is
  /// 2·a_w + a_r, whatever N is, so that the reach grows with N.
  /// @param size  N >= 2 (method window: >= 1)
  /// @deviation [P1] charges each cell the same and has no overhead per request. Of method position
  /// it is the longer turn; the shorter, three reads, is taken as half of it, as in [P1].
  [[nodiscard]] base::Duration timePerNode(const TurnSize& size) const;
};

}  // namespace rivulet::feasibility
