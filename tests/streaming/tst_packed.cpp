// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Points that share a cell: the same path as without, by the machine's own trace, with a third of
/// the cells; and no wrong motion on a control that takes them apart wrongly.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "streaming/simulation/template_proof.h"
#include "support/misread_link.h"
#include "support/setting.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using base::MethodKind;
using base::Vec3;
using streaming::RunReport;

namespace {

streaming::Scenario scenarioOf(const std::vector<Vec3>& points, MethodKind method, bool packed,
                               std::uint64_t seed = 1) {
  streaming::Scenario scenario;
  scenario.machine = *machine::loadPreset("dmu75");
  scenario.seed = seed;
  scenario.program = streaming::programOf(points);
  scenario.settings.parameters.method = method;
  scenario.settings.parameters.pointsPerLoop = 12;
  scenario.settings.parameters.packed = packed;
  scenario.settings.isCommissioned = true;
  scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(600.0);
  return scenario;
}

/// The points where the blocks of the control have led, each once, without those that move nothing.
std::vector<Vec3> executed(const RunReport& report) {
  std::vector<Vec3> targets;
  for (const trace::ExecutedBlock& block : report.controlTrace->blocks) {
    if (block.moves()) {
      targets.push_back(block.targetMm);
    }
  }
  return targets;
}

/// Short and long moves: some points are beyond what fits beside the first of their window.
std::vector<Vec3> wideContour(std::uint64_t seed) {
  base::Random random(seed);
  std::vector<Vec3> points{{1.0, 2.0, 3.0}};
  for (int i = 0; i < 150; ++i) {
    const double stepMm = i % 11 == 0 ? 180.0 : i % 7 == 0 ? 40.0 : 0.4;
    Vec3 next = points.back();
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double to = next[axis] + stepMm * (2.0 * random.uniform() - 1.0);
      next.set(axis, 0.001 * std::round(1000.0 * std::clamp(to, -150.0, 150.0)));
    }
    points.push_back(next);
  }
  return points;
}

struct Reach {
  double feedMmPerMin = 0.0;  ///< largest of a ladder up to which no run waits for the client
  double meanMmPerMin = 0.0;  ///< length over duration, there
};

/// As many points a window as 100 R-parameters hold.
Reach reachOf(MethodKind method, bool packed, bool brisk) {
  constexpr double kStepMmPerMin = 200.0;
  constexpr double kMostMmPerMin = 3000.0;
  const auto seeds = static_cast<std::uint64_t>(tests::setting("RIVULET_SEEDS", 2));
  Reach reach;
  for (double feed = 400.0; feed <= kMostMmPerMin; feed += kStepMmPerMin) {
    double lengthMm = 0.0;
    double seconds = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      base::Random random(seed);
      const std::vector<Vec3> points = streaming::drawContour({300, 0.15, 0.05}, random);
      auto scenario = scenarioOf(points, method, packed, seed);
      scenario.machine.resetDynamics = brisk ? machine::Dynamics::Brisk : machine::Dynamics::Soft;
      templates::TemplateParameters& parameters = scenario.settings.parameters;
      parameters.pointsPerLoop = templates::pointsPerLoopMax(parameters);
      scenario.settings.feedMmPerS = base::mmPerSFromMmPerMin(feed);
      scenario.settings.monitor = false;
      const RunReport real = streaming::simulate(scenario);
      machine::AccessCost& access = scenario.machine.access;
      access.readOverhead = access.writeOverhead = {};
      access.nodeTimeMean = access.nodeTimeDeviation = access.nodeTimeMin = {};
      const RunReport ideal = streaming::simulate(scenario);
      if (!real.isFaultless() || !ideal.isFaultless()) {
        qFatal("%s %s", real.error.text().c_str(), ideal.error.text().c_str());
      }
      // Neither a stop nor a lower override that a client without access times has not.
      if (real.pauses.size() > ideal.pauses.size() || real.duration > 1.01 * ideal.duration) {
        return reach;
      }
      for (std::size_t i = 1; i < points.size(); ++i) {
        lengthMm += base::distance(points[i - 1], points[i]);
      }
      seconds += base::toSeconds(real.duration);
    }
    reach = {feed, base::mmPerMinFromMmPerS(lengthMm / seconds)};
  }
  return reach;
}

}  // namespace

class TestPacked : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void executesTheSamePoints_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<quint64>("seed");
    for (quint64 seed = 1; seed <= 5; ++seed) {
      QTest::addRow("window %llu", seed) << static_cast<int>(MethodKind::Window) << seed;
      QTest::addRow("credit %llu", seed) << static_cast<int>(MethodKind::Credit) << seed;
    }
  }
  void executesTheSamePoints() {
    QFETCH(int, method);
    QFETCH(quint64, seed);
    const std::vector<Vec3> points = wideContour(seed);
    std::vector<Vec3> plain;
    for (const bool packed : {false, true}) {
      const RunReport report =
          streaming::simulate(scenarioOf(points, static_cast<MethodKind>(method), packed, seed));
      QVERIFY2(report.isFaultless() && report.controlTrace, report.error.text().c_str());
      const std::vector<Vec3> at = executed(report);
      QCOMPARE(at.size(), points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        QVERIFY(base::distance(at[i], points[i]) < 1e-9);
      }
    }
  }

  /// Points between the steps of a micrometre are moved to the nearest, at most half a step off in
  /// each axis; points that fall together are refused.
  void isWithinHalfAStep() {
    base::Random random(3);
    const auto points = streaming::drawContour({200, 0.15, 0.05}, random);
    const RunReport report = streaming::simulate(scenarioOf(points, MethodKind::Credit, true));
    QVERIFY2(report.isFaultless() && report.controlTrace, report.error.text().c_str());
    const std::vector<Vec3> at = executed(report);
    QCOMPARE(at.size(), points.size());
    double mostMm = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        mostMm = std::max(mostMm, std::abs(at[i][axis] - points[i][axis]));
      }
    }
    QVERIFY(mostMm <= 0.0005 + 1e-9 && mostMm > 0.0004);
    const std::vector<Vec3> close{{1.0, 0.0, 0.0}, {1.0001, 0.0, 0.0}, {2.0, 0.0, 0.0}};
    const RunReport refused = streaming::simulate(scenarioOf(close, MethodKind::Window, true));
    QVERIFY(refused.error.code == templates::TemplateError::BadCells);
    QVERIFY(streaming::simulate(scenarioOf(close, MethodKind::Window, false)).isFaultless());
  }

  /// A window has a third of the cells, but for its header and its first point.
  void needsFewerCells() {
    templates::TemplateParameters parameters;
    parameters.pointsPerLoop = 20;
    parameters.rParameterCount = 200;
    const int plain = templates::longestWrite(parameters);
    parameters.packed = true;
    QCOMPARE(plain, 63);
    QCOMPARE(templates::longestWrite(parameters), 25);
    QCOMPARE(templates::makeProgram(parameters)->cells.windowStride, 25);
    parameters.rParameterCount = 100;
    QCOMPARE(templates::pointsPerLoopMax(parameters), 39);
    parameters.packed = false;
    QCOMPARE(templates::pointsPerLoopMax(parameters), 13);
  }

  /// What the program does with each value is proved like that of every other program.
  void programsAreProved_data() {
    QTest::addColumn<QString>("axes");
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("feeds");
    QTest::newRow("window") << QStringLiteral("XYZ") << static_cast<int>(MethodKind::Window)
                            << true;
    QTest::newRow("credit") << QStringLiteral("XZ") << static_cast<int>(MethodKind::Credit)
                            << false;
  }
  void programsAreProved() {
    QFETCH(QString, axes);
    QFETCH(int, method);
    QFETCH(bool, feeds);
    templates::TemplateParameters parameters;
    parameters.method = static_cast<MethodKind>(method);
    parameters.pointsPerLoop = 5;
    parameters.packed = true;
    parameters.feedPerPoint = feeds;
    QVERIFY(templates::chooseAxes(parameters, axes.toStdString()));
    const auto program = templates::makeProgram(parameters);
    QVERIFY(program.has_value());
    const auto proved = streaming::requireProven(*program);
    QVERIFY2(proved.has_value(), proved ? "" : proved.error().text().c_str());
  }

  /// A control that counts otherwise refuses the first window with packed points.
  void wrongArithmeticMovesNothingWrongly_data() {
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    const auto row = [](const char* name, const char* written, const char* read) {
      QTest::newRow(name) << QString::fromLatin1(written) << QString::fromLatin1(read);
    };
    row("rounds instead of cutting off", "TRUNC(", "ROUND(");
    row("another base", "*131072", "*131071");
    row("the middle by one off", "-65536)", "-65535)");
    row("thousandths by one digit", ")/1000", ")/10000");
    row("the place of another axis", "+(RIV_P[0]-65536)", "+RIV_C[0]-RIV_C[2]+(RIV_P[0]-65536)");
    row("the last digit is lost", "(RIV_P[3]-65536)", "(0*RIV_P[3]-65536)");
  }
  void wrongArithmeticMovesNothingWrongly() {
    QFETCH(QString, written);
    QFETCH(QString, read);
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    tests::MisreadLink misread(link, written.toStdString(), read.toStdString());
    const streaming::Scenario scenario = scenarioOf(wideContour(2), MethodKind::Window, true);
    const auto flexible = templates::makeProgram(scenario.settings.parameters);
    QVERIFY(flexible && QString::fromStdString(flexible->text).contains(written));
    tests::Operator person{1};
    person.machine = &machine;
    const RunReport report = streaming::runJob(misread, misread, *scenario.program, *flexible,
                                               scenario.settings, person, person);
    QVERIFY2(report.error.code == streaming::StreamError::WindowDamaged,
             report.error.text().c_str());
    // A long move is a window of its own, in which nothing is packed.
    const std::vector<Vec3> points = wideContour(2);
    std::size_t next = 0;
    for (const trace::ExecutedBlock& block : machine.trace().blocks) {
      QVERIFY(!block.moves() || base::distance(block.targetMm, points.at(next++)) < 1e-9);
    }
    QVERIFY(next < points.size() / 2);
  }

  /// The smallest distances of [P1], at its access times: as fast as with a client that needs no
  /// time. RIVULET_SEEDS=40 makes the table of docs/methods.md.
  void reachesMoreThanTwiceTheFeed_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("brisk");
    QTest::newRow("credit, BRISK") << static_cast<int>(MethodKind::Credit) << true;
    if (tests::setting("RIVULET_SEEDS", 0) > 0) {
      QTest::newRow("window, BRISK") << static_cast<int>(MethodKind::Window) << true;
      QTest::newRow("credit, SOFT") << static_cast<int>(MethodKind::Credit) << false;
      QTest::newRow("window, SOFT") << static_cast<int>(MethodKind::Window) << false;
    }
  }
  void reachesMoreThanTwiceTheFeed() {
    QFETCH(int, method);
    QFETCH(bool, brisk);
    const Reach plain = reachOf(static_cast<MethodKind>(method), false, brisk);
    const Reach packed = reachOf(static_cast<MethodKind>(method), true, brisk);
    for (const auto& [name, reach] : {std::pair("plain", plain), std::pair("packed", packed)}) {
      qInfo("%s %s: free up to F %.0f, where the path takes F %.0f in the mean, with its stops",
            QTest::currentDataTag(), name, reach.feedMmPerMin, reach.meanMmPerMin);
    }
    QVERIFY(packed.feedMmPerMin >= 2.0 * plain.feedMmPerMin);
  }
};

RIVULET_TEST(TestPacked)
#include "tst_packed.moc"
