// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/program_loader.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <filesystem>

namespace rivulet::session {

void ProgramLoader::load(const QString& path) {
  const int request = ++m_latest;
  QThreadPool::globalInstance()->start([self = QPointer<ProgramLoader>(this), path, request] {
    auto result = std::make_shared<base::Result<gcode::Program>>(
        gcode::loadProgram(std::filesystem::path(path.toStdString())));
    // The context of the call is the application: `self` is only touched on its own thread.
    QMetaObject::invokeMethod(
        qApp,
        [self, path, request, result] {
          if (!self || self->m_latest != request) {
            return;
          }
          if (*result) {
            Q_EMIT self->loaded(std::make_shared<const gcode::Program>(std::move(**result)), path);
          } else {
            Q_EMIT self->failed(result->error(), path);
          }
        },
        Qt::QueuedConnection);
  });
}

}  // namespace rivulet::session
