// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Tool, spindle and coolant as read from a control: what it does not serve stays unknown.

#include <QtTest>
#include <algorithm>
#include <vector>

#include "machine/config.h"
#include "machine/machine.h"
#include "opcua/await.h"
#include "opcua/error.h"
#include "streaming/run/equipment_watch.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::Reading;
using opcua::SpindleTurn;
using opcua::VariableKind;
using streaming::EquipmentSeen;
using streaming::EquipmentWatch;

namespace {

constexpr base::Duration kDeadline = std::chrono::seconds{2};

const Reading kMissing{opcua::LinkError::VariableMissing, 0.0, {}};

/// Answers of a control to all variables; the named kinds are not served.
std::vector<Reading> answers(const EquipmentWatch& watch, double turn, double flood,
                             const std::vector<VariableKind>& missing = {}) {
  std::vector<Reading> readings;
  for (const opcua::Variable& variable : watch.variables()) {
    Reading reading;
    if (std::find(missing.begin(), missing.end(), variable.kind) != missing.end()) {
      reading = kMissing;
    } else if (variable.kind == VariableKind::ToolName) {
      reading.text = "MILL";
    } else if (variable.kind == VariableKind::GFunction) {
      reading.text = "G55";
    } else if (variable.kind == VariableKind::SpindleTurn) {
      reading.number = turn;
    } else if (variable.kind == VariableKind::MFunction) {
      reading.number = variable.index == opcua::kFloodGroup ? flood : -1.0;
    } else {
      reading.number = 2.0;
    }
    readings.push_back(reading);
  }
  return readings;
}

}  // namespace

class TestEquipmentWatch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsServedIsKnown() {
    EquipmentWatch watch;
    const EquipmentSeen seen = watch.take(answers(watch, 1.0, 8.0));
    QVERIFY(seen == (EquipmentSeen{2, "MILL", 2, "G55", 2.0, 2.0, SpindleTurn::Counterclockwise,
                                   true, false}));
    QCOMPARE(watch.variables().size(), std::size_t{9});
  }

  void whatIsNotServedIsUnknownAndNotAskedAgain() {
    EquipmentWatch watch;
    const EquipmentSeen seen =
        watch.take(answers(watch, 0.0, 9.0, {VariableKind::ToolName, VariableKind::MFunction}));
    QVERIFY(!seen.toolName && !seen.flood && !seen.mist);
    QCOMPARE(*seen.tool, 2);
    QCOMPARE(watch.variables().size(), std::size_t{6});
    QVERIFY(!watch.take(answers(watch, 0.0, 9.0)).toolName);
  }

  /// A variable that fails once is read again; other M functions than those of the coolant, and a
  /// direction that the speed contradicts, are not interpreted.
  void whatIsDoubtfulIsUnknown() {
    EquipmentWatch watch;
    std::vector<Reading> readings = answers(watch, 2.0, 33.0);
    readings[0].status = opcua::LinkError::Rejected;
    const EquipmentSeen seen = watch.take(readings);
    QVERIFY(!seen.tool);
    QVERIFY(!seen.turn);
    QVERIFY(!seen.flood);
    QCOMPARE(watch.variables().size(), std::size_t{9});
    QVERIFY(!watch.take(answers(watch, 7.0, 9.0)).turn);
  }

  void aMachineWithoutToolsServesNone() {
    machine::Machine machine(machine::loadPreset("dmu75").value(), 1);
    streaming::SimulatedLink link(machine);
    EquipmentWatch watch;
    const auto readings = opcua::readNow(link, watch.variables(), kDeadline);
    QVERIFY(readings.has_value());
    const EquipmentSeen seen = watch.take(*readings);
    QVERIFY(seen == (EquipmentSeen{{}, {}, {}, "G500", {}, {}, {}, {}, {}}));
    QCOMPARE(watch.variables().size(), std::size_t{1});
  }

  void aMachineServesWhatItDoes() {
    machine::Machine machine(machine::loadPreset("dmu75-mill").value(), 1);
    streaming::SimulatedLink link(machine);
    QVERIFY(link.uploadProgram("A.MPF", "T1 M6 D1\nG54\nS600 M4 M8\nG4 F20\nM30\n", true));
    QVERIFY(link.selectProgram("A.MPF"));
    QVERIFY(link.cycleStart());
    QVERIFY(opcua::sleepUntil(link, link.now() + std::chrono::seconds{15}));
    EquipmentWatch watch;
    const auto readings = opcua::readNow(link, watch.variables(), kDeadline);
    QVERIFY(readings.has_value());
    const EquipmentSeen seen = watch.take(*readings);
    QCOMPARE(*seen.tool, 1);
    QCOMPARE(*seen.edge, 1);
    QCOMPARE(QString::fromStdString(*seen.workOffset), QStringLiteral("G54"));
    QCOMPARE(*seen.spindlePerMin, 600.0);
    QCOMPARE(*seen.spindleSetPerMin, 600.0);
    QVERIFY(seen.turn == SpindleTurn::Counterclockwise);
    QVERIFY(*seen.flood && !*seen.mist);
  }
};

RIVULET_TEST(TestEquipmentWatch)
#include "tst_equipment_watch.moc"
