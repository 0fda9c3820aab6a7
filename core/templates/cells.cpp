// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// Method window: counted up like the generator's version, for its own text.
constexpr std::uint64_t kWindowVersion = 1;
/// The same for method credit and for rotary axes.
constexpr std::uint64_t kFurtherVersion = 1;
/// Cells in front of the first window.
constexpr int kWindowHeader = 10;
constexpr int kWindowsMax = 8;
constexpr int kWindowsAheadMax = 8;
constexpr double kStepsPerMm = 1000.0;
/// Method file: some 40 kB a window.
constexpr int kFilePointsMax = 1000;
/// Far beyond every control; keeps the arithmetic of cells small.
constexpr int kRParametersMax = 1'000'000;

/// Method signal needs two windows of at least one slot each.
int pointsPerLoopMin(base::MethodKind method) {
  return method == base::MethodKind::Signal ? 2 : 1;
}

CellMap cellsOf(const TemplateParameters& parameters) {
  CellMap cells;
  cells.axes = parameters.axes;
  cells.rotaryAxes = parameters.rotaryAxes;
  cells.pointsPerLoop = parameters.pointsPerLoop;
  if (base::hasWindows(parameters.method)) {
    const int first = parameters.baseCell;
    cells.run = first;
    cells.delivered = first + 1;
    cells.latched = first + 2;
    cells.executed = first + 3;
    cells.layout = first + 4;  // where the methods of [P1] have it: each sees the other's number
    cells.state = first + 5;
    cells.client = first + 6;
    cells.owner = first + 7;
    cells.heartbeat = first + 8;
    cells.signal = cells.stop = cells.feed = cells.run;
    cells.slotStride =
        parameters.slotStride > 0 ? parameters.slotStride : cellsPerPoint(parameters);
    cells.windows = parameters.windows;
    cells.windowStride = kWindowOwnCells + cells.slotStride * parameters.pointsPerLoop;
    cells.firstSlot = first + kWindowHeader + kWindowOwnCells;
    if (parameters.method == base::MethodKind::File) {
      cells.inFiles = true;
      cells.asked = first + 9;
    } else if (correctionSteps(parameters) > 0 && cells.pointsPerLoop > 0) {
      int next = cells.slotCells(cells.slotCount() - 1).back() + 1;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (parameters.axes[axis]) {
          cells.correction[axis] = next++;
        }
      }
    }
    return cells;
  }
  if (parameters.layout == Layout::Paper) {
    cells.firstSlot = kPaperFirstSlot;
    cells.slotStride = kPaperStride;
  } else {
    cells.firstSlot = kContiguousFirstSlot;
    cells.slotStride = cellsPerPoint(parameters);
  }
  return cells;
}

/// What programs with windows differ in besides points, windows, linear axes and cells, below
/// `kVariants`; 0: method window without rotary axes.
constexpr std::uint64_t kVariants = 18 * 8;
std::uint64_t variantOf(const TemplateParameters& parameters) {
  std::uint64_t rotary = 0;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    rotary |= static_cast<std::uint64_t>(parameters.rotaryAxes[axis]) << axis;
  }
  std::uint64_t kind = 0;
  if (parameters.method == base::MethodKind::Credit) {
    const int ahead = std::clamp(parameters.windowsAhead, 1, kWindowsAheadMax);
    kind = static_cast<std::uint64_t>(ahead * 2 - (parameters.slowDown ? 1 : 0));
  } else if (parameters.method == base::MethodKind::File) {
    kind = 17;
  }
  return kind * 8 + rotary;
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

int cellsPerPoint(const TemplateParameters& parameters) {
  const auto linear = std::count(parameters.axes.begin(), parameters.axes.end(), true);
  return static_cast<int>(linear) + static_cast<int>(base::count(parameters.rotaryAxes));
}

std::vector<int> CellMap::slotCells(int slot) const {
  RIVULET_ASSERT(slot >= 0);
  RIVULET_ASSERT(slot < slotCount());
  // Where a slot has room for all axes, an axis keeps its place whichever of them are chosen.
  const bool fixedPlaces = windows == 0 && slotStride >= static_cast<int>(base::kAxisCount);
  std::vector<int> cells;
  cells.reserve(base::kAxisCount + base::kRotaryAxisCount);
  const int window = windows > 0 ? slot / pointsPerLoop : 0;
  const int place = windows > 0 ? slot % pointsPerLoop : slot;
  const int first = firstSlot + window * windowStride + place * slotStride;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (axes[axis]) {
      cells.push_back(first + static_cast<int>(fixedPlaces ? axis : cells.size()));
    }
  }
  for (const bool isChosen : rotaryAxes) {
    if (isChosen) {
      cells.push_back(first + static_cast<int>(cells.size()));
    }
  }
  return cells;
}

int CellMap::last() const {
  int last = std::max({signal, run, stop, feed, layout, heartbeat, asked});
  for (const int cell : correction) {
    last = std::max(last, cell);
  }
  if (slotCount() > 0) {
    for (const int cell : slotCells(slotCount() - 1)) {
      last = std::max(last, cell);
    }
  }
  return last;
}

double checkFactor(int place) {
  // The fractions of multiples of the golden ratio lie far apart and in no simple proportion, so
  // that changes of coordinates do not cancel. Six digits: the number as the program prints it.
  const double turn = 0.618033988749895 * (place + 1);
  return 1.0 + std::floor((turn - std::floor(turn)) * 1e6) / 1e6;
}

int correctionSteps(const TemplateParameters& parameters) {
  const double steps = std::clamp(parameters.correctionLimitMm, 0.0, kCorrectionLimitMmMax);
  return static_cast<int>(std::lround(steps * kStepsPerMm));
}

namespace {

base::Result<void> checkCorrection(const TemplateParameters& parameters) {
  const double limitMm = parameters.correctionLimitMm;
  if (limitMm == 0.0) {
    return {};
  }
  if (!(limitMm > 0.0) || limitMm > kCorrectionLimitMmMax || correctionSteps(parameters) == 0) {
    return base::fail(TemplateError::BadCorrection,
                      fmt::format("A limit of {} mm for the online correction: choose 0.001 to {} "
                                  "mm, or 0 for none.",
                                  limitMm, kCorrectionLimitMmMax));
  }
  if (!base::hasWindows(parameters.method) || parameters.method == base::MethodKind::File) {
    return base::fail(TemplateError::BadCorrection,
                      fmt::format("Method {} has no online correction: choose method window.",
                                  base::methodName(parameters.method)));
  }
  if (parameters.axes == std::array{false, false, false}) {
    return base::fail(TemplateError::BadCorrection,
                      "Only X, Y and Z can be corrected online, but none of them is selected.");
  }
  return {};
}

}  // namespace

base::Result<CellMap> planCells(const TemplateParameters& parameters) {
  if (cellsPerPoint(parameters) == 0) {
    return base::fail(TemplateError::NoAxis,
                      "No axis is selected: choose at least one of X, Y, Z.");
  }
  if (base::any(parameters.rotaryAxes) && !base::streamsRotary(parameters.method)) {
    return base::fail(
        TemplateError::RotaryNeedsWindow,
        fmt::format("Method {} moves only X, Y and Z: choose method window for rotary axes.",
                    base::methodName(parameters.method)));
  }
  if (cellsPerPoint(parameters) > static_cast<int>(base::kStreamedAxesMax)) {
    return base::fail(
        TemplateError::TooManyAxes,
        fmt::format("{} axes are selected ({}): choose at most {}.", cellsPerPoint(parameters),
                    axisLetters(parameters), base::kStreamedAxesMax));
  }
  if (base::Result<void> correction = checkCorrection(parameters); !correction) {
    return base::fail(correction.error());
  }
  const int min = pointsPerLoopMin(parameters.method);
  if (parameters.pointsPerLoop < min) {
    return base::fail(
        TemplateError::TooFewPointsPerLoop,
        fmt::format("Method {} needs N of at least {}; it is {}.",
                    base::methodName(parameters.method), min, parameters.pointsPerLoop));
  }
  if (base::hasWindows(parameters.method)) {
    if (parameters.windows < 1 || parameters.windows > kWindowsMax) {
      return base::fail(TemplateError::BadCells, fmt::format("{} windows: choose 1 to {}.",
                                                             parameters.windows, kWindowsMax));
    }
    if (parameters.windowsAhead < 1 || parameters.windowsAhead > kWindowsAheadMax) {
      return base::fail(TemplateError::BadCells,
                        fmt::format("{} windows ahead of the motion: choose 1 to {}.",
                                    parameters.windowsAhead, kWindowsAheadMax));
    }
    if (parameters.baseCell < 0 || parameters.baseCell > kRParametersMax) {
      return base::fail(TemplateError::BadCells,
                        fmt::format("The cells cannot begin at R{}.", parameters.baseCell));
    }
    constexpr int kStrideMax = 100;
    if (parameters.slotStride != 0 &&
        (parameters.slotStride < cellsPerPoint(parameters) || parameters.slotStride > kStrideMax)) {
      return base::fail(
          TemplateError::BadCells,
          fmt::format("{} cells per point: choose {} to {}, or 0 for as many as axes.",
                      parameters.slotStride, cellsPerPoint(parameters), kStrideMax));
    }
  }
  if (parameters.method == base::MethodKind::File && parameters.pointsPerLoop > kFilePointsMax) {
    return base::fail(TemplateError::DoesNotFit,
                      fmt::format("{} points per file: choose at most {}.",
                                  parameters.pointsPerLoop, kFilePointsMax));
  }
  // Before any arithmetic with N: more points than R-parameters never fit.
  if (parameters.pointsPerLoop > kRParametersMax) {
    return base::fail(
        TemplateError::DoesNotFit,
        fmt::format("N = {} exceeds the R-parameters of every control: choose at most {}.",
                    parameters.pointsPerLoop, pointsPerLoopMax(parameters)));
  }
  const CellMap cells = cellsOf(parameters);
  if (cells.last() >= parameters.rParameterCount) {
    const int fits = pointsPerLoopMax(parameters);
    const std::string largest =
        fits == 0 ? std::string("none fits") : fmt::format("N = {} is the largest that fits", fits);
    return base::fail(TemplateError::DoesNotFit,
                      fmt::format("N = {} needs R-parameters up to R{}, but the control has {}: "
                                  "{}, or set MD28050 to {}.",
                                  parameters.pointsPerLoop, cells.last(),
                                  parameters.rParameterCount, largest, cells.last() + 1));
  }
  return cells;
}

int pointsPerLoopMax(const TemplateParameters& parameters) {
  const int axes = cellsPerPoint(parameters);
  if (axes == 0) {
    return 0;
  }
  if (parameters.method == base::MethodKind::File) {
    return parameters.baseCell + kWindowHeader <= parameters.rParameterCount ? kFilePointsMax : 0;
  }
  TemplateParameters one = parameters;
  one.pointsPerLoop = 1;
  const CellMap cells = cellsOf(one);
  if (base::hasWindows(parameters.method)) {
    const auto corrections = static_cast<int>(std::count_if(
        cells.correction.begin(), cells.correction.end(), [](int cell) { return cell >= 0; }));
    const int perWindow = (parameters.rParameterCount - corrections - cells.windowCount(0)) /
                              std::clamp(parameters.windows, 1, kWindowsMax) -
                          kWindowOwnCells;
    // The last cells of the last slot may stay unused where the stride leaves room.
    int fits = std::max(0, perWindow / cells.slotStride);
    for (one.pointsPerLoop = fits + 1; cellsOf(one).last() < parameters.rParameterCount;
         ++one.pointsPerLoop) {
      fits = one.pointsPerLoop;
    }
    return fits;
  }
  const int room = parameters.rParameterCount - 1 - cells.last();
  const int fits = room < 0 ? 0 : 1 + room / cells.slotStride;
  return fits < pointsPerLoopMin(parameters.method) ? 0 : fits;
}

std::string axisLetters(const TemplateParameters& parameters) {
  std::string letters;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (parameters.axes[axis]) {
      letters += base::kAxisNames[axis];
    }
  }
  return letters + base::rotaryNames(parameters.rotaryAxes);
}

base::Result<void> chooseAxes(TemplateParameters& parameters, std::string_view letters) {
  std::array<bool, base::kAxisCount> axes{};
  base::RotarySet rotaryAxes{};
  for (const char letter : letters) {
    const std::size_t linear = std::string_view("XYZ").find(letter);
    const std::size_t rotary = std::string_view("ABC").find(letter);
    bool* const chosen = linear != std::string_view::npos   ? &axes[linear]
                         : rotary != std::string_view::npos ? &rotaryAxes[rotary]
                                                            : nullptr;
    if (chosen == nullptr || *chosen) {
      return base::fail(
          TemplateError::BadAxes,
          fmt::format("Axes \"{}\": write each of X Y Z A B C at most once, as in XYZAC.",
                      letters));
    }
    *chosen = true;
  }
  parameters.axes = axes;
  parameters.rotaryAxes = rotaryAxes;
  return {};
}

int layoutNumber(const TemplateParameters& parameters) {
  std::uint64_t axes = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    axes |= static_cast<std::uint64_t>(parameters.axes[axis]) << axis;
  }
  // A prime below a million: multiplying and shifting modulo it keeps different programs apart
  // (as long as N < 20833) and spreads the numbers, so that a stray value is not taken for one.
  constexpr std::uint64_t kPrime = 999'983;
  constexpr std::uint64_t kSpread = 618'033;
  constexpr std::uint64_t kVersionShift = 271'829;
  const auto points = static_cast<std::uint64_t>(std::max(parameters.pointsPerLoop, 0));
  if (!base::hasWindows(parameters.method)) {
    const bool signal = parameters.method == base::MethodKind::Signal;
    const std::uint64_t program =
        !signal ? 0 : (parameters.signalStop == SignalStop::EachSignal ? 1 : 2);
    const std::uint64_t layout = parameters.layout == Layout::Paper ? 0 : 1;
    const std::uint64_t code = ((points * 3 + program) * 2 + layout) * 8 + axes;
    return static_cast<int>((code % kPrime * kSpread + kGeneratorVersion * kVersionShift) %
                            kPrime) +
           1;
  }
  constexpr std::uint64_t kCellsSpread = 367'879;
  const std::uint64_t where = static_cast<std::uint64_t>(std::max(parameters.baseCell, 0)) * 128 +
                              static_cast<std::uint64_t>(std::max(parameters.slotStride, 0));
  const std::uint64_t windows =
      static_cast<std::uint64_t>(std::clamp(parameters.windows, 1, kWindowsMax) - 1);
  const std::uint64_t variant = variantOf(parameters);
  const auto correction = static_cast<std::uint64_t>(correctionSteps(parameters));
  if (variant == 0 && correction == 0) {
    // Numbers of their own: apart from those of [P1]'s methods below N = 10416, and from each
    // other below N = 7812 with the cells where they are by default.
    constexpr std::uint64_t kWindowFirst = 500'000;
    const std::uint64_t code =
        kWindowFirst + (points * kWindowsMax + windows) * 8 + axes + where % kPrime * kCellsSpread;
    return static_cast<int>((code % kPrime * kSpread + kWindowVersion * kVersionShift) % kPrime) +
           1;
  }
  // All others lie above, up to 2^24: a 32-bit real still holds them. Apart from each other below
  // N = 1712 with the cells where they are by default. Limits of
  // the correction are spread over all numbers: there are more programs than numbers then.
  constexpr std::uint64_t kFurtherPrime = 15'777'217;
  constexpr std::uint64_t kFurtherSpread = 9'750'853;
  constexpr std::uint64_t kFurtherShift = 4'288'771;
  constexpr std::uint64_t kCorrectionSpread = 6'026'359;
  const std::uint64_t code = ((points * kVariants + variant) * kWindowsMax + windows) * 8 + axes +
                             where % kFurtherPrime * kCellsSpread + correction * kCorrectionSpread;
  return static_cast<int>(
      kPrime + 1 +
      (code % kFurtherPrime * kFurtherSpread + kFurtherVersion * kFurtherShift) % kFurtherPrime);
}

}  // namespace rivulet::templates
