// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/lift_test.h"

#include <fmt/format.h>

#include <cmath>

#include "streaming/run/feed_order.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Result;

/// The overlay of a slow axis goes as far as it may in this time.
constexpr Duration kLifts = std::chrono::seconds{5};
constexpr Duration kStays = std::chrono::seconds{1};
/// Beside what may be asked, mm: little enough to be harmless on a control that obeys it.
constexpr double kBesideMm = 0.05;
/// The axis follows its set point within this, mm.
constexpr double kFollowsMm = 0.05;

bool isAt(double mm, double wantedMm) {
  return std::abs(mm - wantedMm) <= kLoweredMm;
}

class LiftTest {
 public:
  explicit LiftTest(FeedTestSteps& test) : m_test(test), m_liftMm(liftMmOf(test.feedPlan())) {}

  Result<void> run() {
    for (const auto step : {&LiftTest::findPath, &LiftTest::ignoreOthers, &LiftTest::lift,
                            &LiftTest::stand, &LiftTest::lower, &LiftTest::liftAgain}) {
      if (Result<void> done = (this->*step)(); !done || !m_test.goesOn()) {
        return done;
      }
    }
    return {};
  }

 private:
  Result<void> findPath() {
    const auto z = m_test.number(kZ);
    if (!z) {
      return base::fail(z.error());
    }
    m_pathZ = *z;
    return {};
  }

  Result<void> ignoreOthers() {
    for (const double mm : {-kBesideMm, m_liftMm + kBesideMm}) {
      Result<void> done = m_test.set(TestCell::Lift, mm);
      const auto obeyed =
          done ? m_test.await(kStays, [](const auto& seen) { return seen.liftedMm != 0.0; })
               : Result<std::optional<FeedTestSteps::Look>>(base::fail(done.error()));
      done = m_test.set(TestCell::Lift, 0.0);
      if (!obeyed || !done) {
        return base::fail(!obeyed ? obeyed.error() : done.error());
      }
      if (*obeyed) {
        m_test.add("lift-bounds", false,
                   fmt::format("With {:g} mm in the cell of the lift the overlay of Z became {:g} "
                               "mm: nothing but 0 to {:g} mm may act.",
                               mm, (*obeyed)->liftedMm, m_liftMm));
        return {};
      }
    }
    m_test.add("lift-bounds", true,
               fmt::format("Less than 0 and more than {:g} mm had no effect.", m_liftMm));
    return {};
  }

  /// @return the overlay and the axis itself have come to this, mm above the path
  Result<bool> comesTo(double mm) {
    if (Result<void> done = m_test.set(TestCell::Lift, mm); !done) {
      return base::fail(done.error());
    }
    Result<double> z = m_pathZ;
    const auto there = m_test.await(kLifts, [&](const FeedTestSteps::Look& seen) {
      z = m_test.number(kZ);
      return !z || (isAt(seen.liftedMm, mm) && std::abs(*z - m_pathZ - mm) <= kFollowsMm);
    });
    if (!there || !z) {
      return base::fail(!there ? there.error() : z.error());
    }
    m_awayMm = *z - m_pathZ;
    return there->has_value();
  }

  Result<void> lift() {
    const auto isUp = comesTo(m_liftMm);
    if (!isUp) {
      return base::fail(isUp.error());
    }
    m_test.add("lifts", *isUp,
               fmt::format("With {:g} mm in the cell of the lift Z stood {:.3f} mm above the path.",
                           m_liftMm, m_awayMm));
    return *isUp ? Result<void>() : m_test.set(TestCell::Lift, 0.0);
  }

  Result<void> stand() {
    Result<void> done = m_test.set(TestCell::Stands, 1.0);
    const auto moved = done
                           ? m_test.await(kStays, [](const auto& seen) { return seen.moved > 0.0; })
                           : Result<std::optional<FeedTestSteps::Look>>(base::fail(done.error()));
    done = m_test.set(TestCell::Stands, 0.0);
    if (!moved || !done) {
      return base::fail(!moved ? moved.error() : done.error());
    }
    m_test.add("stands-lifted", !*moved,
               *moved ? "While the tool was lifted, the axis that was held moved."
                      : "While the tool was lifted, the axis that was held stood.");
    return *moved ? m_test.set(TestCell::Lift, 0.0) : Result<void>();
  }

  Result<void> lower() {
    const auto isDown = comesTo(0.0);
    if (!isDown) {
      return base::fail(isDown.error());
    }
    m_test.add("lowers", *isDown,
               fmt::format("With 0 in it Z came back to {:.3f} mm from the path.", m_awayMm));
    return {};
  }

  /// What lets the axis go finds the tool lifted.
  Result<void> liftAgain() {
    const auto isUp = comesTo(m_liftMm);
    return isUp ? Result<void>() : Result<void>(base::fail(isUp.error()));
  }

  static constexpr opcua::Variable kZ{opcua::VariableKind::ActualPosition, 2};

  FeedTestSteps& m_test;
  double m_liftMm;
  double m_pathZ = 0.0;
  double m_awayMm = 0.0;
};

}  // namespace

Result<void> requireOverlay(FeedTestSteps& test) {
  const double liftMm = liftMmOf(test.feedPlan());
  if (liftMm <= 0.0) {
    return {};
  }
  const auto limit = test.number(test.cell(TestCell::LiftLimit));
  if (!limit) {
    return base::fail(limit.error());
  }
  test.result().limitMm = *limit;
  test.add("overlay-fits", *limit >= liftMm,
           *limit == kOverlayAddsUp
               ? std::string("The control adds up overlays (MD36750 of Z): a tool would be lifted "
                             "anew in each cycle. Change it, or test without the lift.")
           : *limit == kOverlayThere
               ? std::string("An overlay of Z was active before the test. Press reset, check that "
                             "$AA_OFF_VAL[Z] is 0, and start again.")
               : fmt::format("The control allows an overlay of {:g} mm on Z (SD43350); the test "
                             "needs {:g} mm.",
                             *limit, liftMm));
  return {};
}

Result<void> liftWhileHeld(FeedTestSteps& test) {
  return liftMmOf(test.feedPlan()) > 0.0 ? LiftTest(test).run() : Result<void>();
}

void judgeLowered(FeedTestSteps& test, const FeedTestSteps::Look& seen) {
  if (liftMmOf(test.feedPlan()) <= 0.0 || !test.goesOn()) {
    return;
  }
  const bool isDown = isAt(seen.liftedMm, 0.0);
  test.add("waits-for-tool", isDown && seen.inAir == 0.0,
           isDown ? fmt::format("Let go with a lifted tool, the axis moved in {:g} cycles before "
                                "the tool was back.",
                                seen.inAir)
                  : fmt::format("Let go with a lifted tool, the axis came to the end of its move "
                                "with the tool {:.3f} mm above the path.",
                                seen.liftedMm));
}

}  // namespace rivulet::streaming
