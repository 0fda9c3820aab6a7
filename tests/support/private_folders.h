// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Programs that tests start keep nothing among the files of the person who runs the tests.
#pragma once

#include <QProcessEnvironment>
#include <QString>

namespace rivulet::tests {

/// The environment of the test, but settings, state and data are in this folder.
[[nodiscard]] inline QProcessEnvironment environmentIn(const QString& folder) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* kind : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
    environment.insert(QString::fromUtf8(kind), folder);
  }
  return environment;
}

}  // namespace rivulet::tests
