// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A server of an OPC UA stack that others wrote, in front of `rivulet-machine`, in a process of
/// its own that ends with the object: node_opcua_front.js, or asyncua_front.py.
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>

#include "interop/node_runtime.h"
#include "interop/python_runtime.h"
#include "support/patience.h"

namespace rivulet::tests {

/// Whose server and client it is.
enum class Stack { NodeOpcua, Asyncua };

class FrontProcess {
 public:
  /// Why it cannot be started; empty: it can.
  [[nodiscard]] static QString obstacle(Stack stack) {
    return stack == Stack::Asyncua ? PythonRuntime::obstacle() : NodeRuntime::obstacle();
  }

  /// @param folder  for the plan and the certificates
  FrontProcess(Stack stack, QJsonObject plan, const QString& folder) {
    plan.insert(QStringLiteral("folder"), folder);
    QFile file(folder + QStringLiteral("/plan.json"));
    if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(plan).toJson()) < 0) {
      return;
    }
    file.close();
    if (stack == Stack::Asyncua) {
      PythonRuntime::start(m_process, QStringLiteral("asyncua_front.py"), file.fileName());
    } else {
      NodeRuntime::start(m_process, QStringLiteral("node_opcua_front.js"), file.fileName());
    }
    while (m_endpoint.isEmpty() &&
           (m_process.canReadLine() || m_process.waitForReadyRead(kRunMs))) {
      const QJsonObject said = QJsonDocument::fromJson(m_process.readLine()).object();
      m_endpoint = said[QStringLiteral("endpoint")].toString();
      m_fingerprint = said[QStringLiteral("fingerprint")].toString();
    }
  }
  ~FrontProcess() {
    m_process.terminate();
    m_process.waitForFinished(kRunMs);
  }
  FrontProcess(const FrontProcess&) = delete;
  FrontProcess& operator=(const FrontProcess&) = delete;

  /// Empty if it did not start.
  [[nodiscard]] const QString& endpoint() const { return m_endpoint; }
  [[nodiscard]] const QString& fingerprint() const { return m_fingerprint; }

 private:
  QProcess m_process;
  QString m_endpoint;
  QString m_fingerprint;
};

}  // namespace rivulet::tests
