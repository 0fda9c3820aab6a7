// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Scripts of Python that use asyncua, each in a process of its own that dies with the test.
#pragma once

#include <QFile>
#include <QProcess>
#include <QString>

#include "interop/script_process.h"

namespace rivulet::tests {

class PythonRuntime {
 public:
  /// Why no script can be started; empty: it can.
  [[nodiscard]] static QString obstacle() {
    QProcess process;
    process.start(python(), {QStringLiteral("-c"), QStringLiteral("import asyncua")});
    return process.waitForFinished() && process.exitStatus() == QProcess::NormalExit &&
                   process.exitCode() == 0
               ? QString()
               : QStringLiteral(
                     "asyncua is not installed: scripts/interop installs it and runs this test.");
  }

  /// @param script  a file of tests/interop
  static void start(QProcess& process, const QString& script, const QString& argument) {
    startScript(process, python(), script, argument);
  }

 private:
  static QString python() {
    const QString own = QStringLiteral(RIVULET_SOURCE_DIR "/build/interop/python/bin/python3");
    return qEnvironmentVariable("RIVULET_PYTHON",
                                QFile::exists(own) ? own : QStringLiteral("python3"));
  }
};

}  // namespace rivulet::tests
