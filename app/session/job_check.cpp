// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/job_check.h"

#include "session/background.h"

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
  inBackground(
      this,
      [wanted = m_wanted, plan = std::move(plan), machine = std::move(machine)] {
        if (!wanted->load()) {
          return std::shared_ptr<const forecast::CheckedJob>();
        }
        const forecast::HazardOptions options{machine->start()};
        return std::make_shared<const forecast::CheckedJob>(
            forecast::checkJob(*plan, *machine, options));
      },
      [wanted = m_wanted](JobCheck& self,
                          const std::shared_ptr<const forecast::CheckedJob>& checked) {
        if (checked && self.m_wanted == wanted) {
          self.m_wanted.reset();
          Q_EMIT self.finished(checked);
        }
      });
}

}  // namespace rivulet::session
