// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/trace_parts.h"

#include "opcua/error.h"
#include "opcua/node_map.h"

namespace rivulet::opcua {

namespace {

/// A trace that is larger is an error of the other side.
constexpr std::uint64_t kTraceBytesMax = std::uint64_t{1} << 30U;
/// Parts that are smaller, but the last, are refused: they would keep the client busy for ever.
constexpr std::size_t kPartBytesMin = std::size_t{1} << 16U;

}  // namespace

base::Result<trace::ControlTrace> joinTrace(
    const std::function<base::Result<TracePart>(std::uint64_t from)>& fetch) {
  std::string text;
  for (;;) {
    const auto part = fetch(text.size());
    if (!part) {
      return base::fail(part.error());
    }
    text.append(part->bytes);
    if (text.size() == part->total) {
      return trace::parseControlTrace(text);
    }
    if (part->bytes.size() < kPartBytesMin || text.size() > part->total ||
        part->total > kTraceBytesMax) {
      return base::fail(LinkError::Rejected,
                        "The trace of the control changed while it was fetched. Fetch it again.",
                        std::string(kFetchTrace));
    }
  }
}

}  // namespace rivulet::opcua
