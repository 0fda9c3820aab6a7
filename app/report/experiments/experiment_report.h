// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An experiment as text, JSON, CSV, as a section of the report, and as a page. @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
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

/// What a page of experiments was made with, as rows of name and value.
using ReportFacts = std::vector<std::pair<std::string, std::string>>;

/// All experiments as one page that needs no other file: their pictures are in it. It begins with
/// the facts, and with the SHA-256 of all figures, so that two pages can be compared.
[[nodiscard]] std::string experimentPage(const std::vector<papers::Experiment>& experiments,
                                         const ReportFacts& facts);

}  // namespace rivulet::report
