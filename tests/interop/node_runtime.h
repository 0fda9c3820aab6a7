// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Scripts of node that use node-opcua, each in a process of its own that dies with the test.
#pragma once

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QString>

#include "interop/script_process.h"

namespace rivulet::tests {

class NodeRuntime {
 public:
  /// Why no script can be started; empty: it can.
  [[nodiscard]] static QString obstacle() {
    return node().isEmpty() || modules().isEmpty()
               ? QStringLiteral(
                     "node-opcua is not installed: scripts/interop installs it and runs this test.")
               : QString();
  }

  /// @param script  a file of tests/interop
  static void start(QProcess& process, const QString& script, const QString& argument) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("NODE_PATH"), modules());
    process.setProcessEnvironment(environment);
    startScript(process, node(), script, argument);
  }

 private:
  static QString node() { return QStandardPaths::findExecutable(QStringLiteral("node")); }
  /// Where node finds the library; empty: nowhere.
  static QString modules() {
    const QString folder = qEnvironmentVariable(
        "RIVULET_NODE_MODULES", QStringLiteral(RIVULET_SOURCE_DIR "/build/interop/node_modules"));
    return QFile::exists(folder + QStringLiteral("/node-opcua/package.json")) ? folder : QString();
  }
};

}  // namespace rivulet::tests
