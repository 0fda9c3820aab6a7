// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Passwords in the keyring of the system: a real one, started for this test on a bus of its own.

#include <sys/prctl.h>

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>
#include <optional>

#include "hmi/keyring.h"
#include "hmi/logins.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::Keyring;
using Outcome = hmi::Keyring::Outcome;

namespace {

using rivulet::tests::kRunMs;
const QString kEndpoint = QStringLiteral("opc.tcp://cell-4:4840");

/// Ends with the test, whatever becomes of it.
void begin(QProcess& process, const QString& program, const QStringList& arguments) {
  process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
  process.start(program, arguments);
}

}  // namespace

class TestKeyring : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QProcess m_bus;
  QProcess m_daemon;

  static Outcome write(Keyring& keyring, const QString& password) {
    std::optional<Outcome> outcome;
    keyring.write(QStringLiteral("setter@x"), password, [&](Outcome done) { outcome = done; });
    (void)QTest::qWaitFor([&] { return outcome.has_value(); }, kRunMs);
    return outcome.value_or(Outcome::Refused);
  }
  static std::pair<Outcome, QString> read(Keyring& keyring) {
    std::optional<std::pair<Outcome, QString>> answer;
    keyring.read(QStringLiteral("setter@x"), [&](Outcome outcome, const QString& password) {
      answer = {outcome, password};
    });
    (void)QTest::qWaitFor([&] { return answer.has_value(); }, kRunMs);
    return answer.value_or(std::pair(Outcome::Refused, QString()));
  }

 private Q_SLOTS:
  void initTestCase() {
    // On a busy computer the daemon has refused to store a password, once in three runs.
    if (!qEnvironmentVariableIsSet("RIVULET_TEST_KEYRING")) {
      QSKIP("Set RIVULET_TEST_KEYRING to test with a real keyring.");
    }
    const QString bus = QStandardPaths::findExecutable(QStringLiteral("dbus-daemon"));
    const QString daemon = QStandardPaths::findExecutable(QStringLiteral("gnome-keyring-daemon"));
    if (bus.isEmpty() || daemon.isEmpty()) {
      QSKIP("There is no gnome-keyring-daemon or dbus-daemon on this computer.");
    }
    begin(m_bus, bus,
          {QStringLiteral("--session"), QStringLiteral("--nofork"),
           QStringLiteral("--print-address")});
    QVERIFY(m_bus.waitForReadyRead(kRunMs));
    qputenv("DBUS_SESSION_BUS_ADDRESS", m_bus.readLine().trimmed());
    qputenv("XDG_CURRENT_DESKTOP", "GNOME");
    qputenv("XDG_RUNTIME_DIR", m_folder.path().toUtf8());
    qputenv("HOME", m_folder.path().toUtf8());
    begin(m_daemon, daemon,
          {QStringLiteral("--foreground"), QStringLiteral("--unlock"),
           QStringLiteral("--components=secrets")});
    m_daemon.write("the password of the keyring\n");
    m_daemon.closeWriteChannel();
    const std::unique_ptr<Keyring> keyring = hmi::systemKeyring();
    // It is there when it has answered.
    QTRY_VERIFY_WITH_TIMEOUT(read(*keyring).first == Outcome::NotKept, kRunMs);
  }
  void cleanupTestCase() {
    for (QProcess* process : {&m_daemon, &m_bus}) {
      process->kill();
      process->waitForFinished(kRunMs);
    }
  }

  void whatIsKeptIsFoundUntilItIsRemoved() {
    const std::unique_ptr<Keyring> keyring = hmi::systemKeyring();
    QCOMPARE(write(*keyring, QStringLiteral("grün & \"böse\"")), Outcome::Done);
    QCOMPARE(read(*keyring), std::pair(Outcome::Done, QStringLiteral("grün & \"böse\"")));
    std::optional<Outcome> removed;
    keyring->remove(QStringLiteral("setter@x"), [&](Outcome outcome) { removed = outcome; });
    QTRY_VERIFY_WITH_TIMEOUT(removed.has_value(), kRunMs);
    QCOMPARE(*removed, Outcome::Done);
    QCOMPARE(read(*keyring).first, Outcome::NotKept);
  }

  void aLoginIsRememberedByNameAndKeptInTheKeyring() {
    const std::filesystem::path folder = m_folder.filePath(QStringLiteral("trust")).toStdString();
    hmi::Logins logins(hmi::systemKeyring(), {}, folder);
    QString found = QStringLiteral("not asked");
    const auto take = [&](const QString& password) { found = password; };
    logins.findPassword(kEndpoint, QStringLiteral("setter"), take);
    QTRY_COMPARE_WITH_TIMEOUT(found, QString(), kRunMs);
    logins.remember(kEndpoint, {{QStringLiteral("setter"), {}, {}}, QStringLiteral("secret"), true},
                    {});
    hmi::Logins later(hmi::systemKeyring(), {}, folder);
    QCOMPARE(later.nameOf(kEndpoint).user, QStringLiteral("setter"));
    QTRY_VERIFY_WITH_TIMEOUT(
        (later.findPassword(kEndpoint, QStringLiteral("setter"), take),
         QTest::qWaitFor([&] { return found == QStringLiteral("secret"); }, 1000)),
        kRunMs);
    QVERIFY(later.view().hasKeyring);
    QFile file(QString::fromStdString((folder / "servers.json").string()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(!file.readAll().contains("secret"));
  }
};

RIVULET_TEST(TestKeyring)
#include "tst_keyring.moc"
