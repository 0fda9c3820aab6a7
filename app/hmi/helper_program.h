// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Programs of Rivulet that the window starts. @threadsafety GUI thread.
#pragma once

#include <QString>

class QProcess;

namespace rivulet::hmi {

/// A program of Rivulet: beside this one, where it is built, or where the system finds programs.
/// @param folder  of the build, beside that of this program @return empty: it is not there
[[nodiscard]] QString programOfRivulet(const QString& name, const QString& folder);

/// Ends a program that runs: it is asked to, and killed if it goes on for `patienceMs`.
void endProgram(QProcess& process, int patienceMs);

}  // namespace rivulet::hmi
