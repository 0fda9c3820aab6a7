// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Base of links that stand in front of another one and change a part of it.
/// @threadsafety one object, one thread; as the link behind it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "opcua/link.h"

namespace rivulet::opcua {

/// Passes everything on.
class ForwardingLink : public Link {
 public:
  /// @param link  outlives this object
  explicit ForwardingLink(Link& link) : m_link(link) {}

  [[nodiscard]] base::Instant now() const override { return m_link.now(); }
  base::RequestId read(std::span<const Variable> variables, base::Duration deadline,
                       Grouping grouping) override {
    return m_link.read(variables, deadline, grouping);
  }
  base::RequestId write(std::span<const Assignment> assignments, base::Duration deadline,
                        Grouping grouping) override {
    return m_link.write(assignments, deadline, grouping);
  }
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override {
    return m_link.store(name, text, deadline);
  }
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override {
    return m_link.readTrace(from, deadline);
  }
  std::optional<Event> wait(base::Instant until) override { return m_link.wait(until); }
  [[nodiscard]] base::Duration silence() const override { return m_link.silence(); }

 protected:
  Link& m_link;
};

}  // namespace rivulet::opcua
