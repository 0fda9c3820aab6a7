// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Keeps this computer awake while a run is in progress: a computer that goes to sleep delivers no
/// windows, and after ten seconds the run has ended. Asks systemd-logind for inhibitor locks, over
/// D-Bus; they end with this program, however that ends. Where there is no logind nothing happens.
/// @threadsafety GUI thread.
#pragma once

#include <QDBusConnection>
#include <QDBusUnixFileDescriptor>
#include <QObject>
#include <vector>

namespace rivulet::hmi {

class SleepGuard final : public QObject {
  Q_OBJECT

 public:
  /// @param bus  of logind: the system's
  explicit SleepGuard(QDBusConnection bus, QObject* parent = nullptr);

  /// From now on this computer is to stay awake, also with its lid closed. The answer of logind is
  /// not waited for: it may refuse.
  void hold();
  void release();
  /// Locks that logind has given.
  [[nodiscard]] std::size_t locks() const { return m_locks.size(); }

 Q_SIGNALS:
  void locksChanged();

 private:
  void ask(const QString& what);

  QDBusConnection m_bus;
  std::vector<QDBusUnixFileDescriptor> m_locks;
  unsigned m_run = 0;  ///< answers to the questions of an earlier one are dropped
  bool m_isHeld = false;
};

}  // namespace rivulet::hmi
