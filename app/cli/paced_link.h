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

#include "opcua/link.h"

namespace rivulet::cli {

class PacedLink final : public opcua::Link {
 public:
  /// @param link  in virtual time; outlives this object
  explicit PacedLink(opcua::Link& link) : m_link(link), m_virtualStart(link.now()) {}

  base::Instant now() const override { return m_link.now(); }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override {
    return m_link.read(variables, deadline, grouping);
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override {
    return m_link.write(assignments, deadline, grouping);
  }
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override {
    return m_link.store(name, text, deadline);
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    std::optional<opcua::Event> event = m_link.wait(until);
    std::this_thread::sleep_until(m_start + (m_link.now() - m_virtualStart));
    return event;
  }
  [[nodiscard]] base::Duration silence() const override { return m_link.silence(); }

 private:
  opcua::Link& m_link;
  base::Instant m_virtualStart;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace rivulet::cli
