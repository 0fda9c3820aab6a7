// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// G41 and G42: where the centre of the tool goes. All tools here have a radius of 5 mm.

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "machine/machine.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::ChannelStatus;
using machine::Machine;

namespace {

struct Outcome {
  std::string path;  ///< "10,0,0 ..." end points; "~" before the end point of an arc
  int alarm = 0;
  std::vector<base::Vec3> samples;
};

Outcome runProgram(const std::string& text) {
  machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
  config.axes[2].startMm = 0.0;
  config.tools->changeTime = {};
  config.tools->tools = {{1, "MILL", {{0.0, 5.0}}, false}};
  Machine machine(std::move(config), 1);
  const bool ready = machine.storeProgram("T.MPF", "T1 M6 G1 F2000\n" + text + "\nM30\n", true) &&
                     machine.selectProgram("T.MPF") && machine.cycleStart();
  if (!ready) {
    qFatal("the program could not be started");
  }
  for (int i = 0; i < 100000 && machine.state().channel == ChannelStatus::Active; ++i) {
    machine.advance(machine.now() + base::fromMilliseconds(4.0));
  }
  Outcome outcome;
  outcome.alarm = machine.state().alarm;
  base::Vec3 from;
  for (const trace::ExecutedBlock& block : machine.trace().blocks) {
    if (!block.moves()) {
      continue;
    }
    const bool isArc = block.lengthMm > base::distance(from, block.targetMm) + 1e-6;
    outcome.path += (outcome.path.empty() ? "" : " ") + std::string(isArc ? "~" : "");
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      outcome.path += (axis == 0 ? "" : ",") +
                      base::formatNumber(std::round(block.targetMm[axis] * 1e4) / 1e4 + 0.0);
    }
    from = block.targetMm;
  }
  for (const trace::ControlSample& sample : machine.trace().samples) {
    outcome.samples.push_back(sample.commandMm);
  }
  return outcome;
}

}  // namespace

class TestRadiusCompensation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// TOFFL is added to the length of the tool; with its negative length there is none.
  void offsetOfTheLength() {
    // The way is longer than from one programmed place to the next.
    QCOMPARE(QString::fromStdString(runProgram("TOFFL=5\nZ10").path), QStringLiteral("~0,0,10"));
    QCOMPARE(QString::fromStdString(runProgram("TOFFL=5\nR1=$P_TOOLL[1]\nTOFFL=R1-5\nZ10").path),
             QStringLiteral("0,0,10"));
    QCOMPARE(runProgram("TOFFL=OF_NOTHING").alarm, 12550);
  }

  void paths_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("path");
    const auto row = [](const char* what, const char* text, const char* path) {
      QTest::newRow(what) << text << path;
    };
    // Square of 20 mm, counterclockwise: inside with G41, outside with G42.
    row("inner corners", "G41 X10 Y0\nX30\nY20\nX10\nG40 X0",
        "10,5,0 25,5,0 25,15,0 10,15,0 0,20,0");
    row("outer corners with circles", "G42 X10 Y0\nX30\nY20\nX10\nG40 X0",
        "10,-5,0 30,-5,0 ~35,0,0 35,20,0 ~30,25,0 10,25,0 0,20,0");
    row("outer corners with intersections", "G451 G42 X10 Y0\nX30\nY20\nX10\nG40 X0",
        "10,-5,0 35,-5,0 35,25,0 10,25,0 0,20,0");
    row("acute corners get a circle", "G451 G42 X10 Y0\nX30\nX10 Y5\nG40 X0",
        "10,-5,0 30,-5,0 ~31.2127,4.8507,0 11.2127,9.8507,0 0,5,0");
    row("straight on", "G41 X10 Y0\nX20\nX30\nG40 X40", "10,5,0 20,5,0 30,5,0 40,0,0");
    row("back on the same way", "G41 X10 Y0\nX20\nX10\nG40 X0",
        "10,5,0 20,5,0 ~20,-5,0 10,-5,0 0,0,0");
    // Arcs: the tool inside a circle of 20 mm, and around one.
    row("arc, inside", "G41 X20 Y0\nG3 X0 Y20 CR=20\nG1 G40 X0 Y0", "15,0,0 ~0,15,0 0,0,0");
    row("arc, outside", "G42 X20 Y0\nG3 X0 Y20 CR=20\nG1 G40 X0 Y40", "25,0,0 ~0,25,0 0,40,0");
    row("full circle", "G41 X20 Y0\nG3 I-20\nG1 G40 X0", "15,0,0 ~15,0,0 0,0,0");
    row("arc of the tool's radius", "G41 X10 Y0\nX20\nG3 X25 Y5 CR=5\nG1 Y20\nG40 X30",
        "10,5,0 20,5,0 20,20,0 30,20,0");
    row("rounded tangent", "G41 X10 Y0\nX20\nG3 X24.995 Y4.96 CR=5\nG1 Y20\nG40 X30",
        "10,5,0 20,5,0 19.9952,5,0 19.995,4.96,0 19.995,20,0 30,20,0");
    row("line into arc, inner", "G41 X-20 Y5\nX0 Y5\nG3 X20 Y25 I0 J20\nG40 G1 X20 Y30",
        "-20,10,0 0,10,0 ~15,25,0 20,30,0");
    row("inner corner at an arc", "G41 X-20 Y0\nX0\nG2 X20 Y-20 I20\nG40 G1 X30",
        "-20,5,0 -4.4949,5,0 ~20,-25,0 30,-20,0");
    row("outer corner, arc inside", "G42 X-20 Y0\nX0\nG2 X20 Y-20 I20\nG40 G1 X30",
        "-20,-5,0 0,-5,0 ~5,0,0 ~20,-15,0 30,-20,0");
    row("outer corner at an arc", "G41 X-20 Y0\nX0\nG2 X20 Y-20 I0 J-20\nG40 G1 X30",
        "-20,5,0 0,5,0 ~25,-20,0 30,-20,0");
    row("outer corner at an arc, intersection",
        "G451 G42 X-20 Y0\nX0\nG3 X-20 Y20 I-20\nG40 G1 X-30",
        "-20,-5,0 0,-5,0 5,-5,0 5,0,0 ~-20,25,0 -30,20,0");
    // Along the tool the path is as programmed, where the tool is.
    row("infeed between", "G41 X10 Y0\nZ-2\nX30\nZ-4\nY20\nG40 X0",
        "10,5,0 10,5,-2 25,5,-2 25,5,-4 25,20,-4 0,20,-4");
    row("another plane", "G18\nG41 X0 Z10\nX30\nG40 X40", "0,0,5 30,0,5 40,0,10");
    row("offset", "G55\nZ200 G41 X10 Y0\nX30\nG40 X40", "10,5,200 30,5,200 40,0,200");
    row("mirrored", "MIRROR X0\nG41 X10 Y0\nX30\nG40 X40", "-10,5,0 -30,5,0 -40,0,0");
    row("mirrored along the tool", "MIRROR Z0\nG41 X10 Y0\nX30\nG40 X40", "10,5,0 30,5,0 40,0,0");
    row("turned", "ROT RPL=90\nG41 X10 Y0\nX30\nG40 X40", "-5,10,0 -5,30,0 0,40,0");
    row("ends at a stop of the pre-run", "G41 X10 Y0\nX30\nSTOPRE\nX40\nG40 X50",
        "10,5,0 30,5,0 40,5,0 50,0,0");
    row("ends with the program", "G41 X10 Y0\nX30", "10,5,0 30,5,0");
    row("KONT before the contour", "KONT G41 X10 Y0\nX30\nG40 X40", "10,5,0 30,5,0 40,0,0");
    row("no radius", "D0 X10\nX30", "10,0,0 30,0,0");
  }
  void paths() {
    QFETCH(QString, text);
    QFETCH(QString, path);
    const Outcome outcome = runProgram(text.toStdString());
    QCOMPARE(outcome.alarm, 0);
    QCOMPARE(QString::fromStdString(outcome.path), path);
  }

  void alarms_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("alarm");
    QTest::newRow("no edge") << "D0 G41 X10" << 10750;
    QTest::newRow("no tool") << "T0 M6\nG41 X10" << 10750;
    QTest::newRow("selected in an arc") << "G41 G2 X10 Y10 CR=10" << 10753;
    QTest::newRow("deselected in an arc") << "G41 X10\nX20\nG40 G2 X30 Y10 CR=10" << 10754;
    QTest::newRow("arc too small") << "G41 X10 Y0\nX20\nG3 X20 Y6 CR=3\nX0" << 10751;
    QTest::newRow("gap too narrow") << "G41 X10 Y0\nX20\nY6\nX0\nG40 Y20" << 10751;
    QTest::newRow("tilted") << "ROT X30\nG41 X10" << 12550;
    QTest::newRow("plane changed") << "G41 X10\nX20\nG18 Z10" << 10757;
    QTest::newRow("KONT around the start") << "KONT G41 X10\nX-10\nG40 X-20" << 12550;
    QTest::newRow("KONT around the end") << "KONT G41 X10\nX20\nG40 X0" << 12550;
    QTest::newRow("cycle") << "G41 X10\nX20\nCYCLE81(20,0,2,-5)" << 61815;
  }
  void alarms() {
    QFETCH(QString, text);
    QFETCH(int, alarm);
    QCOMPARE(runProgram(text.toStdString()).alarm, alarm);
  }

  /// Around a contour of lines and arcs the centre is never nearer than the radius.
  void keepsItsDistance() {
    for (const char* corners : {"G450", "G451"}) {
      const Outcome outcome = runProgram(std::string(corners) +
                                         "\nG0 X-20 Y-20\nG1 G41 X0 Y-10\nY10\nX15 Y30\n"
                                         "G2 X35 Y10 I0 J-20\nG1 X40 Y0\nX20 Y-5\nX0 Y0\n"
                                         "G40 X-20 Y-20");
      QCOMPARE(outcome.alarm, 0);
      double nearest = 1e9;
      const std::vector<base::Vec3> contour{{0, 0, 0},  {0, 10, 0},  {15, 30, 0}, {35, 10, 0},
                                            {40, 0, 0}, {20, -5, 0}, {0, 0, 0}};
      const auto begin = std::find_if(outcome.samples.begin(), outcome.samples.end(),
                                      [](base::Vec3 sample) { return sample.x < -19.0; });
      for (auto at = begin; at != outcome.samples.end(); ++at) {
        const base::Vec3 sample = *at;
        for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
          const bool isArc = i == 2;
          const base::Vec3 centre{15, 10, 0};
          const bool beside = isArc && sample.x >= 15.0 && sample.y >= 10.0;
          const double distance =
              isArc ? (beside ? std::abs(base::distance(sample, centre) - 20.0) : 1e9)
                    : base::distanceToSegment(sample, contour[i], contour[i + 1]);
          nearest = std::min(nearest, distance);
        }
      }
      QVERIFY2(nearest > 5.0 - 0.011 && nearest < 5.001, std::to_string(nearest).c_str());
    }
  }

  /// Without compensation the words cost nothing, to the bit.
  void offIsOff() {
    QCOMPARE(runProgram("G40 G450 X10 Y5\nG2 X20 Y-5 CR=10\nG451 X30").path,
             runProgram("X10 Y5\nG2 X20 Y-5 CR=10\nX30").path);
  }
};

RIVULET_TEST(TestRadiusCompensation)
#include "tst_radius_compensation.moc"
