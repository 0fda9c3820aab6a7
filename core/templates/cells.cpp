// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/contract.h"
#include "base/error.h"
#include "templates/method_template.h"

namespace rivulet::templates {

namespace {

constexpr double kStepsPerMm = 1000.0;
/// More points than R-parameters never fit: above this, no arithmetic is done with N.
constexpr int kPointsMax = 1'000'000;

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

std::string_view targetName(TargetControl target) {
  return target == TargetControl::Sinumerik ? "sinumerik" : "linuxcnc";
}

std::string_view targetTitle(TargetControl target) {
  return target == TargetControl::Sinumerik ? "SINUMERIK" : "LinuxCNC";
}

std::optional<TargetControl> targetFromName(std::string_view name) {
  for (const TargetControl target : {TargetControl::Sinumerik, TargetControl::LinuxCnc}) {
    if (targetName(target) == name) {
      return target;
    }
  }
  return std::nullopt;
}

std::vector<int> CellMap::slotCells(int slot) const {
  RIVULET_ASSERT(slot >= 0);
  RIVULET_ASSERT(slot < slotCount());
  // If a slot has room for all axes, each axis keeps its place whichever axes are selected.
  const bool fixedPlaces = windows == 0 && slotStride >= static_cast<int>(base::kAxisCount);
  std::vector<int> cells;
  cells.reserve(base::kAxisCount + base::kRotaryAxisCount + 1);
  const int window = windows > 0 ? slot / pointsPerLoop : 0;
  const int place = windows > 0 ? slot % pointsPerLoop : slot;
  const int first = firstSlot + window * windowStride + place * slotStride +
                    (packed && place > 0 ? axisCount() - 1 : 0);
  if (packed && place > 0) {
    cells.push_back(first);
    if (feedPerPoint) {
      cells.push_back(first + 1);
    }
    return cells;
  }
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
  if (feedPerPoint) {
    cells.push_back(first + static_cast<int>(cells.size()));
  }
  return cells;
}

int CellMap::last() const {
  int last = std::max({signal, run, stop, feed, layout, heartbeat, asked, overrideActs, factor});
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

double WindowProtocol::checkFactor(int place) {
  // The fractions of multiples of the golden ratio lie far apart and in no simple proportion, so
  // that changes of coordinates do not cancel. Six digits: the number as the program prints it.
  const double turn = 0.618033988749895 * (place + 1);
  return 1.0 + std::floor((turn - std::floor(turn)) * 1e6) / 1e6;
}

int correctionSteps(const WindowSettings& settings) {
  const double steps = settings.liftMm != 0.0
                           ? std::clamp(settings.liftMm, 0.0, kLiftMmMax)
                           : std::clamp(settings.correctionLimitMm, 0.0, kCorrectionLimitMmMax);
  return static_cast<int>(std::lround(steps * kStepsPerMm));
}

namespace {

/// Whether the cells fit the control or not.
base::Result<CellMap> planCellsAnywhere(const TemplateParameters& parameters) {
  const MethodTemplate& method = methodTemplate(parameters);
  const int axes = axisCount(parameters);
  if (!hasTemplate(parameters)) {
    return base::fail(
        TemplateError::NotOnTarget,
        fmt::format("There is no program of method {} for {}: choose method window or credit.",
                    base::methodName(parameters.method), targetTitle(parameters.target)));
  }
  if (axes == 0) {
    return base::fail(TemplateError::NoAxis,
                      "No axis is selected: choose at least one of X, Y, Z.");
  }
  if (base::any(parameters.rotaryAxes) && !base::streamsRotary(parameters.method)) {
    return base::fail(
        TemplateError::RotaryNeedsWindow,
        fmt::format("Method {} moves only X, Y and Z: choose method window for rotary axes.",
                    base::methodName(parameters.method)));
  }
  if (axes > static_cast<int>(base::kStreamedAxesMax)) {
    return base::fail(TemplateError::TooManyAxes,
                      fmt::format("{} axes are selected ({}): choose at most {}.", axes,
                                  axisLetters(parameters), base::kStreamedAxesMax));
  }
  if (parameters.pointsPerLoop < method.pointsMin()) {
    return base::fail(TemplateError::TooFewPointsPerLoop,
                      fmt::format("Method {} needs N of at least {}; it is {}.",
                                  base::methodName(parameters.method), method.pointsMin(),
                                  parameters.pointsPerLoop));
  }
  if (base::Result<void> settings = method.check(parameters); !settings) {
    return base::fail(settings.error());
  }
  if (parameters.pointsPerLoop > kPointsMax) {
    return base::fail(
        TemplateError::DoesNotFit,
        fmt::format("N = {} exceeds the R-parameters of every control: choose at most {}.",
                    parameters.pointsPerLoop, pointsPerLoopMax(parameters)));
  }
  return method.cells(parameters);
}

}  // namespace

base::Result<CellMap> planCells(const TemplateParameters& parameters) {
  base::Result<CellMap> plan = planCellsAnywhere(parameters);
  if (!plan) {
    return plan;
  }
  const CellMap& cells = *plan;
  if (cells.last() >= parameters.rParameterCount) {
    const int fits = pointsPerLoopMax(parameters);
    const std::string largest =
        fits == 0 ? std::string("none fits") : fmt::format("N = {} is the largest that fits", fits);
    return base::fail(
        TemplateError::DoesNotFit,
        fmt::format("N = {} needs R-parameters up to R{}, but the control has {}: {}{}.",
                    parameters.pointsPerLoop, cells.last(), parameters.rParameterCount, largest,
                    parameters.target == TargetControl::Sinumerik
                        ? fmt::format(", or set MD28050 to {}", cells.last() + 1)
                        : std::string()));
  }
  return plan;
}

int pointsPerLoopMax(const TemplateParameters& parameters) {
  return axisCount(parameters) == 0 ? 0 : methodTemplate(parameters).pointsMax(parameters);
}

int axisCount(const TemplateParameters& parameters) {
  const auto linear = std::count(parameters.axes.begin(), parameters.axes.end(), true);
  return static_cast<int>(linear) + static_cast<int>(base::count(parameters.rotaryAxes));
}

int cellsPerPoint(const TemplateParameters& parameters) {
  const bool hasFeed = parameters.feedPerPoint && base::fillsWindows(parameters.method);
  return axisCount(parameters) - cellsOfFirstPoint(parameters) + (hasFeed ? 1 : 0);
}

int cellsOfFirstPoint(const TemplateParameters& parameters) {
  return packingOf(parameters) ? axisCount(parameters) - 1 : 0;
}

std::optional<base::Packing> packingOf(const TemplateParameters& parameters) {
  return parameters.packed && base::fillsWindows(parameters.method) && axisCount(parameters) > 0
             ? std::optional(base::Packing(axisCount(parameters)))
             : std::nullopt;
}

int longestWrite(const TemplateParameters& parameters) {
  return methodTemplate(parameters).longestWrite(parameters);
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

}  // namespace rivulet::templates
