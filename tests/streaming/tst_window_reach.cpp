// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// How fast method window can go without the machine waiting for the client, by form of access. The
/// points are evenly 0.15 mm apart, the smallest distance [P1] ran method position with at F 500.

#include <QtTest>

#include "base/units.h"
#include "streaming/simulation/scenario.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using machine::ArrayCharge;
using opcua::Grouping;
using streaming::RunReport;

namespace {

constexpr double kPointDistanceMm = 0.15;
constexpr double kPaperFeedMmPerMin = 500.0;
constexpr int kPointsPerWindow = 13;  // two windows fill the usual 100 R-parameters
constexpr int kPackedPerWindow = 39;  // the same, packed
constexpr int kWindows = 20;
constexpr int kPackedWindows = 6;

/// The form in which the points travel.
struct Form {
  Grouping grouping = Grouping::List;
  bool packed = false;

  [[nodiscard]] int pointsPerWindow() const { return packed ? kPackedPerWindow : kPointsPerWindow; }
  [[nodiscard]] std::size_t windows() const { return packed ? kPackedWindows : kWindows; }
  [[nodiscard]] std::size_t points() const {
    return windows() * static_cast<std::size_t>(pointsPerWindow());
  }
};

/// The machine of [P1], but for what keeps it slow on short blocks: with the jerk limit and the
/// block cycle of dmu75 it is slower than any client. These would hide who waits for whom.
machine::MachineConfig fastMachine(ArrayCharge charge) {
  machine::MachineConfig config = *machine::loadPreset("dmu75-arrays");
  config.access.arrays.charge = charge;
  config.blocksPerCycleMax = 0.0;
  config.resetDynamics = machine::Dynamics::Brisk;
  return config;
}

RunReport run(machine::MachineConfig config, double feedMmPerMin, Form form, std::uint64_t seed,
              bool monitor = true) {
  base::Random random(seed);
  streaming::Scenario scenario;
  scenario.machine = std::move(config);
  scenario.seed = seed;
  scenario.program =
      streaming::programOf(streaming::drawContour({form.points(), kPointDistanceMm, 0.0}, random));
  scenario.settings.parameters.pointsPerLoop = form.pointsPerWindow();
  scenario.settings.parameters.packed = form.packed;
  // Signs of life are seldom enough to leave the stream its time.
  scenario.settings.parameters.silenceLimitS = std::max(
      templates::kSilenceLimitS, 40.0 * base::toSeconds(scenario.machine.access.writeOverhead));
  scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  scenario.settings.grouping = form.grouping;
  scenario.settings.monitor = monitor;
  return streaming::simulate(scenario);
}

/// Whether each stop between two windows is as long as it is for a client that needs no time at
/// all.
bool waitsForNobody(const machine::MachineConfig& config, double feedMmPerMin, Form form,
                    std::uint64_t seed) {
  machine::MachineConfig free = config;
  free.access.readOverhead = free.access.writeOverhead = {};
  free.access.nodeTimeMean = free.access.nodeTimeDeviation = free.access.nodeTimeMin = {};
  const RunReport real = run(config, feedMmPerMin, form, seed);
  const RunReport ideal = run(free, feedMmPerMin, form, seed);
  if (!real.isFaultless() || !ideal.isFaultless() || ideal.pauses.size() != form.windows() - 1) {
    qFatal("a run failed: %s %s", real.error.text().c_str(), ideal.error.text().c_str());
  }
  if (real.pauses.size() != ideal.pauses.size()) {
    return false;
  }
  for (std::size_t i = 0; i < real.pauses.size(); ++i) {
    if (real.pauses[i].duration > ideal.pauses[i].duration + config.interpolationCycle) {
      return false;
    }
  }
  return true;
}

constexpr std::uint64_t kSeeds = 5;

bool waitsForNobody(const machine::MachineConfig& config, double feedMmPerMin, Form form) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    if (!waitsForNobody(config, feedMmPerMin, form, seed)) {
      return false;
    }
  }
  return true;
}

/// The largest feed of a ladder up to which nobody waits in any of the runs.
double reachMmPerMin(const machine::MachineConfig& config, Form form, double stepMmPerMin,
                     double mostMmPerMin) {
  double reach = 0.0;
  for (double feed = stepMmPerMin; feed <= mostMmPerMin; feed += stepMmPerMin) {
    if (!waitsForNobody(config, feed, form)) {
      break;
    }
    reach = feed;
  }
  return reach;
}

}  // namespace

class TestWindowReach : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The machine reaches the programmed feed: the client is what is measured.
  void theMachineReachesTheFeed() {
    const RunReport report =
        run(fastMachine(ArrayCharge::Node), 10.0 * kPaperFeedMmPerMin, {Grouping::ArrayCount}, 1);
    QVERIFY(report.isFaultless() && report.controlTrace);
    double mostMmPerS = 0.0;
    for (const trace::ControlSample& sample : report.controlTrace->samples) {
      mostMmPerS = std::max(mostMmPerS, sample.feedMmPerS);
    }
    QVERIFY(std::abs(base::mmPerMinFromMmPerS(mostMmPerS) - 10.0 * kPaperFeedMmPerMin) < 1.0);
  }

  void arraysReachTenTimesThePaper() {
    const double reach =
        reachMmPerMin(fastMachine(ArrayCharge::Node), {Grouping::ArrayCount}, 2500.0, 40000.0);
    qInfo("arrays charged per node: no wait up to F %.0f", reach);
    QVERIFY2(reach >= 10.0 * kPaperFeedMmPerMin, std::to_string(reach).c_str());
  }

  /// Without them, or where the control charges their elements, it is not so: what makes the
  /// difference is the number of nodes.
  void listsDoNot() {
    const double list =
        reachMmPerMin(fastMachine(ArrayCharge::Node), {Grouping::List}, 50.0, 5000.0);
    const double element =
        reachMmPerMin(fastMachine(ArrayCharge::Element), {Grouping::ArrayCount}, 50.0, 5000.0);
    qInfo("lists: no wait up to F %.0f; arrays charged per element: up to F %.0f", list, element);
    for (const double reach : {list, element}) {
      QVERIFY2(reach >= 300.0 && reach <= 2.0 * kPaperFeedMmPerMin, std::to_string(reach).c_str());
    }
  }

  /// … or what a node carries: packed, a point needs one where it needed three.
  void packedListsReachTwiceAsFar() {
    const double packed = reachMmPerMin(fastMachine(ArrayCharge::Node), {Grouping::List, true},
                                        400.0, 4.0 * kPaperFeedMmPerMin);
    qInfo("packed lists: no wait up to F %.0f", packed);
    QVERIFY2(packed >= 4.0 * kPaperFeedMmPerMin, std::to_string(packed).c_str());
  }

  /// The position of the axes is read at least once a second even where nothing is left for it.
  void readingThePositionCostsLittle() {
    const machine::MachineConfig config = fastMachine(ArrayCharge::Node);
    for (const double feed : {900.0, 1200.0, 2000.0}) {
      base::Duration withIt{};
      base::Duration without{};
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        withIt += run(config, feed, {}, seed).duration;
        without += run(config, feed, {}, seed, false).duration;
      }
      qInfo("F %.0f, beyond the reach: %.2f s with the display, %.2f s without", feed,
            base::toSeconds(withIt), base::toSeconds(without));
      QVERIFY(base::toSeconds(withIt) < 1.05 * base::toSeconds(without));
    }
  }

  /// A window costs at least three round trips: its content, its number, and the look at the
  /// control.
  void roundTripsCostFeed() {
    constexpr double kStep = 1.1;
    double before = 40000.0;
    for (const std::chrono::milliseconds roundTrip : {50ms, 200ms, 500ms}) {
      std::array<double, 2> reach{};
      for (const bool isArray : {false, true}) {
        machine::MachineConfig config = fastMachine(ArrayCharge::Node);
        config.access.readOverhead += roundTrip;
        config.access.writeOverhead += roundTrip;
        const Grouping grouping = isArray ? Grouping::ArrayCount : Grouping::List;
        for (double feed = 20.0; feed < before && waitsForNobody(config, feed, {grouping});
             feed *= kStep) {
          reach[isArray ? 1 : 0] = feed;
        }
      }
      qInfo("round trip %d ms: no wait up to F %.0f with lists, F %.0f with arrays",
            static_cast<int>(roundTrip.count()), reach[0], reach[1]);
      QVERIFY(reach[0] >= 20.0 && reach[0] <= reach[1] && reach[1] < before);
      before = reach[1];
    }
  }

  /// The machine of the preset itself, whose jerk limit leaves the client more time.
  void theFittedMachineDoesNotWaitEither() {
    const machine::MachineConfig config = *machine::loadPreset("dmu75-arrays");
    for (const double feed : {500.0, 2000.0, 5000.0, 20000.0}) {
      QVERIFY2(waitsForNobody(config, feed, Form{Grouping::ArrayCount}),
               std::to_string(feed).c_str());
    }
  }
};

RIVULET_TEST(TestWindowReach)
#include "tst_window_reach.moc"
