// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An R-parameter as a client sees it through a subscription, in virtual time: the server samples
/// the value at fixed intervals, keeps the newest change, and sends it with the next publication. A
/// value sampled at the time of a publication is sent with the following one, because the
/// publication is assembled first. @threadsafety one object, one thread.
#pragma once

#include <optional>
#include <vector>

#include "machine/machine.h"

namespace rivulet::machine {

class SubscriptionModel {
 public:
  struct Notification {
    base::Instant at{};
    double value = 0.0;
  };

  /// @param interval requested; at least the preset's minimum. For both sampling and publishing
  /// @param start     first sample
  SubscriptionModel(Machine& machine, int rParameter, base::Duration interval, base::Instant start);

  [[nodiscard]] base::Duration revisedInterval() const { return m_interval; }

  /// Advances machine and subscription. @return what has been sent meanwhile
  [[nodiscard]] std::vector<Notification> advance(base::Instant until);

 private:
  Machine& m_machine;
  int m_rParameter;
  base::Duration m_interval;
  base::Instant m_next;
  std::optional<double> m_sampled;  ///< nothing before the first sample
  std::optional<double> m_queued;
};

}  // namespace rivulet::machine
