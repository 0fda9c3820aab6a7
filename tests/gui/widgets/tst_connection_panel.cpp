// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;

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
    for (const char* expected : {"-12.346", "105.000", "500", "Active", "Running",
                                 "RIVULET_SIGNAL_7.MPF", "None", "Live", "Virtual machine"}) {
      QVERIFY2(text.contains(expected), expected);
    }
  }

  void saysWhatIsNotKnown() {
    test::Language language;
    ConnectionPanel panel;
    panel.setConnectionState(ConnectionState::Connected);
    QVERIFY(test::visibleText(panel).contains("No data"));
    QVERIFY(!test::visibleText(panel).contains("Virtual machine"));
    MachineView machine = test::runningMachine();
    machine.isStale = true;
    machine.ageS = 2.34;
    machine.alarmNumber = 10'870;
    machine.alarmText = "No facing axis defined";
    panel.setMachineState(machine);
    QString text = test::visibleText(panel);
    QVERIFY(text.contains(QString("Stale: 2.3") + QChar(0x00A0) + "s old"));
    QVERIFY(text.contains("10870: No facing axis defined"));
    panel.setConnectionState(ConnectionState::Lost);
    QVERIFY(test::visibleText(panel).contains("Old values"));
  }

  void speaksBothLanguages() {
    test::Language language;
    ConnectionPanel panel;
    panel.setConnectionState(ConnectionState::Connected);
    panel.setMachineState(test::runningMachine());
    language.german();
    const QString text = test::visibleText(panel);
    for (const char* expected : {"-12,346", "Verbunden", "Istposition", "Trennen", "Aktiv"}) {
      QVERIFY2(text.contains(expected), expected);
    }
    language.english();
    QVERIFY(test::visibleText(panel).contains("-12.346"));
  }
};

RIVULET_TEST(TestConnectionPanel)
#include "tst_connection_panel.moc"
