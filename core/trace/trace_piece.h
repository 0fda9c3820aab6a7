// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A control's trace in pieces, fetched while the run lasts. @threadsafety pure functions and plain
/// values.
#pragma once

#include <cstddef>
#include <cstdint>

#include "trace/control_trace.h"

namespace rivulet::trace {

/// How many records have been recorded or fetched since a start of the program.
struct TracePosition {
  std::uint64_t start = 0;  ///< number of that start; 0: the last one
  std::uint64_t samples = 0;
  std::uint64_t blocks = 0;
  std::uint64_t events = 0;

  friend bool operator==(const TracePosition&, const TracePosition&) = default;
};

struct TracePiece {
  ControlTrace records;  ///< truncated: records before these are missing
  TracePosition next;    ///< where the next piece begins
  bool isLast = true;    ///< nothing more has been recorded so far
};

/// Records of each kind in a piece at most: twenty seconds of an interpolation cycle of 4 ms.
inline constexpr std::size_t kPieceRecordsMax = 5000;

/// @param kept  records that are still there
/// @param begin  where they begin  @param from  of another start of the program: nothing is given,
///        and records are missing
/// @param recordsMax  of each kind
[[nodiscard]] TracePiece cutPiece(const ControlTrace& kept, const TracePosition& begin,
                                  const TracePosition& from,
                                  std::size_t recordsMax = kPieceRecordsMax);

}  // namespace rivulet::trace
