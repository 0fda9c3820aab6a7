// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_panel.h"
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
