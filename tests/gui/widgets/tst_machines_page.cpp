// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of all machines: what is shown of those that are not connected, how one is removed, and
/// the board of services.

#include <QFrame>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/connection/machines_page.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

MachineCardView machine(const char* name, int port) {
  MachineCardView view;
  view.name = QString::fromLatin1(name);
  view.endpoint = QStringLiteral("opc.tcp://127.0.0.1:%1").arg(port);
  view.canRemove = true;
  return view;
}

/// With the cards, which Qt shows later.
void show(MachinesPage& page, const std::vector<MachineCardView>& machines) {
  page.setMachines(machines);
  test::settle(page);
}

QPushButton* button(const MachinesPage& page, const char* name) {
  return page.findChild<QPushButton*>(QString::fromLatin1(name));
}

}  // namespace

class TestMachinesPage : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  /// Each start of a virtual machine on a free port would leave a card for ever.
  void machinesThatAreGoneAreOneLine() {
    MachinesPage page;
    page.show();
    std::vector<MachineCardView> machines{machine("Mill 3", 4840)};
    for (int port = 40001; port < 40006; ++port) {
      machines.push_back(machine("", port));
      machines.back().isLeftOver = true;
    }
    show(page, machines);
    QVERIFY(test::visibleText(page).contains("Mill 3"));
    QVERIFY(!test::visibleText(page).contains("40001"));
    QVERIFY(test::visibleText(page).contains("5 virtual machines of this computer do not answer"));
    button(page, "show-left-over")->click();
    QVERIFY(test::settle(page));
    QVERIFY(test::visibleText(page).contains("40001"));
    button(page, "show-left-over")->click();
    machines.resize(1);
    show(page, machines);
    QVERIFY(!button(page, "show-left-over")->isVisible());
  }

  void whatIsNotConnectedHasAnAge() {
    MachinesPage page;
    page.show();
    MachineCardView mill = machine("Mill 3", 4840);
    show(page, {mill});
    QVERIFY(test::visibleText(page).contains("Not connected with this window"));
    mill.answers = true;
    mill.lookedS = 12.0;
    show(page, {mill});
    QVERIFY2(test::visibleText(page).contains("its port answered 12"),
             qPrintable(test::visibleText(page)));
    mill.answers = false;
    show(page, {mill});
    QVERIFY(test::visibleText(page).contains("Not reachable: no answer 12"));
  }

  void removingIsConfirmed() {
    MachinesPage page;
    page.show();
    MachineCardView mill = machine("Mill 3", 4840);
    mill.hasLimits = true;
    mill.hasCalibration = true;
    show(page, {mill});
    QSignalSpy removed(&page, &MachinesPage::removeRequested);
    button(page, "remove")->click();
    QVERIFY(removed.isEmpty() && !button(page, "open")->isVisible());
    QVERIFY(test::visibleText(page).contains("Its runs and recordings stay"));
    QVERIFY(test::visibleText(page).contains("limits, calibration."));
    button(page, "keep")->click();
    QVERIFY(removed.isEmpty() && button(page, "open")->isVisible());
    button(page, "remove")->click();
    show(page, {mill});  // its age is shown every second
    button(page, "confirm-remove")->click();
    QTRY_COMPARE(removed.size(), 1);
    QCOMPARE(removed.front().front().toString(), mill.endpoint);
    mill.canRemove = false;  // connected
    show(page, {mill});
    QVERIFY(!button(page, "remove")->isVisible() && !button(page, "confirm-remove")->isVisible());
  }

  void servicesShowNoOldFigures() {
    MachinesPage page;
    page.show();
    ServiceView service;
    service.endpoint = QStringLiteral("opc.tcp://10.0.0.7:4841");
    service.link = ServiceLink::Connected;
    service.machine = QStringLiteral("opc.tcp://10.0.0.8:4840");
    service.state = QStringLiteral("running");
    service.program = QStringLiteral("rows.nc");
    service.waitingFor = QStringLiteral("network");
    service.alarm = QStringLiteral("The spindle is hot.");
    service.isRunning = true;
    service.pointsDone = 12;
    service.points = 49;
    service.timeLeftS = 80.0;
    const auto text = [&page, &service] {
      page.setServices({service});
      test::settle(page);
      return test::visibleText(page);
    };
    for (const char* fact : {"opc.tcp://10.0.0.8:4840", "Running", "rows.nc", "12 of 49 points",
                             "1:20", "Nothing comes from the control", "spindle is hot"}) {
      QVERIFY2(text().contains(QLatin1String(fact)), fact);
    }
    page.openService(service.endpoint);
    QVERIFY(text().contains("12 of 49 points") && button(page, "panel-stop")->isEnabled());
    service.link = ServiceLink::Silent;
    QVERIFY(text().contains("No answer for some seconds") && !text().contains("12 of 49"));
    QVERIFY(!button(page, "panel-hold")->isEnabled());
    page.openService({});
    QVERIFY(text().contains("No answer for some seconds") && !text().contains("12 of 49"));
    service.link = ServiceLink::Gone;
    QVERIFY(text().contains("Service does not answer") && !text().contains("12 of 49"));
  }

  void servicesAreFoundOrTyped() {
    MachinesPage page;
    page.show();
    QSignalSpy added(&page, &MachinesPage::addServiceRequested);
    QSignalSpy searched(&page, &MachinesPage::searchRequested);
    button(page, "service-search")->click();
    QCOMPARE(searched.size(), 1);
    page.setFound({QStringLiteral("opc.tcp://10.0.0.7:4841"), QStringLiteral("opc.tcp://a:1")}, {});
    test::settle(page);
    button(page, "service-found-1")->click();
    QTRY_COMPARE(added.size(), 1);
    QCOMPARE(added.back().front().toString(), QStringLiteral("opc.tcp://a:1"));
    auto* address = page.findChild<QLineEdit*>(QStringLiteral("service-address"));
    QVERIFY(!button(page, "service-add")->isEnabled());
    address->setText(QStringLiteral(" mill3:4841 "));
    button(page, "service-add")->click();
    QCOMPARE(added.back().front().toString(), QStringLiteral("mill3:4841"));
    page.setServicesBlocked(QStringLiteral("Only an engineer can do this."));
    QTest::keyClick(address, Qt::Key_Return);
    QVERIFY(!button(page, "service-add")->isEnabled() && added.size() == 2);
  }
};

RIVULET_TEST(TestMachinesPage)
#include "tst_machines_page.moc"
