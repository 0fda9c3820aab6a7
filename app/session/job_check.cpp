// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/job_check.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace rivulet::session {

void JobCheck::cancel() {
  if (m_wanted) {
    m_wanted->store(false);
    m_wanted.reset();
  }
}

void JobCheck::start(std::shared_ptr<const job::Plan> plan,
                     std::shared_ptr<const machine::MachineConfig> machine) {
  cancel();
  m_wanted = std::make_shared<std::atomic<bool>>(true);
  QThreadPool::globalInstance()->start([self = QPointer<JobCheck>(this), wanted = m_wanted,
                                        plan = std::move(plan), machine = std::move(machine)] {
    if (!wanted->load()) {
      return;
    }
    const experiments::HazardOptions options{machine->start()};
    auto hazards =
        std::make_shared<const Hazards>(experiments::hazardsOf(*plan, *machine, options));
    // The context of the call is the application: `self` is only touched on its own thread.
    QMetaObject::invokeMethod(
        qApp,
        [self, wanted, hazards] {
          if (self && self->m_wanted == wanted) {
            self->m_wanted.reset();
            Q_EMIT self->finished(hazards);
          }
        },
        Qt::QueuedConnection);
  });
}

}  // namespace rivulet::session
