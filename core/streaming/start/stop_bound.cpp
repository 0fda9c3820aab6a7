// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/stop_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/axes.h"
#include "streaming/methods/pause_placement.h"

namespace rivulet::streaming {

namespace {

/// Parts of a move are of the same length but for this share.
constexpr double kRounding = 1e-6;

}  // namespace

StopBound stopBound(std::span<const gcode::StreamPoint> points, std::optional<base::Vec3> toolMm,
                    const RunSettings& settings) {
  StopBound bound;
  if (points.empty()) {
    return bound;
  }
  const auto& parameters = settings.parameters;
  const auto perLoop = static_cast<std::size_t>(std::max(1, parameters.pointsPerLoop));
  // Others end at the end of their loop.
  std::vector<std::size_t> begins = base::hasWindows(parameters.method)
                                        ? cutWindows(points, perLoop, windowCut(settings)).begins
                                        : evenPauses(points, perLoop, true).begins;
  begins.push_back(points.size());
  const double secondsMax = windowCut(settings).secondsMax;
  std::optional<gcode::StreamPoint> from;
  if (toolMm) {
    from = points.front();
    from->positionMm = *toolMm;
  }
  // After so many points.
  std::vector<double> reachedS{0.0};
  std::vector<double> reachedMm{0.0};
  for (const gcode::StreamPoint& to : points) {
    const double seconds = from ? moveS(*from, to, settings.feedMmPerS) : 0.0;
    reachedS.push_back(reachedS.back() + seconds);
    reachedMm.push_back(reachedMm.back() +
                        (from ? base::distance(from->positionMm, to.positionMm) : 0.0));
    const bool isLong = secondsMax > 0.0 && seconds > (1.0 + kRounding) * secondsMax;
    if (isLong && (!bound.longMove || seconds > bound.longMove->seconds)) {
      bound.longMove = {to.line, seconds, &to == &points.front()};
    }
    from = to;
  }
  const auto together = static_cast<std::size_t>(windowsAfterStop(parameters));
  for (std::size_t window = 0; window + 1 < begins.size(); ++window) {
    const std::size_t to = begins[std::min(window + together, begins.size() - 1)];
    bound.seconds = std::max(bound.seconds, reachedS[to] - reachedS[begins[window]]);
    bound.mm = std::max(bound.mm, reachedMm[to] - reachedMm[begins[window]]);
  }
  return bound;
}

std::string describe(const StopBound& bound, FeedProof proof, bool hasFeedCell) {
  std::string text = fmt::format(
      "Stop: the control still executes {} that is in motion, at most {:.1f} s and {:.0f} mm.",
      hasFeedCell ? "the window" : "the loop", bound.seconds, bound.mm);
  if (bound.longMove) {
    const std::string move =
        fmt::format("move {} line {} alone takes {:.1f} s", bound.longMove->isFirst ? "to" : "of",
                    bound.longMove->line.value, bound.longMove->seconds);
    text += bound.longMove->isFirst
                ? " The first " + move + ": bring the tool nearer before the start."
                : " The " + move + " and is not divided.";
  }
  if (hasFeedCell) {
    text += ' ' + std::string(describe(proof));
  }
  return text;
}

gcode::MoveRules moveRules(const RunSettings& settings) {
  gcode::MoveRules rules;
  rules.tolerance = settings.tolerance;
  rules.onSteps = settings.tolerance != 0.0 && templates::packingOf(settings.parameters);
  if (base::hasWindows(settings.parameters.method)) {
    rules.secondsMax = windowCut(settings).secondsMax;
  }
  if (rules.secondsMax > 0.0 && settings.programFeeds) {
    rules.feeds = settings.programFeeds;
  } else if (rules.secondsMax > 0.0) {
    rules.feedMmPerS = settings.feedMmPerS;
  }
  return rules;
}

double windowSMaxOf(FeedProof proof, templates::TargetControl target, double limitS) {
  // A LinuxCNC has no such actions: its way through the HAL is tried before each program.
  const bool isProved = proof == FeedProof::Proved || target == templates::TargetControl::LinuxCnc;
  return isProved ? 0.0 : limitS;
}

}  // namespace rivulet::streaming
