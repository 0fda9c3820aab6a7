// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The operator's window in a process of its own, operated by its pilot (gui/pilot/pilot.cpp): its
/// buttons are pressed by their names. Ended with the object. @threadsafety the test's thread.
#pragma once

#include <sys/prctl.h>

#include <QByteArrayList>
#include <QDeadlineTimer>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <csignal>
#include <vector>

#include "support/patience.h"

namespace rivulet::tests {

/// A window as an operator starts it, and what its pilot says.
class WindowProcess {
 public:
  /// @param environment  with its homes @param machine  endpoint @param program  file; empty: the
  /// window is not told any
  WindowProcess(QProcessEnvironment environment, const QString& machine, const QString& program) {
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    environment.insert(QStringLiteral("QT_PLUGIN_PATH"), QStringLiteral(RIVULET_PILOT_PLUGINS));
    environment.insert(QStringLiteral("QT_QPA_GENERIC_PLUGINS"), QStringLiteral("rivulet-pilot"));
    m_process.setProcessEnvironment(environment);
    m_process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    QStringList arguments{QStringLiteral("--connect"), machine};
    if (!program.isEmpty()) {
      arguments << QStringLiteral("--open") << program;
    }
    m_process.start(QStringLiteral(RIVULET_PROGRAM), arguments);
    if (!m_process.waitForStarted(kRunMs)) {
      qFatal("rivulet does not start");
    }
  }
  ~WindowProcess() {
    m_process.kill();
    m_process.waitForFinished();
  }

  [[nodiscard]] bool isOpen() const { return m_process.state() == QProcess::Running; }
  /// @return the answer; empty, with a warning: there was none
  QByteArray ask(const QByteArray& command) {
    m_process.write(command + '\n');
    m_history << command;
    m_answer.clear();
    if (!waitFor([this] { return !m_answer.isEmpty(); })) {
      complain();
    }
    return m_answer;
  }
  /// Waits until the window shows one of these states.
  bool awaitState(const std::vector<const char*>& states) {
    const bool isShown = waitFor([&] {
      return std::any_of(states.begin(), states.end(),
                         [this](const char* state) { return m_state.startsWith(state); });
    });
    if (!isShown) {
      complain();
    }
    return isShown;
  }
  [[nodiscard]] bool isIn(const char* state) const { return m_state.startsWith(state); }
  /// Lets it work for a while. @return whether its run is still in progress
  bool works(int ms) {
    const QDeadlineTimer until(ms);
    return waitFor([&] { return until.hasExpired() || isIn("Done"); }) && !isIn("Done");
  }
  void signal(int number) { ::kill(static_cast<pid_t>(m_process.processId()), number); }
  /// Waits until it has ended. @return exit code; -1: killed, or it does not end
  int exit() {
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(kRunMs)) {
      return -1;
    }
    return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
  }

 private:
  static constexpr int kPollMs = 10;

  /// Takes what the pilot says until the condition holds. @return false if it never did
  template <class Condition>
  bool waitFor(const Condition& condition) {
    const QDeadlineTimer patience(kRunMs);
    while (!condition()) {
      if (patience.hasExpired() || (!isOpen() && !m_process.canReadLine())) {
        return false;
      }
      if (!m_process.canReadLine()) {
        m_process.waitForReadyRead(kPollMs);
        continue;
      }
      const QByteArray line = m_process.readLine().trimmed();
      m_history << line;
      (line.startsWith("state: ") ? m_state : m_answer) =
          line.startsWith("state: ") ? line.mid(7) : line;
    }
    return true;
  }

  void complain() {
    qWarning("%s\n%s", m_history.join('\n').constData(),
             m_process.readAllStandardError().constData());
  }

  QProcess m_process;
  QByteArrayList m_history;  ///< what it was told and what it said
  QByteArray m_state;
  QByteArray m_answer;
};

}  // namespace rivulet::tests
