// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An experiment as text, JSON, CSV, and as a section of the report. @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "papers/experiment.h"

namespace rivulet::report {

/// For a terminal: the paper's figures and ours, then the tables and notes.
[[nodiscard]] std::string experimentText(const papers::Experiment& experiment);

[[nodiscard]] nlohmann::ordered_json experimentJson(const papers::Experiment& experiment);

/// Checks, tables and plotted series, one after another, each with a heading; fields with commas
/// or quotes are quoted.
[[nodiscard]] std::string experimentCsv(const papers::Experiment& experiment);

/// A section of a Markdown document.
/// @param images  path of each plot as the document names it, one per plot
[[nodiscard]] std::string experimentMarkdown(const papers::Experiment& experiment,
                                             const std::vector<std::string>& images);

}  // namespace rivulet::report
