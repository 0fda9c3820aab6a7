// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a recording holds, and where in the file: made while it is written, kept at its end
/// (docs/formats.md). Its size does not depend on the length of the run. @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "trace/value_range.h"

namespace rivulet::trace {

/// Frames that follow one another in the file.
struct IndexGroup {
  std::uint64_t bytes = 0;  ///< in the file
  std::uint64_t frames = 0;
  base::Instant first = base::Instant::max();  ///< of its records
  base::Instant last = base::Instant::min();   ///< before `first`: no record has a time
  std::uint64_t samples = 0;                   ///< live observations
  std::uint64_t accesses = 0;
  std::uint64_t notes = 0;
  std::uint64_t controlSamples = 0;
  std::array<ValueRange, base::kAxisCount> positionMm;  ///< of the live observations
  ValueRange feedMmPerS;                                ///< of the live observations
  ValueRange accessMs;

  void add(const IndexGroup& next);
};

struct RecordingIndex {
  /// Finer groups are joined two by two.
  static constexpr std::size_t kGroupsMax = 4096;

  std::vector<IndexGroup> groups;  ///< from the beginning of the file, without a gap
  /// Lines of the recording that the others need to be understood; empty: not come yet.
  std::string head;         ///< format and settings
  std::string traceHeader;  ///< first line of the control's trace
  std::string end;          ///< how the run ended

  /// @param lines  text of a frame of `bytes` bytes in the file
  void addFrame(std::string_view lines, std::uint64_t bytes);
  [[nodiscard]] IndexGroup total() const;

 private:
  std::uint64_t m_framesPerGroup = 1;
};

[[nodiscard]] std::string printIndex(const RecordingIndex& index);
/// @return nothing: it is damaged, or of a later version
[[nodiscard]] std::optional<RecordingIndex> parseIndex(std::string_view text);

}  // namespace rivulet::trace
