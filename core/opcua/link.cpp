// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/link.h"

#include <limits>

namespace rivulet::opcua {

base::Result<trace::TracePiece> Control::fetchTracePiece(const trace::TracePosition& from) {
  const base::Result<trace::ControlTrace> whole = fetchTrace();
  if (!whole) {
    return base::fail(whole.error());
  }
  trace::TracePosition begin;
  begin.start = from.start;
  trace::TracePiece piece =
      trace::cutPiece(*whole, begin, from, std::numeric_limits<std::size_t>::max());
  piece.records.truncated = whole->truncated;
  return piece;
}

}  // namespace rivulet::opcua
