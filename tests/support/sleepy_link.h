// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A client that does nothing for a while, as on a computer that was suspended: in virtual time,
/// the link holds back what happens meanwhile. @threadsafety one thread.
#pragma once

#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "opcua/forwarding_link.h"

namespace rivulet::tests {

class SleepyLink final : public opcua::ForwardingLink {
 public:
  struct Sleep {
    base::Instant from{};
    base::Instant to{};
  };
  /// @param asleep  asked whenever the client waits: for how long it sleeps now
  SleepyLink(Link& link, std::function<base::Duration(base::Instant)> asleep)
      : ForwardingLink(link), m_asleep(std::move(asleep)) {}

  std::optional<opcua::Event> wait(base::Instant until) override {
    if (const base::Duration asleep = m_asleep(now()); asleep > base::Duration{}) {
      const base::Instant awake = now() + asleep;
      m_sleeps.push_back({now(), awake});
      while (now() < awake) {
        if (auto event = m_link.wait(awake)) {
          m_kept.push_back(std::move(*event));
        }
      }
    }
    if (m_kept.empty()) {
      return m_link.wait(until);
    }
    opcua::Event event = std::move(m_kept.front());
    m_kept.pop_front();
    return event;
  }
  [[nodiscard]] const std::vector<Sleep>& sleeps() const { return m_sleeps; }

 private:
  std::function<base::Duration(base::Instant)> m_asleep;
  std::vector<Sleep> m_sleeps;
  std::deque<opcua::Event> m_kept;
};

}  // namespace rivulet::tests
