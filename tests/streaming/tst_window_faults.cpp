// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The invariants of methods window and credit under everything that can go wrong, and of the
/// methods of [P1] that what does go wrong is seen. The judge here shares no code with methods,
/// driver or oracle: it has the list of points and what the machine says it has executed.
/// RIVULET_SEED=n replays one run, RIVULET_SCENARIOS=n runs so many; scripts/soak runs many.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "fault_scenario.h"
#include "gcode/path_deviation.h"
#include "machine/machine.h"
#include "platform/thread_executor.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;
using base::Vec3;
using streaming::FaultEvidence;
using streaming::FaultScenario;
using streaming::FaultSegment;
using streaming::Outcome;
using streaming::RunReport;

namespace {

constexpr double kSameMm = 1e-6;
constexpr double kMovedMm = 1e-9;
/// Where the control was reset in the middle of a rounding, the point it rounds counts as either.
constexpr double kResetMm = 0.06;

/// Follows the points one by one: each block that moves must end at the point that is due.
class Follower {
 public:
  Follower(const std::vector<gcode::StreamPoint>& points, const base::RotarySet& rotaryAxes)
      : m_points(points), m_rotaryAxes(rotaryAxes) {}

  /// @return what was wrong; empty: nothing
  QString follow(const FaultSegment& segment) {
    bool isFirst = true;
    for (const trace::ExecutedBlock& block : segment.trace.blocks) {
      const bool moves = block.lengthMm > kMovedMm || block.turnDeg > kMovedMm;
      if (isDue(m_due, block)) {
        ++m_due;
      } else if (isFirst && !m_resets.empty() && moves) {
        if (!catchUp(block)) {
          return QStringLiteral("behind a reset: not the point due (%1)").arg(m_due);
        }
      } else if (moves) {
        return QStringLiteral("point %1 was due, the axes went to %2 %3 %4, %5 %6 %7")
            .arg(m_due)
            .arg(block.targetMm.x)
            .arg(block.targetMm.y)
            .arg(block.targetMm.z)
            .arg(block.targetDeg[0])
            .arg(block.targetDeg[1])
            .arg(block.targetDeg[2]);
      }
      isFirst = isFirst && !moves;
    }
    if (!segment.trace.blocks.empty()) {
      m_resets.clear();
    }
    if (segment.wasReset) {
      m_resets.push_back({segment.endMm, segment.endDeg});
    }
    return {};
  }

  [[nodiscard]] std::size_t executed() const { return m_due; }
  [[nodiscard]] std::size_t resetsInRounding() const { return m_caughtUp; }

 private:
  [[nodiscard]] bool isAt(std::size_t point, Vec3 mm, const base::RotaryDeg& deg,
                          double tolerance) const {
    bool turned = false;
    for (std::size_t axis = 0; axis < deg.size(); ++axis) {
      turned = turned || (m_rotaryAxes[axis] &&
                          std::abs(m_points[point].rotaryDeg[axis] - deg[axis]) > tolerance);
    }
    return !turned && base::distance(m_points[point].positionMm, mm) <= tolerance;
  }
  [[nodiscard]] bool isDue(std::size_t point, const trace::ExecutedBlock& block) const {
    return point < m_points.size() && isAt(point, block.targetMm, block.targetDeg, kSameMm);
  }

  bool catchUp(const trace::ExecutedBlock& block) {
    const auto isThere = [this](std::size_t point) {
      return std::any_of(m_resets.begin(), m_resets.end(), [&](const base::AxisPosition& at) {
        return isAt(point, at.mm, at.deg, kResetMm);
      });
    };
    for (std::size_t point = m_due; point < m_points.size(); ++point) {
      if (isDue(point, block)) {
        m_due = point + 1;
        ++m_caughtUp;
        return true;
      }
      if (!isThere(point)) {
        break;
      }
    }
    for (std::size_t point = m_due; point-- > 0 && isThere(point);) {
      if (isDue(point, block)) {
        m_due = point + 1;
        ++m_caughtUp;
        return true;
      }
    }
    return false;
  }

  const std::vector<gcode::StreamPoint>& m_points;
  std::size_t m_due = 0;
  std::size_t m_caughtUp = 0;
  base::RotarySet m_rotaryAxes;
  /// Where the control was reset since the last block: one reset may leave the tool at a point
  /// whose block it has cut off, and the next one beyond.
  std::vector<base::AxisPosition> m_resets;
};

struct Tally {
  std::size_t runs = 0;
  std::size_t attempts = 0;
  std::size_t points = 0;
  std::size_t whole = 0;  ///< every point executed in the end
  std::size_t wrong = 0;
  std::size_t stopped = 0;
  std::size_t lost = 0;
  std::size_t damaged = 0;
  std::size_t resets = 0;
  std::size_t strayWrites = 0;
  std::size_t intruded = 0;
  std::size_t refused = 0;
  std::size_t caughtUp = 0;
  std::size_t withRotary = 0;
  std::size_t packed = 0;
  std::size_t merged = 0;
  std::size_t leftOut = 0;  ///< points of those

  void add(const Tally& other) {
    runs += other.runs;
    attempts += other.attempts;
    points += other.points;
    whole += other.whole;
    wrong += other.wrong;
    stopped += other.stopped;
    lost += other.lost;
    damaged += other.damaged;
    resets += other.resets;
    strayWrites += other.strayWrites;
    intruded += other.intruded;
    refused += other.refused;
    caughtUp += other.caughtUp;
    withRotary += other.withRotary;
    packed += other.packed;
    merged += other.merged;
    leftOut += other.leftOut;
  }
};

std::vector<gcode::StreamPoint> pointsOf(const FaultScenario& drawn) {
  const base::AxisPosition start = drawn.run.scenario.machine.start();
  return gcode::streamPoints(drawn.run.scenario.program->trajectory, start.mm, start.deg).points;
}

void count(const FaultEvidence& evidence, Tally& tally) {
  ++tally.runs;
  tally.attempts += evidence.reports.size();
  tally.strayWrites += evidence.strayWrites;
  tally.intruded += evidence.intrusions > 0 ? 1 : 0;
  for (const FaultSegment& segment : evidence.segments) {
    tally.resets += segment.wasReset ? 1 : 0;
  }
  for (const RunReport& report : evidence.reports) {
    tally.stopped += report.outcome == Outcome::Stopped ? 1 : 0;
    tally.lost += report.error.code == opcua::LinkError::ConnectionLost ? 1 : 0;
    tally.damaged += report.error.code == streaming::StreamError::WindowDamaged ? 1 : 0;
    tally.refused += report.error.code == streaming::StreamError::WrongProgram ? 1 : 0;
  }
}

/// Faster than programmed? Another writer may have set any override that the program obeys.
QString feedsOf(const FaultScenario& drawn, const FaultEvidence& evidence) {
  using templates::FeedCell;
  const double raised = evidence.intrusions > 0 ? FeedCell::kMax / FeedCell::kProgrammed : 1.0;
  const double most = drawn.run.scenario.settings.feedMmPerS * raised * (1.0 + 1e-9);
  for (const FaultSegment& segment : evidence.segments) {
    for (const trace::ControlSample& sample : segment.trace.samples) {
      if (sample.feedMmPerS > most) {
        return QStringLiteral("feed %1 mm/s, programmed %2").arg(sample.feedMmPerS).arg(most);
      }
    }
  }
  return {};
}

/// @return what methods window and credit must never do; empty: nothing
QString examineWindow(
    std::uint64_t seed, Tally& tally, std::optional<opcua::Grouping> arrays = std::nullopt,
    MethodKind method = MethodKind::Window,
    machine::RParameterReading rRead = machine::RParameterReading::AtInterpretation) {
  FaultScenario drawn =
      streaming::drawFaults(seed, *machine::loadPreset(arrays ? "dmu75-arrays" : "dmu75"), method);
  drawn.run.scenario.machine.rRead = rRead;
  if (arrays) {
    drawn.run.scenario.settings.grouping = *arrays;
  }
  const FaultEvidence evidence = streaming::expose(drawn);
  const std::vector<gcode::StreamPoint> points = pointsOf(drawn);
  count(evidence, tally);
  const base::RotarySet& rotaryAxes = drawn.run.scenario.settings.parameters.rotaryAxes;
  tally.withRotary += base::any(rotaryAxes) ? 1 : 0;
  tally.packed += drawn.run.scenario.settings.parameters.packed ? 1 : 0;
  if (const double tolerance = drawn.run.scenario.settings.tolerance; tolerance > 0.0) {
    ++tally.merged;
    tally.leftOut += drawn.whole.points.size() - points.size();
    if (!gcode::isAlong(gcode::placesOf(drawn.whole),
                        gcode::placesOf(drawn.run.scenario.program->trajectory), tolerance)) {
      return QStringLiteral("the path is not that of the program within %1 mm").arg(tolerance);
    }
  }
  Follower follower(points, rotaryAxes);
  for (const FaultSegment& segment : evidence.segments) {
    if (segment.trace.truncated) {
      return QStringLiteral("the machine's trace is incomplete");
    }
    if (const QString wrong = follower.follow(segment); !wrong.isEmpty()) {
      return wrong;
    }
  }
  tally.points += follower.executed();
  tally.whole += follower.executed() == points.size() ? 1 : 0;
  tally.caughtUp += follower.resetsInRounding();
  if (!evidence.violations.empty()) {
    return QString::fromStdString(evidence.violations.front());
  }
  if (!evidence.endedByItself) {
    return QStringLiteral("the control was left waiting for a client that was gone");
  }
  if (const QString feed = feedsOf(drawn, evidence); !feed.isEmpty()) {
    return feed;
  }
  // What the reports say agrees with what was.
  const RunReport& last = evidence.reports.back();
  if (last.outcome == Outcome::Completed && follower.executed() < points.size()) {
    return QStringLiteral("completed without all points");
  }
  for (const RunReport& report : evidence.reports) {
    if (report.integrity.judged && !report.integrity.isFaultless() &&
        follower.resetsInRounding() == 0) {
      return QStringLiteral("the oracle found a fault that was none");
    }
  }
  // Without an intruder an operator who goes on gets the whole program executed; behind a reset in
  // the middle of a window only if it is certain where the tool is.
  if (drawn.resumes && evidence.intrusions == 0 && !drawn.resetAfter &&
      !evidence.wasResetWhileHeld && follower.executed() < points.size()) {
    return QStringLiteral("not finished after %1 attempts: %2")
        .arg(evidence.reports.size())
        .arg(QString::fromStdString(last.error.text()));
  }
  return {};
}

/// @return wrong motion that nobody reported; empty: none
QString examinePaper(std::uint64_t seed, MethodKind method, Tally& tally) {
  const FaultScenario drawn = streaming::drawFaults(seed, *machine::loadPreset("dmu75"), method);
  const FaultEvidence evidence = streaming::expose(drawn);
  const std::vector<gcode::StreamPoint> points = pointsOf(drawn);
  count(evidence, tally);
  Follower follower(points, {});
  QString wrong;
  for (const FaultSegment& segment : evidence.segments) {
    if (wrong.isEmpty()) {
      wrong = follower.follow(segment);
    }
  }
  const RunReport& report = evidence.reports.back();
  if (wrong.isEmpty() && report.outcome == Outcome::Completed &&
      follower.executed() < points.size()) {
    wrong = QStringLiteral("not all points");
  }
  tally.points += follower.executed();
  tally.whole += follower.executed() == points.size() ? 1 : 0;
  tally.wrong += wrong.isEmpty() ? 0 : 1;
  if (!wrong.isEmpty() && report.isFaultless()) {
    return QStringLiteral("reported as faultless: ") + wrong;
  }
  if (!wrong.isEmpty() && report.integrity.judged && report.integrity.isFaultless()) {
    return QStringLiteral("the oracle saw nothing: ") + wrong;
  }
  return feedsOf(drawn, evidence);
}

std::size_t numberFrom(const char* name, std::size_t otherwise) {
  bool isNumber = false;
  const qulonglong value = qEnvironmentVariable(name).toULongLong(&isNumber);
  return isNumber ? value : otherwise;
}

std::vector<std::uint64_t> seedsToRun(std::size_t usual) {
  std::vector<std::uint64_t> seeds;
  if (qEnvironmentVariableIsSet("RIVULET_SEED")) {
    seeds.push_back(numberFrom("RIVULET_SEED", 1));
    return seeds;
  }
  const std::size_t count = numberFrom("RIVULET_SCENARIOS", usual);
  const std::size_t first = numberFrom("RIVULET_FIRST", 1);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    seeds.push_back(seed);
  }
  seeds.push_back(std::random_device{}());  // one that nobody has tried
  qInfo("fresh seed: RIVULET_SEED=%llu", static_cast<unsigned long long>(seeds.back()));
  return seeds;
}

template <class Examine>
Tally examineAll(const std::vector<std::uint64_t>& seeds, const Examine& examine,
                 QStringList& findings) {
  std::vector<QString> found(seeds.size());
  std::vector<Tally> tallies(seeds.size());
  parallel::ThreadExecutor executor;
  executor.forEach(seeds.size(), [&](std::size_t i) { found[i] = examine(seeds[i], tallies[i]); });
  Tally sum;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    sum.add(tallies[i]);
    if (!found[i].isEmpty()) {
      findings << QStringLiteral("RIVULET_SEED=%1: %2").arg(seeds[i]).arg(found[i]);
    }
  }
  return sum;
}

void print(const char* what, const Tally& sum) {
  qInfo(
      "%s: %zu runs, %zu attempts, %zu points, %zu whole, %zu with wrong motion; %zu stopped, %zu "
      "lost, %zu windows refused, %zu resets (%zu in a rounding), %zu stray writes, %zu intruded, "
      "%zu wrong programs, %zu with rotary axes, %zu with packed points, %zu within a tolerance "
      "(%zu points left out)",
      what, sum.runs, sum.attempts, sum.points, sum.whole, sum.wrong, sum.stopped, sum.lost,
      sum.damaged, sum.resets, sum.caughtUp, sum.strayWrites, sum.intruded, sum.refused,
      sum.withRotary, sum.packed, sum.merged, sum.leftOut);
}

}  // namespace

class TestWindowFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void windowKeepsItsInvariants() {
    const std::vector<std::uint64_t> seeds = seedsToRun(400);
    QStringList findings;
    const Tally sum = examineAll(
        seeds, [](std::uint64_t seed, Tally& tally) { return examineWindow(seed, tally); },
        findings);
    print("window", sum);
    QVERIFY2(findings.isEmpty(),
             qPrintable(QStringLiteral("%1 of %2\n").arg(findings.size()).arg(seeds.size()) +
                        findings.mid(0, 20).join(u'\n')));
    if (seeds.size() > 100) {
      // The scenarios must be worth something.
      QVERIFY(sum.attempts > seeds.size() + seeds.size() / 5);
      QVERIFY(sum.stopped > 0 && sum.lost > 0 && sum.damaged > 0 && sum.resets > 0);
      QVERIFY(sum.strayWrites > 0 && sum.intruded > 0 && sum.refused > 0);
      QVERIFY(sum.withRotary > seeds.size() / 5);
      QVERIFY(sum.merged > seeds.size() / 3 && 2 * sum.leftOut > sum.points);
    }
  }

  /// A window that travels as one array must keep them too.
  void arraysKeepThemToo() {
    const std::vector<std::uint64_t> seeds = seedsToRun(200);
    for (const opcua::Grouping form : {opcua::Grouping::ArrayCount, opcua::Grouping::ArrayRange}) {
      QStringList findings;
      const Tally sum = examineAll(
          seeds,
          [form](std::uint64_t seed, Tally& tally) { return examineWindow(seed, tally, form); },
          findings);
      print(std::string(opcua::groupingName(form)).c_str(), sum);
      QVERIFY2(findings.isEmpty(),
               qPrintable(QStringLiteral("%1 of %2\n").arg(findings.size()).arg(seeds.size()) +
                          findings.mid(0, 20).join(u'\n')));
      if (seeds.size() > 100) {
        QVERIFY(sum.whole > 0 && sum.stopped > 0 && sum.lost > 0 && sum.damaged > 0);
      }
    }
  }

  /// The same promises without a stop between windows, even on a control that does not read as
  /// method credit needs it (and on which it is never started): there the machine waits.
  void creditKeepsThemToo() {
    for (const machine::RParameterReading rRead : {machine::RParameterReading::AtInterpretation,
                                                   machine::RParameterReading::CachedUntilStopre}) {
      const bool isFit = rRead == machine::RParameterReading::AtInterpretation;
      const std::vector<std::uint64_t> seeds = seedsToRun(isFit ? 400 : 100);
      QStringList findings;
      const Tally sum = examineAll(
          seeds,
          [rRead](std::uint64_t seed, Tally& tally) {
            return examineWindow(seed, tally, std::nullopt, MethodKind::Credit, rRead);
          },
          findings);
      print(isFit ? "credit" : "credit, values cached", sum);
      QVERIFY2(findings.isEmpty(),
               qPrintable(QStringLiteral("%1 of %2\n").arg(findings.size()).arg(seeds.size()) +
                          findings.mid(0, 20).join(u'\n')));
      if (seeds.size() > 300) {
        QVERIFY(sum.attempts > seeds.size() + seeds.size() / 5);
        QVERIFY(sum.whole > 0 && sum.stopped > 0 && sum.lost > 0 && sum.damaged > 0);
        QVERIFY(sum.resets > 0 && sum.strayWrites > 0 && sum.intruded > 0 && sum.refused > 0);
      }
    }
  }

  /// Windows that are files: old ones arrive late, and are refused.
  void filesKeepThemToo() {
    const std::vector<std::uint64_t> seeds = seedsToRun(150);
    QStringList findings;
    const Tally sum = examineAll(
        seeds,
        [](std::uint64_t seed, Tally& tally) {
          return examineWindow(seed, tally, std::nullopt, MethodKind::File);
        },
        findings);
    print("file", sum);
    QVERIFY2(findings.isEmpty(),
             qPrintable(QStringLiteral("%1 of %2\n").arg(findings.size()).arg(seeds.size()) +
                        findings.mid(0, 20).join(u'\n')));
    if (seeds.size() > 100) {
      QVERIFY(sum.whole > 0 && sum.stopped > 0 && sum.lost > 0 && sum.resets > 0);
    }
  }

  void whatGoesWrongWithTheMethodsOfThePaperIsSeen() {
    const std::vector<std::uint64_t> seeds = seedsToRun(100);
    for (const MethodKind method : base::kPaperMethods) {
      QStringList findings;
      const Tally sum = examineAll(
          seeds,
          [method](std::uint64_t seed, Tally& tally) { return examinePaper(seed, method, tally); },
          findings);
      print(std::string(base::methodName(method)).c_str(), sum);
      QVERIFY2(findings.isEmpty(),
               qPrintable(QStringLiteral("%1 of %2\n").arg(findings.size()).arg(seeds.size()) +
                          findings.mid(0, 20).join(u'\n')));
      if (seeds.size() > 50) {
        QVERIFY(sum.wrong > seeds.size() / 10);
      }
    }
  }
};

RIVULET_TEST(TestWindowFaults)
#include "tst_window_faults.moc"
