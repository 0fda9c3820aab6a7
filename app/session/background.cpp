// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/background.h"

#include <QThreadPool>

namespace rivulet::session {

namespace {

/// Qt draws with the threads of its global pool, and waits for them: what takes minutes there stops
/// the window.
QThreadPool& pool() {
  static QThreadPool own;
  return own;
}

}  // namespace

void startInPool(std::function<void()> work) {
  // Its destructor would wait when the application has become unusable already.
  [[maybe_unused]] static const bool isAwaited = [] {
    qAddPostRoutine(awaitPool);
    return true;
  }();
  pool().start(std::move(work));
}

void awaitPool() {
  pool().waitForDone();
}

int poolThreads() {
  return pool().maxThreadCount();
}

void runInBackground(std::function<std::function<void()>()> work) {
  startInPool(
      [work = std::move(work)] { QMetaObject::invokeMethod(qApp, work(), Qt::QueuedConnection); });
}

}  // namespace rivulet::session
