// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/motion_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trace/spectrum.h"

namespace rivulet::trace {

namespace {

/// Turns by less are chords of a curve.
constexpr double kCornerDegMin = 1.0;
/// The feed is kept at this share of it or more.
constexpr double kFeedKeptShare = 0.95;
/// An axis slower than this stands, or reverses.
constexpr double kAxisMovesMmPerS = 0.05;
constexpr std::size_t kPeaksMax = 5;
/// Samples of one spectrum.
constexpr std::size_t kSpectrumSize = 4096;
constexpr std::size_t kSpectrumSizeMin = 256;

double leftOf(base::Vec3 direction, base::Vec3 off) {
  return direction.x * off.y - direction.y * off.x;
}

/// Collects distances to the path.
class ContourCounter {
 public:
  void add(const ProgramPath& path, base::Instant at, base::Vec3 position, const PathPlace& place) {
    m_distances.push_back(place.distanceMm);
    m_squares += place.distanceMm * place.distanceMm;
    const base::Vec3 off = position - path.at(place.lengthMm);
    const double left = leftOf(path.direction(place.segment), off);
    m_error.leftMm = std::max(m_error.leftMm, left);
    m_error.rightMm = std::min(m_error.rightMm, left);
    if (place.distanceMm > m_error.maxMm) {
      m_error.maxMm = place.distanceMm;
      m_error.at = at;
      m_error.placeMm = position;
      m_error.line = path.points()[place.segment].line;
    }
  }

  [[nodiscard]] ContourError error() {
    m_error.count = m_distances.size();
    if (m_error.count > 0) {
      m_error.rmsMm = std::sqrt(m_squares / static_cast<double>(m_error.count));
      const auto rank = m_distances.begin() + static_cast<std::ptrdiff_t>(m_error.count * 95 / 100);
      std::nth_element(m_distances.begin(), rank, m_distances.end());
      m_error.p95Mm = *rank;
    }
    return m_error;
  }

 private:
  ContourError m_error;
  std::vector<double> m_distances;
  double m_squares = 0.0;
};

/// Where the actual position is on the path: near the set point, and mostly after it in time.
PathPlace placeOfActual(const Motion& motion, const MotionSample& sample, const ProgramPath& path,
                        const MatchedSample& matched) {
  if (!motion.hasSet) {
    return matched.place;
  }
  const double lagMm = base::distance(sample.setMm, sample.actualMm);
  // Around a corner, the lag is shorter than the path.
  return path.nearest(
      sample.actualMm,
      std::max(0.0, matched.place.lengthMm - 3.0 * lagMm - matched.place.distanceMm),
      matched.place.lengthMm + lagMm);
}

void judgeContour(MotionQuality& quality, const Motion& motion, const ProgramPath& path,
                  const PathMatch& match) {
  ContourCounter set;
  ContourCounter actual;
  MotionReader samples(motion.samples);
  for (const MatchedSample& matched : match.samples) {
    if (!std::isfinite(matched.place.distanceMm)) {
      continue;
    }
    const MotionSample& sample = samples[matched.sample];
    if (motion.hasSet) {
      set.add(path, sample.at, sample.setMm, matched.place);
    }
    if (motion.hasActual) {
      actual.add(path, sample.at, sample.actualMm, placeOfActual(motion, sample, path, matched));
    }
  }
  quality.setContour = set.error();
  quality.actualContour = actual.error();
}

/// The following error of one axis. Least squares over its speed and its direction tell what
/// changes its sign with the direction.
class FollowingCounter {
 public:
  /// @param errorMm  set point minus actual position
  void add(double errorMm, double mmPerS) {
    ++m_count;
    m_squares += errorMm * errorMm;
    m_maxMm = std::max(m_maxMm, std::abs(errorMm));
    if (std::abs(mmPerS) < kAxisMovesMmPerS) {
      return;
    }
    const double direction = mmPerS > 0.0 ? 1.0 : -1.0;
    m_forwards = m_forwards || mmPerS > 0.0;
    m_backwards = m_backwards || mmPerS < 0.0;
    m_vv += mmPerS * mmPerS;
    m_vd += mmPerS * direction;
    m_dd += 1.0;
    m_ev += errorMm * mmPerS;
    m_ed += errorMm * direction;
  }

  [[nodiscard]] FollowingError error() const {
    FollowingError error;
    error.maxMm = m_maxMm;
    error.rmsMm = std::sqrt(m_squares / static_cast<double>(m_count));
    const double determinant = m_vv * m_dd - m_vd * m_vd;
    // At one speed only, the two parts cannot be told apart.
    if (m_forwards && m_backwards && !(determinant < 1e-6 * m_vv * m_dd)) {
      error.reversalMm = 2.0 * std::abs((m_ed * m_vv - m_ev * m_vd) / determinant);
    }
    return error;
  }

 private:
  std::size_t m_count = 0;
  double m_squares = 0.0;
  double m_maxMm = 0.0;
  double m_vv = 0.0;
  double m_vd = 0.0;
  double m_dd = 0.0;
  double m_ev = 0.0;
  double m_ed = 0.0;
  bool m_forwards = false;
  bool m_backwards = false;
};

void judgeFollowing(MotionQuality& quality, const Motion& motion) {
  quality.hasFollowing = motion.hasSet && motion.hasActual && motion.samples.size() > 2;
  if (!quality.hasFollowing) {
    return;
  }
  std::array<FollowingCounter, base::kAxisCount> counters;
  MotionReader samples(motion.samples);
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const MotionSample& before = samples[i - 1];
    const MotionSample& sample = samples[i];
    const MotionSample& after = samples[i + 1];
    const double seconds = base::toSeconds(after.at - before.at);
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      counters[axis].add(sample.setMm[axis] - sample.actualMm[axis],
                         (after.setMm[axis] - before.setMm[axis]) / seconds);
    }
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    quality.following[axis] = counters[axis].error();
  }
}

double turnDegAt(const ProgramPath& path, std::size_t point) {
  std::size_t next = point + 1;
  while (next < path.points().size() && base::norm(path.direction(next)) == 0.0) {
    ++next;
  }
  if (next >= path.points().size()) {
    return 0.0;
  }
  const double cosine = base::dot(path.direction(point), path.direction(next));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

void findCorners(MotionQuality& quality, const Motion& motion, const ProgramPath& path,
                 const PathMatch& match) {
  MotionReader samples(motion.samples);
  std::size_t from = 0;
  for (std::size_t point = 0; point + 1 < path.points().size(); ++point) {
    const double turn = path.isBlockEnd(point) ? turnDegAt(path, point) : 0.0;
    if (turn < kCornerDegMin || base::norm(path.direction(point)) == 0.0) {
      continue;
    }
    const base::Vec3 place = path.points()[point].positionMm;
    const double at = path.lengthTo(point);
    const double before = at - path.lengthTo(point) + (point > 0 ? path.lengthTo(point - 1) : 0.0);
    const double after = path.lengthTo(point + 1);
    CornerRounding corner{point, path.points()[point].line, turn, 0.0, 0.0, 0.0};
    corner.setMm = corner.actualMm = corner.mmPerSMin = std::numeric_limits<double>::infinity();
    while (from < match.samples.size() && match.samples[from].place.lengthMm < before) {
      ++from;
    }
    for (std::size_t i = from;
         i + 1 < match.samples.size() && match.samples[i].place.lengthMm <= after; ++i) {
      const MotionSample a = samples[match.samples[i].sample];
      const MotionSample& b = samples[match.samples[i + 1].sample];
      const double set = base::distanceToSegment(place, a.setMm, b.setMm);
      corner.actualMm =
          std::min(corner.actualMm, base::distanceToSegment(place, a.actualMm, b.actualMm));
      if (set < corner.setMm) {
        corner.setMm = set;
      }
      corner.mmPerSMin = std::min(corner.mmPerSMin, a.pathMmPerS);
    }
    if (std::isfinite(corner.setMm)) {
      corner.setMm = motion.hasSet ? corner.setMm : 0.0;
      corner.actualMm = motion.hasActual ? corner.actualMm : 0.0;
      quality.corners.push_back(corner);
    }
  }
}

void addStanding(FeedKept& feed, const std::vector<Standstill>& stops) {
  for (const Standstill& stop : stops) {
    auto found = std::find_if(feed.standing.begin(), feed.standing.end(),
                              [&stop](const TimeLost& lost) { return lost.cause == stop.cause; });
    if (found == feed.standing.end()) {
      feed.standing.push_back({stop.cause, 0.0, 0});
      found = feed.standing.end() - 1;
    }
    found->seconds += base::toSeconds(stop.duration);
    ++found->stops;
  }
}

/// The programmed feed at each sample, from the program or from the trace.
class ProgrammedFeeds {
 public:
  ProgrammedFeeds(const Motion& motion, const ProgramPath* path, const PathMatch* match)
      : m_motion(motion),
        m_path(path),
        m_match(match != nullptr && match->judged ? match : nullptr) {}

  /// @param index  not less than at the call before  @return 0: not known
  [[nodiscard]] double at(std::size_t index, const MotionSample& sample) {
    double feed = 0.0;
    if (m_path != nullptr && m_match != nullptr) {
      const std::vector<MatchedSample>& matched = m_match->samples;
      while (m_next + 1 < matched.size() && matched[m_next].sample < index) {
        ++m_next;
      }
      feed = m_path->points()[matched[m_next].place.segment].feedMmPerS;
    }
    const bool isKnown = feed > 0.0 || !m_motion.hasFeed || !std::isfinite(sample.feedMmPerS);
    return isKnown ? feed : sample.feedMmPerS;
  }

 private:
  const Motion& m_motion;
  const ProgramPath* m_path;
  const PathMatch* m_match;
  std::size_t m_next = 0;
};

void judgeFeed(MotionQuality& quality, const Motion& motion, const std::vector<Standstill>& stops,
               const ProgramPath* path, const PathMatch* match) {
  FeedKept& feed = quality.feed;
  addStanding(feed, stops);
  ProgrammedFeeds feeds(motion, path, match);
  MotionReader samples(motion.samples);
  double knownMm = 0.0;
  double keptMm = 0.0;
  double movingS = 0.0;
  double standingS = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const MotionSample& before = samples[i - 1];
    const MotionSample& sample = samples[i];
    const double lengthMm = base::distance(motion.placeMm(sample), motion.placeMm(before));
    const double stepS = base::toSeconds(sample.at - before.at);
    const double programmed = feeds.at(i, sample);
    if (lengthMm > 0.0 || movingS > 0.0) {
      standingS = lengthMm > 0.0 ? 0.0 : standingS + stepS;
      movingS += stepS;
    }
    if (programmed <= 0.0 || lengthMm == 0.0) {
      continue;
    }
    feed.known = true;
    knownMm += lengthMm;
    keptMm += sample.pathMmPerS >= kFeedKeptShare * programmed ? lengthMm : 0.0;
    feed.programmedS += lengthMm / programmed;
  }
  feed.motionS = movingS - standingS;
  feed.share = knownMm > 0.0 ? keptMm / knownMm : 0.0;
  double standing = 0.0;
  for (const TimeLost& lost : feed.standing) {
    standing += lost.seconds;
  }
  feed.slowS = feed.known ? std::max(0.0, feed.motionS - standing - feed.programmedS) : 0.0;
}

void addPeaks(Vibration& vibration, const std::vector<double>& spectrum, std::size_t axis,
              double stepHz) {
  for (std::size_t k = 2; k + 1 < spectrum.size(); ++k) {
    if (spectrum[k] > spectrum[k - 1] && spectrum[k] >= spectrum[k + 1]) {
      vibration.peaks.push_back({axis, stepHz * static_cast<double>(k), spectrum[k]});
    }
  }
}

/// Whether nearly all steps are the usual one.
bool isRegular(const Motion& motion) {
  const double stepS = base::toSeconds(motion.step);
  PackedReader<PackedTimes> at(motion.samples.times());
  std::size_t regular = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    const double own = base::toSeconds(at[i] - at[i - 1]);
    regular += static_cast<std::size_t>(std::abs(own - stepS) <= 0.01 * stepS);
  }
  return 100 * regular >= 99 * (at.size() - 1);
}

void judgeVibration(MotionQuality& quality, const Motion& motion) {
  const double stepS = base::toSeconds(motion.step);
  const std::size_t count = motion.samples.size();
  Vibration& vibration = quality.vibration;
  vibration.known = count > kSpectrumSizeMin && isRegular(motion);
  if (!vibration.known) {
    return;
  }
  std::size_t size = kSpectrumSize;
  while (size > count - 2) {
    size /= 2;
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const MotionColumn ofX = motion.hasActual ? MotionColumn::ActualX : MotionColumn::SetX;
    const auto column = static_cast<MotionColumn>(static_cast<std::size_t>(ofX) + axis);
    if (motion.samples.isConstant(column)) {
      continue;  // nothing vibrates
    }
    const PackedValues positions = motion.samples.valuesOf(column);
    PackedReader<PackedValues> position(positions);
    const auto acceleration = [&position, stepS](std::size_t i) {
      return (position[i + 2] - 2.0 * position[i + 1] + position[i]) / (stepS * stepS);
    };
    double squares = 0.0;
    double before = acceleration(0);
    for (std::size_t i = 1; i + 2 < count; ++i) {
      const double now = acceleration(i);
      const double jerk = (now - before) / stepS;
      squares += jerk * jerk;
      before = now;
    }
    vibration.jerkRmsMmPerS3[axis] = std::sqrt(squares / static_cast<double>(count - 3));
    addPeaks(vibration, meanAmplitudes(count - 2, acceleration, size, size), axis,
             1.0 / (stepS * static_cast<double>(size)));
  }
  std::sort(vibration.peaks.begin(), vibration.peaks.end(),
            [](const SpectrumPeak& a, const SpectrumPeak& b) {
              return a.amplitudeMmPerS2 > b.amplitudeMmPerS2;
            });
  vibration.peaks.resize(std::min(vibration.peaks.size(), kPeaksMax));
}

}  // namespace

std::vector<ContourDistance> contourDistances(const Motion& motion, const ProgramPath& path,
                                              const PathMatch& match) {
  std::vector<ContourDistance> distances;
  MotionReader samples(motion.samples);
  for (const MatchedSample& matched : match.samples) {
    if (std::isfinite(matched.place.distanceMm)) {
      const PathPlace actual = placeOfActual(motion, samples[matched.sample], path, matched);
      distances.push_back({matched.sample, matched.place.segment, matched.place.lengthMm,
                           matched.place.distanceMm, actual.distanceMm, actual.lengthMm});
    }
  }
  return distances;
}

MotionQuality judgeMotion(const Motion& motion, const std::vector<Standstill>& stops,
                          const ProgramPath* path, const PathMatch* match) {
  MotionQuality quality;
  if (path != nullptr && match != nullptr && match->judged) {
    judgeContour(quality, motion, *path, *match);
    findCorners(quality, motion, *path, *match);
  }
  judgeFollowing(quality, motion);
  judgeFeed(quality, motion, stops, path, match);
  judgeVibration(quality, motion);
  return quality;
}

}  // namespace rivulet::trace
