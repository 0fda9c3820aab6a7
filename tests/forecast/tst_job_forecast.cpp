// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a whole job would do on a machine: found before the start, and the same as the machine does.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/units.h"
#include "forecast/job_forecast.h"
#include "forecast/job_restart.h"
#include "forecast/large_machine.h"
#include "job/main_program.h"
#include "machine/machine.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using forecast::Hazard;
using forecast::HazardKind;

namespace {

job::Plan planOf(const std::string& text, gcode::Dialect dialect = gcode::Dialect::Sinumerik) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  const auto plan = job::makePlan("PART.MPF", text, options);
  if (!plan || !plan->isWhole()) {
    qFatal("the test's program is no job");
  }
  return *plan;
}

machine::MachineConfig mill() {
  return *machine::loadPreset("dmu75-mill");
}

std::vector<Hazard> hazards(const std::string& text) {
  return forecast::hazardsOf(planOf(text), mill(), {mill().start()});
}

/// "travel 4 X, tool-missing 7"
QString found(const std::vector<Hazard>& hazards) {
  QStringList all;
  for (const Hazard& hazard : hazards) {
    QString one = QString::fromUtf8(hazardName(hazard.kind).data()) +
                  QStringLiteral(" %1").arg(hazard.line.value);
    if (hazard.travel) {
      one += QLatin1Char(' ') + QChar::fromLatin1(hazard.travel->axis);
    }
    all << one;
  }
  return all.join(QStringLiteral(", "));
}

/// Three stretches of 100 chords, a tool change and a dwell.
std::string part() {
  std::string text = "G54\nT1 D1 M6\nS3000 M3\nG0 X20 Y0 Z20\n";
  for (int stretch = 0; stretch < 3; ++stretch) {
    text += "G1 Z-1 F800\n";
    for (int i = 1; i <= 100; ++i) {
      text += "X" + std::to_string(20.0 * std::cos(0.1 * i)) + " Y" +
              std::to_string(20.0 * std::sin(0.1 * i)) + " F3000\n";
    }
    text += stretch == 1
                ? "G0 Z20\nG4 F3\n"
                : "SUPA G0 Z200 D0\nT" + std::to_string(2 + stretch) + " D1 M6\nG0 X20 Y0\nZ20\n";
  }
  return text + "M30\n";
}

class Watcher final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
  bool stopRequested(base::Instant now) override { return stopsAt && now >= *stopsAt; }

  std::optional<base::Instant> stopsAt;
};

streaming::WholeJobReport runOnMill(const std::string& text, const streaming::RunSettings& settings,
                                    std::optional<double> stopsAfterS = {}) {
  machine::Machine machine(mill(), 1);
  streaming::SimulatedLink link(machine);
  Watcher watcher;
  if (stopsAfterS) {
    watcher.stopsAt = link.now() + base::fromSeconds(*stopsAfterS);
  }
  return streaming::runWholeJob(link, link, planOf(text), settings, watcher, watcher);
}

streaming::RunSettings settings() {
  streaming::RunSettings all;
  all.feedMmPerS = base::mmPerSFromMmPerMin(3000.0);
  all.isCommissioned = true;
  return all;
}

}  // namespace

class TestJobForecast : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A machine that nobody has named is as large as the job needs, and says so.
  void largeMachine() {
    const job::Plan plan = planOf("G54\nG0 X0 Y0 Z10\nX2000\nSUPA G0 Y-900\nM30\n");
    machine::MachineConfig config = mill();
    QVERIFY(!found(forecast::hazardsOf(plan, config, {config.start()})).isEmpty());
    const std::vector<std::string> notes = forecast::enlarge(config, plan);
    QCOMPARE(found(forecast::hazardsOf(plan, config, {config.start()})), QString());
    QCOMPARE(notes.size(), std::size_t{2});
    QVERIFY(notes[0].find("X goes from -375 to 2001 mm instead of -375 to 375 mm") !=
            std::string::npos);
    QVERIFY(notes[1].find("Y goes from -901") != std::string::npos);
    QVERIFY(forecast::enlarge(config, plan).empty());
  }

  void toolsTooLarge() {
    const job::Plan plan = planOf(
        "G54\nT3 D1 M6\nG0 X0 Y0 Z10\nG1 Z0 F100\nG41 G1 X20\nG3 X20.4 Y0.4 CR=0.3\nG1 X20 "
        "Y40\nG40 X0\nG0 Z50\nM30\n");
    machine::MachineConfig config = mill();
    QVERIFY(found(forecast::hazardsOf(plan, config, {config.start()})).contains("refused"));
    QCOMPARE(forecast::enlarge(config, plan).size(), std::size_t{1});
    QCOMPARE(found(forecast::hazardsOf(plan, config, {config.start()})), QString());
  }

  void nothingIsFoundInASoundJob() {
    QCOMPARE(found(hazards("G54\nT1 D1 M6\nS3000 M3\nG0 X0 Y0 Z50\nG1 X20 Y20 Z-2 F500\n"
                           "SUPA G0 Z200 D0\nM30\n")),
             QString());
  }

  /// In a streamed stretch the farthest point counts, with its own line.
  void travelInAStretch() {
    const std::vector<Hazard> all =
        hazards("G54\nT1 D1 M6\nG0 X0 Y0 Z50\nX380\nX400\nX390\nX0\nG4 F1\nG0 X1\nM30\n");
    QCOMPARE(found(all), QStringLiteral("travel 5 X"));
    QCOMPARE(all[0].travel->target, 400.0);
    QCOMPARE(all[0].travel->max, 375.0);
    QCOMPARE(QString::fromStdString(describe(all[0])),
             QStringLiteral("Line 5 (stretch 1): X would go to 400.000 mm in machine coordinates, "
                            "25.000 mm beyond its limit of 375 mm. Move the workpiece or change "
                            "the work offset."));
    QVERIFY(!requireNoHazard(planOf("G0 X1\n"), all));
  }

  /// The work offset and the length of the tool count, in native blocks and in stretches.
  void offsetsCount() {
    QCOMPARE(found(hazards("T1 D1 M6\nG0 X0 Y0 Z180\nM30\n")), QString());
    QCOMPARE(found(hazards("T1 D1 M6\nG0 X0 Y0 Z190\nM30\n")), QStringLiteral("travel 2 Z"));
    QCOMPARE(found(hazards("T7 D1 M6\nG0 X0 Y0 Z180\nM30\n")), QStringLiteral("travel 2 Z"));
    QCOMPARE(found(hazards("G55\nT1 D1 M6\nG0 X300 Y0 Z180\nM30\n")), QStringLiteral("travel 3 X"));
    QCOMPARE(found(hazards("G54\nT1 D1 M6\nG0 X0 Y0 Z180\nSUPA G0 Z300 D0\nM30\n")),
             QStringLiteral("travel 4 Z"));
  }

  /// Within a cycle: the bottom of the hole is below the travel.
  void travelInACycle() {
    QCOMPARE(found(hazards("T7 D1 M6\nS1000 M3\nG0 X0 Y0 Z-100\nF100\n"
                           "CYCLE81(-100,-110,2,-450)\nM30\n")),
             QStringLiteral("travel 5 Z"));
  }

  void toolsAndSpindle() {
    const std::vector<Hazard> all =
        hazards("T1 M6\nS24000 M3\nG0 X0 Y0 Z50\nT12\nM6\nG0 X1\nM30\n");
    QCOMPARE(found(all), QStringLiteral("spindle-speed 2, tool-missing 4"));
    QVERIFY(!all[0].stops() && all[1].stops());
    QVERIFY(QString::fromStdString(describe(all[0])).contains(QStringLiteral("S24000 is 4000 1/")));
    QVERIFY(
        QString::fromStdString(describe(all[1])).startsWith(QStringLiteral("Line 4: tool T12")));
  }

  /// A name that differs in blanks and the like is named.
  void aToolWithNearlyTheName() {
    machine::MachineConfig config = mill();
    const std::string name = config.tools->tools.front().name;
    std::string other = name;
    std::replace(other.begin(), other.end(), '_', ' ');
    QVERIFY(other != name);
    const auto all = hazards("T=\"" + other + "\" M6\nG0 X0 Y0 Z50\nM30\n");
    QCOMPARE(found(all), QStringLiteral("tool-missing 1"));
    QCOMPARE(all.front().near, name);
    QVERIFY(describe(all.front()).find(", but " + name + " is.") != std::string::npos);
    QVERIFY(hazards("T=\"NOT_THERE\" M6\nG0 X0 Y0 Z50\nM30\n").front().near.empty());
  }

  void whatTheMachineRefuses() {
    QCOMPARE(found(hazards("T1 M6\nD9\nG0 X0 Y0 Z50\nM30\n")), QStringLiteral("refused 2"));
    const std::vector<Hazard> all = hazards("G0 X0 Y0 Z50\nM8\nNOT_THERE\nG0 X900\nM30\n");
    QCOMPARE(found(all), QStringLiteral("not-checked 3"));
    QVERIFY(requireNoHazard(planOf("G0 X1\n"), all));
  }

  /// Programs of other dialects: the line is that of the source.
  void translated() {
    const job::Plan plan = planOf(
        "G21 G90\nT12 M6\nG54\nG43 H12\nG0 X0 Y0 Z50\nG1 X500 F500\nM30\n", gcode::Dialect::Fanuc);
    QCOMPARE(found(forecast::hazardsOf(plan, mill(), {mill().start()})),
             QStringLiteral("tool-missing 2, travel 6 X"));
  }

  /// What the machine does is what was found: it stops where the check says, and only there.
  void theMachineAgrees() {
    int stopped = 0;
    for (const char* const end : {"G0 X1", "G0 X380", "SUPA G0 Z300 D0", "T12 M6", "D9"}) {
      const std::string text =
          "G54\nT1 D1 M6\nG0 X0 Y0 Z50\nG1 X5 F3000\nM8\n" + std::string(end) + "\nM30\n";
      const job::Plan plan = planOf(text);
      const bool isSound =
          requireNoHazard(plan, forecast::hazardsOf(plan, mill(), {mill().start()})).has_value();
      machine::Machine machine(mill(), 1);
      streaming::SimulatedLink link(machine);
      Watcher watcher;
      const streaming::WholeJobReport report =
          streaming::runWholeJob(link, link, plan, settings(), watcher, watcher);
      QCOMPARE(report.outcome == streaming::Outcome::Completed, isSound);
      stopped += isSound ? 0 : 1;
    }
    QCOMPARE(stopped, 4);
  }

  void timesAreThoseMeasured_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("window") << static_cast<int>(base::MethodKind::Window);
    QTest::newRow("credit") << static_cast<int>(base::MethodKind::Credit);
  }

  void timesAreThoseMeasured() {
    QFETCH(const int, method);
    streaming::RunSettings run = settings();
    run.parameters.method = static_cast<base::MethodKind>(method);
    const job::Plan plan = planOf(part());
    const streaming::JobTimes estimated =
        forecast::forecast(plan, mill(), run, {mill().start()}).times;
    const streaming::WholeJobReport report = runOnMill(part(), run);
    QCOMPARE(report.outcome, streaming::Outcome::Completed);
    const streaming::JobTimes& measured = report.times;
    const auto differ = [](base::Duration a, base::Duration b) {
      return std::abs(base::toSeconds(a) - base::toSeconds(b));
    };
    const std::string both = "estimated " + std::to_string(base::toSeconds(estimated.total())) +
                             " s, measured " + std::to_string(base::toSeconds(measured.total()));
    // What the client waits for depends on its accesses, which the estimate takes as an average.
    QVERIFY2(differ(estimated.total(), measured.total()) < 0.1 * base::toSeconds(measured.total()),
             both.c_str());
    // Each of the three blocks is seen a little longer: the control waits before and after it.
    const std::string tools = std::to_string(base::toSeconds(estimated.toolChange)) + " s, " +
                              std::to_string(base::toSeconds(measured.toolChange)) + " s";
    QVERIFY2(differ(estimated.toolChange, measured.toolChange) < 1.5, tools.c_str());
    QVERIFY(differ(estimated.pauses, measured.pauses) < 1.0);
    QVERIFY(measured.toolChange > std::chrono::seconds{14});  // three of 5 s
    QVERIFY(measured.native > std::chrono::seconds{3});       // the dwell
    base::Duration inBlocks{};
    for (const base::Duration each :
         forecast::checkJob(plan, mill(), {mill().start()}).nativeTimes) {
      inBlocks += each;
    }
    QCOMPARE(inBlocks, estimated.toolChange + estimated.native);
    streaming::JobTimes sum;
    for (const streaming::JobTimes& times : report.partTimes) {
      sum += times;
    }
    sum.handover = measured.handover;
    QVERIFY(differ(sum.total(), measured.total()) < 1e-6);
    QCOMPARE(report.reached.stretch, static_cast<int>(plan.stretchCount()));
  }

  /// A job that is stopped knows how far it came.
  void howFarItCame() {
    const streaming::WholeJobReport inNative = runOnMill(part(), settings(), 3.0);
    QCOMPARE(QString::fromStdString(describe(inNative.reached)),
             QStringLiteral("at the block for the control in line 2"));
    const streaming::WholeJobReport inStretch = runOnMill(part(), settings(), 9.0);
    QCOMPARE(inStretch.outcome, streaming::Outcome::Stopped);
    QCOMPARE(inStretch.reached.stretch, 1);
    QCOMPARE(inStretch.reached.native, 0);
    const std::size_t executed = inStretch.reached.executed;
    QVERIFY(executed > 3 && executed < 102);
    // G0 in line 4 is the first point.
    QCOMPARE(inStretch.reached.line.value, static_cast<unsigned>(executed + 3));
  }

  /// From where a stop has left the tool, a job that begins at its beginning may go straight
  /// through the part. Height and place are in machine coordinates, whatever offset and tool.
  void firstMovesThroughTheCut_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<bool>("isInCut");
    QTest::addColumn<bool>("passesCut");
    QTest::addColumn<double>("topMm");
    const QString plain = QStringLiteral("G54\nT1 D1 M6\nS3000 M3\nG0 X20 Y0 Z20\n");
    QTest::newRow("from its start") << plain << false << false << 20.0;
    QTest::newRow("from the cut") << plain << true << true << 20.0;
    QTest::newRow("from the cut, retracted first")
        << QStringLiteral("SUPA G0 Z200 D0\n") + plain << true << false << 20.0;
    QTest::newRow("from the cut, retracted too late")
        << QStringLiteral("G54\nT1 D1 M6\nG0 X20 Y0\nSUPA G0 Z200 D0\nG0 Z20\n") << true << true
        << 20.0;
    QTest::newRow("from the cut, drilling first")
        << QStringLiteral("G54\nT1 D1 M6\nS900 M3\nG0 X-9 Y0 Z20 F300\nCYCLE81(20,0,2,-5)\n")
        << true << true << 2.0;  // where the tool is behind a cycle, only the control knows
    // The first move of a stretch counts as well.
    QTest::newRow("from the cut, streamed")
        << QStringLiteral("G0 X20 Y0 Z20\n") << true << true << 20.0;
  }
  void firstMovesThroughTheCut() {
    QFETCH(const QString, head);
    QFETCH(const bool, isInCut);
    QFETCH(const bool, passesCut);
    QFETCH(const double, topMm);
    const job::Plan plan = planOf(head.toStdString() + "G1 Z-1 F800\nX-20\nY15\nX20\nY0\n" +
                                  "G0 Z20\nM5\nX60 Y60\nM30\n");
    const auto checked = forecast::checkJob(plan, mill(), {mill().start()});
    QVERIFY2(checked.hazards.empty(), found(checked.hazards).toUtf8().constData());
    const auto zero = forecast::zeroAt(plan, mill(), plan.parts.size() - 1);
    QVERIFY(zero.has_value());
    QCOMPARE(checked.cut.highestMm.z - zero->z, topMm);
    const base::AxisPosition tool =
        isInCut ? base::AxisPosition{*zero + base::Vec3{-3, 8, -1}, {}} : mill().start();
    const auto cut = forecast::cutOnTheWay(plan, mill(), tool, checked.cut);
    QCOMPARE(cut.has_value(), passesCut);
    if (cut) {
      QCOMPARE(cut->heightMm, checked.cut.highestMm.z);
      QVERIFY(cut->isClearFromAbove);
      base::AxisPosition raised = tool;
      raised.mm.z = cut->heightMm;
      QVERIFY(!forecast::cutOnTheWay(plan, mill(), raised, checked.cut));
    }
  }
};

RIVULET_TEST(TestJobForecast)
#include "tst_job_forecast.moc"
