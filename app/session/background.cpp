// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/background.h"

#include <QThreadPool>

namespace rivulet::session {

void startInPool(std::function<void()> work) {
  // Qt itself waits for the pool when the application has become unusable already.
  [[maybe_unused]] static const bool isAwaited = [] {
    qAddPostRoutine([] { QThreadPool::globalInstance()->waitForDone(); });
    return true;
  }();
  QThreadPool::globalInstance()->start(std::move(work));
}

void runInBackground(std::function<std::function<void()>()> work) {
  startInPool(
      [work = std::move(work)] { QMetaObject::invokeMethod(qApp, work(), Qt::QueuedConnection); });
}

}  // namespace rivulet::session
