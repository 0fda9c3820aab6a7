// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a client sees of an R-parameter through a subscription, in virtual time: the server looks
/// at the value at fixed intervals, keeps the newest change, and sends it with the next
/// publication. A value sampled at a publication leaves with the following one: the publication
/// is put together first. @threadsafety one object, one thread.
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

  /// @param interval  asked for; not shorter than the preset allows. Sampling and publishing alike
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
