// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the test of whole jobs does to its own client: a permission reaches the control later than
/// the client believes, and a client is lost. @threadsafety as the link below.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "opcua/forwarding_link.h"

namespace rivulet::streaming {

class JobTestLink final : public opcua::ForwardingLink {
 public:
  /// @param run  the cell of the permission  @param beat  that of the signs of life
  JobTestLink(opcua::Link& link, const opcua::Variable& run, const opcua::Variable& beat)
      : ForwardingLink(link), m_run(run), m_beat{beat, 0.25} {}

  /// The next write of this permission, in a request of its own, is answered at once and made so
  /// much later.
  void withhold(double permission, base::Duration duration) {
    m_wanted = permission;
    m_duration = duration;
  }
  [[nodiscard]] bool isWithholding() const { return m_release.has_value(); }
  /// Nothing is sent any more: for the client the connection is lost.
  void lose() { m_isLost = m_isToldSoon = true; }

  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override {
    return m_isLost ? refuse() : m_link.read(variables, deadline, grouping);
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override {
    if (m_isLost) {
      return refuse();
    }
    if (m_wanted && assignments.size() == 1 && assignments.front().variable == m_run &&
        assignments.front().value == *m_wanted) {
      m_wanted.reset();
      m_withheld = assignments.front();
      m_release = now() + m_duration;
      return m_link.write({&m_beat, 1}, deadline, grouping);  // the answer to be given meanwhile
    }
    return m_link.write(assignments, deadline, grouping);
  }
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override {
    return m_isLost ? refuse() : m_link.readTrace(from, deadline);
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    if (m_isToldSoon) {
      m_isToldSoon = false;
      opcua::Event event;
      event.kind = opcua::EventKind::ConnectionLost;
      event.sent = event.at = now();
      event.error =
          base::makeError(opcua::LinkError::ConnectionLost, "The test has left its client alone.");
      return event;
    }
    for (;;) {
      if (m_release && now() >= *m_release) {
        m_release.reset();
        m_late = m_link.write({&m_withheld, 1}, opcua::kSilenceMax, opcua::Grouping::List);
      }
      std::optional<opcua::Event> event =
          m_link.wait(m_release ? std::min(until, *m_release) : until);
      const bool isLate = event && m_late && event->request == *m_late;
      if (isLate) {
        m_late.reset();
      }
      if (event && !isLate && !m_isLost) {
        return event;
      }
      if (!event && now() >= until) {
        return std::nullopt;
      }
    }
  }

 private:
  /// Whoever asks is told once more.
  base::RequestId refuse() {
    m_isToldSoon = true;
    return {};
  }

  opcua::Variable m_run;
  opcua::Assignment m_beat;
  std::optional<double> m_wanted;
  base::Duration m_duration{};
  opcua::Assignment m_withheld;
  std::optional<base::Instant> m_release;
  std::optional<base::RequestId> m_late;
  bool m_isLost = false;
  bool m_isToldSoon = false;  ///< that the connection is lost
};

}  // namespace rivulet::streaming
