// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-machine` in a process of its own, on a free port unless told otherwise, ended with the
/// object. If the test dies before that, the machine dies with it: it would keep the pipe open
/// whose end ctest waits for.
#pragma once

#include <sys/prctl.h>

#include <QCoreApplication>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <csignal>

#include "support/patience.h"

namespace rivulet::tests {

/// For a server that is ended and started again under the same address: a port of this process,
/// below those the system gives to clients. Of those, another test's client may take one while
/// the server is away.
[[nodiscard]] inline QString portOfThisProcess() {
  constexpr qint64 kFirstPort = 21'000;
  constexpr qint64 kPorts = 8000;
  return QString::number(kFirstPort + QCoreApplication::applicationPid() % kPorts);
}

class MachineProcess {
 public:
  /// @param program  the executable @param arguments  beside the port; a "--port" wins
  explicit MachineProcess(const QString& program, QStringList arguments = {}) {
    if (!arguments.contains(QStringLiteral("--port"))) {
      arguments << QStringLiteral("--port") << QStringLiteral("0");
    }
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    m_process.start(program, arguments);
    while (m_process.state() != QProcess::NotRunning && !m_process.canReadLine()) {
      m_process.waitForReadyRead(kRunMs);
    }
    m_endpoint = QString::fromUtf8(m_process.readLine()).trimmed();
  }
  ~MachineProcess() {
    m_process.terminate();
    if (!m_process.waitForFinished(kRunMs)) {
      kill();
    }
  }
  MachineProcess(const MachineProcess&) = delete;
  MachineProcess& operator=(const MachineProcess&) = delete;

  /// "opc.tcp://127.0.0.1:40123"; empty if it did not start.
  [[nodiscard]] const QString& endpoint() const { return m_endpoint; }
  /// As if its power failed.
  void kill() {
    m_process.kill();
    m_process.waitForFinished(kRunMs);
  }

 private:
  QProcess m_process;
  QString m_endpoint;
};

}  // namespace rivulet::tests
