// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-service` in a process of its own, on a free port, and what tests ask of it.
/// @threadsafety the test's thread.
#pragma once

#include <sys/prctl.h>

#include <QDebug>
#include <QElapsedTimer>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <QThread>
#include <csignal>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "service/service_client.h"
#include "support/patience.h"

namespace rivulet::tests {

class ServiceProcess {
 public:
  using Values = std::map<std::string, std::string>;

  /// @param options  beside the port; a "--port" wins
  ServiceProcess(const QString& program, const QString& machine,
                 const QProcessEnvironment& environment, QStringList options = {}) {
    if (!options.contains(QStringLiteral("--port"))) {
      options << QStringLiteral("--port") << QStringLiteral("0");
    }
    m_process.setProcessEnvironment(environment);
    m_process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    m_process.start(program, QStringList{QStringLiteral("run"), machine} + options);
    while (m_process.state() != QProcess::NotRunning && !m_process.canReadLine()) {
      m_process.waitForReadyRead(kRunMs);
    }
    m_endpoint = QString::fromUtf8(m_process.readLine()).trimmed();
    if (!m_endpoint.isEmpty()) {
      connect();
    }
  }
  ~ServiceProcess() {
    m_client.reset();
    if (m_process.state() != QProcess::NotRunning) {
      end(SIGTERM);
    }
  }
  ServiceProcess(const ServiceProcess&) = delete;
  ServiceProcess& operator=(const ServiceProcess&) = delete;

  /// Empty: it did not start.
  [[nodiscard]] const QString& endpoint() const { return m_endpoint; }
  /// @return its exit code; -1: it had to be killed, or was
  int end(int signal) {
    m_client.reset();
    ::kill(static_cast<pid_t>(m_process.processId()), signal);
    return finish();
  }
  int finish() {
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(kRunMs)) {
      m_process.kill();
      m_process.waitForFinished(kRunMs);
      return -1;
    }
    return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
  }
  [[nodiscard]] QString errors() { return QString::fromUtf8(m_process.readAllStandardError()); }

  void connect() {
    auto client = service::ServiceClient::connect(m_endpoint.toStdString());
    if (!client) {
      qFatal("the service does not answer: %s", client.error().text().c_str());
    }
    m_client = *std::move(client);
  }
  [[nodiscard]] Values read() {
    const auto values = m_client->read();
    return values ? *values : Values{};
  }
  [[nodiscard]] std::string value(const std::string& name) {
    const Values values = read();
    const auto found = values.find(name);
    return found == values.end() ? std::string("(no answer)") : found->second;
  }
  service::Answer call(const std::string& method, const std::vector<std::string>& inputs = {}) {
    const auto answer = m_client->call(method, inputs);
    return answer ? *answer : service::Answer{false, answer.error().text(), {}};
  }
  /// Calls a method until it gives a confirmation. @return empty: it is refused
  std::string confirmation(const std::string& method) {
    service::Answer answer;
    awaitThat([&](const Values&) {
      answer = call(method);
      return !service::isNotYet(answer);
    });
    m_refusal = answer.accepted ? std::string() : answer.message;
    return answer.confirmation;
  }
  /// Why the last `confirmation` was refused; empty: it was not.
  [[nodiscard]] const std::string& refusal() const { return m_refusal; }
  /// @return false: it did not come true
  bool awaitThat(const std::function<bool(const Values&)>& isTrue) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < kRunMs) {
      const Values values = read();
      if (values.empty()) {
        return false;
      }
      if (isTrue(values)) {
        return true;
      }
      QThread::msleep(kPollMs);
    }
    return false;
  }
  /// Waits until so many points of the run have been executed.
  bool awaitPoints(int points) {
    return awaitThat([points](const Values& values) {
      return std::stoi(values.at("Production/ActiveProgram/PointsDone")) >= points;
    });
  }
  bool await(const std::string& name, const std::string& value) {
    const bool came = awaitThat([&](const Values& values) { return values.at(name) == value; });
    if (!came) {
      for (const auto& [key, seen] : read()) {
        qWarning("%s=%s", key.c_str(), seen.c_str());
      }
    }
    return came;
  }

 private:
  static constexpr unsigned kPollMs = 20;

  QProcess m_process;
  QString m_endpoint;
  std::string m_refusal;
  std::unique_ptr<service::ServiceClient> m_client;
};

}  // namespace rivulet::tests
