// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Signals as a table that other tools, and `importTrace`, read. @threadsafety pure.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/instant.h"
#include "trace/envelope.h"

namespace rivulet::trace {

struct ExportedSignal {
  std::string name;
  std::string unit;  ///< may be empty
  std::shared_ptr<const Envelope> samples;
};

/// Signals with the same instants.
struct SharedTimes {
  std::size_t begin = 0;  ///< index of the first sample, the same for all
  std::size_t end = 0;
  std::vector<const ExportedSignal*> members;  ///< not empty
};
/// The samples between two instants, both included; those with the most samples last.
[[nodiscard]] std::vector<SharedTimes> sharedTimesOf(const std::vector<ExportedSignal>& exported,
                                                     base::Instant from, base::Instant to);

/// A table of the samples between two instants, both included, without loss. Semicolons separate
/// the columns: commas would be taken for decimal signs where all numbers are whole.
/// Signals with the same instants share a column of time, others have one of their own before them.
/// Numbers have a decimal point; a gap is "nan".
/// @param timeName, timeUnit  of the columns of time: "t", "s"
[[nodiscard]] std::string printSignals(const std::vector<ExportedSignal>& exported,
                                       base::Instant from, base::Instant to,
                                       std::string_view timeName, std::string_view timeUnit);

}  // namespace rivulet::trace
