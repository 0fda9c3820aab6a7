// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/contract.h"
#include "base/error.h"

namespace rivulet::templates {

namespace {

/// Counted up whenever the text of a template changes its meaning for the client.
constexpr std::uint64_t kGeneratorVersion = 1;

constexpr int kPaperFirstSlot = 11;
constexpr int kPaperStride = 10;
constexpr int kContiguousFirstSlot = 10;

int chosenAxes(const std::array<bool, base::kAxisCount>& axes) {
  return static_cast<int>(std::count(axes.begin(), axes.end(), true));
}

/// Method signal needs two windows of at least one slot each.
int pointsPerLoopMin(base::MethodKind method) {
  return method == base::MethodKind::Signal ? 2 : 1;
}

CellMap cellsOf(const TemplateParameters& parameters) {
  CellMap cells;
  cells.axes = parameters.axes;
  cells.pointsPerLoop = parameters.pointsPerLoop;
  if (parameters.layout == Layout::Paper) {
    cells.firstSlot = kPaperFirstSlot;
    cells.slotStride = kPaperStride;
  } else {
    cells.firstSlot = kContiguousFirstSlot;
    cells.slotStride = chosenAxes(parameters.axes);
  }
  return cells;
}

}  // namespace

std::error_code make_error_code(TemplateError code) {
  static const base::NamedCategory category("templates");
  return {static_cast<int>(code), category};
}

std::string_view layoutName(Layout layout) {
  return layout == Layout::Paper ? "paper" : "contiguous";
}

std::optional<Layout> layoutFromName(std::string_view name) {
  for (const Layout layout : {Layout::Paper, Layout::Contiguous}) {
    if (layoutName(layout) == name) {
      return layout;
    }
  }
  return std::nullopt;
}

std::vector<int> CellMap::slotCells(int slot) const {
  RIVULET_ASSERT(slot >= 0);
  RIVULET_ASSERT(slot < pointsPerLoop);
  // Where a slot has room for all axes, an axis keeps its place whichever of them are chosen.
  const bool fixedPlaces = slotStride >= static_cast<int>(base::kAxisCount);
  std::vector<int> cells;
  cells.reserve(base::kAxisCount);
  const int first = firstSlot + slot * slotStride;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (axes[axis]) {
      cells.push_back(first + static_cast<int>(fixedPlaces ? axis : cells.size()));
    }
  }
  return cells;
}

int CellMap::last() const {
  int last = std::max({signal, run, stop, feed, layout});
  if (pointsPerLoop > 0) {
    for (const int cell : slotCells(pointsPerLoop - 1)) {
      last = std::max(last, cell);
    }
  }
  return last;
}

base::Result<CellMap> planCells(const TemplateParameters& parameters) {
  if (chosenAxes(parameters.axes) == 0) {
    return base::fail(TemplateError::NoAxis, "No axis is chosen: choose at least one of X, Y, Z.");
  }
  const int min = pointsPerLoopMin(parameters.method);
  if (parameters.pointsPerLoop < min) {
    return base::fail(
        TemplateError::TooFewPointsPerLoop,
        fmt::format("Method {} needs N of at least {}; it is {}.",
                    base::methodName(parameters.method), min, parameters.pointsPerLoop));
  }
  // Before any arithmetic with N: more points than R-parameters never fit.
  constexpr int kRParametersMax = 1'000'000;
  if (parameters.pointsPerLoop > kRParametersMax) {
    return base::fail(TemplateError::DoesNotFit,
                      fmt::format("N = {} is beyond every control: choose at most {}.",
                                  parameters.pointsPerLoop, pointsPerLoopMax(parameters)));
  }
  const CellMap cells = cellsOf(parameters);
  if (cells.last() >= parameters.rParameterCount) {
    const int fits = pointsPerLoopMax(parameters);
    const std::string largest =
        fits == 0 ? std::string("none fits") : fmt::format("N = {} is the largest that fits", fits);
    return base::fail(
        TemplateError::DoesNotFit,
        fmt::format("N = {} needs R-parameters up to R{}, and the control has {}: {}, or set "
                    "MD28050 to {}.",
                    parameters.pointsPerLoop, cells.last(), parameters.rParameterCount, largest,
                    cells.last() + 1));
  }
  return cells;
}

int pointsPerLoopMax(const TemplateParameters& parameters) {
  const int axes = chosenAxes(parameters.axes);
  if (axes == 0) {
    return 0;
  }
  TemplateParameters one = parameters;
  one.pointsPerLoop = 1;
  const CellMap cells = cellsOf(one);
  const int room = parameters.rParameterCount - 1 - cells.last();
  const int fits = room < 0 ? 0 : 1 + room / cells.slotStride;
  return fits < pointsPerLoopMin(parameters.method) ? 0 : fits;
}

int layoutNumber(const TemplateParameters& parameters) {
  std::uint64_t axes = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    axes |= static_cast<std::uint64_t>(parameters.axes[axis]) << axis;
  }
  const bool signal = parameters.method == base::MethodKind::Signal;
  const std::uint64_t program =
      !signal ? 0 : (parameters.signalStop == SignalStop::EachSignal ? 1 : 2);
  const std::uint64_t layout = parameters.layout == Layout::Paper ? 0 : 1;
  const std::uint64_t code =
      ((static_cast<std::uint64_t>(std::max(parameters.pointsPerLoop, 0)) * 3 + program) * 2 +
       layout) *
          8 +
      axes;
  // A prime below a million: multiplying and shifting modulo it keeps different programs apart
  // (as long as N < 20833) and spreads the numbers, so that a stray value is not taken for one.
  constexpr std::uint64_t kPrime = 999'983;
  constexpr std::uint64_t kSpread = 618'033;
  constexpr std::uint64_t kVersionShift = 271'829;
  return static_cast<int>((code % kPrime * kSpread + kGeneratorVersion * kVersionShift) % kPrime) +
         1;
}

}  // namespace rivulet::templates
