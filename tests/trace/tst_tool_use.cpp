// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Which tool was in the spindle for how long, by the events of the control.

#include <QtTest>
#include <string>
#include <utility>

#include "support/test_program.h"
#include "trace/analysis/tool_use.h"

using namespace rivulet;
using trace::ControlEvent;
using trace::ControlTrace;
using trace::ToolUse;
using Kind = ControlEvent::Kind;

namespace {

base::Instant at(double seconds) {
  return base::Instant{base::fromSeconds(seconds)};
}

ControlEvent made(Kind kind, double fromS, double toS, double value, std::string name = {}) {
  return {at(fromS), at(toS), {1}, kind, value, std::move(name)};
}

}  // namespace

class TestToolUse : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingRecordedIsNothingUsed() {
    ControlTrace trace;
    QVERIFY(trace::toolUses(trace).empty());
    trace.events.push_back(made(Kind::WorkOffset, 0.0, 0.0, 54.0));
    trace.events.push_back(made(Kind::Dwell, 1.0, 3.0, 0.0));
    QVERIFY(trace::toolUses(trace).empty());
  }

  /// Two tools; what stays in force over a change counts for both.
  void timesGoToTheToolInTheSpindle() {
    ControlTrace trace;
    trace.samples.push_back({at(0.0), {}, {}, 0.0, {}, {}, {}});
    trace.samples.push_back({at(60.0), {}, {}, 0.0, {}, {}, {}});
    trace.events = {
        made(Kind::WorkOffset, 1.0, 1.0, 54.0),  made(Kind::ToolChange, 2.0, 8.0, 1.0, "MILL"),
        made(Kind::Spindle, 9.0, 10.0, 3000.0),  made(Kind::Coolant, 10.0, 10.0, 1.0),
        made(Kind::Spindle, 15.0, 15.5, 2000.0), made(Kind::WorkOffset, 20.0, 20.0, 55.0),
        made(Kind::ToolChange, 30.0, 35.0, 2.0), made(Kind::Spindle, 36.0, 37.0, -800.0),
        made(Kind::Coolant, 40.0, 40.0, 0.0),    made(Kind::Spindle, 50.0, 50.0, 0.0)};
    const std::vector<ToolUse> uses = trace::toolUses(trace);
    QCOMPARE(uses.size(), std::size_t{2});
    const ToolUse& mill = uses[0];
    QVERIFY(mill.number == 1 && mill.name == "MILL");
    QCOMPARE(base::toSeconds(mill.change), 6.0);
    QCOMPARE(base::toSeconds(mill.inSpindle), 22.0);
    QCOMPARE(base::toSeconds(mill.turning), 21.0);
    QCOMPARE(base::toSeconds(mill.cooling), 20.0);
    QCOMPARE(mill.perMinLeast, 2000.0);
    QCOMPARE(mill.perMinMost, 3000.0);
    QVERIFY(mill.clockwise && !mill.counterclockwise && mill.flood && !mill.mist);
    QVERIFY((mill.workOffsets == std::vector<int>{54, 55}));
    const ToolUse& second = uses[1];
    QVERIFY(second.number == 2 && second.name.empty());
    QCOMPARE(base::toSeconds(second.change), 5.0);
    QCOMPARE(base::toSeconds(second.inSpindle), 25.0);
    QCOMPARE(base::toSeconds(second.turning), 14.0);
    QCOMPARE(base::toSeconds(second.cooling), 5.0);
    QVERIFY(second.counterclockwise && !second.clockwise && second.flood);
    QVERIFY((second.workOffsets == std::vector<int>{55}));
  }

  /// A tool that was in the spindle already is unknown, but its time is not.
  void whatWasThereBeforeIsKeptApart() {
    ControlTrace trace;
    trace.events = {made(Kind::Spindle, 1.0, 2.0, 500.0), made(Kind::ToolChange, 11.0, 15.0, 7.0)};
    const std::vector<ToolUse> uses = trace::toolUses(trace);
    QCOMPARE(uses.size(), std::size_t{2});
    QVERIFY(!uses[0].number);
    QCOMPARE(base::toSeconds(uses[0].turning), 10.0);
    QVERIFY(uses[1].number == 7);
    QCOMPARE(base::toSeconds(uses[1].inSpindle), 0.0);
  }
};

RIVULET_TEST(TestToolUse)
#include "tst_tool_use.moc"
