// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole programs of a TNC as jobs of a SINUMERIK. The cuts are worked out by hand from the TNC 640
// User's Manuals; ellipse, steps, rows, contour and spiral follow tasks of their chapters
// "Programming examples".

#include <QFile>
#include <QFileInfo>
#include <QtTest>
#include <cmath>
#include <string>
#include <vector>

#include "base/text.h"
#include "base/units.h"
#include "gcode/block_observer.h"
#include "gcode/feeds.h"
#include "gcode/program.h"
#include "job/plan.h"
#include "streaming/control/control_axes.h"
#include "streaming/simulation/fitted_machine.h"
#include "streaming/simulation/job_proof.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

const QString kFolder = QStringLiteral(RIVULET_SOURCE_DIR "/tests/job/heidenhain/");

job::Plan planOf(const QString& name) {
  const std::string path = (kFolder + name).toStdString();
  QFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::ReadOnly)) {
    qFatal("%s is missing", path.c_str());
  }
  gcode::LoadOptions options;
  options.subprogram = gcode::subprogramsBeside(path);
  options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
  options.toolRadiusMm = streaming::toolRadii(machine::loadPreset("dmu75-mill")->tools, false);
  options.keepArcs = true;
  const auto plan = job::makePlan(name.toStdString(), file.readAll().toStdString(), options);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return *plan;
}

/// "X1 Y2 Z3 F100" of each point that is reached with a feed.
QStringList cutsOf(const gcode::Trajectory& trajectory) {
  QStringList cuts;
  for (const gcode::TrajectoryPoint& point : trajectory.points) {
    if (point.kind == gcode::MoveKind::Rapid) {
      continue;
    }
    std::string text;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      text += std::string(1, base::kAxisNames[axis]) +
              base::formatFixed(point.positionMm[axis], 6) + " ";
    }
    text += "F" + base::formatFixed(base::mmPerMinFromMmPerS(point.feedMmPerS), 6);
    cuts.push_back(QString::fromStdString(text));
  }
  return cuts;
}

}  // namespace

class TestHeidenhainJobs : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void programs_data() {
    QTest::addColumn<int>("cuts");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("last");
    // As many cuts as there are (-1: not counted), the first and the last; empty: not compared.
    const auto add = [](const char* name, int cuts, const char* first, const char* last) {
      QTest::newRow(name) << cuts << QString::fromLatin1(first) << QString::fromLatin1(last);
    };
    add("flange.H", 24, "X30 Y0 Z-2 F150", "X15 Y-25.980762 Z-18 F200");
    add("contour.H", 9, "X-10 Y-10 Z-5 F1000", "X5 Y5 Z-5 F500");
    add("compensated.H", 1, "X-30 Y50 Z-5 F1000", "X-30 Y50 Z-5 F1000");
    add("ellipse.H", 9, "X93.30127 Y75 Z-5 F100", "X93.30127 Y75 Z-5 F350");
    add("rows.H", 24, "X15 Y10 Z-5 F250", "X75 Y30 Z-10 F250");
    add("steps.H", 25, "X-20 Y30 Z-4 F2000", "X-20 Y30 Z-20 F2000");
    add("spiral.H", 4, "X50 Y50 Z-12.75 F1000", "X30 Y50 Z0.75 F200");
    add("mirrored.H", 15, "X10 Y0 Z-2 F300", "X105 Y10 Z-1 F300");
    add("old.H", 6, "X20 Y20 Z-15 F120", "X35 Y20 Z-40 F120");
    add("deep.H", 14, "X10 Y10 Z-7 F200", "X70 Y10 Z7 F250");
    add("plate.H", 10, "X10 Y10 Z-8 F150", "X50 Y80 Z-11 F150");
    add("inch.H", 6, "X0 Y0 Z-2.54 F127", "X0 Y0 Z-2.54 F254");
    add("choices.H", 1, "X7.071068 Y7.071068 Z16.2 F300", "X7.071068 Y7.071068 Z16.2 F300");
    add("milled.H", -1, "X50 Y50 Z0 F200", "");
    add("bored.H", 0, "", "");
    add("main.H", 18, "X-20 Y-10 Z-3 F400", "X40 Y-10 Z-3 F400");
  }
  void programs() {
    QFETCH(const int, cuts);
    QFETCH(const QString, first);
    QFETCH(const QString, last);
    job::Plan plan = planOf(QString::fromLatin1(QTest::currentDataTag()));
    for (const job::Refusal& each : plan.refusals) {
      QFAIL(job::describe(each).c_str());
    }
    for (const gcode::Diagnostic& each : plan.program.diagnostics) {
      QVERIFY2(each.severity != gcode::Severity::Error, gcode::describe(each).c_str());
    }
    const QStringList found = cutsOf(plan.program.trajectory);
    if (cuts >= 0) {
      QCOMPARE(found.size(), cuts);
    }
    if (!first.isEmpty()) {
      QCOMPARE(found.front(), first);
    }
    if (!last.isEmpty()) {
      QCOMPARE(found.back(), last);
    }

    const streaming::FittedMachine machine =
        streaming::fitMachine(*machine::loadPreset("dmu75-mill"), plan);
    streaming::RunSettings settings;
    settings.parameters.method = base::MethodKind::Window;
    settings.parameters.pointsPerLoop = 7;
    settings.parameters = streaming::withTurnedAxes(settings.parameters, plan.program.trajectory);
    settings.parameters.feedPerPoint = true;
    settings.isCommissioned = true;
    settings.programFeeds = gcode::ProgramFeeds{};
    settings.programFeeds->rapidMmPerS = machine.config.rapidMmPerS;
    settings.programFeeds->feedMmPerSMax = machine.config.feedMmPerSMax();
    settings.feedMmPerS = machine.config.feedMmPerSMax();
    const auto proof = streaming::proveJob(plan, machine.config, settings);
    QVERIFY2(proof.has_value(), proof ? "" : proof.error().text().c_str());
    QVERIFY2(proof->difference.empty(), proof->difference.c_str());
  }

  /// What the control gets of the tapped holes: where the thread begins and ends, its pitch.
  void tapping() {
    const job::Plan plan = planOf(QStringLiteral("flange.H"));
    int taps = 0;
    for (const job::Part& part : plan.parts) {
      const auto* const native = std::get_if<job::NativeBlock>(&part);
      if (native != nullptr && native->text.find("CYCLE84") != std::string::npos) {
        ++taps;
        QVERIFY2(native->text.find("CYCLE84(2,2,0,-15,,0,3,,1,,400,400)") != std::string::npos,
                 native->text.c_str());
      }
    }
    QCOMPARE(taps, 6);
  }

  /// Native blocks of one kind, line by line.
  static QString linesOf(const job::Plan& plan, job::NativeReason reason) {
    QStringList lines;
    for (const job::Part& part : plan.parts) {
      const auto* const native = std::get_if<job::NativeBlock>(&part);
      if (native != nullptr && native->reason == reason && !native->text.empty()) {
        lines += QString::fromStdString(native->text).split(QLatin1Char('\n'));
      }
    }
    return lines.join(QStringLiteral(" | "));
  }
  /// 202 leaves the wall with the spindle at its angle; 209 breaks the chip; DR is an allowance.
  void boring() {
    const job::Plan plan = planOf(QStringLiteral("bored.H"));
    QCOMPARE(
        linesOf(plan, job::NativeReason::Cycle),
        QStringLiteral("G1 Z-15 F60 | G4 F0.5 | SPOS=30 | G0 Y20.2 | G1 Z2 F120 | G0 Y20 | M3 | "
                       "CYCLE84(3,3,0,-18,,0,3,,1.5,,200,200,,,,1,5,1.5)"));
    QVERIFY(linesOf(plan, job::NativeReason::RadiusCompensation)
                .startsWith(QStringLiteral("G41 OFFN=0.2 | ")));
  }
  /// The pocket and the bores about its middle reach their depth, beside walls that the radius of
  /// the tool leaves.
  void milling() {
    const job::Plan plan = planOf(QStringLiteral("milled.H"));
    double deepest = 0.0;
    double farthest = 0.0;
    for (const gcode::TrajectoryPoint& point : plan.program.trajectory.points) {
      deepest = std::min(deepest, point.positionMm.z);
      if (point.positionMm.z < -1e-9 && point.positionMm.z > -8.0 - 1e-9) {
        const base::Vec3 from = point.positionMm - base::Vec3{50, 50, 0};
        const double angle = 15.0 / 180.0 * std::acos(-1.0);
        farthest = std::max(farthest, from.x * std::cos(angle) + from.y * std::sin(angle));
      }
    }
    QCOMPARE(deepest, -20.0);
    QVERIFY(std::abs(farthest - (30.0 - 5.05)) < 1e-9);
  }

  /// TOOL CALL changes the tool, whether it is named by number or by name.
  void namedTool() {
    const job::Plan plan = planOf(QStringLiteral("choices.H"));
    QStringList tools;
    for (const job::Part& part : plan.parts) {
      const auto* const native = std::get_if<job::NativeBlock>(&part);
      if (native != nullptr && native->reason == job::NativeReason::Tool) {
        tools.push_back(QString::fromStdString(native->text));
      }
    }
    QCOMPARE(tools, QStringList{QStringLiteral("T=\"MILL_63\" M6 S900")});
  }

  /// The control gets the whole compensated contour, with its way on and off.
  void compensation() {
    const job::Plan plan = planOf(QStringLiteral("compensated.H"));
    QStringList lines;
    for (const job::Part& part : plan.parts) {
      const auto* const native = std::get_if<job::NativeBlock>(&part);
      if (native != nullptr && native->reason == job::NativeReason::RadiusCompensation) {
        lines += QString::fromStdString(native->text).split(QLatin1Char('\n'));
      }
    }
    QCOMPARE(lines.join(QStringLiteral(" | ")),
             QStringLiteral("G41 | G1 X5 Y35 F1000 | G1 Y50 F300 | G1 Y95 F300 | G1 X95 F300 | "
                            "G1 Y5 F300 | G1 X5 F300 | G1 Y50 F300 | G1 Y70 F1000 | G40 | G40 | "
                            "G0 X-30 Y80"));
  }
};

RIVULET_TEST(TestHeidenhainJobs)
#include "tst_heidenhain_jobs.moc"
