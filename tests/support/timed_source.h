// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source in virtual time.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "live/source.h"
#include "opcua/link.h"

namespace rivulet::tests {

/// Says its lines at their times, counted from the first time it is asked.
class TimedSource : public live::Source {
 public:
  /// @param link  tells the time; outlives this object
  explicit TimedSource(const opcua::Link& link) : m_link(link) {}
  void say(base::Duration at, const std::string& text) { m_lines.emplace(at, text); }
  void closeAt(base::Duration at) { m_closes = at; }

  std::string name() const override { return "script"; }
  std::size_t read(std::span<char> into) override {
    const base::Duration now = time();
    for (auto next = m_lines.begin(); next != m_lines.end() && next->first <= now;
         next = m_lines.erase(next)) {
      m_text += next->second;
    }
    const std::size_t count = std::min(into.size(), m_text.size());
    std::copy_n(m_text.begin(), count, into.begin());
    m_text.erase(0, count);
    return count;
  }
  bool isClosed() const override { return m_text.empty() && m_closes && time() >= *m_closes; }

 protected:
  [[nodiscard]] base::Duration time() const {
    m_first = m_first.value_or(m_link.now());
    return m_link.now() - *m_first;
  }

 private:
  const opcua::Link& m_link;
  std::multimap<base::Duration, std::string> m_lines;
  std::string m_text;
  std::optional<base::Duration> m_closes;
  mutable std::optional<base::Instant> m_first;
};

}  // namespace rivulet::tests
