// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Services on the board of machines: the real window, and service and virtual machine as programs,
/// over OPC UA in real time. Between window and service is a proxy with faults. That each point is
/// executed once is judged by the machine's own list.

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>
#include <algorithm>

#include "gui/look_check.h"
#include "hmi/main_window.h"
#include "support/fault_proxy.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/service_process.h"
#include "support/test_program.h"
#include "support/user_list.h"
#include "widgets/common/hold_button.h"
#include "widgets/connection/machines_page.h"
#include "widgets/connection/service_panel.h"

using namespace rivulet;
using hmi::MainWindow;
using tests::ServiceProcess;
using widgets::StatusLabel;

namespace {

using rivulet::tests::kSoonMs;

void shown(QWidget* page) {
  for (QWidget* at = page; at != nullptr; at = at->parentWidget()) {
    if (auto* tabs = at->findChild<QTabWidget*>(); tabs != nullptr && tabs->isAncestorOf(page)) {
      for (int i = 0; i < tabs->count(); ++i) {
        if (tabs->widget(i)->isAncestorOf(page)) {
          tabs->setCurrentIndex(i);
        }
      }
      return;
    }
  }
}

}  // namespace

class TestServiceBoard : public QObject {
  Q_OBJECT

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  std::unique_ptr<MainWindow> m_window;

  [[nodiscard]] std::unique_ptr<ServiceProcess> service(QStringList options = {}) const {
    return std::make_unique<ServiceProcess>(
        QStringLiteral(RIVULET_SERVICE), m_scene.endpoint(), m_scene.environment(),
        options << QStringLiteral("--jobs") << m_scene.path(""));
  }
  void openWindow(const QStringList& services, const QString& language = QStringLiteral("en"),
                  widgets::Theme theme = widgets::Theme::Light) {
    hmi::Settings settings;
    settings.language = language;
    settings.theme = theme;
    settings.services = services;
    m_window = std::make_unique<MainWindow>(settings, false);
    m_window->resize(1280, 800);
    m_window->show();
    shown(page());
  }
  [[nodiscard]] widgets::MachinesPage* page() const {
    return m_window->findChild<widgets::MachinesPage*>();
  }
  template <class Widget = QPushButton>
  [[nodiscard]] Widget* find(const char* name) const {
    return page()->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] QString says(const char* name) const {
    const auto* label = find<StatusLabel>(name);
    return label != nullptr && label->isVisible() ? label->text() : QString();
  }
  [[nodiscard]] bool isSeen(const char* name) const {
    const auto* label = find<QLabel>(name);
    return label != nullptr && label->isVisible();
  }
  /// As a finger does.
  void hold(const char* name) const {
    auto* button = find<widgets::HoldButton>(name);
    QSignalSpy held(button, &widgets::HoldButton::held);
    QTest::mousePress(button, Qt::LeftButton);
    QVERIFY(held.wait(kSoonMs));
    QTest::mouseRelease(button, Qt::LeftButton);
  }
  void picture(const char* name, QSize size = {1280, 800}) const {
    m_window->resize(size);
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::processEvents();  // layouts settle in several steps
    }
    const QPixmap grabbed = m_window->grab();
    grabbed.save(QStringLiteral(RIVULET_SCREENSHOTS "/%1.png").arg(QLatin1String(name)));
    const QStringList faults = tests::lookFaults(*m_window, grabbed.toImage());
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
  }

 private Q_SLOTS:
  void initTestCase() {
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    m_scene.switchOn();
  }
  void cleanup() {
    m_window.reset();
    m_scene.awaitStandstill();
  }
  void cleanupTestCase() { m_scene.switchOff(); }

  void drivesAMachine() {
    const std::size_t before = m_scene.executed().size();
    const QStringList port{QStringLiteral("--port"),
                           QString::number(tests::portOfThisProcess().toInt() + 8000)};
    auto running = service(port);
    tests::FaultProxy proxy(running->endpoint().toStdString());
    openWindow({QString::fromStdString(proxy.endpoint())});
    QTRY_COMPARE_WITH_TIMEOUT(says("service-state"), QStringLiteral("No program"), kSoonMs);
    find("service-open")->click();
    QTRY_COMPARE(says("panel-state"), QStringLiteral("No program"));

    // Nothing moves before it was shown what will.
    QVERIFY(!find("panel-start")->isEnabled());
    auto* files = find<QComboBox>("panel-files");
    QTRY_VERIFY_WITH_TIMEOUT(files->findText(QStringLiteral("rows.nc")) >= 0, kSoonMs);
    files->setCurrentIndex(files->findText(QStringLiteral("rows.nc")));
    find("panel-load")->click();
    QTRY_VERIFY_WITH_TIMEOUT(says("panel-reply").startsWith(QStringLiteral("rows.nc is loaded")),
                             kSoonMs);
    QVERIFY(running->call("LoadJob", {"rows.nc", "feed=1200;points=4"}).accepted);
    QTRY_COMPARE(says("panel-state"), QStringLiteral("Program loaded"));
    QTRY_VERIFY(find("panel-start")->isEnabled());
    QTest::mouseClick(find("panel-start"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(
        find<QLabel>("panel-preflight")->text().startsWith(QStringLiteral("Start streams rows.nc")),
        kSoonMs);
    picture("service-preflight");
    hold("panel-start");
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Running"), kSoonMs);
    const auto points = [this] { return find<QLabel>("panel-points")->text(); };
    QTRY_VERIFY_WITH_TIMEOUT(points() > QStringLiteral("4 of 49 points"), kSoonMs);
    QVERIFY(!find("panel-load")->isEnabled());
    find("panel-hold")->click();
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Holding"), kSoonMs);
    picture("service-holding");
    find("panel-hold")->click();
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Running"), kSoonMs);

    // A lost connection is said, and no old figure is shown; the run does not care.
    tests::NetworkFault cut;
    cut.kind = tests::FaultKind::Cut;
    proxy.begin(cut);
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Service does not answer"),
                              kSoonMs);
    QVERIFY(!isSeen("panel-points") && !find("panel-hold")->isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Running"), kSoonMs);
    find("panel-stop")->click();
    const auto hasEnded = [&] { return says("panel-state") == QStringLiteral("Run interrupted"); };
    QTRY_VERIFY_WITH_TIMEOUT(
        hasEnded() || (find<QPushButton>("panel-hold")->text() == QStringLiteral("End here") &&
                       find("panel-hold")->isEnabled()),
        kSoonMs);
    if (!hasEnded()) {  // between two windows it has
      find("panel-hold")->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(hasEnded(), kSoonMs);
    find("panel-back")->click();
    QTRY_COMPARE(says("service-state"), QStringLiteral("Run interrupted"));
    picture("service-board");
    find("service-open")->click();
    QTRY_VERIFY(find("panel-resume")->isVisible());
    find("panel-resume")->click();
    QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("panel-preflight")
                                 ->text()
                                 .startsWith(QStringLiteral("ResumeRun goes on with run")),
                             kSoonMs);
    hold("panel-start");
    QVERIFY(running->await("Session/LastOutcome", "completed"));
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Program loaded"), kSoonMs);
    QVERIFY(m_scene.isWhole(before));

    QCOMPARE(running->end(SIGKILL), -1);
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Service does not answer"),
                              kSoonMs);
    QVERIFY(!isSeen("panel-points"));
    running = service(port);
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("No program"), kSoonMs);
  }

  /// The network passes nothing on, and nobody says that the connection is lost.
  void saysThatNothingIsHeard() {
    const auto running = service();
    tests::FaultProxy proxy(running->endpoint().toStdString());
    openWindow({QString::fromStdString(proxy.endpoint())});
    QVERIFY(running->await("Monitoring/IsConnected", "true"));
    QVERIFY(running->call("LoadJob", {"rows.nc", ""}).accepted);
    QTRY_COMPARE_WITH_TIMEOUT(says("service-state"), QStringLiteral("Program loaded"), kSoonMs);
    QVERIFY(isSeen("service-points"));
    tests::NetworkFault stall;
    stall.kind = tests::FaultKind::Stall;
    stall.duration = std::chrono::seconds(5);
    proxy.begin(stall);
    QTRY_COMPARE_WITH_TIMEOUT(says("service-state"), QStringLiteral("No answer for some seconds"),
                              kSoonMs);
    QVERIFY(!isSeen("service-points"));
    QTRY_COMPARE_WITH_TIMEOUT(says("service-state"), QStringLiteral("Program loaded"), kSoonMs);
    QVERIFY(isSeen("service-points"));
  }

  /// The address of the next one is typed from the beginning; one that is there is said.
  void servicesAreAddedOneAfterAnother() {
    openWindow({});
    auto* address = find<QLineEdit>("service-address");
    const auto cards = [this] {
      return page()->findChildren<QPushButton*>(QStringLiteral("service-open")).size();
    };
    qsizetype count = 0;
    for (const char* typed : {"127.0.0.1:1", "127.0.0.1:2"}) {
      QTest::keyClicks(address, QString::fromUtf8(typed));
      find("service-add")->click();
      QCOMPARE(cards(), ++count);
      QCOMPARE(address->text(), QString());
    }
    QTest::keyClicks(address, QStringLiteral("opc.tcp://127.0.0.1:2/"));
    find("service-add")->click();
    QCOMPARE(cards(), count);
    QVERIFY(isSeen("service-found"));
  }

  /// The rules of the service: everybody sees, who has logged in does.
  void asksForNameAndPin() {
    const QString users = m_scene.path("users.json");
    tests::writeUsers(users, {{"anna", permission::Role::Engineer, "4711"}});
    const auto running = service({QStringLiteral("--users"), users});
    openWindow({running->endpoint()}, QStringLiteral("de"), widgets::Theme::Dark);
    QTRY_COMPARE_WITH_TIMEOUT(says("service-state"), QStringLiteral("Kein Programm"), kSoonMs);
    picture("service-board-de", {1024, 768});
    find("service-open")->click();
    QCOMPARE(find<QComboBox>("panel-files")->count(), 0);  // strangers see no file
    find<QLineEdit>("panel-file")->setText(QStringLiteral("rows.nc"));
    find("panel-load")->click();
    QTRY_VERIFY_WITH_TIMEOUT(
        says("panel-reply").startsWith(QStringLiteral("This service has users")), kSoonMs);
    const auto logIn = [this](const QString& pin) {
      find("panel-login")->click();
      find<QLineEdit>("panel-name")->setText(QStringLiteral("anna"));
      find<QLineEdit>("panel-pin")->setText(pin);
      find("panel-enter")->click();
    };
    // The PIN goes encrypted, so the certificate of the service has to be known.
    logIn(QStringLiteral("4711"));
    QTRY_VERIFY_WITH_TIMEOUT(find("trust-decline") != nullptr, kSoonMs);
    picture("service-trust-de", {1024, 768});
    hold("trust-accept");
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-user"), QStringLiteral("Angemeldet: anna"), kSoonMs);
    find("panel-load")->click();
    QTRY_VERIFY_WITH_TIMEOUT(says("panel-reply").startsWith(QStringLiteral("rows.nc is loaded")),
                             kSoonMs);
    picture("service-panel-de", {1024, 768});
    // Who mistypes the PIN still sees the machine.
    logIn(QStringLiteral("4712"));
    QTRY_VERIFY_WITH_TIMEOUT(!says("panel-alarm").isEmpty(), kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(says("panel-state"), QStringLiteral("Programm geladen"), kSoonMs);
    QCOMPARE(says("panel-user"), QStringLiteral("Niemand ist angemeldet."));
  }
};

RIVULET_TEST(TestServiceBoard)
#include "tst_service_board.moc"
