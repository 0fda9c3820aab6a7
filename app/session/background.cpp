// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/background.h"

#include <QThreadPool>

namespace rivulet::session {

void runInBackground(std::function<std::function<void()>()> work) {
  QThreadPool::globalInstance()->start(
      [work = std::move(work)] { QMetaObject::invokeMethod(qApp, work(), Qt::QueuedConnection); });
}

}  // namespace rivulet::session
