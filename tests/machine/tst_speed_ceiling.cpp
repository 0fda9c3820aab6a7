// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "machine/speed_ceiling.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::SpeedCeiling;
using machine::SpeedProfile;
using machine::SpeedSection;
using machine::SpeedState;

namespace {

/// A bend of the path whose limits rise and fall as on a dense smooth contour.
std::deque<SpeedSection> smoothSections(base::Random& random) {
  std::deque<SpeedSection> sections;
  const double pi = std::acos(-1.0);
  const double waveMm = 5.0 + 15.0 * random.uniform();
  const double slowest = 15.0 + 10.0 * random.uniform();
  double mm = 0.0;
  for (int i = 0; i < 160; ++i) {
    SpeedSection section;
    section.lengthMm = 0.15 + 0.1 * random.uniform();
    section.feedMmPerS = 50.0;
    section.fastestMmPerS = 60.0;
    section.limits = {500.0 + 300.0 * random.uniform(), 15000.0 + 10000.0 * random.uniform()};
    section.jointMmPerS = i == 0 ? 0.0 : slowest * (1.5 + std::sin(2.0 * pi * mm / waveMm));
    section.jointAccelerationMmPerS2 = 1e9;
    mm += section.lengthMm;
    sections.push_back(section);
  }
  return sections;
}

/// Time and state at the start of each section and at the end.
struct Passing {
  std::vector<double> atS;
  std::vector<SpeedState> states;
};

Passing drive(SpeedCeiling ceiling) {
  Passing passing;
  SpeedState state;
  double mm = 0.0;
  double seconds = 0.0;
  std::size_t reach = 0;
  while (ceiling.size() > 0) {
    if (mm == 0.0) {
      passing.atS.push_back(seconds);
      passing.states.push_back(state);
    }
    const SpeedProfile profile = ceiling.profile(mm, state, &reach);
    state = profile.end();
    seconds += profile.durationS();
    mm += profile.lengthMm();
    if (mm > ceiling.section(0).lengthMm * (1.0 - 1e-9)) {
      state = ceiling.passJoint(state);
      ceiling.popFront();
      mm = 0.0;
    }
  }
  passing.atS.push_back(seconds);
  passing.states.push_back(state);
  return passing;
}

/// Shortest time between two joints, near the optimum: dynamic programming backwards over a grid of
/// speed and acceleration, in steps of the path of 0.06 mm at most, with five values of the jerk
/// per step, interpolating the time between grid points. At the border of what is feasible only the
/// feasible neighbours count, and the end may be missed by one grid step: both make it rather
/// shorter. It is no strict bound; its error is of the order of a percent.
class Reference {
 public:
  explicit Reference(const std::deque<SpeedSection>& sections) : m_sections(sections) {}

  double secondsBetween(std::size_t from, std::size_t to, const SpeedState& start,
                        const SpeedState& end) {
    m_times.assign(kSpeeds * kAccelerations, kNever);
    for (std::size_t i = 0; i < kSpeeds * kAccelerations; ++i) {
      const SpeedState state = stateOf(i);
      if (state.speedMmPerS <= end.speedMmPerS + kSpeedStep &&
          state.accelerationMmPerS2 <= end.accelerationMmPerS2 + kAccelerationStep) {
        m_times[i] = 0.0;
      }
    }
    for (std::size_t section = to; section-- > from;) {
      const int steps = static_cast<int>(std::ceil(m_sections[section].lengthMm / 0.06));
      for (int step = steps; step-- > 0;) {
        sweep(section, m_sections[section].lengthMm / steps, step + 1 == steps);
      }
    }
    return timeFrom(start);
  }

 private:
  static constexpr double kSpeedStep = 0.5;
  static constexpr double kAccelerationStep = 40.0;
  static constexpr std::size_t kSpeeds = 102;
  static constexpr std::size_t kAccelerations = 43;
  static constexpr double kNever = 1e6;

  static SpeedState stateOf(std::size_t index) {
    return {static_cast<double>(index / kAccelerations) * kSpeedStep,
            (static_cast<double>(index % kAccelerations) - 21.0) * kAccelerationStep};
  }

  [[nodiscard]] double timeFrom(const SpeedState& state) const {
    const double v = state.speedMmPerS / kSpeedStep;
    const double a = state.accelerationMmPerS2 / kAccelerationStep + 21.0;
    if (v < 0.0 || a < 0.0 || v > kSpeeds - 1.0 || a > kAccelerations - 1.0) {
      return kNever;
    }
    const std::size_t i = std::min(static_cast<std::size_t>(v), kSpeeds - 2);
    const std::size_t k = std::min(static_cast<std::size_t>(a), kAccelerations - 2);
    double weights = 0.0;
    double sum = 0.0;
    for (const std::size_t di : {0U, 1U}) {
      for (const std::size_t dk : {0U, 1U}) {
        const double weight = (1.0 - std::abs(v - static_cast<double>(i + di))) *
                              (1.0 - std::abs(a - static_cast<double>(k + dk)));
        const double time = m_times[(i + di) * kAccelerations + k + dk];
        if (time < kNever) {
          weights += weight;
          sum += weight * time;
        }
      }
    }
    return weights > 0.25 ? sum / weights : kNever;
  }

  void sweep(std::size_t index, double stepMm, bool endsSection) {
    const SpeedSection& section = m_sections[index];
    const double capMmPerS = std::min(section.feedMmPerS, section.fastestMmPerS);
    double speedMax = capMmPerS;
    double accelerationMax = section.limits.accelerationMmPerS2;
    if (endsSection) {
      speedMax = std::min(speedMax, m_sections[index + 1].jointMmPerS);
      accelerationMax = std::min(accelerationMax, m_sections[index + 1].limits.accelerationMmPerS2);
    }
    std::vector<double> times(m_times.size(), kNever);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const SpeedState state = stateOf(i);
      if (state.speedMmPerS <= 0.0 || state.speedMmPerS > capMmPerS + 0.5 * kSpeedStep) {
        continue;
      }
      for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        SpeedProfile motion(state);
        motion.add(3.0 * stepMm / state.speedMmPerS, share * section.limits.jerkMmPerS3);
        if (motion.lengthMm() <= stepMm) {
          continue;
        }
        const double seconds = motion.secondsAt(stepMm);
        const SpeedState after = motion.stateAt(seconds);
        if (after.speedMmPerS <= speedMax + 1e-9 &&
            std::abs(after.accelerationMmPerS2) <= accelerationMax + 1e-9) {
          times[i] = std::min(times[i], seconds + timeFrom(after));
        }
      }
      times[i] = std::min(times[i], kNever);
    }
    m_times = std::move(times);
  }

  const std::deque<SpeedSection>& m_sections;
  std::vector<double> m_times;
};

}  // namespace

class TestSpeedCeiling : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// At most 8 % longer than the shortest time under the same limits, between two joints of a
  /// smooth contour that are passed in motion.
  void isNearTheShortestTime() {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      base::Random random(seed);
      const std::deque<SpeedSection> sections = smoothSections(random);
      SpeedCeiling ceiling;
      ceiling.replaceTail(0, sections);
      const Passing passing = drive(ceiling);
      QCOMPARE(passing.atS.size(), sections.size() + 1);
      const std::size_t from = 30;
      const std::size_t to = 130;
      const double ours = passing.atS[to] - passing.atS[from];
      const double shortest =
          Reference(sections).secondsBetween(from, to, passing.states[from], passing.states[to]);
      const QString where =
          QStringLiteral("seed %1: %2 s, reference %3 s").arg(seed).arg(ours).arg(shortest);
      QVERIFY2(ours <= 1.08 * shortest, qPrintable(where));
      QVERIFY2(ours >= 0.97 * shortest, qPrintable(where + QStringLiteral(": a poor reference")));
    }
  }
};

RIVULET_TEST(TestSpeedCeiling)
#include "tst_speed_ceiling.moc"
