// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The result of an experiment on the virtual machine: figures of [P1] and ours, tables and plots.
/// All experiments have this form, so that one function each writes text, JSON, CSV, SVG and the
/// report. @threadsafety plain values.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/plot.h"

namespace rivulet::papers {

/// What the agreement of a figure with its reference says.
enum class Mark {
  None,            ///< not stated
  Input,           ///< the machine was given it
  Fitted,          ///< free parameters of the machine were chosen by it
  ByConstruction,  ///< follows from how program or machine are built; a fault of them would show
  Predicted,       ///< nothing was chosen by it
};

/// One figure, its reference, and the range in which it must be.
struct Check {
  std::string what;    ///< "read, 20 parameters in a list, average"
  std::string unit;    ///< "ms"; empty for a count or ratio
  std::string source;  ///< "[P1] Table I"
  double reference = std::numeric_limits<double>::quiet_NaN();  ///< not a number: none is given
  double ours = 0.0;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  Mark mark = Mark::None;
  /// The same figure of a machine or model without what is shown; not a number: none was run.
  double nullModel = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] bool passed() const { return accepts(ours); }
  /// Then the check says nothing of what it is named after.
  [[nodiscard]] bool nullModelPasses() const { return accepts(nullModel); }
  [[nodiscard]] bool accepts(double value) const { return value >= lowest && value <= highest; }
  /// ours / reference - 1; not a number without a reference or with reference 0.
  [[nodiscard]] double deviation() const {
    return reference == 0.0 ? std::numeric_limits<double>::quiet_NaN() : ours / reference - 1.0;
  }
};

/// Cells are text as printed: numbers locale-free, "" for none.
struct Table {
  std::string title;
  std::vector<std::string> columns;  ///< with units: "d_min (mm)"
  std::vector<std::vector<std::string>> rows;
};

using base::Plot;
using base::Series;
using base::SeriesStyle;

struct Experiment {
  std::string name;   ///< "table1"
  std::string title;  ///< one line
  std::string setup;  ///< what was run: contour, feeds, seeds; sentences
  std::vector<Check> checks;
  std::vector<Table> tables;
  std::vector<Plot> plots;
  std::vector<std::string> notes;  ///< what a reader must know to judge the figures

  [[nodiscard]] bool passed() const {
    for (const Check& check : checks) {
      if (!check.passed()) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace rivulet::papers
