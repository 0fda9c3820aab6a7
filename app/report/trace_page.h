// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One page for a person on a recording or trace: HTML that needs no other file, and prints on one
/// sheet. @threadsafety pure.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "trace/analysis/trace_analysis.h"

namespace rivulet::report {

struct TracePage {
  std::string title;  ///< the program or the file
  bool isWrong = false;
  std::string result;                                      ///< one sentence
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and value
  std::string limitedBy;                                   ///< of a stream; may be empty
};

/// @param page  texts as they are, not escaped
[[nodiscard]] std::string tracePageHtml(const TracePage& page,
                                        const trace::TraceAnalysis& analysis);

}  // namespace rivulet::report
