// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Signals as a table that other tools, and `importTrace`, read. @threadsafety pure.
#pragma once

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

/// A table of the samples between two instants, both included, without loss. Semicolons separate
/// the columns: commas would be taken for decimal signs where all numbers are whole.
/// Signals with the same instants share a column of time, others have one of their own before them.
/// Numbers have a decimal point; a gap is "nan".
/// @param timeName, timeUnit  of the columns of time: "t", "s"
[[nodiscard]] std::string printSignals(const std::vector<ExportedSignal>& exported,
                                       base::Instant from, base::Instant to,
                                       std::string_view timeName, std::string_view timeUnit);

}  // namespace rivulet::trace
