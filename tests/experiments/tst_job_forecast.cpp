// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a whole job would do on a machine: found before the start, and the same as the machine does.

#include <QtTest>

#include "base/units.h"
#include "experiments/job_forecast.h"
#include "job/main_program.h"
#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"
#include "streaming/whole_job.h"
#include "support/test_program.h"

using namespace rivulet;
using experiments::Hazard;
using experiments::HazardKind;

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
  return experiments::hazardsOf(planOf(text), mill(), {mill().start()});
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

class Watcher final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
  bool stopRequested(base::Instant) override { return false; }
};

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

  void whatTheMachineRefuses() {
    QCOMPARE(found(hazards("T1 M6\nD9\nG0 X0 Y0 Z50\nM30\n")), QStringLiteral("refused 2"));
    const std::vector<Hazard> all = hazards("G0 X0 Y0 Z50\nM8\nNOT_THERE\nG0 X900\nM30\n");
    QCOMPARE(found(all), QStringLiteral("not-checked 3"));
    QVERIFY(requireNoHazard(planOf("G0 X1\n"), all));
  }

  /// Programs of other dialects: the line is that of the source.
  void translated() {
    const job::Plan plan = planOf("G21 G90\nT12 M6\nG54\nG43 H1\nG0 X0 Y0 Z50\nG1 X500 F500\nM30\n",
                                  gcode::Dialect::Iso);
    QCOMPARE(found(experiments::hazardsOf(plan, mill(), {mill().start()})),
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
          requireNoHazard(plan, experiments::hazardsOf(plan, mill(), {mill().start()})).has_value();
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
};

RIVULET_TEST(TestJobForecast)
#include "tst_job_forecast.moc"
