// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The locks that keep a computer awake, with a D-Bus and a logind of the test's own.

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <QDBusConnection>
#include <QDBusContext>
#include <QProcess>
#include <QStandardPaths>
#include <QtTest>

#include "hmi/sleep_guard.h"
#include "support/patience.h"
#include "support/test_program.h"

using rivulet::hmi::SleepGuard;

namespace {

/// Stands in for logind: gives the writing ends of pipes, and sees when they are closed.
class FakeLogind : public QObject, protected QDBusContext {
  Q_OBJECT
  Q_CLASSINFO("D-Bus Interface", "org.freedesktop.login1.Manager")

 public:
  ~FakeLogind() override {
    for (const int end : m_ends) {
      close(end);
    }
  }

  /// Locks that somebody still holds.
  [[nodiscard]] int held() const {
    int count = 0;
    for (const int end : m_ends) {
      pollfd state{end, POLLIN, 0};
      poll(&state, 1, 0);
      count += (state.revents & POLLHUP) == 0 ? 1 : 0;
    }
    return count;
  }

  QStringList asked;
  QString refused;  ///< of this kind no lock is given

 public Q_SLOTS:
  QDBusUnixFileDescriptor Inhibit(const QString& what, const QString& who, const QString& why,
                                  const QString& mode) {
    asked << what;
    if (what == refused || who.isEmpty() || why.isEmpty() || mode != QLatin1String("block")) {
      sendErrorReply(QDBusError::AccessDenied, QStringLiteral("not for you"));
      return {};
    }
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
      qFatal("no pipe");
    }
    m_ends.push_back(ends[0]);
    QDBusUnixFileDescriptor given(ends[1]);
    close(ends[1]);
    return given;
  }

 private:
  std::vector<int> m_ends;
};

}  // namespace

class TestSleepGuard : public QObject {
  Q_OBJECT

  QProcess m_daemon;
  QString m_address;
  FakeLogind m_logind;

  [[nodiscard]] QDBusConnection connection(const char* name) const {
    return QDBusConnection::connectToBus(m_address, QString::fromUtf8(name));
  }

 private Q_SLOTS:
  void initTestCase() {
    using rivulet::tests::kRunMs;
    const QString daemon = QStandardPaths::findExecutable(QStringLiteral("dbus-daemon"));
    if (daemon.isEmpty()) {
      QSKIP("There is no dbus-daemon.");
    }
    m_daemon.start(daemon, {QStringLiteral("--session"), QStringLiteral("--nofork"),
                            QStringLiteral("--print-address")});
    while (m_daemon.state() != QProcess::NotRunning && !m_daemon.canReadLine()) {
      m_daemon.waitForReadyRead(kRunMs);
    }
    m_address = QString::fromUtf8(m_daemon.readLine()).trimmed();
    QDBusConnection bus = connection("logind");
    QVERIFY(bus.registerService(QStringLiteral("org.freedesktop.login1")));
    QVERIFY(bus.registerObject(QStringLiteral("/org/freedesktop/login1"), &m_logind,
                               QDBusConnection::ExportAllSlots));
  }
  void cleanupTestCase() {
    QDBusConnection::disconnectFromBus(QStringLiteral("logind"));
    QDBusConnection::disconnectFromBus(QStringLiteral("guard"));
    m_daemon.terminate();
    m_daemon.waitForFinished();
  }
  void init() {
    m_logind.asked.clear();
    m_logind.refused.clear();
  }

  void locksLastAsLongAsARun() {
    SleepGuard guard(connection("guard"));
    guard.hold();
    guard.hold();
    QTRY_COMPARE(guard.locks(), std::size_t{2});
    QCOMPARE(m_logind.asked,
             QStringList({QStringLiteral("sleep:idle"), QStringLiteral("handle-lid-switch")}));
    QCOMPARE(m_logind.held(), 2);
    guard.release();
    QTRY_COMPARE(m_logind.held(), 0);
  }

  void aLockThatComesAfterTheRunIsGivenBack() {
    SleepGuard guard(connection("guard"));
    guard.hold();
    guard.release();
    QTRY_COMPARE(m_logind.asked.size(), 2);
    QTRY_COMPARE(m_logind.held(), 0);
    QCOMPARE(guard.locks(), std::size_t{0});
  }

  void oneThatIsRefusedDoesNotTakeTheOther() {
    m_logind.refused = QStringLiteral("handle-lid-switch");
    SleepGuard guard(connection("guard"));
    guard.hold();
    QTRY_COMPARE(guard.locks(), std::size_t{1});
    QTRY_COMPARE(m_logind.asked.size(), 2);
    QCOMPARE(m_logind.held(), 1);
    guard.release();
    QTRY_COMPARE(m_logind.held(), 0);
  }

  void withoutLogindNothingHappens() {
    SleepGuard guard(QDBusConnection(QStringLiteral("there is none")));
    guard.hold();
    QCoreApplication::processEvents();
    QCOMPARE(guard.locks(), std::size_t{0});
    guard.release();
  }
};

RIVULET_TEST(TestSleepGuard)
#include "tst_sleep_guard.moc"
