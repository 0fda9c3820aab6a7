// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The tool is lifted while the axes are held, by an overlay, and lowered before the run goes on.
/// By the machine's own trace.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/units.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "support/whole_trace_link.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Instant;
using base::MethodKind;
using streaming::FeedOrder;
using streaming::Outcome;
using tests::Operator;

namespace {

constexpr double kLiftMm = 3.0;

struct World {
  World() : machine(*machine::loadPreset("dmu75"), 1), link(machine) { person.machine = &machine; }

  streaming::RunReport run(MethodKind method, std::size_t moves = 8) {
    streaming::RunSettings settings;
    settings.parameters.method = method;
    settings.parameters.liftMm = kLiftMm;
    settings.liftMmMax = kLiftMm;
    settings.parameters.pointsPerLoop = 2;
    settings.isCommissioned = true;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
    const auto flexible = templates::makeProgram(settings.parameters);
    tests::WholeTraceLink whole(link);
    return streaming::runJob(whole, link, *tests::lines(moves, 60.0), *flexible, settings, person,
                             person);
  }
  /// How far the run is in its first hold, and for how long the axes have stood.
  [[nodiscard]] double stoodS(Instant now) {
    if (!person.seen || !person.seen->stoodAfter) {
      m_stands.reset();
      return -1.0;
    }
    m_stands = m_stands.value_or(now);
    return base::toSeconds(now - *m_stands);
  }
  [[nodiscard]] double actualZ() const { return machine.state().actualMm.z; }

  machine::Machine machine;
  streaming::SimulatedLink link;
  Operator person{1};

 private:
  std::optional<Instant> m_stands;
};

/// Held in the second move; @param then  what is ordered so many seconds after the axes
/// have stood
std::function<FeedOrder(Instant)> heldOnce(World& world, std::function<FeedOrder(double)> then) {
  return [&world, then, begun = std::optional<Instant>(), done = false](Instant now) mutable {
    const base::Vec3 at = world.machine.state().commandMm;
    if (at.z < 1e-6 && at.x < 40.0 && !begun) {  // on the way back along X
      begun = now;
    }
    if (!begun || done) {
      return FeedOrder{};
    }
    const double s = world.stoodS(now);
    const FeedOrder order = s < 0.0 ? FeedOrder{true} : then(s);
    done = s >= 0.0 && !order.holds && order.liftMm == 0.0;
    return order;
  };
}

}  // namespace

class TestLift : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void liftsAndComesBack_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit);
  }
  /// Up by 3 mm, straight; the path waits at the same place; down to within a micrometre; then on.
  void liftsAndComesBack() {
    QFETCH(int, method);
    World world;
    double highest = 0.0;
    double beforeZ = NAN;
    double afterZ = NAN;
    std::vector<double> seenMm;
    world.person.orderWhen = heldOnce(world, [&](double s) {
      if (s < 0.5) {
        beforeZ = world.actualZ();
      }
      highest = std::max(highest, world.actualZ() - beforeZ);
      if (world.person.seen->liftedMm) {
        seenMm.push_back(*world.person.seen->liftedMm);
      }
      afterZ = s > 5.5 ? world.actualZ() : afterZ;
      return FeedOrder{s<6.0, 100.0, std::nullopt, s> 1.0 && s < 3.0 ? kLiftMm : 0.0};
    });
    const auto report = world.run(static_cast<MethodKind>(method));
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    QVERIFY(std::abs(highest - kLiftMm) < 0.01);
    QVERIFY(std::abs(afterZ - beforeZ) < 0.001);
    QVERIFY(std::abs(*std::max_element(seenMm.begin(), seenMm.end()) - kLiftMm) < 0.01);
    QVERIFY(std::abs(seenMm.back()) < 0.005);
    QVERIFY(!world.person.wasIgnored);  // Z moves, and is meant to
    QVERIFY(!report.wrong);             // and it is not on the path, which waits
    QVERIFY(world.person.hasNote("lift of the tool in mm: 3.000"));
    QVERIFY(world.person.hasNote("lift of the tool in mm: 0.000"));
    // As long as the tool was up, no set point of the path has moved.
    const auto& samples = world.person.trace.samples;
    bool hasArrived = false;  // on the path, from where the tool stood before the run
    for (std::size_t i = 1; i < samples.size(); ++i) {
      hasArrived = hasArrived || std::abs(samples[i].actualMm.z) < 0.01;
      const bool isUp = hasArrived && samples[i].actualMm.z > 0.1 && samples[i].actualMm.x < 60.0 &&
                        samples[i - 1].actualMm.z > 0.1;
      QVERIFY(!isUp || std::abs(samples[i].commandMm.x - samples[i - 1].commandMm.x) < 1e-9);
    }
  }

  /// Continue, and a stop that lets the run end, wait until the tool is back.
  void doesNotGoOnWhileLifted() {
    World world;
    double x = NAN;
    double moved = 0.0;
    world.person.orderWhen = heldOnce(world, [&](double s) {
      if (s < 2.0) {
        x = world.machine.state().commandMm.x;
      } else if (s < 8.0) {
        moved = std::max(moved, std::abs(world.machine.state().commandMm.x - x));
      }
      return FeedOrder{s < 2.0, 100.0, std::nullopt, s < 8.0 ? kLiftMm : 0.0};
    });
    const auto report = world.run(MethodKind::Window);
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    QCOMPARE(moved, 0.0);
  }

  /// Only axes that stand, held, are lifted; never further than agreed, and never down.
  void isOnlyForAxesThatStand() {
    World world;
    double highest = 0.0;
    double lowest = 0.0;
    world.person.orderWhen = [&](Instant) {
      highest = std::max(highest, world.machine.state().overlayMm.z);
      return FeedOrder{false, 100.0, std::nullopt, kLiftMm};
    };
    QCOMPARE(world.run(MethodKind::Window).outcome, Outcome::Completed);
    QCOMPARE(highest, 0.0);
    for (const double wrong : {-2.0, 50.0, std::nan("")}) {
      World other;
      highest = 0.0;
      other.person.orderWhen = heldOnce(other, [&](double s) {
        highest = std::max(highest, other.machine.state().overlayMm.z);
        lowest = std::min(lowest, other.machine.state().overlayMm.z);
        return FeedOrder{s < 3.0, 100.0, std::nullopt, s < 1.5 ? wrong : 0.0};
      });
      const auto report = other.run(MethodKind::Window);
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      QVERIFY(highest < kLiftMm + 1e-6);
      QCOMPARE(lowest, 0.0);
    }
  }

  /// What another client writes into the cell of the lift does not drive the tool down.
  void theControlItselfNeverLowersBelowThePath() {
    World world;
    double lowest = 0.0;
    streaming::RunSettings settings;
    settings.parameters.liftMm = kLiftMm;
    settings.liftMmMax = kLiftMm;
    settings.parameters.pointsPerLoop = 2;
    const int cell = templates::makeProgram(settings.parameters)->cells.correction[2];
    QVERIFY(cell >= 0);
    world.person.orderWhen = heldOnce(world, [&](double s) {
      if (s > 0.5 && s < 2.0) {
        world.machine.writeRParameter(cell, -1.0);
      }
      lowest = std::min(lowest, world.machine.state().overlayMm.z);
      return FeedOrder{s < 3.0};
    });
    QVERIFY(world.run(MethodKind::Window).isFaultless());
    QCOMPARE(lowest, 0.0);
  }

  /// Another client lets the path go on while the tool is lifted: the control itself lowers it
  /// first, and moves nothing along the path until it is back.
  void theControlItselfLowersBeforeThePathGoesOn() {
    World world;
    const int feedCell = templates::makeProgram([] {
                           templates::TemplateParameters parameters;
                           parameters.liftMm = kLiftMm;
                           parameters.pointsPerLoop = 2;
                           return parameters;
                         }())
                             ->cells.overrideWanted;
    double x = NAN;
    double movedInAir = 0.0;
    bool isWritten = false;
    bool hasMoved = false;
    world.person.orderWhen = heldOnce(world, [&](double s) {
      const base::Vec3 at = world.machine.state().commandMm;
      const double lifted = world.machine.state().overlayMm.z;
      if (!isWritten) {
        x = at.x;
      }
      if (s > 2.0 && !isWritten) {
        isWritten = lifted > kLiftMm - 1e-6;
        world.machine.writeRParameter(feedCell, 100.0);
      }
      if (isWritten && lifted > 0.001) {
        movedInAir = std::max(movedInAir, std::abs(at.x - x));
      }
      hasMoved = hasMoved || (isWritten && std::abs(at.x - x) > 0.1);
      return FeedOrder{s < 4.0, 100.0, std::nullopt, s < 3.0 ? kLiftMm : 0.0};
    });
    // The stream's own hold is undone by somebody else, who is named in the report.
    const auto report = world.run(MethodKind::Window);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QVERIFY(isWritten && hasMoved);
    QCOMPARE(movedInAir, 0.0);
    // In the machine's own trace: when it leaves the place, it is down.
    bool isUp = false;
    for (const trace::ControlSample& sample : world.machine.trace().samples) {
      const bool isThere = std::abs(sample.commandMm.x - x) < 1e-6;
      isUp = isUp || (isThere && std::abs(sample.commandMm.z - kLiftMm) < 0.01);
      if (isUp && !isThere) {
        QVERIFY(sample.commandMm.z < 0.01);
        break;
      }
    }
    QVERIFY(isUp);
  }

  /// Where a lifted tool has not been seen to come back, no program that lifts is started.
  void isRefusedWhereItWasNotTested() {
    for (const double seenMm : {0.0, kLiftMm - 0.5}) {
      World world;
      streaming::RunSettings settings;
      settings.parameters.liftMm = kLiftMm;
      settings.liftMmMax = seenMm;
      const auto report = streaming::runJob(world.link, world.link, *tests::lines(8, 60.0),
                                            *templates::makeProgram(settings.parameters), settings,
                                            world.person, world.person);
      QVERIFY(report.error.code == templates::TemplateError::BadCorrection);
      QVERIFY(world.machine.programNames().empty());
    }
  }

  /// A client that is gone leaves the tool lifted, and the axes held. Who resumes the run lowers it
  /// before the path goes on: no point is executed in the air.
  void isLoweredBeforeALeftRunEnds() {
    World world;
    streaming::RunSettings settings;
    settings.parameters.liftMm = kLiftMm;
    settings.liftMmMax = kLiftMm;
    settings.parameters.pointsPerLoop = 2;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
    const auto program = tests::lines(8, 60.0);
    bool leaves = false;
    world.person.orderWhen = heldOnce(world, [&](double s) {
      leaves = s > 2.0;
      return FeedOrder{true, 100.0, std::nullopt, kLiftMm};
    });
    world.person.leavesWhen = [&](Instant) { return leaves; };
    world.person.stopWhen = [&](Instant) { return leaves; };
    const auto flexible = templates::makeProgram(settings.parameters);
    tests::WholeTraceLink whole(world.link);
    const auto left = streaming::runJob(whole, world.link, *program, *flexible, settings,
                                        world.person, world.person);
    QVERIFY(left.leftHeld && left.checkpoint);
    QVERIFY(std::abs(world.machine.state().overlayMm.z - kLiftMm) < 1e-6);
    const double x = world.machine.state().commandMm.x;
    const auto resume =
        streaming::resumeFrom(world.link, *program, left.settings, *left.checkpoint);
    QVERIFY2(resume.has_value(), resume ? "" : resume.error().text().c_str());
    QCOMPARE(world.machine.state().overlayMm.z, 0.0);
    // The set point, with the overlay: as long as it is up, it does not move along the path.
    bool isUp = false;
    for (const trace::ControlSample& sample : world.machine.trace().samples) {
      const bool isThere = std::abs(sample.commandMm.x - x) < 1e-6;
      isUp = isUp || (isThere && std::abs(sample.commandMm.z - kLiftMm) < 0.01);
      QVERIFY(!isUp || isThere || sample.commandMm.z < 0.01);
    }
    QVERIFY(isUp);
    QVERIFY(std::abs(world.machine.state().commandMm.x - x) > 1.0);  // then it went on
  }

  void refusesWhatCannotBe() {
    templates::TemplateParameters parameters;
    parameters.liftMm = kLiftMm;
    QVERIFY(templates::requireProgram(parameters));
    parameters.correctionLimitMm = 0.1;
    QVERIFY(!templates::requireProgram(parameters));  // one overlay for both
    parameters.correctionLimitMm = 0.0;
    for (const double wrong : {-1.0, 10.5, 1e-5, std::nan("")}) {
      parameters.liftMm = wrong;
      QVERIFY(!templates::requireProgram(parameters));
    }
    parameters.liftMm = kLiftMm;
    for (const auto method : {MethodKind::Position, MethodKind::Signal, MethodKind::File}) {
      parameters.method = method;
      QVERIFY(!templates::requireProgram(parameters));
    }
  }
};

RIVULET_TEST(TestLift)
#include "tst_lift.moc"
