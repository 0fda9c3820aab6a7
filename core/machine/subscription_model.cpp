// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/subscription_model.h"

#include <algorithm>

namespace rivulet::machine {

SubscriptionModel::SubscriptionModel(Machine& machine, int rParameter, base::Duration interval,
                                     base::Instant start)
    : m_machine(machine),
      m_rParameter(rParameter),
      m_interval(std::max(interval, machine.config().access.samplingMin)),
      m_next(start) {
}

std::vector<SubscriptionModel::Notification> SubscriptionModel::advance(base::Instant until) {
  std::vector<Notification> sent;
  for (; m_next <= until; m_next += m_interval) {
    m_machine.advance(m_next);
    if (m_queued) {
      sent.push_back({m_next, *m_queued});
      m_queued.reset();
    }
    const double value = m_machine.ncRParameter(m_rParameter);
    if (!m_sampled || *m_sampled != value) {
      m_sampled = value;
      m_queued = value;
    }
  }
  m_machine.advance(until);
  return sent;
}

}  // namespace rivulet::machine
