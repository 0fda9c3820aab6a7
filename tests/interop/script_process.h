// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the scripts of tests/interop are started.
#pragma once

#include <sys/prctl.h>

#include <QProcess>
#include <QString>
#include <csignal>

namespace rivulet::tests {

/// The process dies with the test. @param script  a file of tests/interop
inline void startScript(QProcess& process, const QString& interpreter, const QString& script,
                        const QString& argument) {
  process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
  process.start(interpreter,
                {QStringLiteral(RIVULET_SOURCE_DIR "/tests/interop/") + script, argument});
}

}  // namespace rivulet::tests
