// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/cycles/drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/axes.h"
#include "nc/function_number.h"

namespace rivulet::nc {

namespace {

using base::Vec3;
using Steps = tl::expected<std::vector<CycleStep>, CycleFault>;

// Positions of the parameters, from 0. The first five are those of all drilling cycles.
constexpr std::size_t kRetraction = 0;     // RTP, absolute
constexpr std::size_t kReference = 1;      // RFP, absolute
constexpr std::size_t kSafety = 2;         // SDIS, without sign
constexpr std::size_t kDepth = 3;          // DP, absolute
constexpr std::size_t kRelativeDepth = 4;  // DPR, without sign
constexpr std::size_t kDwell = 5;          // DTB; 8 of CYCLE83
constexpr std::size_t kToolAxis = 12;      // _AXN of CYCLE83 and CYCLE84

constexpr int kStrokesMax = 10000;
constexpr int kOriented = 19;

/// What the drilling cycles have in common.
class Drilling {
 public:
  Drilling(CycleArguments arguments, const CycleStart& start, std::size_t axisParameter)
      : m_arguments(arguments), m_start(start), m_axis((start.planeFirstAxis + 2) % 3) {
    const double number = axisParameter == 0 ? 0.0 : value(axisParameter);
    if (number >= 1.0 && number <= 3.0) {
      m_axis = static_cast<std::size_t>(number) - 1;
    }
  }

  /// @return why the planes contradict each other
  std::optional<CycleFault> readPlanes() {
    const double retraction = lengthMm(kRetraction);
    m_reference = lengthMm(kReference);
    const double relative = lengthMm(kRelativeDepth);
    if (relative != 0.0) {
      // Without a sign: away from the retraction plane.
      if (retraction == m_reference) {
        return CycleFault{kReferencePlaneWrong, "RFP"};
      }
      m_up = retraction > m_reference ? 1.0 : -1.0;
      m_depth = m_reference - m_up * std::abs(relative);
    } else {
      m_depth = lengthMm(kDepth);
      m_up = m_depth > m_reference ? -1.0 : 1.0;
    }
    if ((retraction - m_reference) * m_up < 0.0) {
      return CycleFault{kReferencePlaneWrong, "RTP"};
    }
    m_safety = m_reference + m_up * lengthMm(kSafety);
    m_retraction = retraction;
    return std::nullopt;
  }

  [[nodiscard]] bool has(std::size_t index) const {
    return index < m_arguments.size() && m_arguments[index];
  }
  [[nodiscard]] double value(std::size_t index) const {
    return has(index) ? *m_arguments[index] : 0.0;
  }
  /// -1: none
  [[nodiscard]] int choice(std::size_t index) const {
    return functionNumber(value(index)).value_or(-1);
  }
  [[nodiscard]] double lengthMm(std::size_t index) const {
    return value(index) * m_start.lengthFactor;
  }

  // Steps. Heights are coordinates of the drilling axis.
  void rapid(double height) { add({.kind = CycleStep::Kind::Rapid, .toMm = at(height)}); }
  void feed(double height, double factor = 1.0) {
    add({.kind = CycleStep::Kind::Feed, .toMm = at(height), .feedFactor = factor});
  }
  void tap(double height, double mmPerS) {
    add({.kind = CycleStep::Kind::Feed, .toMm = at(height), .feedMmPerS = mmPerS});
  }
  /// @param time  s; negative: turns of the spindle
  void dwell(double time) {
    const double turnS = m_start.spindlePerMin > 0.0 ? 60.0 / m_start.spindlePerMin : 0.0;
    const double seconds = time < 0.0 ? -time * turnS : time;
    if (seconds > 0.0) {
      add({.kind = CycleStep::Kind::Dwell, .seconds = seconds});
    }
  }
  void spindle(int function, double perMin = 0.0) {
    add({.kind = CycleStep::Kind::Spindle, .function = function, .spindlePerMin = perMin});
  }
  void shift(Vec3 byMm) { m_shiftMm = byMm; }
  [[nodiscard]] std::vector<CycleStep> take() { return std::move(m_steps); }

  [[nodiscard]] double safety() const { return m_safety; }
  [[nodiscard]] double retraction() const { return m_retraction; }
  [[nodiscard]] double depth() const { return m_depth; }
  [[nodiscard]] double depthMm() const { return std::abs(m_reference - m_depth); }
  /// The height so far below the reference plane.
  [[nodiscard]] double below(double mm) const { return m_reference - m_up * mm; }
  [[nodiscard]] double reference() const { return m_reference; }
  [[nodiscard]] std::size_t axis() const { return m_axis; }

 private:
  [[nodiscard]] Vec3 at(double height) const {
    Vec3 place = m_start.positionMm;
    place.set(m_axis, height);
    return place + m_shiftMm;
  }
  void add(CycleStep step) { m_steps.push_back(step); }

  CycleArguments m_arguments;
  const CycleStart& m_start;
  std::size_t m_axis;
  double m_up = 1.0;  ///< direction of the axis out of the hole
  double m_retraction = 0.0;
  double m_reference = 0.0;
  double m_safety = 0.0;
  double m_depth = 0.0;
  Vec3 m_shiftMm;
  std::vector<CycleStep> m_steps;
};

/// CYCLE81, CYCLE82.
Steps drill(Drilling drilling) {
  drilling.rapid(drilling.safety());
  drilling.feed(drilling.depth());
  drilling.dwell(drilling.value(kDwell));
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

/// CYCLE83(RTP, RFP, SDIS, DP, DPR, FDEP, FDPR, DAM, DTB, DTS, FRF, VARI, _AXN, _MDEP, _VRT, _DTD,
/// _DIS1).
struct DeepHole {
  explicit DeepHole(const Drilling& drilling)
      : wholeMm(drilling.depthMm()),
        firstMm(
            drilling.has(6) && drilling.value(6) != 0.0
                ? std::abs(drilling.lengthMm(6))
                : (drilling.has(5) ? std::abs(drilling.reference() - drilling.lengthMm(5)) : 0.0)),
        degression(drilling.value(7)),
        degressionMm(drilling.lengthMm(7)),
        smallestMm(drilling.lengthMm(13)),
        bottomS(drilling.value(8)),
        startS(drilling.value(9)),
        lastS(drilling.value(15) != 0.0 ? drilling.value(15) : drilling.value(8)),
        firstFeed(drilling.value(10) > 0.0 ? drilling.value(10) : 1.0),
        removesChips(drilling.value(11) != 0.0),
        breakMm(drilling.value(14) > 0.0 ? drilling.lengthMm(14) : 1.0),
        limitMm(drilling.value(16) > 0.0 ? drilling.lengthMm(16) : automaticLimitMm(wholeMm)) {}

  /// How far above the last depth the feed begins again.
  static double automaticLimitMm(double depthMm) {
    return depthMm <= 30.0 ? 0.6 : std::min(depthMm / 50.0, 7.0);
  }

  [[nodiscard]] double nextStroke(double strokeMm, double leftMm) const {
    double next = strokeMm;
    if (degression > 0.0) {
      next = std::max(strokeMm - degressionMm, std::min(degressionMm, strokeMm));
      if (leftMm > next && leftMm < 2.0 * next) {
        return leftMm / 2.0;
      }
    } else if (degression < 0.0) {
      next = strokeMm * std::min(-degression, 1.0);
    }
    return std::max(next, smallestMm);
  }

  double wholeMm;
  double firstMm;
  double degression;  ///< DAM; > 0 a length, < 0 a factor
  double degressionMm;
  double smallestMm;
  double bottomS;
  double startS;
  double lastS;
  double firstFeed;
  bool removesChips;
  double breakMm;
  double limitMm;
};

Steps drillDeep(Drilling drilling) {
  const DeepHole hole(drilling);
  if (!(hole.firstMm > 0.0)) {
    return tl::unexpected(CycleFault{kFirstDepthWrong, "FDEP"});
  }
  drilling.rapid(drilling.safety());
  double stroke = hole.firstMm;
  double depth = std::min(stroke, hole.wholeMm);
  drilling.feed(drilling.below(depth), hole.firstFeed);
  for (int strokes = 1; depth < hole.wholeMm && strokes < kStrokesMax; ++strokes) {
    drilling.dwell(hole.bottomS);
    if (hole.removesChips) {
      drilling.rapid(drilling.safety());
      drilling.dwell(hole.startS);
      drilling.rapid(drilling.below(depth - hole.limitMm));
    } else {
      drilling.feed(drilling.below(depth - hole.breakMm));
    }
    stroke = hole.nextStroke(stroke, hole.wholeMm - depth);
    // The last depth is the one programmed, to the last bit.
    depth = depth + stroke < hole.wholeMm - 1e-9 ? depth + stroke : hole.wholeMm;
    drilling.feed(depth < hole.wholeMm ? drilling.below(depth) : drilling.depth());
  }
  drilling.dwell(hole.lastS);
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

/// Standard pitch of a metric thread, mm; 0: there is none of this size.
double standardPitchMm(double size) {
  static constexpr std::array<std::pair<double, double>, 21> kPitches{
      {{3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1.0},  {8, 1.25}, {10, 1.5}, {12, 1.75},
       {14, 2.0}, {16, 2.0}, {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3.0}, {27, 3.0},
       {30, 3.5}, {33, 3.5}, {36, 4.0}, {39, 4.0}, {42, 4.5}, {45, 4.5}, {48, 5.0}}};
  const auto found = std::find_if(kPitches.begin(), kPitches.end(),
                                  [size](const auto& entry) { return entry.first == size; });
  return found == kPitches.end() ? 0.0 : found->second;
}

/// CYCLE84(RTP, RFP, SDIS, DP, DPR, DTB, SDAC, MPIT, PIT, POSS, SST, SST1, _AXN).
Steps tap(Drilling drilling, const CycleStart& start) {
  const double size = drilling.value(7);
  const double pitch = drilling.lengthMm(8);
  const double pitchMm =
      pitch != 0.0 ? pitch : std::copysign(standardPitchMm(std::abs(size)), size);
  const bool contradicts =
      size != 0.0 && pitch != 0.0 && std::abs(pitch) != standardPitchMm(std::abs(size));
  if (pitchMm == 0.0 || contradicts) {
    return tl::unexpected(CycleFault{kPitchWrong, "PIT"});
  }
  const int after = drilling.choice(6);
  if (after < 3 || after > 5) {
    return tl::unexpected(CycleFault{kSpindleDirectionMissing, "SDAC"});
  }
  const double inPerMin = drilling.value(10) > 0.0 ? drilling.value(10) : start.spindlePerMin;
  const double outPerMin = drilling.value(11) > 0.0 ? drilling.value(11) : inPerMin;
  const int in = pitchMm > 0.0 ? 3 : 4;  // a negative pitch is a left-hand thread
  const int out = 7 - in;
  drilling.rapid(drilling.safety());
  drilling.spindle(kOriented);
  drilling.spindle(in, inPerMin);
  drilling.tap(drilling.depth(), std::abs(pitchMm) * inPerMin / 60.0);
  drilling.dwell(drilling.value(kDwell));
  drilling.spindle(out, outPerMin);
  drilling.tap(drilling.safety(), std::abs(pitchMm) * outPerMin / 60.0);
  drilling.rapid(drilling.retraction());
  drilling.spindle(after);
  return drilling.take();
}

/// CYCLE86(RTP, RFP, SDIS, DP, DPR, DTB, SDIR, RPA, RPO, RPAP, POSS).
Steps bore(Drilling drilling, const CycleStart& start) {
  const int turn = drilling.choice(6);
  if (turn != 3 && turn != 4) {
    return tl::unexpected(CycleFault{kSpindleDirectionMissing, "SDIR"});
  }
  drilling.rapid(drilling.safety());
  drilling.spindle(turn);
  drilling.feed(drilling.depth());
  drilling.dwell(drilling.value(kDwell));
  drilling.spindle(kOriented);
  // The edge leaves the wall before the tool is drawn out.
  Vec3 off;
  off.set(start.planeFirstAxis, drilling.lengthMm(7));
  off.set((start.planeFirstAxis + 1) % base::kAxisCount, drilling.lengthMm(8));
  drilling.shift(off);
  drilling.rapid(drilling.depth() + drilling.lengthMm(9));
  drilling.rapid(drilling.safety());
  drilling.shift({});
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

/// CYCLE85(RTP, RFP, SDIS, DP, DPR, DTB, FFR, RFF), CYCLE89 (.., DTB): out of the hole with feed.
Steps ream(Drilling drilling, bool namesFeeds) {
  const double inMmPerS = namesFeeds ? drilling.lengthMm(6) / 60.0 : 0.0;
  const double outMmPerS = namesFeeds ? drilling.lengthMm(7) / 60.0 : 0.0;
  drilling.rapid(drilling.safety());
  drilling.tap(drilling.depth(), inMmPerS);
  drilling.dwell(drilling.value(kDwell));
  drilling.tap(drilling.safety(), outMmPerS);
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

/// CYCLE87(RTP, RFP, SDIS, DP, DPR, SDIR), CYCLE88(.., DTB, SDIR): the spindle stops, and the
/// program until cycle start.
Steps boreWithStop(Drilling drilling, bool dwells) {
  const int turn = drilling.choice(dwells ? 6 : 5);
  if (turn != 3 && turn != 4) {
    return tl::unexpected(CycleFault{kSpindleDirectionMissing, "SDIR"});
  }
  drilling.rapid(drilling.safety());
  drilling.spindle(turn);
  drilling.feed(drilling.depth());
  drilling.dwell(dwells ? drilling.value(kDwell) : 0.0);
  drilling.spindle(5);
  drilling.spindle(0);
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

/// CYCLE840(RTP, RFP, SDIS, DP, DPR, DTB, SDR, SDAC, ENC, MPIT, PIT, _AXN): with a chuck that gives
/// way. Without a pitch the feed is the programmed one.
Steps tapWithChuck(Drilling drilling, const CycleStart& start) {
  const int after = drilling.choice(7);
  const int out = drilling.choice(6);
  if (after != 0 && (after < 3 || after > 5)) {
    return tl::unexpected(CycleFault{kSpindleDirectionMissing, "SDAC"});
  }
  const double size = std::abs(drilling.value(9));
  const double pitchMm =
      drilling.value(10) != 0.0 ? std::abs(drilling.lengthMm(10)) : standardPitchMm(size);
  const double mmPerS = pitchMm * start.spindlePerMin / 60.0;
  drilling.rapid(drilling.safety());
  drilling.tap(drilling.depth(), mmPerS);
  drilling.dwell(drilling.value(kDwell));
  drilling.spindle(out == 3 || out == 4 ? out : 4);
  drilling.tap(drilling.safety(), mmPerS);
  drilling.spindle(after >= 3 ? after : 3);
  drilling.rapid(drilling.retraction());
  return drilling.take();
}

Vec3 inPlane(const CycleStart& start, double firstMm, double secondMm) {
  Vec3 place = start.positionMm;
  place.set(start.planeFirstAxis, firstMm);
  place.set((start.planeFirstAxis + 1) % base::kAxisCount, secondMm);
  return place;
}

}  // namespace

bool isDrillingCycle(std::string_view name) {
  static constexpr std::array<std::string_view, 10> kNames{
      "CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84", "CYCLE85",
      "CYCLE86", "CYCLE87", "CYCLE88", "CYCLE89", "CYCLE840"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool isHolePattern(std::string_view name) {
  return name == "HOLES1" || name == "HOLES2" || name == "CYCLE801" || name == "CYCLE802";
}

Steps expandCycle(std::string_view name, CycleArguments arguments, const CycleStart& start) {
  const bool namesAxis = name == "CYCLE83" || name == "CYCLE84";
  Drilling drilling(arguments, start, namesAxis ? kToolAxis : 0);
  if (std::optional<CycleFault> fault = drilling.readPlanes()) {
    return tl::unexpected(*std::move(fault));
  }
  if (name == "CYCLE83") {
    return drillDeep(std::move(drilling));
  }
  if (name == "CYCLE84") {
    return tap(std::move(drilling), start);
  }
  if (name == "CYCLE840") {
    return tapWithChuck(std::move(drilling), start);
  }
  if (name == "CYCLE85" || name == "CYCLE89") {
    return ream(std::move(drilling), name == "CYCLE85");
  }
  if (name == "CYCLE87" || name == "CYCLE88") {
    return boreWithStop(std::move(drilling), name == "CYCLE88");
  }
  return name == "CYCLE86" ? bore(std::move(drilling), start) : drill(std::move(drilling));
}

std::vector<Vec3> holesOf(std::string_view name, CycleArguments arguments,
                          const CycleStart& start) {
  constexpr double kHolesMax = 10000.0;
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const auto value = [arguments](std::size_t index) {
    return index < arguments.size() ? arguments[index].value_or(0.0) : 0.0;
  };
  const double count = std::clamp(std::floor(value(5)), 0.0, kHolesMax);
  const double firstMm = value(0) * start.lengthFactor;
  const double secondMm = value(1) * start.lengthFactor;
  std::vector<Vec3> holes;
  if (name == "CYCLE802") {
    // CYCLE802(_XA, _YA, _X0, _Y0, _X1, ...): what is left out ends the list.
    for (std::size_t at = 2; at + 1 < std::min<std::size_t>(arguments.size(), 20); at += 2) {
      if (arguments[at] && arguments[at + 1]) {
        holes.push_back(
            inPlane(start, value(at) * start.lengthFactor, value(at + 1) * start.lengthFactor));
      }
    }
    return holes;
  }
  if (name == "CYCLE801") {
    // CYCLE801(_SPCA, _SPCO, _STA, _DIS1, _DIS2, _NUM1, _NUM2, _VARI): 1 of _VARI, the edge alone.
    const double rows = std::clamp(std::floor(value(6)), 0.0, kHolesMax / std::max(count, 1.0));
    const double cosine = std::cos(value(2) * kRadPerDeg);
    const double sine = std::sin(value(2) * kRadPerDeg);
    for (double row = 0.0; row < rows; ++row) {
      for (double i = 0.0; i < count; ++i) {
        const double column = std::fmod(row, 2.0) == 0.0 ? i : count - 1.0 - i;
        const bool isEdge =
            row == 0.0 || row == rows - 1.0 || column == 0.0 || column == count - 1.0;
        const double u = column * value(3) * start.lengthFactor;
        const double v = row * value(4) * start.lengthFactor;
        if (isEdge || value(7) != 1.0) {
          holes.push_back(
              inPlane(start, firstMm + u * cosine - v * sine, secondMm + u * sine + v * cosine));
        }
      }
    }
    return holes;
  }
  const auto add = [&](double radiusMm, double degrees) {
    holes.push_back(inPlane(start, firstMm + radiusMm * std::cos(degrees * kRadPerDeg),
                            secondMm + radiusMm * std::sin(degrees * kRadPerDeg)));
  };
  if (name == "HOLES2") {
    // HOLES2(CPA, CPO, RAD, STA1, INDA, NUM): without INDA the holes share the circle.
    const double step = value(4) != 0.0 ? value(4) : 360.0 / std::max(count, 1.0);
    for (double hole = 0.0; hole < count; ++hole) {
      add(value(2) * start.lengthFactor, value(3) + hole * step);
    }
    return holes;
  }
  // HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM)
  for (double hole = 0.0; hole < count; ++hole) {
    add((value(3) + hole * value(4)) * start.lengthFactor, value(2));
  }
  if (!holes.empty() && base::distance(start.positionMm, holes.back()) <
                            base::distance(start.positionMm, holes.front())) {
    std::reverse(holes.begin(), holes.end());
  }
  return holes;
}

}  // namespace rivulet::nc
