// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The model of feasibility/probability against whole runs in virtual time: the error its header
/// states is what is found here.

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "forecast/region.h"
#include "support/hard_machine.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;

namespace {

constexpr std::size_t kSeeds = 120;

struct Case {
  const char* name;
  MethodKind method;
  int pointsPerLoop;
  double deltaMm;
  streaming::ContourOptions contour;
  double slopeMm;  ///< Z per point: with 0 the last coordinate of a slot never changes
  std::vector<double> feedsMmPerMin;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list{
      {"signal N 7", MethodKind::Signal, 7, 0.3, {200, 0.15, 0.15}, 0.0, {600, 1200, 1500, 2200}},
      {"signal N 3", MethodKind::Signal, 3, 0.3, {200, 0.15, 0.15}, 0.0, {600, 1500, 2500}},
      {"signal N 9", MethodKind::Signal, 9, 0.3, {200, 0.05, 0.05}, 0.02, {200, 350, 450, 600}},
      {"position N 7", MethodKind::Position, 7, 0.15, {200, 0.15, 0.15}, 0.0, {250, 400, 430, 500}},
      {"position N 7 wide",
       MethodKind::Position,
       7,
       0.3,
       {200, 0.3, 0.15},
       0.0,
       {500, 750, 800, 900}},
      {"position N 3", MethodKind::Position, 3, 0.3, {200, 0.3, 0.3}, 0.01, {500, 700, 800, 1000}},
      {"position even", MethodKind::Position, 9, 0.2, {200, 0.3, 0.0}, 0.01, {400, 580, 620, 700}},
      {"position, small delta",
       MethodKind::Position,
       7,
       0.1,
       {200, 0.2, 0.2},
       0.0,
       {200, 400, 480}},
      {"position, large delta", MethodKind::Position, 7, 0.25, {200, 0.2, 0.2}, 0.0, {400}},
  };
  return list;
}

std::vector<gcode::StreamPoint> pointsOf(const Case& one) {
  base::Random random(7);
  std::vector<gcode::StreamPoint> points;
  double zMm = 0.0;
  for (base::Vec3 point : streaming::drawContour(one.contour, random)) {
    point.z = zMm;
    zMm += one.slopeMm;
    points.push_back({point, base::LineNumber{}});
  }
  return points;
}

const machine::MachineConfig& hardMachine() {
  static const machine::MachineConfig config = tests::hardMachine();
  return config;
}

forecast::RegionRequest request(const Case& one, const std::vector<double>& feedsMmPerMin) {
  forecast::RegionRequest request;
  request.points = pointsOf(one);
  request.machine = hardMachine();
  request.settings.parameters.method = one.method;
  request.settings.parameters.pointsPerLoop = one.pointsPerLoop;
  request.settings.deltaMm = one.deltaMm;
  request.axis = feasibility::SweepAxis::Delta;
  request.abscissas = {one.deltaMm};
  for (const double feed : feedsMmPerMin) {
    request.feedsMmPerS.push_back(base::mmPerSFromMmPerMin(feed));
  }
  request.seedsPerPoint = kSeeds;
  return request;
}

feasibility::OperatingPoint operatingPoint(const Case& one, double feedMmPerS) {
  return {one.method, one.pointsPerLoop, one.deltaMm, feedMmPerS};
}

double frequency(const forecast::RegionPoint& point) {
  return static_cast<double>(point.failures()) / static_cast<double>(point.runs);
}

}  // namespace

class TestProbability : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Method window: how long a run takes, whether the client keeps up or the machine waits for it.
  void windowTakesAsLongAsPredicted() {
    std::size_t waited = 0;
    for (const int points : {4, 7, 12}) {
      for (const auto& [slower, feedMmPerMin] :
           {std::pair(1, 200.0), std::pair(1, 1500.0), std::pair(1, 5000.0), std::pair(4, 200.0),
            std::pair(4, 600.0), std::pair(4, 3000.0)}) {
        base::Random random(7);
        streaming::Scenario scenario;
        scenario.machine = *machine::loadPreset("dmu75");
        scenario.program = streaming::programOf(streaming::drawContour({200, 0.15, 0.15}, random));
        scenario.machine.access.nodeTimeMean *= slower;
        scenario.settings.parameters.method = MethodKind::Window;
        scenario.settings.parameters.pointsPerLoop = points;
        scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
        const streaming::RunReport report = streaming::simulate(scenario);
        QVERIFY2(report.isFaultless(), report.error.text().c_str());
        const base::Vec3 startMm{0.0, 0.0, 50.0};
        const auto list = gcode::streamPoints(scenario.program->trajectory, startMm);
        const feasibility::Prediction prediction = feasibility::predict(
            list.points, {MethodKind::Window, points, 0.3, scenario.settings.feedMmPerS},
            forecast::streamModelOf(scenario.machine), startMm);
        QCOMPARE(prediction.failureProbability, 0.0);
        const double predicted = base::toSeconds(prediction.duration);
        const double took = base::toSeconds(report.duration);
        qInfo("M %d F %.0f: %.2f s, predicted %.2f s, of which waiting %.2f s, %zu pauses", points,
              feedMmPerMin, took, predicted, base::toSeconds(prediction.waiting),
              report.pauses.size());
        QCOMPARE(prediction.stops, report.pauses.size());
        const bool waits = prediction.waiting > base::Duration{};
        QVERIFY(std::abs(predicted / took - 1.0) <
                (waits ? feasibility::kWaitingDurationError : feasibility::kDurationError));
        waited += waits ? 1 : 0;
      }
    }
    QVERIFY(waited >= 3);
  }

  /// From feeds at which nothing fails to feeds at which everything does.
  void agreesWithTheSimulation() {
    const feasibility::StreamModel model = forecast::streamModelOf(hardMachine());
    base::SerialExecutor executor;
    double sum = 0.0;
    double worst = 0.0;
    double lowest = 1.0;
    double highest = 0.0;
    std::size_t between = 0;
    std::size_t count = 0;
    for (const Case& one : cases()) {
      const auto wanted = request(one, one.feedsMmPerMin);
      const auto result = forecast::simulateRegion(wanted, executor);
      QVERIFY2(!result.error.code, result.error.text().c_str());
      for (const forecast::RegionPoint& point : result.points) {
        QCOMPARE(point.runs, kSeeds);
        const double predicted =
            feasibility::predict(wanted.points, operatingPoint(one, point.feedMmPerS), model)
                .failureProbability;
        const double seen = frequency(point);
        qInfo("%s, F %.0f: predicted %.3f, simulated %.3f (%zu stalled)", one.name,
              base::mmPerMinFromMmPerS(point.feedMmPerS), predicted, seen, point.stalled);
        sum += std::abs(predicted - seen);
        worst = std::max(worst, std::abs(predicted - seen));
        lowest = std::min(lowest, seen);
        highest = std::max(highest, seen);
        between += seen > 0.1 && seen < 0.9 ? 1 : 0;
        ++count;
      }
    }
    const double mean = sum / static_cast<double>(count);
    qInfo("mean difference %.3f, largest %.3f, %zu points", mean, worst, count);
    QVERIFY(mean <= feasibility::kProbabilityError);
    // The comparison says something only if it covers the rise.
    QVERIFY(lowest == 0.0 && highest == 1.0 && between >= 8);
  }

  /// The preset itself is slower: there the points between come from method position.
  void agreesOnThePresetItself() {
    const machine::MachineConfig machine = *machine::loadPreset("dmu75");
    const feasibility::StreamModel model = forecast::streamModelOf(machine);
    base::SerialExecutor executor;
    double sum = 0.0;
    std::size_t between = 0;
    std::size_t count = 0;
    for (const Case& one : cases()) {
      if (one.method != base::MethodKind::Position) {
        continue;
      }
      auto wanted = request(one, one.feedsMmPerMin);
      wanted.machine = machine;
      for (const auto& point : forecast::simulateRegion(wanted, executor).points) {
        const double predicted =
            feasibility::predict(wanted.points, operatingPoint(one, point.feedMmPerS), model)
                .failureProbability;
        sum += std::abs(predicted - frequency(point));
        between += frequency(point) > 0.05 && frequency(point) < 0.95 ? 1 : 0;
        ++count;
      }
    }
    qInfo("mean difference %.3f, %zu points", sum / static_cast<double>(count), count);
    QVERIFY(sum / static_cast<double>(count) <= feasibility::kProbabilityError);
    QVERIFY(between >= 3);
  }

  /// The feed at which half of the runs fail.
  void crossesOneHalfWhereTheSimulationDoes() {
    const feasibility::StreamModel model = forecast::streamModelOf(hardMachine());
    base::SerialExecutor executor;
    int crossed = 0;
    for (const Case& one : cases()) {
      if (one.feedsMmPerMin.size() < 3) {
        continue;  // fails at any feed
      }
      const auto points = pointsOf(one);
      const double feedMmPerS =
          feasibility::feedMmPerSAt(0.5, points, operatingPoint(one, 1.0), model, 1.0, 200.0);
      const double feed = base::mmPerMinFromMmPerS(feedMmPerS);
      if (feedMmPerS >= 200.0) {
        // Windows of one and two points: the standstill alone is nearly always long enough.
        const auto fastest = forecast::simulateRegion(request(one, {12000.0}), executor);
        QVERIFY2(frequency(fastest.points[0]) < 0.6, one.name);
        continue;
      }
      ++crossed;
      const auto result = forecast::simulateRegion(
          request(one,
                  {feed / feasibility::kFeedErrorFactor, feed * feasibility::kFeedErrorFactor}),
          executor);
      const double below = frequency(result.points[0]);
      const double above = frequency(result.points[1]);
      qInfo("%s: half at F %.0f; simulated %.3f below, %.3f above", one.name, feed, below, above);
      QVERIFY2(below < 0.5 && above > 0.5, one.name);
    }
    QVERIFY(crossed >= 6);
  }

  void durationsAgree() {
    const feasibility::StreamModel model = forecast::streamModelOf(hardMachine());
    for (const Case& one : cases()) {
      if (one.feedsMmPerMin.size() < 3) {
        continue;
      }
      const auto points = pointsOf(one);
      streaming::Scenario scenario;
      scenario.machine = hardMachine();
      const base::Vec3 startMm = forecast::regionStartMm(points, one.deltaMm);
      std::vector<base::Vec3> positions;
      for (const gcode::StreamPoint& point : points) {
        positions.push_back(point.positionMm);
      }
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        scenario.machine.axes[axis].startMm = startMm[axis];
      }
      scenario.program = streaming::programOf(positions);
      scenario.settings.parameters.method = one.method;
      scenario.settings.parameters.pointsPerLoop = one.pointsPerLoop;
      scenario.settings.deltaMm = one.deltaMm;
      scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(one.feedsMmPerMin.front());
      const streaming::RunReport report = streaming::simulate(scenario);
      QVERIFY2(report.isFaultless(), one.name);
      const feasibility::Prediction prediction = feasibility::predict(
          points, operatingPoint(one, scenario.settings.feedMmPerS), model, startMm);
      const double ratio = base::toSeconds(prediction.duration) / base::toSeconds(report.duration);
      qInfo("%s: %.2f s predicted, %.2f s simulated", one.name,
            base::toSeconds(prediction.duration), base::toSeconds(report.duration));
      QVERIFY2(std::abs(ratio - 1.0) <= feasibility::kDurationError, one.name);
      QCOMPARE(prediction.stops, report.pauses.size());
    }
  }

  /// A tool that stands at the first point: method position takes the point for passed.
  void firstPointIsTakenForPassed() {
    const Case& one = cases()[3];
    const auto points = pointsOf(one);
    const feasibility::StreamModel model = forecast::streamModelOf(hardMachine());
    const auto point = operatingPoint(one, base::mmPerSFromMmPerMin(250.0));
    const base::Vec3 nearMm = points.front().positionMm + base::Vec3{0.0, 0.0, 0.1};
    const double predicted = feasibility::predict(points, point, model, nearMm).failureProbability;
    std::vector<base::Vec3> positions;
    for (const gcode::StreamPoint& streamed : points) {
      positions.push_back(streamed.positionMm);
    }
    std::size_t failures = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      streaming::Scenario scenario;
      scenario.machine = hardMachine();
      scenario.machine.axes[2].startMm = nearMm.z;
      scenario.program = streaming::programOf(positions);
      scenario.settings.parameters.method = one.method;
      scenario.settings.deltaMm = one.deltaMm;
      scenario.settings.feedMmPerS = point.feedMmPerS;
      scenario.seed = seed;
      failures += forecast::fateOf(scenario) == forecast::RunFate::Ran ? 0 : 1;
    }
    const double seen = static_cast<double>(failures) / static_cast<double>(kSeeds);
    qInfo("predicted %.3f, simulated %.3f", predicted, seen);
    QVERIFY(std::abs(predicted - seen) < 0.25);
    QVERIFY(seen > 0.3);
  }
};

RIVULET_TEST(TestProbability)
#include "tst_probability.moc"
