// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <memory>
#include <vector>

#include "base/units.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "opcua/machinery.h"
#include "support/test_program.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/connection/machine_button.h"
#include "widgets/connection/position_line.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

bool isStruck(const QWidget& widget) {
  const auto labels = widget.findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(), [&widget](const QLabel* label) {
    return label->isVisibleTo(&widget) && label->font().strikeOut();
  });
}

/// The tool tip of the readout that shows a text; empty: none does.
QString hintOf(const QWidget& widget, const QString& shown) {
  const auto labels = widget.findChildren<QLabel*>();
  const auto found = std::find_if(labels.begin(), labels.end(),
                                  [&](const QLabel* label) { return label->text() == shown; });
  return found == labels.end() ? QString() : (*found)->parentWidget()->toolTip();
}

}  // namespace

class TestConnectionPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void asksToConnectAndDisconnect() {
    test::Language language;
    ConnectionPanel panel;
    QSignalSpy connects(&panel, &ConnectionPanel::connectRequested);
    QSignalSpy disconnects(&panel, &ConnectionPanel::disconnectRequested);
    panel.setEndpoint("  opc.tcp://192.168.214.241:4840 ");
    auto* button = panel.findChild<QPushButton*>();
    QVERIFY(button->minimumHeight() >= kTouchHeightPx);
    button->click();
    QCOMPARE(connects.count(), 1);
    QCOMPARE(connects.first().first().toString(), QString("opc.tcp://192.168.214.241:4840"));
    panel.setConnectionState(ConnectionState::Connected);
    QCOMPARE(button->text(), QString("Disconnect"));
    QVERIFY(!panel.findChild<QLineEdit*>()->isEnabled());
    button->click();
    QCOMPARE(disconnects.count(), 1);
    panel.setDisconnectEnabled(false);
    QVERIFY(!button->isEnabled());
    panel.setConnectionState(ConnectionState::Lost, "no answer");
    QVERIFY(button->isEnabled());
    QVERIFY(test::visibleText(panel).contains("Connection lost: no answer"));
    panel.setEndpoint("");
    QVERIFY(!button->isEnabled());
  }

  void showsTheMachine() {
    test::Language language;
    ConnectionPanel panel;
    panel.setConnectionState(ConnectionState::Connected);
    panel.setMachineState(test::runningMachine());
    const QString text = test::visibleText(panel);
    for (const char* expected :
         {"Active", "Running", "RIVULET_SIGNAL_7.MPF", "None", "Virtual machine"}) {
      QVERIFY2(text.contains(expected), expected);
    }
    QVERIFY(!isStruck(panel));
  }

  void showsWhatTheServerDescribes() {
    test::Language language;
    ConnectionPanel panel;
    panel.setConnectionState(ConnectionState::Connected);
    MachineView machine = test::runningMachine();
    panel.setMachineState(machine);
    QVERIFY(!test::visibleText(panel).contains("Described by the server"));
    opcua::DescribedMachine described;
    described.name = "Mill 7";
    described.manufacturer = "Example Machines";
    described.state = "Executing";
    described.operationMode = "Processing";
    described.job = "Order 12";
    described.runsCompleted = 3;
    described.runsPlanned = 8;
    machine.described = std::make_shared<const std::vector<opcua::DescribedMachine>>(1, described);
    machine.describedAgeS = 1.0;
    panel.setMachineState(machine);
    const QString text = test::visibleText(panel);
    for (const char* expected : {"Described by the server", "Mill 7", "Example Machines",
                                 "Executing, Processing", "Order 12, 3 of 8 runs"}) {
      QVERIFY2(text.contains(expected), expected);
    }
    QVERIFY(!text.contains("Serial number"));
    for (const bool isGerman : {false, true}) {
      if (isGerman) {
        language.german();
      }
      test::keep(test::picture(panel, {360, 760}),
                 QString("described_machine_%1").arg(isGerman ? "de" : "en"));
      const auto* box = panel.findChild<QWidget*>("describedMachine");
      QCOMPARE(test::cutTexts(*box), QStringList());
    }
    language.english();
    QVERIFY(!isStruck(panel));
    machine.describedAgeS = 20.0;
    panel.setMachineState(machine);
    QVERIFY(isStruck(panel));
    panel.setConnectionState(ConnectionState::Lost);
    QVERIFY(!test::visibleText(panel).contains("Described by the server"));
  }

  void saysWhatIsNotKnown() {
    test::Language language;
    ConnectionPanel panel;
    panel.setConnectionState(ConnectionState::Connected);
    QVERIFY(!test::visibleText(panel).contains("Virtual machine"));
    MachineView machine = test::runningMachine();
    machine.stateAgeS = 0.6;
    machine.alarmNumber = 10'870;
    machine.alarmText = "No facing axis defined";
    panel.setMachineState(machine);
    QVERIFY(test::visibleText(panel).contains("10870: No facing axis defined"));
    QVERIFY(isStruck(panel));
  }

  /// Live, old, and a point that stands in for the axes.
  void thePositionHasItsAge() {
    test::Language language;
    PositionLine line;
    line.resize(1280, 52);
    QVERIFY(test::visibleText(line).contains("No data"));
    MachineView machine = test::runningMachine();
    line.setMachineState(machine);
    QString text = test::visibleText(line);
    QVERIFY(text.contains("-12.346") && text.contains("105.000") && text.contains("500"));
    QVERIFY(text.contains("Live") && !isStruck(line));
    machine.positionAgeS = 0.51;
    machine.feedAgeS = 0.51;
    line.setMachineState(machine);
    text = test::visibleText(line);
    QVERIFY(!text.contains("Live") && isStruck(line));
    QVERIFY(text.contains(QString("Old: read 0.5") + QChar(0x00A0) + "s ago"));
    machine.executed = MachineView::Executed{437, {1.5, 2.5, -3.25}, 0.1};
    line.setMachineState(machine);
    text = test::visibleText(line);
    QVERIFY(text.contains("-3.250") && !text.contains("-12.346"));
    QVERIFY(text.contains("Last executed point, 437"));
    // A stream that is silent itself stands in for nothing.
    machine.executed->ageS = 0.7;
    line.setMachineState(machine);
    QVERIFY(test::visibleText(line).contains("-12.346") && isStruck(line));
  }

  /// Each has a value, or a dash and a reason; what is to go is as old as the position.
  void toGoAndCommandedFeedAreShown() {
    test::Language language;
    PositionLine line;
    line.resize(1280, 56);
    line.show();
    MachineView machine = test::runningMachine();
    line.setMachineState(machine);
    QCOMPARE(hintOf(line, "to go " + noValue()),
             QString("Distance to go: the control does not report it."));
    QVERIFY(hintOf(line, "set " + noValue()).contains("no run of this window"));
    machine.toGo = MachineView::ToGo{{0.25, -1.5, 0.0}, {}, true};
    machine.feedSetMmPerS = base::mmPerSFromMmPerMin(1200.0);
    line.setMachineState(machine);
    QVERIFY(hintOf(line, "to go -1.500").contains("the path of the program"));
    QVERIFY(hintOf(line, "set 1,200").contains("One feed for all moves"));
    machine.overrideFactor = 0.8;
    line.setMachineState(machine);
    QVERIFY(hintOf(line, QString("set 1,200 · 80") + QChar(0x00A0) + "%")
                .contains("at the control is not read"));
    QVERIFY(!isStruck(line));
    machine.toGo->isComputed = false;
    machine.positionAgeS = 0.6;
    line.setMachineState(machine);
    QVERIFY(hintOf(line, "to go 0.250").contains("as the control reports it"));
    QVERIFY(isStruck(line));
    // What is to go belongs to the axes, not to the point that stands in for them.
    machine.executed = MachineView::Executed{437, {1.5, 2.5, -3.25}, 0.1};
    line.setMachineState(machine);
    QVERIFY(hintOf(line, "to go " + noValue()).contains("no time to read the axes"));
    machine.executed.reset();
    machine.toGo.reset();
    line.setMachineState(machine);
    QVERIFY(hintOf(line, "to go " + noValue()).contains("not on the path"));
  }

  /// Read every 0.9 s, as often as the stream permits: nothing changes with each read.
  void whatIsReadRarelyDoesNotFlicker() {
    test::Language language;
    PositionLine line;
    line.resize(1280, 52);
    MachineView machine = test::runningMachine();
    machine.executed = MachineView::Executed{437, {1.5, 2.5, -3.25}, 0.1};
    machine.isPositionRare = machine.isFeedRare = true;
    for (const double ageS : {0.0, 0.3, 0.51, 0.9, 1.1}) {
      machine.positionAgeS = machine.feedAgeS = ageS;
      line.setMachineState(machine);
      const QString text = test::visibleText(line);
      QVERIFY(text.contains("-12.346") && text.contains("Up to 1 s old") && !isStruck(line));
    }
    // A read that is missing altogether is said.
    machine.positionAgeS = machine.feedAgeS = 1.3;
    line.setMachineState(machine);
    QVERIFY(test::visibleText(line).contains("Last executed point, 437") && isStruck(line));
  }

  /// Nothing is read while a run is prepared, and nothing moves: that is no fault, for a while.
  void silenceIsExpectedWhileARunIsPrepared() {
    test::Language language;
    PositionLine line;
    line.resize(1280, 52);
    MachineButton button;
    button.setConnectionState(ConnectionState::Connected);
    MachineView machine = test::runningMachine();
    const auto show = [&](double ageS) {
      machine.positionAgeS = machine.feedAgeS = machine.stateAgeS = ageS;
      line.setMachineState(machine);
      button.setMachineState(machine);
    };
    show(4.0);
    QVERIFY(isStruck(line) && button.text().contains("silent"));
    machine.isPreparing = true;
    show(4.0);
    QVERIFY(!isStruck(line) && !button.text().contains("silent"));
    QVERIFY(test::visibleText(line).contains("the run is being prepared"));
    show(12.0);
    QVERIFY(isStruck(line) && button.text().contains("silent"));
    machine.isGone = true;
    show(4.0);
    QVERIFY(isStruck(line));
  }

  /// What the control serves of tool and spindle, with its age; what it does not has no place.
  void toolAndSpindleAreShownAsTheControlServesThem() {
    using opcua::SpindleTurn;
    test::Language language;
    PositionLine line;
    line.resize(1280, 56);
    line.show();
    auto* tool = line.findChild<QWidget*>("tool");
    auto* spindle = line.findChild<QWidget*>("spindle");
    auto* number = line.findChild<QLabel*>("tool-number");
    auto* edge = line.findChild<QLabel*>("tool-detail");
    auto* speed = line.findChild<QLabel*>("spindle-speed");
    auto* set = line.findChild<QLabel*>("spindle-detail");
    MachineView machine = test::runningMachine();
    line.setMachineState(machine);
    QVERIFY(!tool->isVisible() && !spindle->isVisible());
    machine.equipment = streaming::EquipmentSeen{
        7, "MILL", 1, "G54", 2998.0, 3000.0, SpindleTurn::Clockwise, true, false};
    machine.equipmentAgeS = 1.4;
    line.setMachineState(machine);
    QVERIFY(tool->isVisible() && spindle->isVisible() && !isStruck(line));
    QCOMPARE(number->text(), QString("7"));
    QCOMPARE(edge->text(), QString("D1 · G54 · MILL"));
    QCOMPARE(speed->text(), QString("↻ 2,998"));
    QCOMPARE(set->text(), QString("set 3,000 · M8"));
    QCOMPARE(tool->accessibleName(), QString("Tool 7, MILL, cutting edge D1, work offset G54"));
    QVERIFY(spindle->accessibleName().contains("clockwise (M3)"));
    QVERIFY(test::visibleText(line).contains("Live"));
    // Older than what is planned: crossed out, and how old it is.
    machine.equipmentAgeS = 1.6;
    line.setMachineState(machine);
    for (const QLabel* label : {number, edge, speed, set}) {
      QVERIFY(label->font().strikeOut());
    }
    QVERIFY(test::visibleText(line).contains("tool and spindle: read 1.6"));
    QVERIFY(tool->toolTip().contains("may have changed"));
    // A lost connection says nothing of the present, however new the values are.
    machine.equipmentAgeS = 0.1;
    machine.isGone = true;
    line.setMachineState(machine);
    QVERIFY(number->font().strikeOut() && speed->font().strikeOut());
    machine.isGone = false;
    // Unknown is not off, and no direction.
    machine.equipment->turn.reset();
    machine.equipment->mist.reset();
    machine.equipment->flood = false;
    line.setMachineState(machine);
    QCOMPARE(speed->text(), QString("2,998"));
    QCOMPARE(set->text(), QString("set 3,000"));
    QVERIFY(spindle->accessibleName().contains("direction not known"));
    QVERIFY(spindle->accessibleName().contains("coolant not known"));
    machine.equipment = streaming::EquipmentSeen{};
    machine.equipment->workOffset = "G54";
    line.setMachineState(machine);
    QVERIFY(!tool->isVisible() && !spindle->isVisible());
  }

  void speaksBothLanguages() {
    test::Language language;
    ConnectionPanel panel;
    PositionLine line;
    panel.setConnectionState(ConnectionState::Connected);
    panel.setMachineState(test::runningMachine());
    line.setMachineState(test::runningMachine());
    language.german();
    const QString text = test::visibleText(panel) + test::visibleText(line);
    for (const char* expected : {"-12,346", "Verbunden", "Trennen", "Aktiv", "Vorschub"}) {
      QVERIFY2(text.contains(expected), expected);
    }
    language.english();
    QVERIFY(test::visibleText(line).contains("-12.346"));
  }
};

RIVULET_TEST(TestConnectionPanel)
#include "tst_connection_panel.moc"
