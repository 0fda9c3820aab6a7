// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Work in the pool is still in progress when the application ends: it must find the application. A
// program of its own, because an application ends once.

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSemaphore>
#include <cstdio>

#include "session/background.h"

namespace {

QSemaphore& ending() {
  static QSemaphore semaphore;
  return semaphore;
}

}  // namespace

int main(int argc, char** argv) {
  bool isThere = true;
  {
    const QCoreApplication application(argc, argv);
    rivulet::session::startInPool([&isThere] {
      ending().acquire();
      // An application that does not wait for this work has gone before the time is over.
      constexpr qint64 kObservedMs = 500;
      QElapsedTimer since;
      since.start();
      while (isThere && since.elapsed() < kObservedMs) {
        isThere = QCoreApplication::instance() != nullptr;
      }
    });
    // What was added last is called first.
    qAddPostRoutine([] { ending().release(); });
  }
  std::printf("%s\n", isThere ? "The application waits for work in progress."
                              : "The application has gone while work was in progress.");
  return isThere ? 0 : 1;
}
