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
  void add(const Motion& motion, const ProgramPath& path, std::size_t sample, base::Vec3 position,
           const PathPlace& place) {
    m_distances.push_back(place.distanceMm);
    m_squares += place.distanceMm * place.distanceMm;
    const base::Vec3 off = position - path.at(place.lengthMm);
    const double left = leftOf(path.direction(place.segment), off);
    m_error.leftMm = std::max(m_error.leftMm, left);
    m_error.rightMm = std::min(m_error.rightMm, left);
    if (place.distanceMm > m_error.maxMm) {
      m_error.maxMm = place.distanceMm;
      m_error.at = motion.samples[sample].at;
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
PathPlace placeOfActual(const Motion& motion, const ProgramPath& path,
                        const MatchedSample& matched) {
  const MotionSample& sample = motion.samples[matched.sample];
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
  for (const MatchedSample& matched : match.samples) {
    if (!std::isfinite(matched.place.distanceMm)) {
      continue;
    }
    const MotionSample& sample = motion.samples[matched.sample];
    if (motion.hasSet) {
      set.add(motion, path, matched.sample, sample.setMm, matched.place);
    }
    if (motion.hasActual) {
      actual.add(motion, path, matched.sample, sample.actualMm,
                 placeOfActual(motion, path, matched));
    }
  }
  quality.setContour = set.error();
  quality.actualContour = actual.error();
}

/// Least squares of the error over speed and direction of one axis.
std::optional<double> reversalOf(const std::vector<double>& errors,
                                 const std::vector<double>& speeds) {
  double vv = 0.0;
  double vd = 0.0;
  double dd = 0.0;
  double ev = 0.0;
  double ed = 0.0;
  bool forwards = false;
  bool backwards = false;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double v = speeds[i];
    if (std::abs(v) < kAxisMovesMmPerS) {
      continue;
    }
    const double d = v > 0.0 ? 1.0 : -1.0;
    forwards = forwards || v > 0.0;
    backwards = backwards || v < 0.0;
    vv += v * v;
    vd += v * d;
    dd += 1.0;
    ev += errors[i] * v;
    ed += errors[i] * d;
  }
  const double determinant = vv * dd - vd * vd;
  // At one speed only, the two parts cannot be told apart.
  if (!forwards || !backwards || determinant < 1e-6 * vv * dd) {
    return std::nullopt;
  }
  return 2.0 * std::abs((ed * vv - ev * vd) / determinant);
}

void judgeFollowing(MotionQuality& quality, const Motion& motion) {
  quality.hasFollowing = motion.hasSet && motion.hasActual && motion.samples.size() > 2;
  for (std::size_t axis = 0; quality.hasFollowing && axis < base::kAxisCount; ++axis) {
    FollowingError& error = quality.following[axis];
    std::vector<double> errors;
    std::vector<double> speeds;
    double squares = 0.0;
    for (std::size_t i = 1; i + 1 < motion.samples.size(); ++i) {
      const MotionSample& sample = motion.samples[i];
      const double off = sample.setMm[axis] - sample.actualMm[axis];
      const MotionSample& before = motion.samples[i - 1];
      const MotionSample& after = motion.samples[i + 1];
      errors.push_back(off);
      speeds.push_back((after.setMm[axis] - before.setMm[axis]) /
                       base::toSeconds(after.at - before.at));
      squares += off * off;
      error.maxMm = std::max(error.maxMm, std::abs(off));
    }
    error.rmsMm = std::sqrt(squares / static_cast<double>(errors.size()));
    error.reversalMm = reversalOf(errors, speeds);
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
      const MotionSample& a = motion.samples[match.samples[i].sample];
      const MotionSample& b = motion.samples[match.samples[i + 1].sample];
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

/// The programmed feed at each used sample, from the program or from the trace; 0: not known.
std::vector<double> feedsOf(const Motion& motion, const ProgramPath* path, const PathMatch* match) {
  std::vector<double> feeds(motion.samples.size(), 0.0);
  if (path != nullptr && match != nullptr && match->judged) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < feeds.size(); ++i) {
      while (next + 1 < match->samples.size() && match->samples[next].sample < i) {
        ++next;
      }
      feeds[i] = path->points()[match->samples[next].place.segment].feedMmPerS;
    }
  }
  for (std::size_t i = 0; motion.hasFeed && i < feeds.size(); ++i) {
    const double own = motion.samples[i].feedMmPerS;
    feeds[i] = feeds[i] <= 0.0 && std::isfinite(own) ? own : feeds[i];
  }
  return feeds;
}

void judgeFeed(MotionQuality& quality, const Motion& motion, const std::vector<Standstill>& stops,
               const ProgramPath* path, const PathMatch* match) {
  FeedKept& feed = quality.feed;
  addStanding(feed, stops);
  const std::vector<double> feeds = feedsOf(motion, path, match);
  double knownMm = 0.0;
  double keptMm = 0.0;
  double movingS = 0.0;
  double standingS = 0.0;
  for (std::size_t i = 1; i < motion.samples.size(); ++i) {
    const MotionSample& sample = motion.samples[i];
    const double lengthMm =
        base::distance(motion.placeMm(sample), motion.placeMm(motion.samples[i - 1]));
    const double stepS = base::toSeconds(sample.at - motion.samples[i - 1].at);
    if (lengthMm > 0.0 || movingS > 0.0) {
      standingS = lengthMm > 0.0 ? 0.0 : standingS + stepS;
      movingS += stepS;
    }
    if (feeds[i] <= 0.0 || lengthMm == 0.0) {
      continue;
    }
    feed.known = true;
    knownMm += lengthMm;
    keptMm += sample.pathMmPerS >= kFeedKeptShare * feeds[i] ? lengthMm : 0.0;
    feed.programmedS += lengthMm / feeds[i];
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

void judgeVibration(MotionQuality& quality, const Motion& motion) {
  const double stepS = base::toSeconds(motion.step);
  const std::size_t count = motion.samples.size();
  std::size_t regular = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double own = base::toSeconds(motion.samples[i].at - motion.samples[i - 1].at);
    regular += static_cast<std::size_t>(std::abs(own - stepS) <= 0.01 * stepS);
  }
  Vibration& vibration = quality.vibration;
  vibration.known = count > kSpectrumSizeMin && 100 * regular >= 99 * (count - 1);
  if (!vibration.known) {
    return;
  }
  std::size_t size = kSpectrumSize;
  while (size > count - 2) {
    size /= 2;
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const auto position = [&](std::size_t i) {
      return motion.hasActual ? motion.samples[i].actualMm[axis] : motion.samples[i].setMm[axis];
    };
    std::vector<double> acceleration;
    for (std::size_t i = 2; i < count; ++i) {
      acceleration.push_back((position(i) - 2.0 * position(i - 1) + position(i - 2)) /
                             (stepS * stepS));
    }
    double squares = 0.0;
    for (std::size_t i = 1; i < acceleration.size(); ++i) {
      const double jerk = (acceleration[i] - acceleration[i - 1]) / stepS;
      squares += jerk * jerk;
    }
    vibration.jerkRmsMmPerS3[axis] =
        std::sqrt(squares / static_cast<double>(acceleration.size() - 1));
    addPeaks(vibration, meanAmplitudes(acceleration, size, size), axis,
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
  for (const MatchedSample& matched : match.samples) {
    if (std::isfinite(matched.place.distanceMm)) {
      const PathPlace actual = placeOfActual(motion, path, matched);
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
