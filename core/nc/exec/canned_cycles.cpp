// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The canned cycles of RS-274 as the moves they consist of: LinuxCNC documentation, G-Codes,
// chapters "Canned Cycles" and "G73" to "G89".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "nc/exec/executor.h"

namespace rivulet::nc {

using base::Vec3;

namespace {

constexpr int kChipBreaking = 730;
constexpr int kDrilling = 810;
constexpr int kDwelling = 820;
constexpr int kPecking = 830;
constexpr int kBoring = 850;
constexpr int kBoringWithDwell = 890;

/// By which the tool stays above the last depth when it returns: a hundredth of an inch.
constexpr double kClearanceMm = 0.01 * base::kMmPerInch;
constexpr double kPecksMax = 1e5;
constexpr double kHolesMax = 1e5;

}  // namespace

bool isCannedCycle(int key) {
  static constexpr std::array kKeys{kChipBreaking, kDrilling, kDwelling,
                                    kPecking,      kBoring,   kBoringWithDwell};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

/// Values that a block leaves out are those of the block before, as numbers: in the unit that holds
/// now, and increments again where G91 holds now.
bool Executor::takeCycleWords(const BlockWords& words) {
  CannedCycle& cycle = m_state.cycle;
  const std::size_t third = m_state.planeThirdAxis();
  const auto missing = [&](std::string word) {
    m_to.faults.report(Severity::Error, std::max(1, words.motionColumn), FaultCode::NumberMissing,
                       std::move(word));
    return false;
  };
  if (words.hasRotary || words.hasAnyCentre() || m_state.feedMode == FeedMode::InverseTime ||
      (cycle.hasStart && cycle.planeFirstAxis != m_state.planeFirstAxis)) {
    m_to.faults.report(Severity::Error, std::max(1, words.motionColumn), FaultCode::CycleNotRun,
                       fmt::format("G{}", cycle.key / 10));
    return false;
  }
  const bool pecks = cycle.key == kChipBreaking || cycle.key == kPecking;
  const bool dwells = cycle.key == kDwelling || cycle.key == kBoringWithDwell;
  if (words.axes.has(third)) {
    cycle.bottom =
        third == 0 && m_state.diameter ? words.axes.value[third] / 2.0 : words.axes.value[third];
  } else if (cycle.isFirst) {
    return missing(std::string(1, base::kAxisNames[third]));
  }
  if (words.hasRadius) {
    cycle.retract = words.radius;
  } else if (cycle.isFirst) {
    return missing("R");
  }
  if (pecks && words.q) {
    cycle.stroke = *words.q;
  } else if (pecks && cycle.isFirst) {
    return missing("Q");
  }
  if (dwells && words.p) {
    cycle.dwellS = *words.p;
  } else if (dwells && cycle.isFirst) {
    return missing("P");
  }
  if (!m_state.retractsToR) {
    // It stays from program to program, and nobody says which holds at the beginning.
    return missing("G98, G99");
  }
  cycle.isFirst = false;
  if (!cycle.hasStart) {
    cycle.hasStart = true;
    cycle.planeFirstAxis = m_state.planeFirstAxis;
    cycle.start = m_position.programmedMm[third] / m_state.lengthFactor;
  }
  return true;
}

void Executor::runCannedCycle(const BlockWords& words) {
  const std::size_t third = m_state.planeThirdAxis();
  if (!takeCycleWords(words)) {
    return;
  }
  m_to.words.foreignMotion();
  m_reader.setMoved();
  m_pathBegun = true;
  const CannedCycle& cycle = m_state.cycle;
  const double unit = m_state.lengthFactor;
  const Vec3 from = m_position.programmedMm;
  const Vec3 place = placeInPlane(words);
  const double startMm = cycle.start * unit;
  const double rMm = cycle.retract * unit + (m_state.relative ? startMm : 0.0);
  const double bottomMm = cycle.bottom * unit + (m_state.relative ? rMm : 0.0);
  const double holes = words.l.value_or(1.0);
  const bool turnsOn = m_state.relative && words.rare && words.named("AP") != nullptr;
  if (!base::isFinite(place) || !std::isfinite(bottomMm) || !(rMm >= bottomMm) ||
      !(holes >= 1.0 && holes <= kHolesMax) || holes != std::floor(holes) ||
      (turnsOn && holes > 1.0)) {
    m_to.faults.report(Severity::Error, std::max(1, words.motionColumn), FaultCode::CycleNotRun,
                       fmt::format("G{}", cycle.key / 10));
    return;
  }
  const double highMm = std::max(startMm, rMm);
  const double clearMm = *m_state.retractsToR ? rMm : highMm;
  const auto at = [third](Vec3 in, double heightMm) {
    in.set(third, heightMm);
    return in;
  };
  double heightMm = from[third];
  if (startMm < rMm) {
    moveTo(at(from, rMm), std::nullopt, words.line);
    heightMm = rMm;
  }
  Vec3 hole = from;
  for (int i = 0; i < static_cast<int>(holes); ++i) {
    hole = m_state.relative ? hole + at(place - from, 0.0) : place;
    moveTo(at(hole, i == 0 && heightMm > rMm ? heightMm : clearMm), std::nullopt, words.line);
    moveTo(at(hole, rMm), std::nullopt, words.line);
    drill(at(hole, rMm), third, bottomMm, words);
    if (cycle.key == kBoring) {
      moveTo(at(hole, rMm), feedMmPerS(), words.line);
    }
    moveTo(at(hole, clearMm),
           cycle.key == kBoringWithDwell ? std::optional(feedMmPerS()) : std::nullopt, words.line);
  }
}

/// From the plane R to the bottom.
void Executor::drill(Vec3 atR, std::size_t third, double bottomMm, const BlockWords& words) {
  const CannedCycle& cycle = m_state.cycle;
  const double strokeMm = cycle.stroke * m_state.lengthFactor;
  const bool pecks = cycle.key == kChipBreaking || cycle.key == kPecking;
  const double rMm = atR[third];
  if (pecks && !(strokeMm > 0.0 && (rMm - bottomMm) / strokeMm <= kPecksMax)) {
    m_to.faults.report(Severity::Error, std::max(1, words.motionColumn), FaultCode::ValueOutOfRange,
                       "Q");
    return;
  }
  const auto to = [&](double heightMm, std::optional<double> feed) {
    atR.set(third, heightMm);
    moveTo(atR, feed, words.line);
  };
  const double feed = feedMmPerS();
  if (pecks) {
    for (double depthMm = rMm - strokeMm; depthMm > bottomMm; depthMm -= strokeMm) {
      to(depthMm, feed);
      if (cycle.key == kPecking) {
        to(rMm, std::nullopt);
      }
      to(depthMm + kClearanceMm, std::nullopt);
    }
  }
  to(bottomMm, feed);
  if (cycle.key == kDwelling || cycle.key == kBoringWithDwell) {
    m_to.path.machineWord(MachineWord::Dwell, cycle.dwellS, words.line);
  }
}

}  // namespace rivulet::nc
