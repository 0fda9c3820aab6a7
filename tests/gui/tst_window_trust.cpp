// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whom the window trusts: the released virtual machine in a process of its own, encrypted, over
/// real sockets; what is asked, what is safe, and what is remembered.

#include <QCheckBox>
#include <QComboBox>
#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>
#include <atomic>
#include <memory>
#include <thread>

#include "base/contract.h"
#include "base/units.h"
#include "hmi/main_window.h"
#include "machine/config.h"
#include "machine/front/login.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "machine/user.h"
#include "opcua/control_map.h"
#include "platform/log.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/status_label.h"
#include "widgets/connection/certificates_page.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/connection/rights_page.h"
#include "widgets/connection/trust_sheet.h"

using namespace rivulet;
using hmi::MainWindow;
using widgets::TrustSheet;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
/// Occurs nowhere else.
constexpr const char* kPassword = "Quittengelee-0815";
constexpr const char* kWrong = "Hagebuttentee-17";

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  return settings;
}

/// A server without encryption, as the oldest controls have it.
class PlainCell {
 public:
  PlainCell() : m_machine(*machine::loadPreset("ideal"), 1) {
    auto server = machine::Server::start(m_machine, {});
    RIVULET_ASSERT(server.has_value());
    m_server = std::move(*server);
    m_thread = std::thread([this] { m_server->run(m_stop); });
  }
  ~PlainCell() {
    m_stop = true;
    m_thread.join();
  }
  PlainCell(const PlainCell&) = delete;
  PlainCell& operator=(const PlainCell&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_server->endpoint(); }

 private:
  machine::Machine m_machine;
  std::unique_ptr<machine::Server> m_server;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

}  // namespace

class TestWindowTrust : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_preset;  ///< of a machine with users
  std::unique_ptr<MainWindow> m_window;

  [[nodiscard]] QStringList encrypted(const char* certificates) const {
    return {QStringLiteral("--encrypted"), QStringLiteral("--certificates"),
            m_folder.filePath(QLatin1String(certificates))};
  }
  [[nodiscard]] QStringList withUsers() const {
    return encrypted("users") + QStringList{QStringLiteral("--preset"), m_preset};
  }
  [[nodiscard]] widgets::ConnectionPanel* panel() const {
    return m_window->findChild<widgets::ConnectionPanel*>();
  }
  [[nodiscard]] QString note() const {
    return panel()->findChild<widgets::StatusLabel*>(QStringLiteral("login-note"))->text();
  }
  /// All that the panel says of the connection.
  [[nodiscard]] QString said() const {
    QStringList texts;
    for (const auto* label : panel()->findChildren<widgets::StatusLabel*>()) {
      texts.append(label->text());
    }
    return texts.join(QLatin1Char('\n'));
  }
  /// A file with the certificate or the key of somebody.
  [[nodiscard]] QString userFile(const char* name, const char* what) const {
    return m_folder.filePath(
        QStringLiteral("%1/client/%2.der").arg(QLatin1String(name), QLatin1String(what)));
  }
  /// Makes them. The certificate of another computer is as good as any.
  [[nodiscard]] std::string fingerprintOf(const char* name) const {
    const auto own =
        trust::ownCertificate(m_folder.filePath(QLatin1String(name)).toStdString(), trust::kClient);
    return own ? opcua::readCertificate(own->certificate)->fingerprint : std::string();
  }
  /// Types user and password, and presses Connect.
  void logIn(const QString& user, const char* password) {
    panel()->findChild<QCheckBox*>(QStringLiteral("login"))->setChecked(true);
    panel()->findChild<QLineEdit*>(QStringLiteral("login-user"))->setText(user);
    panel()
        ->findChild<QLineEdit*>(QStringLiteral("login-password"))
        ->setText(QLatin1String(password));
    panel()->findChild<QPushButton*>(QStringLiteral("connect"))->click();
  }
  void disconnect() {
    panel()->findChild<QPushButton*>(QStringLiteral("connect"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(!isConnected(), kSoonMs);
  }
  [[nodiscard]] TrustSheet* sheet() const { return m_window->findChild<TrustSheet*>(); }
  template <class Widget>
  [[nodiscard]] Widget* find(const char* name) const {
    return m_window->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] QString place() const { return find<QToolButton>("machine")->text(); }
  [[nodiscard]] bool isConnected() const { return place().contains(QStringLiteral("\n")); }
  [[nodiscard]] QString allTextOfSheet() const {
    QStringList texts;
    for (const auto* label : sheet()->findChildren<widgets::StatusLabel*>()) {
      texts.append(label->text());
    }
    return texts.join(QLatin1Char('\n'));
  }
  /// Until it acts.
  void hold(const char* name) {
    auto* button = find<widgets::HoldButton>(name);
    QVERIFY(button != nullptr && button->isEnabled());
    QSignalSpy held(button, &widgets::HoldButton::held);
    QTest::mousePress(button, Qt::LeftButton);
    QVERIFY(held.wait(kSoonMs));
    QTest::mouseRelease(button, Qt::LeftButton);
  }

 private Q_SLOTS:
  void initTestCase() {
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    // No keyring, whatever desktop the test is started on.
    qputenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent");
    QVERIFY(
        log::setUp({"rivulet", "trace", m_folder.filePath(QStringLiteral("log")).toStdString()}));
    QFile preset(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    QVERIFY(preset.open(QIODevice::ReadOnly));
    const std::string users =
        "\n[[users.list]]\nname = \"setter\"\npassword = \"" +
        machine::passwordText(machine::hashPassword(kPassword, "salt")) +
        "\"\nrights = [\"StateRead\", \"StateWrite\", \"FsRead\", \"FsWrite\", \"ApWrite\"]\n" +
        "\n[[users.list]]\nname = \"reader\"\npassword = \"" +
        machine::passwordText(machine::hashPassword(kPassword, "pepper")) +
        "\"\nrights = [\"SinuReadAll\"]\n" + "\n[[users.list]]\nname = \"emma\"\ncertificate = \"" +
        fingerprintOf("emma") + "\"\nrights = [\"SinuReadAll\"]\n";
    m_preset = m_folder.filePath(QStringLiteral("machine.toml"));
    QFile file(m_preset);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(preset.readAll() + QByteArray::fromStdString(users));
  }

  void init() {
    m_window = std::make_unique<MainWindow>(settings(), false);
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
  }
  void cleanup() {
    m_window.reset();
    QDir(qEnvironmentVariable("XDG_CONFIG_HOME") + QStringLiteral("/rivulet/trust"))
        .removeRecursively();
  }

  void aNewMachineIsAskedAboutAndTheSafeAnswerIsTheEasyOne() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), encrypted("first"));
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    const auto question = sheet()->question();
    QVERIFY(question);
    QCOMPARE(question->kind, opcua::TrustQuestion::Kind::NewServer);
    const QString text = allTextOfSheet();
    QVERIFY2(text.contains(QStringLiteral("CN=")), qPrintable(text));
    const QString fingerprint =
        QString::fromStdString(opcua::fingerprintText(question->shown.fingerprint));
    QVERIFY2(QString(text).remove(QLatin1Char('\n')).contains(fingerprint.left(23)),
             qPrintable(text));
    // Stop stays where it is, and nothing waits for the answer.
    QVERIFY(find<QPushButton>("stop")->isVisible());
    QVERIFY(!isConnected());

    // A key pressed by chance does not connect; nor does a short press on the other button.
    QCOMPARE(QApplication::focusWidget(), find<QPushButton>("trust-decline"));
    QTest::mouseClick(find<widgets::HoldButton>("trust-accept"), Qt::LeftButton);
    QVERIFY(sheet()->question());
    find<QPushButton>("trust-decline")->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QTRY_VERIFY(!sheet()->isVisible());
    QVERIFY(!isConnected());
    const trust::TrustStore store{trust::trustFolder()};
    QVERIFY(store.servers() && store.servers()->empty());
    QCOMPARE(store.rejected().size(), std::size_t{1});
  }

  void anAcceptedMachineIsConnectedEncryptedAndNotAskedAboutAgain() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), encrypted("first"));
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    hold("trust-accept");
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
    QVERIFY(!sheet()->isVisible());
    QVERIFY2(place().endsWith(QStringLiteral("\nencrypted")), qPrintable(place()));
    QVERIFY(find<QToolButton>("machine")->toolTip().contains(
        QStringLiteral("Aes256_Sha256_RsaPss, SignAndEncrypt")));
    QVERIFY(trust::TrustStore{trust::trustFolder()}.rejected().empty());

    disconnect();
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
    QVERIFY(!sheet()->question());
  }

  void aChangedCertificateIsNotAcceptedSilently() {
    const QStringList samePort{QStringLiteral("--port"), tests::portOfThisProcess()};
    QString endpoint;
    {
      const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                          encrypted("first") + samePort);
      endpoint = machine.endpoint();
      m_window->connectTo(endpoint);
      QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
      hold("trust-accept");
      QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!isConnected(), kSoonMs);
    const tests::MachineProcess other(QStringLiteral(RIVULET_MACHINE),
                                      encrypted("second") + samePort);
    QCOMPARE(other.endpoint(), endpoint);
    m_window->connectTo(endpoint);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    const auto question = sheet()->question();
    QCOMPARE(question->kind, opcua::TrustQuestion::Kind::ChangedServer);
    QVERIFY(question->accepted && question->accepted->fingerprint != question->shown.fingerprint);
    const QString text = allTextOfSheet();
    for (const std::string& one : {question->shown.fingerprint, question->acceptedFingerprint}) {
      const auto lines = QString::fromStdString(opcua::fingerprintText(one)).left(23);
      QVERIFY2(text.contains(lines), qPrintable(text));
    }
    QCOMPARE(QApplication::focusWidget(), find<QPushButton>("trust-decline"));
    find<QPushButton>("trust-decline")->click();
    QVERIFY(!isConnected());
    const trust::TrustStore store{trust::trustFolder()};
    QCOMPARE(store.find(endpoint.toStdString())->value().fingerprint,
             question->acceptedFingerprint);

    // From the list of those that were refused.
    QVERIFY(store.acceptRejected(question->shown.fingerprint));
    m_window->connectTo(endpoint);
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
  }

  void noProtectionIsAllowedByNameOnlyAndRemembered() {
    const PlainCell cell;
    const QString endpoint = QString::fromStdString(cell.endpoint());
    const trust::TrustStore store{trust::trustFolder()};
    // It was encrypted before, so it is not taken for a server that need not be.
    opcua::CertificateFacts before;
    before.fingerprint = std::string(64, 'b');
    QVERIFY(store.accept(cell.endpoint(), before, "not kept as it should be"));
    m_window->connectTo(endpoint);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    QCOMPARE(sheet()->question()->kind, opcua::TrustQuestion::Kind::Protection);
    QVERIFY(sheet()->question()->wasEncrypted);
    QVERIFY(find<QRadioButton>("trust-choice-0")->text() == QStringLiteral("None"));
    hold("trust-accept");
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
    QVERIFY2(place().endsWith(QStringLiteral("\nnot protected")), qPrintable(place()));
    QCOMPARE(store.find(cell.endpoint())->value().security, std::string("None"));
    disconnect();
    m_window->connectTo(endpoint);
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);

    // Taken back where certificates are listed: then it is asked about again.
    auto* page = m_window->findChild<widgets::CertificatesPage*>();
    auto* table = page->findChild<QTableView*>(QStringLiteral("servers"));
    QCOMPARE(table->model()->rowCount(), 1);
    table->selectRow(0);
    page->findChild<QPushButton*>(QStringLiteral("server-strengthen"))->click();
    m_window->connectTo(endpoint);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    QVERIFY(!isConnected());
  }

  void whoIsNobodyHasToSayWho() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), withUsers());
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY2_WITH_TIMEOUT(note().contains(QStringLiteral("lets nobody in")), qPrintable(note()),
                              kSoonMs);
    QVERIFY(!sheet()->isVisible());
    // Who has to type something sees where, and the first line says the same.
    QTRY_VERIFY(panel()->isVisible());
    const auto alarm = [this] { return m_window->findChild<widgets::AlarmLine*>()->text(); };
    QVERIFY2(alarm().contains(QStringLiteral("user name")), qPrintable(alarm()));

    // The certificate is asked about before a password is sent.
    logIn(QStringLiteral("setter"), kWrong);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    hold("trust-accept");
    QTRY_VERIFY2_WITH_TIMEOUT(note().contains(QStringLiteral("refuses user or password")),
                              qPrintable(note()), kSoonMs);
    QVERIFY(!isConnected());
    QTRY_VERIFY(panel()->isVisible());
    QTRY_VERIFY2(alarm().contains(QStringLiteral("password")), qPrintable(alarm()));
    QVERIFY2(!alarm().contains(QStringLiteral("network")), qPrintable(alarm()));
    QVERIFY(panel()->findChild<QLineEdit*>(QStringLiteral("login-password"))->text().isEmpty());
    logIn(QStringLiteral("setter"), kPassword);
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);

    // The name is remembered, the password is not; it is asked for before anything is sent.
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY2_WITH_TIMEOUT(note().contains(QStringLiteral("Type the password")),
                              qPrintable(note()), kSoonMs);
    QCOMPARE(panel()->findChild<QLineEdit*>(QStringLiteral("login-user"))->text(),
             QStringLiteral("setter"));

    // After five wrong ones the right one is refused, too.
    for (int i = 0; i < machine::kWrongPasswordsMax + 1; ++i) {
      const bool isLast = i == machine::kWrongPasswordsMax;
      if (isConnected()) {
        disconnect();
      }
      logIn(QStringLiteral("setter"), isLast ? kPassword : kWrong);
      QVERIFY(!note().contains(QStringLiteral("locks the user")));  // nothing is known yet
      QTRY_VERIFY2_WITH_TIMEOUT(note().contains(QStringLiteral("locks the user")),
                                qPrintable(note()), kSoonMs);
    }
    QVERIFY(!isConnected());
  }

  void theRightsOfTheUserAreSaid() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), withUsers());
    m_window->setEndpoint(machine.endpoint());
    logIn(QStringLiteral("reader"), kPassword);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    hold("trust-accept");
    QTRY_VERIFY_WITH_TIMEOUT(isConnected(), kSoonMs);
    auto* page = m_window->findChild<widgets::RightsPage*>();
    auto* outcome = page->findChild<widgets::StatusLabel*>(QStringLiteral("rights-outcome"));
    page->findChild<QPushButton*>(QStringLiteral("rights-examine"))->click();
    QTRY_VERIFY2_WITH_TIMEOUT(outcome->text().contains(QStringLiteral("not possible")),
                              qPrintable(outcome->text()), kSoonMs);
    QStringList texts;
    for (const auto* label : page->findChildren<QLabel*>()) {
      texts.append(label->text());
    }
    QVERIFY(texts.join(QLatin1Char('\n')).contains(QStringLiteral("StateWrite")));
  }

  /// Files that cannot be used are said, and so is a certificate that nobody has registered; the
  /// right one is shown again the next time, without a question.
  void aUserLogsInByCertificate() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), withUsers());
    QVERIFY(!fingerprintOf("stranger").empty());
    m_window->setEndpoint(machine.endpoint());
    const auto field = [this](const char* name) {
      return panel()->findChild<QLineEdit*>(QLatin1String(name));
    };
    const auto logInAs = [&](const char* name) {
      field("login-certificate")->setText(userFile(name, "certificate"));
      field("login-key")->setText(userFile(name, "key"));
      panel()->findChild<QPushButton*>(QStringLiteral("connect"))->click();
    };
    panel()->findChild<QCheckBox*>(QStringLiteral("login"))->setChecked(true);
    QVERIFY(field("login-user")->isVisibleTo(panel()));
    panel()->findChild<QComboBox*>(QStringLiteral("login-kind"))->setCurrentIndex(1);
    QVERIFY(!field("login-user")->isVisibleTo(panel()));
    QVERIFY(field("login-certificate")->isVisibleTo(panel()));

    logInAs("nobody");
    QVERIFY2(said().contains(userFile("nobody", "certificate")), qPrintable(said()));
    QFile key(userFile("emma", "key"));
    QVERIFY(key.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    logInAs("emma");
    QVERIFY2(said().contains(QStringLiteral("chmod 600")), qPrintable(said()));
    QVERIFY(key.setPermissions(QFile::ReadOwner | QFile::WriteOwner));

    logInAs("stranger");
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    hold("trust-accept");
    QTRY_VERIFY2_WITH_TIMEOUT(note().contains(QStringLiteral("refuses this certificate")),
                              qPrintable(note()), kSoonMs);
    QVERIFY(!isConnected());
    logInAs("emma");
    QTRY_VERIFY2_WITH_TIMEOUT(isConnected(), qPrintable(said()), kSoonMs);

    m_window = std::make_unique<MainWindow>(settings(), false);
    m_window->show();
    m_window->setEndpoint(machine.endpoint());
    QCOMPARE(field("login-certificate")->text(), userFile("emma", "certificate"));
    QCOMPARE(field("login-key")->text(), userFile("emma", "key"));
    m_window->connectTo(machine.endpoint());
    QTRY_VERIFY2_WITH_TIMEOUT(isConnected(), qPrintable(said()), kSoonMs);
  }

  /// A map that cannot be used is said; one that can is shown as long as the machine is connected,
  /// and chosen again the next time.
  void theMapOfAMachineIsRemembered() {
    const PlainCell cell;
    const QString endpoint = QString::fromStdString(cell.endpoint());
    const QString file = m_folder.filePath(QStringLiteral("cell.toml"));
    const auto write = [&](const std::string& text) {
      QFile map(file);
      QVERIFY(map.open(QIODevice::WriteOnly));
      map.write(QByteArray::fromStdString(text));
    };
    const auto mapFile = [this] {
      return panel()->findChild<QLineEdit*>(QStringLiteral("map-file"));
    };
    const auto connectNow = [this] {
      panel()->findChild<QPushButton*>(QStringLiteral("connect"))->click();
    };
    opcua::ControlMap map = opcua::sinumerikMap(99, 3);
    std::erase_if(map.nodes, [](const auto& node) {  // this machine does not show its equipment
      return node.first.kind >= opcua::VariableKind::ToolNumber;
    });

    m_window->setEndpoint(endpoint);
    QVERIFY(!mapFile()->isVisibleTo(panel()));
    panel()->findChild<QCheckBox*>(QStringLiteral("mapped"))->setChecked(true);
    QVERIFY(mapFile()->isVisibleTo(panel()));
    mapFile()->setText(file);
    connectNow();  // the file is missing
    QVERIFY2(said().contains(file), qPrintable(said()));
    write("[cells]\nnode = 5\n");
    connectNow();
    QVERIFY2(said().contains(file + QStringLiteral(", line 2:")), qPrintable(said()));
    opcua::ControlMap wrong = map;
    wrong.nodes[{opcua::VariableKind::PathFeed, 0}] = "ns=0;s=Nothing";
    write(opcua::controlMapText(wrong));
    connectNow();
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains(QStringLiteral("feed.path of the map")),
                              qPrintable(said()), kSoonMs);
    QVERIFY(!isConnected());
    QCOMPARE(mapFile()->text(), file);

    write(opcua::controlMapText(map));
    connectNow();
    QTRY_VERIFY2_WITH_TIMEOUT(isConnected(), qPrintable(said()), kSoonMs);
    QCOMPARE(mapFile()->text(), file);
    QVERIFY(mapFile()->isVisibleTo(panel()) && !mapFile()->isEnabled());
    disconnect();
    m_window->setEndpoint(QStringLiteral("opc.tcp://127.0.0.1:1"));
    QVERIFY(!mapFile()->isVisibleTo(panel()));

    m_window = std::make_unique<MainWindow>(settings(), false);
    m_window->show();
    m_window->setEndpoint(endpoint);
    QVERIFY(mapFile()->isVisibleTo(panel()));
    QCOMPARE(mapFile()->text(), file);
    connectNow();
    QTRY_VERIFY2_WITH_TIMEOUT(isConnected(), qPrintable(said()), kSoonMs);
  }

  /// A run as a user: no file has the password, neither settings nor log nor recording.
  void aRunLeavesNoTraceOfThePassword() {
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE),
        withUsers() +
            QStringList{QStringLiteral("--state"), m_folder.filePath(QStringLiteral("state"))});
    QByteArray program("G90 G1 F1000\n");
    for (int i = 1; i <= 20; ++i) {
      program += "X" + QByteArray::number(0.4 * i) + " Y" + QByteArray::number(0.1 * i) + "\n";
    }
    QFile file(m_folder.filePath(QStringLiteral("line.nc")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(program + "M30\n");
    file.close();
    hmi::Settings kept = settings();
    kept.stateFolder = m_folder.filePath(QStringLiteral("audit")).toStdString();
    m_window = std::make_unique<MainWindow>(kept, true);
    m_window->show();
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Window;
    stream.parameters.pointsPerLoop = 7;
    stream.feedMmPerS = base::mmPerSFromMmPerMin(400.0);
    m_window->setStreamSettings(stream);
    m_window->openProgram(file.fileName());
    m_window->setEndpoint(machine.endpoint());
    logIn(QStringLiteral("setter"), kPassword);
    QTRY_VERIFY_WITH_TIMEOUT(sheet()->isVisible(), kSoonMs);
    hold("trust-accept");
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QVERIFY(finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == streaming::Outcome::Completed, report->error.text().c_str());
    m_window->close();
    m_window.reset();

    int files = 0;
    for (const QString& folder :
         {m_folder.path(), qEnvironmentVariable("XDG_CONFIG_HOME"),
          qEnvironmentVariable("XDG_DATA_HOME"), qEnvironmentVariable("XDG_STATE_HOME")}) {
      for (QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
           each.hasNext(); ++files) {
        QFile one(each.next());
        QVERIFY2(one.open(QIODevice::ReadOnly), qPrintable(one.fileName()));
        const QByteArray bytes = one.readAll();
        for (const char* password : {kPassword, kWrong}) {
          QVERIFY2(!bytes.contains(password), qPrintable(one.fileName()));
        }
      }
    }
    QVERIFY2(files > 8, qPrintable(QString::number(files)));
  }
};

RIVULET_TEST(TestWindowTrust)
#include "tst_window_trust.moc"
