// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A motion that leaves the travel is seen before it starts.

#include <QtTest>
#include <vector>

#include "forecast/motion_travel.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

machine::MachineConfig mill() {
  return *machine::loadPreset("dmu75-mill");
}

gcode::StreamPoint pointAt(base::Vec3 mm, std::uint32_t line) {
  gcode::StreamPoint point;
  point.positionMm = mm;
  point.line.value = line;
  return point;
}

streaming::EquipmentSeen equipment(const char* offset, int tool, int edge) {
  streaming::EquipmentSeen seen;
  seen.workOffset = offset;
  seen.tool = tool;
  seen.edge = edge;
  return seen;
}

}  // namespace

class TestMotionTravel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The zero is that of work offset and tool length.
  void zeroOfOffsetAndTool() {
    const auto none = forecast::activeZero(mill(), equipment("G500", 0, 0));
    const auto offset = forecast::activeZero(mill(), equipment("G54", 0, 0));
    const auto tool = forecast::activeZero(mill(), equipment("G54", 1, 1));
    QVERIFY(none && offset && tool);
    QVERIFY(*none == base::Vec3{});
    QVERIFY(*offset == (base::Vec3{0.0, 0.0, -200.0}));  // of the preset
    QVERIFY(tool->z > offset->z && tool->x == offset->x);
    // What the control does not say, or the machine does not have, is not guessed.
    QVERIFY(!forecast::activeZero(mill(), {}));
    QVERIFY(!forecast::activeZero(mill(), equipment("G54", 99, 1)));
    QVERIFY(!forecast::activeZero(mill(), equipment("G54", 0, 1)));
  }

  void leavesTheTravel() {
    const machine::MachineConfig machine = mill();
    const base::Vec3 zeroMm{10.0, 20.0, 30.0};
    const double mostX = machine.axes[0].positionMmMax - zeroMm.x;
    const std::vector<gcode::StreamPoint> within{pointAt({0.0, 0.0, 0.0}, 1),
                                                 pointAt({mostX, 0.0, 0.0}, 2)};
    QVERIFY(forecast::requireWithinTravel(within, machine, zeroMm));
    std::vector<gcode::StreamPoint> beyond = within;
    beyond.push_back(pointAt({mostX + 0.5, 0.0, 0.0}, 3));
    beyond.push_back(pointAt({mostX + 7.5, 0.0, 0.0}, 4));
    const auto refused = forecast::requireWithinTravel(beyond, machine, zeroMm);
    QVERIFY(!refused);
    const std::string text = refused.error().text();
    QVERIFY2(text.find("Line 4") != std::string::npos &&
                 text.find("7.500 mm beyond") != std::string::npos,
             text.c_str());
    QVERIFY(forecast::requireWithinTravel({}, machine, zeroMm));
  }

  /// Where the workpiece lies is not known: only what no place would help is refused.
  void longerThanTheTravel() {
    const machine::MachineConfig machine = mill();
    const double travelMm = machine.axes[1].positionMmMax - machine.axes[1].positionMmMin;
    const std::vector<gcode::StreamPoint> fits{pointAt({0.0, -1000.0, 0.0}, 1),
                                               pointAt({0.0, travelMm - 1000.0, 0.0}, 2)};
    QVERIFY(forecast::requireWithinTravel(fits, machine, {}));
    const std::vector<gcode::StreamPoint> longer{pointAt({0.0, 0.0, 0.0}, 1),
                                                 pointAt({0.0, travelMm + 0.1, 0.0}, 2)};
    QVERIFY(!forecast::requireWithinTravel(longer, machine, {}));
  }
};

RIVULET_TEST(TestMotionTravel)
#include "tst_motion_travel.moc"
