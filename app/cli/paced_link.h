// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A simulated link at the pace of the wall clock, for sources that live in real time.
/// @threadsafety one object, one thread.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "opcua/forwarding_link.h"

namespace rivulet::cli {

class PacedLink final : public opcua::ForwardingLink {
 public:
  /// @param link  in virtual time; outlives this object
  explicit PacedLink(opcua::Link& link) : ForwardingLink(link), m_virtualStart(link.now()) {}

  std::optional<opcua::Event> wait(base::Instant until) override {
    std::optional<opcua::Event> event = m_link.wait(until);
    std::this_thread::sleep_until(m_start + (m_link.now() - m_virtualStart));
    return event;
  }

 private:
  base::Instant m_virtualStart;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace rivulet::cli
