// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/cycles/milling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/axes.h"
#include "nc/cycles/area.h"

namespace rivulet::nc {

namespace {

using base::Vec3;
using Steps = tl::expected<std::vector<CycleStep>, CycleFault>;

// Positions of the parameters that all have, from 0.
constexpr std::size_t kRtp = 0;   // RTP, absolute
constexpr std::size_t kRfp = 1;   // RFP, absolute
constexpr std::size_t kSdis = 2;  // SDIS, without sign
constexpr std::size_t kDp = 3;    // DP, absolute

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kChordMm = 0.01;
constexpr double kSlotsMax = 1000.0;

/// The parameters, and the area they describe. Lengths in mm.
class Milling : public AreaMill {
 public:
  Milling(CycleArguments arguments, const CycleStart& start)
      : AreaMill(start.toolRadiusMm, start.planeFirstAxis, kChordMm),
        m_arguments(arguments),
        m_start(start) {}

  [[nodiscard]] double value(std::size_t index) const {
    return index < m_arguments.size() ? m_arguments[index].value_or(0.0) : 0.0;
  }
  [[nodiscard]] double lengthMm(std::size_t index) const {
    return value(index) * m_start.lengthFactor;
  }
  /// mm/s; 0: the programmed feed.
  [[nodiscard]] double feed(std::size_t index) const { return lengthMm(index) / 60.0; }

  /// @param relativeDepth  index of DPR; 0: none @return why the planes contradict each other
  std::optional<CycleFault> readPlanes(std::size_t relativeDepth, double allowanceMm) {
    AreaPlanes made;
    made.retraction = lengthMm(kRtp);
    made.reference = lengthMm(kRfp);
    made.safety = std::abs(lengthMm(kSdis));
    made.up = made.retraction < made.reference ? -1.0 : 1.0;
    const double relativeMm = relativeDepth > 0 ? lengthMm(relativeDepth) : 0.0;
    const double depth =
        relativeMm != 0.0 ? made.reference - made.up * std::abs(relativeMm) : lengthMm(kDp);
    made.depth = (made.reference - depth) * made.up - std::abs(allowanceMm);
    setPlanes(made);
    return made.depth < 0.0 ? std::optional(CycleFault{kReferencePlaneWrong, "DP"}) : std::nullopt;
  }

 private:
  CycleArguments m_arguments;
  const CycleStart& m_start;
};

/// A rectangle about the place, with round corners. @return false: the tool does not fit
bool clear(Milling& mill, double halfU, double halfV, double cornerMm, const Clearing& how) {
  mill.approach(0.0, 0.0);
  if (!clearRectangle(mill, halfU, halfV, cornerMm, how)) {
    return false;
  }
  mill.retract(0.0, 0.0);
  return true;
}

/// Of _VARI: 1 roughs, 2 finishes, 0 does both.
void readKind(double vari, Clearing& how) {
  const double kind = std::fmod(std::abs(vari), 10.0);
  how.roughs = kind != 2.0;
  how.finishes = kind == 0.0 || kind == 2.0;
}

Steps tooLarge() {
  return tl::unexpected(CycleFault{kToolTooLarge, "tool radius"});
}

/// POCKET3(_RTP, _RFP, _SDIS, _DP, _LENG, _WID, _CRAD, _PA, _PO, _STA, _MID, _FAL, _FALD, _FFP1,
/// _FFD, _CDIR, _VARI, _MIDA, ...).
Steps rectangularPocket(Milling mill) {
  Clearing how{.infeed = mill.lengthMm(10),
               .apart = mill.lengthMm(17),
               .allowance = mill.lengthMm(11),
               .feed = mill.feed(13),
               .depthFeed = mill.feed(14)};
  readKind(mill.value(16), how);
  if (auto fault = mill.readPlanes(0, how.roughs ? mill.lengthMm(12) : 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  mill.place(mill.lengthMm(7), mill.lengthMm(8), mill.value(9));
  return clear(mill, std::abs(mill.lengthMm(4)) / 2.0, std::abs(mill.lengthMm(5)) / 2.0,
               mill.lengthMm(6), how)
             ? Steps(mill.take())
             : tooLarge();
}

/// POCKET4(_RTP, _RFP, _SDIS, _DP, _PRAD, _PA, _PO, _MID, _FAL, _FALD, _FFP1, _FFD, _CDIR, _VARI,
/// _MIDA, ...).
Steps circularPocket(Milling mill) {
  Clearing how{.infeed = mill.lengthMm(7),
               .apart = mill.lengthMm(14),
               .allowance = mill.lengthMm(8),
               .feed = mill.feed(10),
               .depthFeed = mill.feed(11)};
  readKind(mill.value(13), how);
  if (auto fault = mill.readPlanes(0, how.roughs ? mill.lengthMm(9) : 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  mill.place(mill.lengthMm(5), mill.lengthMm(6), 0.0);
  const double radius = std::abs(mill.lengthMm(4));
  return clear(mill, radius, radius, radius, how) ? Steps(mill.take()) : tooLarge();
}

/// Around a spigot about the place, from outside.
Steps around(Milling mill, double halfU, double halfV, double cornerMm, const Clearing& how) {
  const Spigot spigot{
      .halfU = halfU, .halfV = halfV, .corner = cornerMm, .outside = mill.planes().safety};
  const double outside = startOf(mill, spigot, how);
  mill.approach(outside, 0.0);
  clearAround(mill, spigot, how);
  mill.retract(outside, 0.0);
  return mill.take();
}

/// CYCLE76(_RTP, _RFP, _SDIS, _DP, _DPR, _LENG, _WID, _CRAD, _PA, _PO, _STA, _MID, _FAL, _FALD,
/// _FFP1, _FFD, _CDIR, _VARI, ...).
Steps rectangularSpigot(Milling mill) {
  Clearing how{.infeed = mill.lengthMm(11),
               .allowance = mill.lengthMm(12),
               .feed = mill.feed(14),
               .depthFeed = mill.feed(15)};
  readKind(mill.value(17), how);
  if (auto fault = mill.readPlanes(4, how.roughs ? mill.lengthMm(13) : 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  mill.place(mill.lengthMm(8), mill.lengthMm(9), mill.value(10));
  return around(std::move(mill), std::abs(mill.lengthMm(5)) / 2.0, std::abs(mill.lengthMm(6)) / 2.0,
                mill.lengthMm(7), how);
}

/// CYCLE77(_RTP, _RFP, _SDIS, _DP, _DPR, _PRAD, _PA, _PO, _MID, _FAL, _FALD, _FFP1, _FFD, _CDIR,
/// _VARI, ...).
Steps circularSpigot(Milling mill) {
  Clearing how{.infeed = mill.lengthMm(8),
               .allowance = mill.lengthMm(9),
               .feed = mill.feed(11),
               .depthFeed = mill.feed(12)};
  readKind(mill.value(14), how);
  if (auto fault = mill.readPlanes(4, how.roughs ? mill.lengthMm(10) : 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  mill.place(mill.lengthMm(6), mill.lengthMm(7), 0.0);
  const double radius = std::abs(mill.lengthMm(5));
  return around(std::move(mill), radius, radius, radius, how);
}

/// CYCLE90(RTP, RFP, SDIS, DP, DPR, DIATH, KDIAM, PIT, FFR, CDIR, TYPTH, CPA, CPO): TYPTH 0 within
/// a hole, 1 around a bolt; CDIR 2 clockwise.
Steps threadByMilling(Milling mill) {
  if (auto fault = mill.readPlanes(4, 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  const double pitch = std::abs(mill.lengthMm(7));
  const bool isOutside = mill.value(10) == 1.0;
  const double radius =
      isOutside ? mill.lengthMm(6) / 2.0 + mill.radius() : mill.lengthMm(5) / 2.0 - mill.radius();
  if (!(pitch > 0.0) || !(radius > 0.0)) {
    return pitch > 0.0 ? tooLarge() : Steps(tl::unexpected(CycleFault{kPitchWrong, "PIT"}));
  }
  const double start = isOutside ? radius + mill.radius() + mill.planes().safety : 0.0;
  const double turn = mill.value(9) == 2.0 ? -360.0 : 360.0;
  const double feed = mill.feed(8);
  mill.place(mill.lengthMm(11), mill.lengthMm(12), 0.0);
  mill.approach(start, 0.0);
  const std::vector<double> levels = mill.levels(pitch);
  double height = mill.planes().reference;
  mill.cut(start, 0.0, height, feed);
  mill.cut(radius, 0.0, height, feed);
  for (const double level : levels) {
    mill.spiral(0.0, 0.0, radius, 0.0, turn, height, level, feed);
    height = level;
  }
  mill.cut(start, 0.0, height, feed);
  mill.retract(start, 0.0);
  return mill.take();
}

/// Of LONGHOLE, SLOT1 and SLOT2: how many there are on the circle, and where.
struct Pattern {
  double count = 0.0;
  double firstMm = 0.0;
  double secondMm = 0.0;
  double radiusMm = 0.0;
  double startDegrees = 0.0;
  double stepDegrees = 0.0;

  /// @param at  index of CPA, before CPO, RAD, STA1 and INDA
  Pattern(const Milling& mill, std::size_t at)
      : count(std::clamp(std::floor(mill.value(5)), 0.0, kSlotsMax)),
        firstMm(mill.lengthMm(at)),
        secondMm(mill.lengthMm(at + 1)),
        radiusMm(mill.lengthMm(at + 2)),
        startDegrees(mill.value(at + 3)),
        stepDegrees(mill.value(at + 4) != 0.0 ? mill.value(at + 4) : 360.0 / std::max(count, 1.0)) {
  }
};

/// LONGHOLE(RTP, RFP, SDIS, DP, DPR, NUM, LENG, CPA, CPO, RAD, STA1, INDA, FFD, FFP1, MID): as wide
/// as the tool.
Steps longHoles(Milling mill) {
  if (auto fault = mill.readPlanes(4, 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  const Pattern pattern(mill, 7);
  const double length = std::abs(mill.lengthMm(6));
  for (double i = 0.0; i < pattern.count; ++i) {
    mill.place(pattern.firstMm, pattern.secondMm, pattern.startDegrees + i * pattern.stepDegrees);
    double from = pattern.radiusMm;
    double to = from + length;
    mill.approach(from, 0.0);
    for (const double height : mill.levels(mill.lengthMm(14))) {
      mill.cut(from, 0.0, height, mill.feed(12));
      mill.cut(to, 0.0, height, mill.feed(13));
      std::swap(from, to);
    }
    mill.retract(from, 0.0);
  }
  return mill.take();
}

/// SLOT1(RTP, RFP, SDIS, DP, DPR, NUM, LENG, WID, CPA, CPO, RAD, STA1, INDA, FFD, FFP1, _MID, CDIR,
/// _FAL, VARI, ...).
Steps radialSlots(Milling mill) {
  if (auto fault = mill.readPlanes(4, 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  const Pattern pattern(mill, 8);
  const double length = std::abs(mill.lengthMm(6));
  const double width = std::abs(mill.lengthMm(7));
  Clearing how{.infeed = mill.lengthMm(15),
               .allowance = mill.lengthMm(17),
               .feed = mill.feed(14),
               .depthFeed = mill.feed(13)};
  readKind(mill.value(18), how);
  for (double i = 0.0; i < pattern.count; ++i) {
    const double degrees = pattern.startDegrees + i * pattern.stepDegrees;
    const double middle = pattern.radiusMm + length / 2.0;
    mill.place(pattern.firstMm + middle * std::cos(degrees * kRadPerDeg),
               pattern.secondMm + middle * std::sin(degrees * kRadPerDeg), degrees);
    if (!clear(mill, length / 2.0, width / 2.0, width / 2.0, how)) {
      return tooLarge();
    }
  }
  return mill.take();
}

/// SLOT2(RTP, RFP, SDIS, DP, DPR, NUM, AFSL, WID, CPA, CPO, RAD, STA1, INDA, FFD, FFP1, _MID, CDIR,
/// _FAL, VARI, ...): along the circle.
Steps circumferentialSlots(Milling mill) {
  if (auto fault = mill.readPlanes(4, 0.0)) {
    return tl::unexpected(*std::move(fault));
  }
  const Pattern pattern(mill, 8);
  const double sweep = mill.value(6);
  const double beside = std::abs(mill.lengthMm(7)) / 2.0 - mill.radius();
  if (beside < -1e-9) {
    return tooLarge();
  }
  const double feed = mill.feed(14);
  mill.place(pattern.firstMm, pattern.secondMm, 0.0);
  for (double i = 0.0; i < pattern.count; ++i) {
    const double from = pattern.startDegrees + i * pattern.stepDegrees;
    const double u = pattern.radiusMm * std::cos(from * kRadPerDeg);
    const double v = pattern.radiusMm * std::sin(from * kRadPerDeg);
    mill.approach(u, v);
    for (const double height : mill.levels(mill.lengthMm(15))) {
      mill.cut(u, v, height, mill.feed(13));
      mill.arc(0.0, 0.0, pattern.radiusMm, from, sweep, height, feed);
      mill.arc(0.0, 0.0, pattern.radiusMm + beside, from + sweep, -sweep, height, feed);
      mill.arc(0.0, 0.0, pattern.radiusMm - beside, from, sweep, height, feed);
      mill.arc(0.0, 0.0, pattern.radiusMm, from + sweep, -sweep, height, feed);
    }
    mill.retract(u, v);
  }
  return mill.take();
}

/// How lines lie, by the tens of _VARI: 1 and 3 along the first axis, 3 and 4 to and fro.
void readLines(double vari, Face& face) {
  const double kind = std::floor(std::fmod(std::abs(vari), 100.0) / 10.0);
  face.alternates = kind == 3.0 || kind == 4.0;
  face.alongSecond = kind == 2.0 || kind == 4.0;
}

/// CYCLE71(_RTP, _RFP, _SDIS, _DP, _PA, _PO, _LENG, _WID, _STA, _MID, _MIDA, _FDP, _FALD, _FFP1,
/// _VARI, _FDP1).
Steps face71(Milling mill) {
  const bool finishes = std::fmod(std::abs(mill.value(14)), 10.0) == 2.0;
  if (auto fault = mill.readPlanes(0, finishes ? 0.0 : mill.lengthMm(12))) {
    return tl::unexpected(*std::move(fault));
  }
  mill.place(mill.lengthMm(4), mill.lengthMm(5), mill.value(8));
  Face face{.length = mill.lengthMm(6),
            .width = mill.lengthMm(7),
            .beyond = mill.radius() + mill.planes().safety,
            .apart = mill.lengthMm(10),
            .infeed = mill.lengthMm(9),
            .feed = mill.feed(13)};
  readLines(mill.value(14), face);
  clearFace(mill, face);
  return mill.take();
}

/// CYCLE61(_RTP, _Z0, _SDIS, _Z1, _X0, _Y0, _X1, _Y1, _DZ, _DXY, _UZ, _F, _VARI, _LIM, _DMODE,
/// _AMODE). Assumed: the tens of _AMODE say that _X1 and _Y1 are increments; _DXY is a percentage
/// of the diameter where it is greater than that.
Steps face61(Milling mill) {
  const bool finishes = std::fmod(std::abs(mill.value(12)), 10.0) == 2.0;
  if (auto fault = mill.readPlanes(0, finishes ? 0.0 : mill.lengthMm(10))) {
    return tl::unexpected(*std::move(fault));
  }
  const bool isIncrement = std::floor(std::fmod(std::abs(mill.value(15)), 100.0) / 10.0) == 1.0;
  const double diameter = 2.0 * mill.radius();
  const double apart = mill.lengthMm(9);
  mill.place(mill.lengthMm(4), mill.lengthMm(5), 0.0);
  Face face{.length = mill.lengthMm(6) - (isIncrement ? 0.0 : mill.lengthMm(4)),
            .width = mill.lengthMm(7) - (isIncrement ? 0.0 : mill.lengthMm(5)),
            .beyond = mill.radius() + mill.planes().safety,
            .apart = apart > diameter && diameter > 0.0 ? apart / 100.0 * diameter : apart,
            .infeed = mill.lengthMm(8),
            .feed = mill.feed(11)};
  readLines(mill.value(12), face);
  clearFace(mill, face);
  return mill.take();
}

struct Cycle {
  std::string_view name;
  Steps (*expand)(Milling);
};
constexpr std::array kCycles{Cycle{"CYCLE76", rectangularSpigot},
                             Cycle{"CYCLE77", circularSpigot},
                             Cycle{"CYCLE90", threadByMilling},
                             Cycle{"POCKET3", rectangularPocket},
                             Cycle{"POCKET4", circularPocket},
                             Cycle{"LONGHOLE", longHoles},
                             Cycle{"SLOT1", radialSlots},
                             Cycle{"SLOT2", circumferentialSlots},
                             Cycle{"CYCLE71", face71},
                             Cycle{"CYCLE61", face61}};

const Cycle* cycleOf(std::string_view name) {
  const auto* const found = std::find_if(kCycles.begin(), kCycles.end(),
                                         [name](const Cycle& each) { return each.name == name; });
  return found == kCycles.end() ? nullptr : found;
}

}  // namespace

bool isMillingCycle(std::string_view name) {
  return cycleOf(name) != nullptr;
}

Steps expandMilling(std::string_view name, CycleArguments arguments, const CycleStart& start) {
  return cycleOf(name)->expand(Milling(arguments, start));
}

}  // namespace rivulet::nc
