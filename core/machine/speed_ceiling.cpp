// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/speed_ceiling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

/// A search that moves by no more than this share of its accuracy is at its end.
constexpr double kAccurateShare = 0.1;
/// Halvings where only the safe side matters, not the last bit.
constexpr int kCeilingHalvings = 10;
/// Steps of the search for the moment at which the climb must end.
constexpr int kSearchSteps = 60;
/// Places of a section that ends in a stop at which a motion is compared with the ceiling.
constexpr int kLooksBeforeStop = 8;
/// A motion this close to the ceiling is on it, where the jerk limit is that of a usual axis; where
/// it is weak, so is what counts as rounding.
constexpr double kOnCeilingMmPerS = 1e-6;
constexpr double kOnCeilingPerJerkS2 = 1e-10;
/// Share of it by which a motion may pass the ceiling, so that rounding does not hold it back.
constexpr double kTouchShare = 0.01;
/// What is below these is rounding.
constexpr double kTimeS = 1e-12;
constexpr double kRoundingS = 1e-6;
constexpr double kRoundingMmPerS = 1e-9;
constexpr double kRoundingMmPerS2 = 1e-6;
/// What a violated limit of acceleration counts as in speed; any factor makes it negative.
constexpr double kSpeedPerAccelerationS = 1e-3;

double slopeMmPerS2(double fromMmPerS, double toMmPerS, double lengthMm) {
  return (toMmPerS * toMmPerS - fromMmPerS * fromMmPerS) / (2.0 * lengthMm);
}

/// The smaller one of two slopes; none if they differ in sign.
double smallerSlope(double a, double b) {
  if (a > 0.0 && b > 0.0) {
    return std::min(a, b);
  }
  return a < 0.0 && b < 0.0 ? std::max(a, b) : 0.0;
}

double onCeilingMmPerS(const SpeedSection& section) {
  return std::min(kOnCeilingMmPerS, kOnCeilingPerJerkS2 * section.limits.jerkMmPerS3);
}

/// Whether a motion loses more speed in proportion than another at the same place (negative), or
/// less: the sign of the difference of d ln(v)/ds.
double steepness(const SpeedState& state, const SpeedState& other) {
  const double v = state.speedMmPerS;
  const double w = other.speedMmPerS;
  if (w <= 0.0) {
    return v;  // the other one is about to stand
  }
  return state.accelerationMmPerS2 * w * w - other.accelerationMmPerS2 * v * v;
}

/// Constant jerk until the motion stands, or at least over a length.
ConstantJerk withJerk(const SpeedState& from, double jerk, double lengthMm) {
  const double v = from.speedMmPerS;
  const double a = from.accelerationMmPerS2;
  if (jerk < 0.0) {
    return {from, (a + std::sqrt(a * a - 2.0 * jerk * v)) / -jerk, jerk};
  }
  const double square = a * a - 2.0 * jerk * v;
  const bool turnsBack = a < 0.0 && square > 0.0;
  return {from,
          turnsBack ? (-a - std::sqrt(square)) / jerk
                    : std::max(0.0, -2.0 * a / jerk) + std::cbrt(6.0 * lengthMm / jerk),
          jerk};
}

/// Closes in on the place where a value changes its sign: regula falsi, in which an end that stays
/// counts half, and a halving every fourth step, for the value may have bends.
class SignChange {
 public:
  SignChange(double lowAt, double low, double highAt, double high)
      : m_lowAt(lowAt), m_low(low), m_highAt(highAt), m_high(high) {}

  /// The place to look at next, between the ends.
  [[nodiscard]] double next() {
    const double at = m_lowAt + width() * m_low / (m_low - m_high);
    const bool isBetween = at > m_lowAt && at < m_highAt;
    return m_steps++ % 4 == 3 || !isBetween ? 0.5 * (m_lowAt + m_highAt) : at;
  }
  /// What was found there, and of which end it has the sign.
  void take(double at, double value, bool isLow) {
    m_moved = isLow ? at - m_lowAt : m_highAt - at;
    if (isLow) {
      m_lowAt = at;
      m_low = value;
      m_high *= m_wasLow ? 0.5 : 1.0;
    } else {
      m_highAt = at;
      m_high = value;
      m_low *= m_wasLow ? 1.0 : 0.5;
    }
    m_wasLow = isLow;
  }

  [[nodiscard]] double width() const { return m_highAt - m_lowAt; }
  /// By how much the last step moved an end.
  [[nodiscard]] double moved() const { return m_moved; }
  [[nodiscard]] double lowAt() const { return m_lowAt; }
  [[nodiscard]] double high() const { return m_high; }

 private:
  double m_lowAt;
  double m_low;
  double m_highAt;
  double m_high;
  double m_moved = 0.0;
  int m_steps = 0;
  bool m_wasLow = true;
};

/// Where a motion is as steep as the ceiling: there it touches it, passes it or misses it.
struct Touch {
  double seconds = 0.0;    ///< of the motion
  double gapMmPerS = 0.0;  ///< the ceiling above the motion
};

/// How far a motion is looked at.
struct Until {
  double mm = 0.0;
  double seconds = 0.0;  ///< when the motion is there, or stands before it
};

/// The first such moment, or none. @param mm  where the motion begins on the ceiling
/// @param steepnessNow  at its beginning, not 0   @param accurateS  what the moment may be off
std::optional<Touch> firstTouch(const ConstantJerk& motion, const Until& until,
                                const SpeedProfile& ceiling, double mm, double steepnessNow,
                                double accurateS) {
  const bool falls = steepnessNow > 0.0;
  double beforeS = 0.0;
  double before = steepnessNow;
  for (std::size_t k = 0; k < ceiling.phaseCount(); ++k) {
    const double phaseMm = ceiling.phaseEndMm(k) - mm;
    if (phaseMm <= 0.0) {
      continue;
    }
    const bool reached = phaseMm < motion.lengthMm();
    const double afterS = reached && phaseMm != until.mm
                              ? std::min(until.seconds, motion.secondsAt(phaseMm))
                              : until.seconds;
    const SpeedState there = motion.stateAt(afterS);
    const SpeedState above =
        reached ? ceiling.phaseEnd(k) : ceiling.stateAtMm(mm + motion.lengthMm());
    const double after = steepness(there, above);
    if ((after > 0.0) == falls && after != 0.0) {
      if (!reached) {
        return std::nullopt;
      }
      beforeS = afterS;
      before = after;
      continue;
    }
    Touch touch{afterS, above.speedMmPerS - there.speedMmPerS};
    SignChange change(beforeS, before, afterS, after);
    for (int i = 0; i < kSearchSteps && change.high() != 0.0; ++i) {
      const double atS = change.next();
      const SpeedState ours = motion.stateAt(atS);
      const SpeedState theirs = ceiling.stateAtMm(mm + motion.lengthMmAt(atS));
      touch = {atS, theirs.speedMmPerS - ours.speedMmPerS};
      const double found = steepness(ours, theirs);
      change.take(atS, found, (found > 0.0) == falls);
      if (change.width() <= accurateS || change.moved() <= kAccurateShare * accurateS) {
        break;
      }
    }
    return touch;
  }
  return std::nullopt;
}

}  // namespace

double SpeedCeiling::cap(const Section& section) const {
  return std::min(section.given.feedMmPerS * m_override, section.given.fastestMmPerS);
}

SpeedState SpeedCeiling::jointAfter(std::size_t index) const {
  return index + 1 < m_sections.size() ? m_sections[index + 1].joint : SpeedState{};
}

double SpeedCeiling::accelerationAfter(std::size_t index) const {
  return index + 1 < m_sections.size() ? m_sections[index + 1].accelerationMmPerS2
                                       : m_sections[index].given.limits.accelerationMmPerS2;
}

std::size_t SpeedCeiling::replaceTail(std::size_t keep, const std::deque<SpeedSection>& tail) {
  const SpeedState reached = m_sections.empty() ? SpeedState{} : m_sections.front().reached;
  m_sections.resize(keep);
  for (const SpeedSection& given : tail) {
    Section section;
    section.given = given;
    section.forwardMmPerS2 = given.limits.accelerationMmPerS2;
    m_sections.push_back(section);
  }
  if (keep == 0) {
    m_sections.front().reached = reached;
  }
  reachForward(keep);
  return planBackwards(keep, false);
}

void SpeedCeiling::setOverride(double factor) {
  m_override = factor;
  reachForward(0);
  planBackwards(0, true);
}

void SpeedCeiling::reachForward(std::size_t from) {
  for (std::size_t i = from; i < m_sections.size(); ++i) {
    Section& section = m_sections[i];
    const SpeedLimits& limits = section.given.limits;
    if (i == 0) {
      continue;  // the path has come here
    }
    const Section& before = m_sections[i - 1];
    const double perSectionMmPerS2 =
        before.given.limits.jerkMmPerS3 * before.given.lengthMm / before.given.fastestMmPerS;
    section.forwardMmPerS2 = std::min(
        {section.given.jointAccelerationMmPerS2, limits.accelerationMmPerS2,
         before.given.limits.accelerationMmPerS2, before.forwardMmPerS2 + perSectionMmPerS2});
    SpeedState state = SpeedProfile::climb(before.reached, before.given.lengthMm, cap(before),
                                           before.given.limits, section.forwardMmPerS2)
                           .end();
    const double limit = std::min({section.given.jointMmPerS, cap(before), cap(section)});
    double& a = state.accelerationMmPerS2;
    if (state.speedMmPerS > limit) {
      state.speedMmPerS = limit;
      a = std::min(a, slopeMmPerS2(before.reached.speedMmPerS, limit, before.given.lengthMm));
    }
    // From here on it must be able to climb on.
    const double v = state.speedMmPerS;
    const double j = limits.jerkMmPerS3;
    a = std::min(a, std::sqrt(2.0 * j * std::max(0.0, cap(section) - v)));
    a = std::max({a, -section.forwardMmPerS2, -std::sqrt(2.0 * j * v)});
    section.reached = state;
  }
}

std::size_t SpeedCeiling::planBackwards(std::size_t from, bool everything) {
  for (std::size_t i = m_sections.size(); i-- > 0;) {
    Section& section = m_sections[i];
    const SpeedSection& given = section.given;
    const double accelerationMmPerS2 = std::min(
        section.forwardMmPerS2,
        accelerationAfter(i) + given.limits.jerkMmPerS3 * given.lengthMm / given.fastestMmPerS);
    const SpeedState after = jointAfter(i);
    const bool sameAcceleration = accelerationMmPerS2 == section.accelerationMmPerS2;
    section.accelerationMmPerS2 = accelerationMmPerS2;
    section.ceiling =
        SpeedProfile::climb({after.speedMmPerS, -after.accelerationMmPerS2}, given.lengthMm,
                            cap(section), given.limits, accelerationMmPerS2)
            .reversed();
    if (i == 0) {
      return 0;
    }
    const SpeedState joint = chooseJoint(i);
    const bool unchanged = i < from && joint == section.joint && sameAcceleration;
    section.joint = joint;
    if (unchanged && !everything) {
      return i;
    }
  }
  return 0;
}

SpeedState SpeedCeiling::chooseJoint(std::size_t index) const {
  const Section& section = m_sections[index];
  const Section& before = m_sections[index - 1];
  const double limit = std::min({section.given.jointMmPerS, cap(before), cap(section)});
  if (limit <= 0.0) {
    return {};
  }
  const double j = section.given.limits.jerkMmPerS3;
  const double jBefore = before.given.limits.jerkMmPerS3;
  const double allowed = section.accelerationMmPerS2;
  // What both sections can bear, so that the climb (backwards) can go on.
  const SpeedState climbed = section.ceiling.stateAtMm(0.0);
  const auto lowest = [&](double v) {
    // Braking harder than the ceiling in proportion is of no use.
    const double slower = v / climbed.speedMmPerS;
    return -std::min({allowed, std::sqrt(2.0 * jBefore * std::max(0.0, cap(before) - v)),
                      slower * slower * std::max(0.0, -climbed.accelerationMmPerS2)});
  };
  const auto highest = [&](double v) {
    return std::min({allowed, std::sqrt(2.0 * jBefore * v),
                     std::sqrt(2.0 * j * std::max(0.0, cap(section) - v))});
  };
  const auto canClimbOn = [&](const SpeedState& state) {
    const double v = state.speedMmPerS;
    const double a = state.accelerationMmPerS2;
    return v <= limit + kRoundingMmPerS && std::abs(a) <= allowed + kRoundingMmPerS2 &&
           (a > 0.0 ? v >= 0.5 * a * a / jBefore - kRoundingMmPerS
                    : v + 0.5 * a * a / jBefore <= cap(before) + kRoundingMmPerS);
  };
  const double v = std::min(limit, climbed.speedMmPerS);
  if (canClimbOn(climbed)) {
    return climbed;
  }
  const auto isSafeAt = [&](const SpeedState& state) { return isSafe(index, 0.0, state); };
  const double wanted =
      smallerSlope(section.reached.accelerationMmPerS2,
                   slopeMmPerS2(v, jointAfter(index).speedMmPerS, section.given.lengthMm));
  SpeedState best{v, std::clamp(wanted, lowest(v), std::max(lowest(v), highest(v)))};
  if (isSafeAt(best)) {
    return best;
  }
  double unsafe = best.accelerationMmPerS2;
  best.accelerationMmPerS2 = lowest(v);
  if (isSafeAt(best)) {
    for (int i = 0; i < kCeilingHalvings; ++i) {
      const double middle = 0.5 * (best.accelerationMmPerS2 + unsafe);
      if (isSafeAt({v, middle})) {
        best.accelerationMmPerS2 = middle;
      } else {
        unsafe = middle;
      }
    }
    return best;
  }
  double tooFast = v;
  best = {};
  for (int i = 0; i < kCeilingHalvings; ++i) {
    const double middle = 0.5 * (best.speedMmPerS + tooFast);
    const SpeedState state{middle, lowest(middle)};
    if (isSafeAt(state)) {
      best = state;
    } else {
      tooFast = middle;
    }
  }
  return best;
}

SpeedCeiling::Meeting SpeedCeiling::meet(std::size_t index, double mm,
                                         const SpeedState& from) const {
  Meeting meeting;
  meeting.marginMmPerS = std::numeric_limits<double>::max();  // nothing has been compared yet
  SpeedState state = from;
  for (; index < m_sections.size(); ++index, mm = 0.0) {
    const SpeedSection& given = m_sections[index].given;
    const SpeedProfile& ceiling = m_sections[index].ceiling;
    const double leftMm = std::max(0.0, given.lengthMm - mm);
    const auto met = [&](double atMm, double gapMmPerS) {
      meeting.index = index;
      meeting.mm = atMm;
      meeting.gapMmPerS = gapMmPerS;
      meeting.marginMmPerS = std::min(meeting.marginMmPerS, gapMmPerS);
      return meeting;
    };
    const SpeedState above = ceiling.stateAtMm(mm);
    const double steepnessNow = steepness(state, above);
    if (steepnessNow == 0.0) {
      return met(mm, above.speedMmPerS - state.speedMmPerS);
    }
    const bool falls = steepnessNow > 0.0;
    if (!falls) {
      meeting.marginMmPerS = std::min(meeting.marginMmPerS, above.speedMmPerS - state.speedMmPerS);
    }
    const double jerk = falls ? -given.limits.jerkMmPerS3 : given.limits.jerkMmPerS3;
    const ConstantJerk motion = withJerk(state, jerk, leftMm);
    const double endS = motion.lengthMm() > leftMm ? motion.secondsAt(leftMm) : motion.durationS();
    if (falls && jointAfter(index).speedMmPerS <= 0.0) {
      // Both speeds vanish at a stop: a motion that is too fast before may seem to touch only
      // there.
      for (int look = 1; look < kLooksBeforeStop; ++look) {
        const double atS = endS * look / kLooksBeforeStop;
        const double aboveMmPerS = ceiling.stateAtMm(mm + motion.lengthMmAt(atS)).speedMmPerS;
        meeting.marginMmPerS =
            std::min(meeting.marginMmPerS, aboveMmPerS - motion.stateAt(atS).speedMmPerS);
      }
    }
    const double accurateS = std::sqrt(kRoundingMmPerS / given.limits.jerkMmPerS3);
    if (const auto touch =
            firstTouch(motion, {leftMm, endS}, ceiling, mm, steepnessNow, accurateS)) {
      return met(std::min(given.lengthMm, mm + motion.lengthMmAt(touch->seconds)),
                 touch->gapMmPerS);
    }
    if (motion.lengthMm() < leftMm) {
      const double faded = fadedSpeedMmPerS(state, given.limits.jerkMmPerS3);
      if (!falls && faded > -onCeilingMmPerS(given)) {
        return met(mm + motion.lengthMm(), above.speedMmPerS);  // it comes to a stand here
      }
      meeting.marginMmPerS =
          std::min(meeting.marginMmPerS, faded - onCeilingMmPerS(given));  // turns back
      break;
    }
    state = motion.stateAt(endS);
    const SpeedState joint = jointAfter(index);
    const double spare = std::min(
        joint.speedMmPerS - state.speedMmPerS,
        kSpeedPerAccelerationS * (accelerationAfter(index) - std::abs(state.accelerationMmPerS2)));
    meeting.marginMmPerS = std::min(meeting.marginMmPerS, spare);
    if (spare < -onCeilingMmPerS(given)) {
      break;
    }
  }
  meeting.index = std::min(index, m_sections.size() - 1);
  meeting.mm = m_sections[meeting.index].given.lengthMm;
  return meeting;
}

bool SpeedCeiling::isSafe(std::size_t index, double mm, const SpeedState& state,
                          std::size_t* reach) const {
  if (index >= m_sections.size()) {
    return state.speedMmPerS <= onCeilingMmPerS(m_sections.back().given);
  }
  const Meeting meeting = meet(index, mm, state);
  if (reach != nullptr) {
    *reach = std::max(*reach, meeting.index);
  }
  return meeting.marginMmPerS >= -onCeilingMmPerS(m_sections[index].given);
}

bool SpeedCeiling::isSafeAtJoint(const SpeedState& state, std::size_t* reach) const {
  const double a = state.accelerationMmPerS2;
  return state.speedMmPerS <= jointAfter(0).speedMmPerS + kRoundingMmPerS &&
         std::abs(a) <= accelerationAfter(0) + kRoundingMmPerS2 && isSafe(1, 0.0, state, reach);
}

SpeedState SpeedCeiling::passJoint(const SpeedState& state) const {
  const SpeedState joint = jointAfter(0);
  const SpeedSection& given = m_sections.front().given;
  const bool same = std::abs(joint.speedMmPerS - state.speedMmPerS) <= onCeilingMmPerS(given) &&
                    std::abs(joint.accelerationMmPerS2 - state.accelerationMmPerS2) <=
                        kRoundingS * given.limits.jerkMmPerS3;
  return same || joint.speedMmPerS <= 0.0 ? joint : state;
}

SpeedProfile SpeedCeiling::profile(double mm, const SpeedState& state, std::size_t* reach) const {
  const Section& section = m_sections.front();
  const double lengthMm = section.given.lengthMm;
  const SpeedProfile& ceiling = section.ceiling;
  const auto onCeilingFrom = [&](SpeedProfile profile, double fromMm) {
    profile.addRest(ceiling, fromMm);
    profile.setEnd(lengthMm - mm, ceiling.end());
    *reach = std::max<std::size_t>(*reach, 1);
    return profile;
  };
  const SpeedState above = ceiling.stateAtMm(mm);
  const double touchMmPerS = kTouchShare * onCeilingMmPerS(section.given);
  if (std::abs(above.speedMmPerS - state.speedMmPerS) <= onCeilingMmPerS(section.given) &&
      kSpeedPerAccelerationS * std::abs(above.accelerationMmPerS2 - state.accelerationMmPerS2) <=
          onCeilingMmPerS(section.given)) {
    return onCeilingFrom(SpeedProfile(state), mm);
  }
  SpeedProfile climb = SpeedProfile::climb(state, lengthMm - mm, cap(section), section.given.limits,
                                           accelerationAfter(0));
  if (isSafeAtJoint(climb.end(), reach)) {
    return climb;
  }
  // The last moment from which the acceleration may fall.
  const auto meetingAt = [&](double seconds) {
    const Meeting meeting = meet(0, mm + climb.lengthMmAt(seconds), climb.stateAt(seconds));
    *reach = std::max(*reach, meeting.index);
    return meeting;
  };
  const auto marginOf = [&](const Meeting& meeting) {
    return meeting.marginMmPerS + 2.0 * touchMmPerS;
  };
  Meeting meeting = meetingAt(0.0);  // of the low end of the search
  SignChange change(0.0, marginOf(meeting), climb.durationS(),
                    std::min(marginOf(meetingAt(climb.durationS())), -touchMmPerS));
  for (int i = 0; i < kSearchSteps && marginOf(meeting) > touchMmPerS && change.width() > kTimeS;
       ++i) {
    const double atS = change.next();
    const Meeting found = meetingAt(atS);
    const bool isSafe = marginOf(found) >= 0.0;
    if (isSafe) {
      meeting = found;
    }
    change.take(atS, marginOf(found), isSafe);
  }
  climb.cut(change.lowAt());
  const double fromMm = mm + climb.lengthMm();
  const double gap = std::abs(meeting.gapMmPerS);
  if (meeting.index == 0 && meeting.mm <= fromMm && gap > onCeilingMmPerS(section.given) &&
      climb.durationS() <= kTimeS) {
    // No faster than the ceiling in proportion: that is safe, and nothing else is.
    const double slower = state.speedMmPerS / ceiling.stateAtMm(mm).speedMmPerS;
    SpeedProfile profile(state);
    profile.addRest(ceiling, mm, std::min(1.0, slower));
    profile.setEnd(lengthMm - mm, profile.end());
    return profile;
  }
  const ConstantJerk fall = withJerk(climb.end(), -section.given.limits.jerkMmPerS3, lengthMm);
  const double fallMm = (meeting.index > 0 ? lengthMm : meeting.mm) - fromMm;
  climb.add(fallMm < fall.lengthMm() ? fall.secondsAt(fallMm) : fall.durationS(),
            -section.given.limits.jerkMmPerS3);
  if (meeting.index > 0) {
    climb.setEnd(lengthMm - mm, climb.end());
  } else if (gap <= onCeilingMmPerS(section.given)) {
    return onCeilingFrom(std::move(climb), meeting.mm);
  }
  return climb;
}

}  // namespace rivulet::machine
