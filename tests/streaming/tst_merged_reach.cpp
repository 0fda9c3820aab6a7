// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// How fast dense points can be streamed without the machine waiting for the client: as they are,
/// packed, within a tolerance, and both; by method, at the access times of [P1] and with its
/// machine as it is. `RIVULET_SEEDS=10` makes the table of docs/reach.md.

#include <QtTest>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "feasibility/probability.h"
#include "feasibility/verdict.h"
#include "forecast/region.h"
#include "gcode/path_deviation.h"
#include "report/operating_point.h"
#include "streaming/simulation/scenario.h"
#include "streaming/start/stop_bound.h"
#include "support/setting.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;
using base::Vec3;
using streaming::RunReport;

namespace {

constexpr double kToleranceMm = 0.005;
constexpr double kPaperFeedMmPerMin = 500.0;
constexpr double kPathMm = 150.0;
constexpr double kPointDistanceMm = 0.15;
constexpr double kRestMm = 0.05;

/// What is streamed.
enum class Path {
  Curve,    ///< points on a smooth line, as a CAM system puts them there
  Contour,  ///< `streaming::drawContour`: each step has a direction of its own
};

struct Form {
  MethodKind method = MethodKind::Window;
  bool brisk = false;
  bool packed = false;
  double tolerance = 0.0;
  Path path = Path::Curve;
  int slower = 1;  ///< access, times as slow
};

/// At least 5 mm of radius, irregular steps of 0.15 mm and more, coordinates of three digits.
std::vector<Vec3> drawCurve(std::uint64_t seed) {
  constexpr double kTurnPerMm = 0.1;
  base::Random random(seed);
  std::array<double, 3> wave{};
  std::array<double, 3> phase{};
  for (std::size_t i = 0; i < wave.size(); ++i) {
    wave[i] = 10.0 + 30.0 * random.uniform();
    phase[i] = 2.0 * std::numbers::pi * random.uniform();
  }
  std::vector<Vec3> points;
  Vec3 at{};
  double course = 0.0;
  for (double mm = 0.0; mm < kPathMm;) {
    points.push_back({0.001 * std::round(1000.0 * at.x), 0.001 * std::round(1000.0 * at.y),
                      0.001 * std::round(1000.0 * at.z)});
    const double step = kPointDistanceMm + kRestMm * random.exponential();
    course += kTurnPerMm * step *
              (std::sin(2.0 * std::numbers::pi * mm / wave[0] + phase[0]) +
               std::sin(2.0 * std::numbers::pi * mm / wave[1] + phase[1]));
    const double climb = 0.2 * std::sin(2.0 * std::numbers::pi * mm / wave[2] + phase[2]);
    at = at + step * Vec3{std::cos(course), std::sin(course), climb};
    mm += step;
  }
  return points;
}

std::vector<Vec3> pointsOf(Path path, std::uint64_t seed) {
  constexpr double kPoints = kPathMm / (kPointDistanceMm + kRestMm);
  base::Random random(seed);
  return path == Path::Curve
             ? drawCurve(seed)
             : streaming::drawContour(
                   {static_cast<std::size_t>(kPoints), kPointDistanceMm, kRestMm}, random);
}

std::shared_ptr<const gcode::Program> programOf(const Form& form, std::uint64_t seed,
                                                const streaming::RunSettings& settings) {
  auto program = std::make_shared<gcode::Program>(*streaming::programOf(pointsOf(form.path, seed)));
  if (const auto applied = gcode::applyRules(*program, streaming::moveRules(settings)); !applied) {
    qFatal("%s", applied.error().text().c_str());
  }
  return program;
}

streaming::Scenario scenarioOf(const Form& form, double feedMmPerMin, std::uint64_t seed) {
  streaming::Scenario scenario;
  scenario.machine = *machine::loadPreset("dmu75");
  scenario.machine.access.nodeTimeMean *= form.slower;
  scenario.machine.access.nodeTimeDeviation *= form.slower;
  scenario.machine.resetDynamics = form.brisk ? machine::Dynamics::Brisk : machine::Dynamics::Soft;
  scenario.seed = seed;
  streaming::RunSettings& settings = scenario.settings;
  settings.parameters.method = form.method;
  settings.parameters.packed = form.packed;
  settings.parameters.pointsPerLoop = templates::pointsPerLoopMax(settings.parameters);
  settings.parameters.silenceLimitS *= form.slower;  // a window in one request is no silence
  settings.isCommissioned = true;
  settings.tolerance = form.tolerance;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  scenario.program = programOf(form, seed, settings);
  return scenario;
}

struct Free {
  bool isFree = true;
  double seconds = 0.0;
  double secondsAlone = 0.0;  ///< with a client that needs no time
  double lengthMm = 0.0;
  double deviationMm = 0.0;  ///< of the points that the machine has executed from the program
  std::size_t points = 0;
};

double deviationOf(const RunReport& report, const std::vector<Vec3>& points) {
  std::vector<base::AxisPosition> executed;
  for (const trace::ExecutedBlock& block : report.controlTrace->blocks) {
    if (block.moves()) {
      executed.push_back({block.targetMm});
    }
  }
  std::vector<base::AxisPosition> program;
  for (const Vec3& point : points) {
    program.push_back({point});
  }
  // The tool stands at the first point: no block leads there.
  if (executed.size() + 1 <= program.size() && !(executed.front().mm == program.front().mm)) {
    executed.insert(executed.begin(), program.front());
  }
  return gcode::pathDeviation(program, executed, 1.0).value_or(1.0);
}

/// Whether the run takes no longer, and no stop in it, than with a client that needs no time.
Free look(const Form& form, double feedMmPerMin, std::uint64_t seed) {
  streaming::Scenario scenario = scenarioOf(form, feedMmPerMin, seed);
  const RunReport real = streaming::simulate(scenario);
  machine::AccessCost& access = scenario.machine.access;
  access.readOverhead = access.writeOverhead = {};
  access.nodeTimeMean = access.nodeTimeDeviation = access.nodeTimeMin = {};
  const RunReport ideal = streaming::simulate(scenario);
  if (!real.isFaultless() || !ideal.isFaultless()) {
    qFatal("%s %s", real.error.text().c_str(), ideal.error.text().c_str());
  }
  Free found;
  found.isFree =
      real.pauses.size() <= ideal.pauses.size() && real.duration <= 1.01 * ideal.duration;
  for (std::size_t i = 0; found.isFree && i < real.pauses.size(); ++i) {
    found.isFree =
        real.pauses[i].duration <= ideal.pauses[i].duration + scenario.machine.interpolationCycle;
  }
  const auto& path = scenario.program->trajectory.points;
  for (std::size_t i = 1; i < path.size(); ++i) {
    found.lengthMm += base::distance(path[i - 1].positionMm, path[i].positionMm);
  }
  found.seconds = base::toSeconds(real.duration);
  found.secondsAlone = base::toSeconds(ideal.duration);
  found.deviationMm = deviationOf(real, pointsOf(form.path, seed));
  found.points = path.size();
  return found;
}

struct Reach {
  double feedMmPerMin = 0.0;  ///< largest of the ladder up to which no run waits for the client
  double meanMmPerMin = 0.0;  ///< length over duration, there
};

Reach reachOf(const Form& form, std::uint64_t seeds) {
  constexpr double kStepMmPerMin = 200.0;
  constexpr double kMostMmPerMin = 10'000.0;
  Reach reach;
  for (double feed = 400.0; feed <= kMostMmPerMin; feed += feed < 3000.0 ? kStepMmPerMin : 1000.0) {
    Free sum;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Free one = look(form, feed, seed);
      if (!one.isFree) {
        return reach;
      }
      sum.seconds += one.seconds;
      sum.lengthMm += one.lengthMm;
    }
    reach = {feed, base::mmPerMinFromMmPerS(sum.lengthMm / sum.seconds)};
  }
  return reach;
}

/// By the equation, of the first path.
double verdictMmPerMin(const Form& form) {
  const streaming::Scenario scenario = scenarioOf(form, 1000.0, 1);
  const auto points = gcode::streamPoints(scenario.program->trajectory, {}).points;
  const feasibility::OperatingPoint point = report::operatingPointOf(scenario.settings);
  const auto verdict = feasibility::judge(
      point, feasibility::programDistances(points, point.pointsPerLoop, point.feedMmPerS), {});
  return verdict ? base::mmPerMinFromMmPerS(verdict->feedMmPerSMax) : 0.0;
}

constexpr double kWaitingShare = 0.01;

/// By the prediction: up to where the machine is not expected to wait. Method window only.
double predictedMmPerMin(const Form& form, std::uint64_t seed) {
  constexpr double kStep = 1.02;
  constexpr double kMostMmPerMin = 10'000.0;
  const streaming::Scenario scenario = scenarioOf(form, 1000.0, seed);
  const base::Vec3 startMm = scenario.machine.start().mm;
  const auto points = gcode::streamPoints(scenario.program->trajectory, startMm).points;
  double most = 0.0;
  for (double feed = 100.0; form.method == MethodKind::Window && feed <= kMostMmPerMin;
       feed *= kStep) {
    feasibility::OperatingPoint point = report::operatingPointOf(scenario.settings);
    point.feedMmPerS = base::mmPerSFromMmPerMin(feed);
    const feasibility::Prediction prediction =
        feasibility::predict(points, point, forecast::streamModelOf(scenario.machine), startMm);
    if (base::toSeconds(prediction.waiting) >
        kWaitingShare * base::toSeconds(prediction.duration)) {
      break;
    }
    most = feed;
  }
  return most;
}

/// Whether it does so, simulated.
bool waits(const Form& form, double feedMmPerMin, std::uint64_t seed) {
  const Free found = look(form, feedMmPerMin, seed);
  return found.seconds > (1.0 + kWaitingShare) * found.secondsAlone;
}

}  // namespace

Q_DECLARE_METATYPE(Form)

class TestMergedReach : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Ten times the feed of [P1], where the points are as dense as its own: no stop is longer than
  /// with a client that needs no time, and the path is that of the program.
  void tenTimesThePaperWithinTheTolerance_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("brisk");
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
      for (const bool brisk : {false, true}) {
        QTest::addRow("%s, %s", base::methodName(method).data(), brisk ? "BRISK" : "SOFT")
            << static_cast<int>(method) << brisk;
      }
    }
  }
  void tenTimesThePaperWithinTheTolerance() {
    QFETCH(int, method);
    QFETCH(bool, brisk);
    const Form form{static_cast<MethodKind>(method), brisk, true, kToleranceMm};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Free found = look(form, 10.0 * kPaperFeedMmPerMin, seed);
      QVERIFY2(found.isFree, qPrintable(QStringLiteral("seed %1").arg(seed)));
      QVERIFY2(found.deviationMm <= kToleranceMm, qPrintable(QString::number(found.deviationMm)));
    }
  }

  /// Each of the two is needed, where the machine could go as fast.
  void itTakesPackingAndTheTolerance_data() {
    QTest::addColumn<bool>("packed");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("neither") << false << 0.0;
    QTest::newRow("packed alone") << true << 0.0;
    QTest::newRow("the tolerance alone") << false << kToleranceMm;
  }
  void itTakesPackingAndTheTolerance() {
    QFETCH(bool, packed);
    QFETCH(double, tolerance);
    QVERIFY(
        !look({MethodKind::Credit, true, packed, tolerance}, 10.0 * kPaperFeedMmPerMin, 1).isFree);
  }

  /// Where the machine begins to wait is predicted for packed and merged points, too: within 10 %.
  void theLimitIsPredicted_data() {
    QTest::addColumn<Form>("form");
    const auto row = [](const char* name, const Form& form) { QTest::newRow(name) << form; };
    row("plain", {MethodKind::Window, true, false, 0.0});
    row("merged", {MethodKind::Window, true, false, kToleranceMm});
    row("packed", {MethodKind::Window, true, true, 0.0, Path::Curve, 5});
    row("packed and merged", {MethodKind::Window, true, true, kToleranceMm, Path::Curve, 5});
    row("merged contour", {MethodKind::Window, true, false, kToleranceMm, Path::Contour});
  }
  void theLimitIsPredicted() {
    QFETCH(Form, form);
    constexpr double kError = 0.1;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const double predicted = predictedMmPerMin(form, seed);
      qInfo("predicted F %.0f", predicted);
      QVERIFY(predicted > 0.0 && predicted < 5000.0);
      QVERIFY(!waits(form, (1.0 - kError) * predicted, seed));
      QVERIFY(waits(form, (1.0 + kError) * predicted, seed));
    }
  }

  /// A row of docs/reach.md each, with what the equation and the prediction say.
  void table_data() {
    QTest::addColumn<Form>("form");
    for (const Path path : {Path::Curve, Path::Contour}) {
      for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
        for (const bool brisk : {true, false}) {
          for (const double tolerance : {0.0, kToleranceMm}) {
            for (const bool packed : {false, true}) {
              QTest::addRow("%s | %s, %s | %s%s", path == Path::Curve ? "curve" : "contour",
                            base::methodName(method).data(), brisk ? "BRISK" : "SOFT",
                            packed ? "packed" : "plain", tolerance > 0.0 ? ", 0.005 mm" : "")
                  << Form{method, brisk, packed, tolerance, path};
            }
          }
        }
      }
    }
  }
  void table() {
    QFETCH(Form, form);
    const int seeds = tests::setting("RIVULET_SEEDS", 0);
    if (seeds == 0) {
      QSKIP("RIVULET_SEEDS=10 makes the table of docs/reach.md");
    }
    const Reach reach = reachOf(form, static_cast<std::uint64_t>(seeds));
    const Free fast = look(form, 10.0 * kPaperFeedMmPerMin, 1);
    qInfo("%s | %zu | F %.0f | F %.0f | %.0f | %.1f (%.1f) | %.0f", QTest::currentDataTag(),
          fast.points, reach.feedMmPerMin, verdictMmPerMin(form), reach.meanMmPerMin, fast.seconds,
          fast.secondsAlone, predictedMmPerMin(form, 1));
  }
};

RIVULET_TEST(TestMergedReach)
#include "tst_merged_reach.moc"
