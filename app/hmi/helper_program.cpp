// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/helper_program.h"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>

namespace rivulet::hmi {

QString programOfRivulet(const QString& name, const QString& folder) {
  const QString here = QCoreApplication::applicationDirPath();
  for (const QString& place : {here, here + QStringLiteral("/../") + folder}) {
    const QString found = QStandardPaths::findExecutable(name, {place});
    if (!found.isEmpty()) {
      return found;
    }
  }
  return QStandardPaths::findExecutable(name);
}

void endProgram(QProcess& process, int patienceMs) {
  if (process.state() == QProcess::NotRunning) {
    return;
  }
  process.terminate();
  if (!process.waitForFinished(patienceMs)) {
    process.kill();
    process.waitForFinished(patienceMs);
  }
}

}  // namespace rivulet::hmi
