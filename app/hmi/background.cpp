// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/background.h"

#include <QCoreApplication>
#include <QThreadPool>
#include <utility>

namespace rivulet::hmi {

void runInBackground(std::function<std::function<void()>()> work) {
  QThreadPool::globalInstance()->start(
      [work = std::move(work)] { QMetaObject::invokeMethod(qApp, work(), Qt::QueuedConnection); });
}

}  // namespace rivulet::hmi
