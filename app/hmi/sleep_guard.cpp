// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/sleep_guard.h"

#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <utility>

#include "platform/log.h"

namespace rivulet::hmi {

SleepGuard::SleepGuard(QDBusConnection bus, QObject* parent)
    : QObject(parent), m_bus(std::move(bus)) {
}

void SleepGuard::hold() {
  if (std::exchange(m_isHeld, true)) {
    return;
  }
  ++m_run;
  // One by one: a user may be allowed one and not the other. A lid counts by itself, because
  // logind ignores the first lock when it is closed.
  ask(QStringLiteral("sleep:idle"));
  ask(QStringLiteral("handle-lid-switch"));
}

void SleepGuard::release() {
  m_isHeld = false;
  if (!m_locks.empty()) {
    m_locks.clear();  // closes them
    Q_EMIT locksChanged();
  }
}

void SleepGuard::ask(const QString& what) {
  // @source org.freedesktop.login1(5), Inhibit
  QDBusMessage call = QDBusMessage::createMethodCall(
      QStringLiteral("org.freedesktop.login1"), QStringLiteral("/org/freedesktop/login1"),
      QStringLiteral("org.freedesktop.login1.Manager"), QStringLiteral("Inhibit"));
  call << what << QStringLiteral("Rivulet") << QStringLiteral("A program is being streamed")
       << QStringLiteral("block");
  auto* watcher = new QDBusPendingCallWatcher(m_bus.asyncCall(call), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, what, watcher, run = m_run] {
    watcher->deleteLater();
    const QDBusPendingReply<QDBusUnixFileDescriptor> reply = *watcher;
    if (reply.isError()) {
      log::logger().info("This computer may go to sleep during the run ({}): {}",
                         what.toStdString(), reply.error().message().toStdString());
    } else if (m_isHeld && run == m_run) {
      m_locks.push_back(reply.value());
      Q_EMIT locksChanged();
    }
  });
}

}  // namespace rivulet::hmi
