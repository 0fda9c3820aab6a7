// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Work that would stop the window: it runs in a pool of threads, and the GUI thread takes what
/// came out.
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <functional>
#include <utility>

namespace rivulet::session {

/// Runs work in the pool. It may use the application, which waits for it when it ends.
/// @threadsafety GUI thread
void startInPool(std::function<void()> work);
/// Waits until everything in the pool is done, also what is not begun.
void awaitPool();
/// So much is done at once; the rest waits.
[[nodiscard]] int poolThreads();

/// Runs work in the pool; what it returns is then called on the GUI thread.
void runInBackground(std::function<std::function<void()>()> work);

/// Calls `call(object)` in the event loop of the GUI thread, unless the object is gone by then.
/// @threadsafety Any thread: the application is the context of the call, so the object is looked at
/// on its own thread only.
template <class Object, class Call>
void callLater(const QPointer<Object>& object, Call call) {
  QMetaObject::invokeMethod(
      qApp,
      [object, call = std::move(call)]() mutable {
        if (object) {
          call(*object);
        }
      },
      Qt::QueuedConnection);
}

/// Runs `compute()` in the pool, then `take(object, result)` on the GUI thread, unless the
/// object is gone by then. Both must be copyable, and so must the result.
template <class Object, class Compute, class Take>
void inBackground(Object* object, Compute compute, Take take) {
  runInBackground([object = QPointer<Object>(object), compute = std::move(compute),
                   take = std::move(take)]() mutable -> std::function<void()> {
    return [object, take, result = compute()]() mutable {
      if (object) {
        take(*object, std::move(result));
      }
    };
  });
}

}  // namespace rivulet::session
