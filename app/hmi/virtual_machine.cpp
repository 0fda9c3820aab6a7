// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/virtual_machine.h"

#include <signal.h>
#include <sys/prctl.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include "hmi/helper_program.h"

namespace rivulet::hmi {

namespace {

constexpr int kEndMs = 3000;
constexpr qsizetype kLineBytesMax = 4096;

}  // namespace

QString sampleFile() {
  const QString here = QCoreApplication::applicationDirPath();
  for (const char* const folder :
       {"/../share/rivulet/programs", "/../../../../resources/programs"}) {
    const QFileInfo file(here + QLatin1String(folder) + QStringLiteral("/scorpion.tap"));
    if (file.isFile()) {
      return file.canonicalFilePath();
    }
  }
  return {};
}

VirtualMachine::VirtualMachine(QObject* parent) : QObject(parent) {
  m_process.setProcessChannelMode(QProcess::MergedChannels);
  m_process.setStandardInputFile(QProcess::nullDevice());
  m_process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
  connect(&m_process, &QProcess::readyRead, this, &VirtualMachine::read);
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      Q_EMIT failed(tr("The virtual machine cannot be started: %1").arg(m_process.errorString()));
    }
  });
  connect(&m_process, &QProcess::finished, this, [this] {
    read();
    Q_EMIT failed(m_hasListened ? tr("The virtual machine has ended.")
                                : tr("The virtual machine cannot be started: %1")
                                      .arg(QString::fromUtf8(m_line).trimmed()));
  });
}

VirtualMachine::~VirtualMachine() {
  m_process.disconnect(this);
  endProgram(m_process, kEndMs);
}

void VirtualMachine::start() {
  if (isOn()) {
    return;
  }
  const QString program =
      programOfRivulet(QStringLiteral("rivulet-machine"), QStringLiteral("machine"));
  if (program.isEmpty()) {
    Q_EMIT failed(tr("The program rivulet-machine is missing. Install it beside this window."));
    return;
  }
  m_line.clear();
  m_hasListened = false;
  m_process.start(program, {QStringLiteral("--port"), QStringLiteral("0")});
}

void VirtualMachine::read() {
  static const QRegularExpression address(QStringLiteral("opc\\.tcp://\\S+"));
  const QByteArray said = m_process.readAll();
  if (m_hasListened) {
    return;  // only so that it can go on writing
  }
  m_line = (m_line + said).right(kLineBytesMax);
  const QRegularExpressionMatch match = address.match(QString::fromUtf8(m_line));
  if (match.hasMatch() && m_line.indexOf('\n', match.capturedEnd()) >= 0) {
    m_hasListened = true;
    Q_EMIT listens(match.captured());
  }
}

}  // namespace rivulet::hmi
