// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/rate.h"

#include "base/units.h"

namespace rivulet::live {

void Rate::add(base::Instant now, std::size_t count) {
  const std::size_t size = m_values.size();
  if (size >= 2 && m_values[size - 1].first - m_values[size - 2].first < kStep) {
    m_values.pop_back();  // the newest one stands for all of its step
  }
  m_values.emplace_back(now, count);
  // The one before the window stays: the window begins between it and the next.
  while (m_values.size() > 2 && now - m_values[1].first >= kWindow) {
    m_values.pop_front();
  }
}

double Rate::perS() const {
  if (m_values.size() < 2) {
    return 0.0;
  }
  const auto& [first, before] = m_values.front();
  const auto& [last, after] = m_values.back();
  const double seconds = base::toSeconds(last - first);
  return seconds > 0.0 ? static_cast<double>(after - before) / seconds : 0.0;
}

}  // namespace rivulet::live
