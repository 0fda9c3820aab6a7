// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Dry runs of whole jobs: higher, without spindle and coolant, or not at all.

#include <QtTest>

#include "forecast/job_forecast.h"
#include "job/dry_plan.h"
#include "job/main_program.h"
#include "plan_text.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

constexpr double kRaiseMm = 50.0;

/// Streamed and native motion, radius compensation, a drilling cycle, a frame, and two tools.
const char* const kPart =
    "N10 G17 G90 G71 G54\n"
    "T2 M6 D1 S3000 M3\n"
    "G0 X0 Y0\n"
    "G0 Z50 M8\n"
    "G0 Z5\n"
    "G1 Z-2 F2000\n"
    "G41 X20 Y0\n"
    "X60\n"
    "Y40\n"
    "G40 X90 Y60\n"
    "G0 Z50 M9\n"
    "SUPA G0 Z200 D0\n"
    "T7 M6\n"
    "D1\n"
    "S1000 M3 M8\n"
    "G0 X10 Y10\n"
    "G0 Z10\n"
    "MCALL CYCLE81(10,0,2,-5)\n"
    "X10 Y10\n"
    "X30\n"
    "MCALL\n"
    "TRANS X5\n"
    "G0 X1 Y1 Z3 M8\n"
    "TRANS\n"
    "G0 Z60\n"
    "M5 M9\n"
    "M30\n";

job::Plan planOf(const std::string& text, gcode::Dialect dialect = gcode::Dialect::Sinumerik) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  const auto plan = job::makePlan("PART.MPF", text, options);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return *plan;
}

machine::MachineConfig mill(double zMin) {
  machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
  config.axes[2].positionMmMin = zMin;
  config.axes[2].positionMmMax = 2000.0;
  return config;
}

/// Of all motion, streamed and native, machine coordinates, to 1 mm.
double lowestMm(const job::Plan& plan) {
  const auto isBelow = [&plan](double zMin) {
    const machine::MachineConfig config = mill(zMin);
    const auto hazards = forecast::hazardsOf(plan, config, {config.start()});
    return std::any_of(hazards.begin(), hazards.end(), [](const forecast::Hazard& hazard) {
      return hazard.travel && hazard.travel->axis == 'Z';
    });
  };
  double zMm = -1000.0;
  while (!isBelow(zMm + 1.0)) {
    zMm += 1.0;
  }
  return zMm;
}

class Console final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  bool stopRequested(base::Instant) override { return false; }
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
};

}  // namespace

class TestDryPlan : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Everything takes place higher on the machine, and the spindle stays still.
  void isRaisedAndDry_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("dialect");
    QTest::newRow("SINUMERIK") << QString::fromLatin1(kPart)
                               << static_cast<int>(gcode::Dialect::Sinumerik);
    QTest::newRow("ISO") << QStringLiteral(
                                "G21 G90 G17 G54\nT2 M6\nG43 H2\nS3000 M3\nG0 X0 Y0 Z50 M8\nG1 Z-2 "
                                "F1000\nX30\nG0 Z20\nG98 G81 X10 Y10 Z-5 R2 F200\nX20\nG80\nG0 Z60 "
                                "M9\nM5\nG0 X5\nM30\n")
                         << static_cast<int>(gcode::Dialect::Fanuc);
  }
  void isRaisedAndDry() {
    QFETCH(const QString, text);
    QFETCH(const int, dialect);
    const job::Plan wet = planOf(text.toStdString(), static_cast<gcode::Dialect>(dialect));
    const auto dry = job::dryPlan(wet, kRaiseMm);
    QVERIFY2(dry.has_value(), dry ? "" : dry.error().text().c_str());
    const double lowest = lowestMm(wet);
    QCOMPARE(lowestMm(*dry), lowest + kRaiseMm);
    streaming::RunSettings settings;
    settings.parameters.method = base::MethodKind::Window;
    settings.parameters.pointsPerLoop = 5;
    settings.isCommissioned = true;
    settings.feedMmPerS = 40.0;
    // The machine itself stops with an alarm below that.
    machine::Machine machine(mill(lowest + kRaiseMm - 1.0), 1);
    streaming::SimulatedLink link(machine);
    Console console;
    const auto report = streaming::runWholeJob(link, link, *dry, settings, console, console);
    QVERIFY2(report.outcome == streaming::Outcome::Completed, report.error.text().c_str());
    QVERIFY(report.integrity.isFaultless());
    bool changesTools = false;
    for (const trace::ControlEvent& event : report.controlTrace->events) {
      using Kind = trace::ControlEvent::Kind;
      QVERIFY(event.kind != Kind::Spindle || event.value == 0.0);
      QVERIFY(event.kind != Kind::Coolant || event.value == 0.0);
      changesTools = changesTools || event.kind == Kind::ToolChange;
    }
    QVERIFY(changesTools);
  }

  void wordsAreTakenOut() {
    const auto dry = job::dryPlan(
        planOf(
            "G17 G90\nN20 T1 M06 S=3000 M3 D1\nM8 MSG(\"M8\")\nS500 M4\nG4 S5\nG4 F1\nM0\nM30\n"),
        1.0);
    QVERIFY2(dry.has_value(), dry ? "" : dry.error().text().c_str());
    std::vector<std::string> texts;
    for (const job::Part& part : dry->parts) {
      if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
        texts.push_back(native->text);
      }
    }
    QVERIFY(texts.at(0).find("T1 M06") != std::string::npos);
    QVERIFY(texts.at(0).find("D1") != std::string::npos);
    for (const std::string& text : texts) {
      QVERIFY2(text.find("M3 ") == std::string::npos && text.find("M4") == std::string::npos &&
                   text.find('S') != 0,
               text.c_str());
    }
  }

  void isRefusedWhereItIsNotSafe_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("tapping") << QStringLiteral("G0 X1 Y1 Z9\nCYCLE84(5,0,1,-8,,,3,,1,0,100,200)\n")
                             << 2;
    QTest::newRow("turned") << QStringLiteral("G0 X1 Y1 Z9\nROT Z30\nG0 X5 M8\n") << 3;
    QTest::newRow("swivelled") << QStringLiteral("G0 X1 Y1 Z9\nTRAORI\nG1 X5 F100\nTRAFOOF\n") << 2;
    QTest::newRow("program") << QStringLiteral("G0 X1 Y1 Z9\nL100\n") << 2;
    QTest::newRow("increment") << QStringLiteral("G0 X1 Y1 Z9\nG91 G0 Z-3 M8\n") << 2;
    QTest::newRow("revolution") << QStringLiteral("G0 X1 Y1 Z9\nG95 F0.1 S500 M3\nG1 X5 M8\n") << 2;
  }
  void isRefusedWhereItIsNotSafe() {
    QFETCH(const QString, text);
    QFETCH(const int, line);
    const auto dry = job::dryPlan(
        planOf(("G17 G90\n" + text.section(QLatin1Char('\n'), 0, -1)).toStdString()), kRaiseMm);
    QVERIFY(!dry);
    QVERIFY(dry.error().code == job::JobError::NotDry);
    QVERIFY2(dry.error().context == "PART.MPF:" + std::to_string(line + 1),
             dry.error().text().c_str());
    QVERIFY(!job::dryPlan(planOf("G0 X1\n"), 0.0));
  }
};

RIVULET_TEST(TestDryPlan)
#include "tst_dry_plan.moc"
