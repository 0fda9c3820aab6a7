// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/trace_piece.h"

#include <algorithm>

namespace rivulet::trace {

namespace {

/// @return whether nothing is left
template <class Record>
bool cut(const std::vector<Record>& kept, std::uint64_t begin, std::uint64_t from, std::size_t max,
         std::vector<Record>& piece, std::uint64_t& next) {
  const std::uint64_t end = begin + kept.size();
  const std::uint64_t first = std::clamp(from, begin, end);
  next = std::min<std::uint64_t>(end, first + max);
  piece.assign(kept.begin() + static_cast<std::ptrdiff_t>(first - begin),
               kept.begin() + static_cast<std::ptrdiff_t>(next - begin));
  return next == end;
}

}  // namespace

TracePiece cutPiece(const ControlTrace& kept, const TracePosition& begin, const TracePosition& from,
                    std::size_t recordsMax) {
  TracePiece piece;
  piece.records.cycle = kept.cycle;
  piece.records.rotaryAxes = kept.rotaryAxes;
  if (from.start != 0 && from.start != begin.start) {
    piece.records.truncated = true;
    piece.next = from;
    return piece;
  }
  piece.next.start = begin.start;
  const bool noSamples = cut(kept.samples, begin.samples, from.samples, recordsMax,
                             piece.records.samples, piece.next.samples);
  const bool noBlocks = cut(kept.blocks, begin.blocks, from.blocks, recordsMax,
                            piece.records.blocks, piece.next.blocks);
  const bool noEvents = cut(kept.events, begin.events, from.events, recordsMax,
                            piece.records.events, piece.next.events);
  piece.isLast = noSamples && noBlocks && noEvents;
  piece.records.truncated =
      from.samples < begin.samples || from.blocks < begin.blocks || from.events < begin.events;
  return piece;
}

}  // namespace rivulet::trace
