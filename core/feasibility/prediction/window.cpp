// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <span>

#include "base/contract.h"
#include "feasibility/client_turn.h"
#include "feasibility/prediction/control_line.h"
#include "feasibility/prediction/methods.h"

namespace rivulet::feasibility {

/// Two windows, mean times: the client brings window n+2 from the moment it sees that window n has
/// been copied; the control copies a window when it stands and the window is there.
Prediction predictWindows(const std::vector<gcode::StreamPoint>& points,
                          const OperatingPoint& operatingPoint, const StreamModel& model,
                          base::Vec3 startMm) {
  RIVULET_ASSERT(operatingPoint.pointsPerLoop >= 1);
  constexpr std::size_t kWindows = 2;
  const Clockwork clock(model.control);
  const auto perWindow = static_cast<std::size_t>(operatingPoint.pointsPerLoop);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool changes =
        i > 0 && !operatingPoint.feedPerPoint && points[i].feedMmPerS != points[i - 1].feedMmPerS;
    if (i == 0 || changes || i == begins.back() + perWindow) {
      begins.push_back(i);
    }
  }
  const std::size_t count = begins.size();
  const double nodeMs = base::toMilliseconds(model.access.nodeMean);
  // Signs of life come between the other accesses.
  const double beatMs = base::toMilliseconds(model.access.writeOverhead) + nodeMs;
  const double slowdown = 1.0 + beatMs / base::toMilliseconds(kUsualBeatInterval);
  const double pollMs = slowdown * (base::toMilliseconds(model.access.readOverhead) + nodeMs);
  const ClientTurn turn = turnOf(operatingPoint.turn());
  const double bringMs = slowdown * (2.0 * base::toMilliseconds(model.access.writeOverhead) +
                                     (turn.content + turn.number) * nodeMs);
  // Relatch, the decision, and the copy with its check: see the generator.
  const double blocksPerPoint = operatingPoint.cellsOfFirst > 0 ? 2.0 : 1.4;
  constexpr double kBlocks = 9.0;
  const double readyMs =
      clock.relatchMs +
      clock.blockMs * (kBlocks + blocksPerPoint * static_cast<double>(perWindow));
  // A pass of the waiting loop: relatch, its blocks, and a dwell of 20 ms.
  const double passMs = clock.relatchMs + 10.0 * clock.blockMs + 20.0;
  const double displayMs =
      base::toMilliseconds(model.access.readOverhead) + (operatingPoint.cellsPerPoint + 1) * nodeMs;
  const double displayIntervalMs = base::toMilliseconds(kDisplayIntervalMax);
  double displayedMs = 0.0;
  std::vector<double> broughtMs(count, 0.0);
  std::vector<double> copiedMs(count, 0.0);
  double endMs = 0.0;
  double standingMs = 0.0;
  double waitingMs = 0.0;
  base::Vec3 fromMm = startMm;
  for (std::size_t window = 0; window < count; ++window) {
    if (window >= kWindows) {
      const double seenMs = copiedMs[window - kWindows] + 1.5 * pollMs;
      double freeMs = broughtMs[window - 1];
      if (seenMs >= freeMs + displayMs) {
        displayedMs = freeMs = seenMs;  // the display is read while the client waits
      } else if (freeMs >= displayedMs + displayIntervalMs) {
        displayedMs = freeMs;
        freeMs += displayMs;
      }
      broughtMs[window] = std::max(freeMs, seenMs) + bringMs;
    }
    const double plannedMs =
        window == 0 ? endMs : endMs + std::max(clock.standMs, clock.up(readyMs));
    const double lateMs = broughtMs[window] - endMs;
    const double waitMs = window > 0 && lateMs > 0.0
                              ? std::max(0.0, lateMs + 0.5 * passMs + readyMs - (plannedMs - endMs))
                              : 0.0;
    const double beginMs = plannedMs + waitMs;
    copiedMs[window] = std::max(endMs, beginMs - 2.0 * clock.blockMs);
    if (window > 0) {
      standingMs += beginMs - endMs;
      waitingMs += waitMs;
    }
    const std::size_t begin = begins[window];
    const std::size_t end = window + 1 < count ? begins[window + 1] : points.size();
    const Stretch motion(std::span<const gcode::StreamPoint>(points).subspan(begin, end - begin),
                         fromMm, operatingPoint.feedMmPerS, model);
    fromMm = motion.endMm();
    endMs = beginMs + motion.durationS() * 1e3;
  }
  Prediction prediction;
  prediction.duration = base::fromMilliseconds(endMs + clock.relatchMs);
  prediction.standing = base::fromMilliseconds(standingMs);
  prediction.waiting = base::fromMilliseconds(waitingMs);
  prediction.stops = count - 1;
  return prediction;
}

}  // namespace rivulet::feasibility
