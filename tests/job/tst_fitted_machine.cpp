// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "streaming/simulation/fitted_machine.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

streaming::FittedMachine fitted(const char* text) {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
  const auto plan = job::makePlan("PART.MPF", text, options);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *plan);
}

}  // namespace

class TestFittedMachine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void leavesWhatFits() {
    const auto made = fitted("G54\nT3 D2 M6\nG0 X1 Y1 Z10\nG1 Z-5 F100\nM30\n");
    QCOMPARE(QString::fromStdString(made.notes.empty() ? "" : made.notes.front()), QString());
    QCOMPARE(made.config.workOffsetMm(540).z, -200.0);
    QCOMPARE(made.config.tools->tools.size(), std::size_t{10});
  }

  void loadsTools() {
    const auto made = fitted("T3 M6\nD4\nT42 M6\nT=\"SPECIAL\" M6\nG0 X1 Y1 Z10\nM30\n");
    QVERIFY(made.config.tools->find(42)->hasEdge(4));
    QVERIFY(made.config.tools->find("SPECIAL")->hasEdge(1));
    QCOMPARE(made.notes.size(), std::size_t{2});
    QVERIFY(made.notes[0].find("SPECIAL, T42") != std::string::npos);
    QVERIFY(made.config.tools->find(3)->hasEdge(4));
    QCOMPARE(made.config.tools->find(3)->edges[3].lengthMm, 102.5);
  }

  /// G92 says where the operator has brought the tool.
  void bringsTheToolToItsStart() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::LinuxCnc;
    const auto plan = job::makePlan("A.NGC", "G92 Y8\nS500 M3\nG0 X1 Z2\nM2\n", options);
    QVERIFY(plan.has_value());
    const auto made = streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *plan);
    QCOMPARE(made.config.axes[1].startMm,
             8.0 + made.config.workOffsetMm(machine::kNoWorkOffsetKey).y);
  }

  /// Of the feed that a program does not name, a rapid needs none.
  void namesNoRapidForItsFeed() {
    const auto notesOf = [](const char* text) {
      QString all;
      for (const std::string& note : fitted(text).notes) {
        all += QString::fromStdString(note) + QLatin1Char('\n');
      }
      return all;
    };
    QVERIFY(!notesOf("G0 SUPA Z100 D0\nG0 X1 Y1 Z10\nG1 Z5 F100\nM30\n").contains("before any F"));
    QVERIFY(notesOf("G0 X1 Y1 Z10\nG1 SUPA Z100 D0\nM30\n").contains("Line 2 comes before any F"));
    QVERIFY(notesOf("G0 X1 Y1 Z10\nG1 Z5\nM30\n").contains("Line 2 comes before any F"));
  }

  /// H of a tool that the program does not call: it is in the spindle.
  void hasTheAssumedTool() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    job::Profile profile;
    profile.assumesTool = true;
    const auto plan = job::makePlan("A.NC", "G43 H3 Z5.\nM30\n", options, profile);
    QVERIFY(plan.has_value());
    const auto made = streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *plan);
    QCOMPARE(made.config.tools->inSpindle.number, 3);
    QVERIFY(made.notes.front().find("H3") != std::string::npos);
    const auto other = job::makePlan("A.NC", "T2 M6\nG43 H3 Z5.\nM30\n", options, profile);
    QVERIFY(other.has_value());
    const auto notes = streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *other).notes;
    QVERIFY(notes.front().find("Line 2 has H3 (T2)") == 0);
  }

  /// Where the program does not fit, the workpiece lies in the middle; the rest stays.
  void placesTheWorkpiece() {
    const auto made = fitted("G54\nG0 X900 Y1 Z10\nG1 X1000 F100\nM30\n");
    QCOMPARE(made.notes.size(), std::size_t{1});
    QCOMPARE(made.config.workOffsetMm(540).x, -950.0);
    QCOMPARE(made.config.workOffsetMm(540).z, -200.0);
    // Native motion counts as well.
    const auto native = fitted("G0 X0 Y0 Z10\nG41 G1 X600 F100\nG40 X700\nM30\n");
    QCOMPARE(native.config.workOffsetMm(540).x, -350.0);
  }

  void doesNotStretchTheTravel() {
    const auto made = fitted("G0 X0 Y0 Z10\nX2000\nM30\n");
    QVERIFY(made.notes.empty());
    QCOMPARE(made.config.axes[0].positionMmMax, 375.0);
  }

  /// An axis that is placed once is not streamed, so it stands there from the beginning.
  void rotaryAxesStandWhereTheyArePlaced() {
    const auto made = fitted("G0 X0 Y0 Z10 C4\nG1 X5 F100\nC4\nM30\n");
    const auto axis = made.config.rotaryAxes[2];
    QVERIFY(axis.has_value());
    QCOMPARE(axis->startDeg, 4.0);
    QVERIFY(made.notes.front().find("C stands at 4 degrees") != std::string::npos);
    const auto turned = fitted("G0 X0 Y0 Z10 C4\nG1 X5 F100\nC5\nM30\n");
    QVERIFY(turned.config.rotaryAxes[2].has_value());
    QCOMPARE(turned.config.rotaryAxes[2]->startDeg, 0.0);
  }

  void hasAFeedBeforeAnyF() {
    const auto made = fitted("G0 X0 Y0 Z10\nG1 X5\nM30\n");
    QCOMPARE(made.notes.size(), std::size_t{1});
    QVERIFY(made.notes.front().find("Line 2") == 0);
    QCOMPARE(made.config.defaultFeedMmPerS, streaming::kFittedFeedMmPerS);
    QCOMPARE(fitted("G0 X0 Y0 Z10\nG1 X5 F100\nM30\n").config.defaultFeedMmPerS, 0.0);
  }

  void addsRotaryAxes() {
    const auto made = fitted("G0 X0 Y0 Z10 A0 B0\nG1 A300 B10 F100\nM30\n");
    QVERIFY(made.config.rotaryAxes[1].has_value());
    QCOMPARE(made.config.rotaryAxes[0]->positionDegMax, 36000.0);
    QCOMPARE(made.notes.size(), std::size_t{2});
  }
};

RIVULET_TEST(TestFittedMachine)
#include "tst_fitted_machine.moc"
