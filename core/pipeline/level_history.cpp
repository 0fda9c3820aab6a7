// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/level_history.h"

#include <algorithm>
#include <utility>

namespace rivulet::pipeline {

void LevelHistory::add(base::Instant at, const std::array<int, kBufferCount>& levels) {
  auto index = static_cast<std::size_t>(at.time_since_epoch() / m_length);
  while (index >= kStretches) {
    halve();
    index /= 2;
  }
  // A stretch begins with the levels that the one before has left.
  while (m_stretches.size() <= index) {
    m_stretches.push_back({m_levels, m_levels});
  }
  m_levels = levels;
  Stretch& stretch = m_stretches.back();
  for (std::size_t i = 0; i < kBufferCount; ++i) {
    stretch.least[i] = std::min(stretch.least[i], levels[i]);
    stretch.greatest[i] = std::max(stretch.greatest[i], levels[i]);
  }
}

/// Two stretches become one.
void LevelHistory::halve() {
  std::vector<Stretch> longer;
  for (std::size_t i = 0; i < m_stretches.size(); i += 2) {
    Stretch stretch = m_stretches[i];
    if (i + 1 < m_stretches.size()) {
      for (std::size_t k = 0; k < kBufferCount; ++k) {
        stretch.least[k] = std::min(stretch.least[k], m_stretches[i + 1].least[k]);
        stretch.greatest[k] = std::max(stretch.greatest[k], m_stretches[i + 1].greatest[k]);
      }
    }
    longer.push_back(stretch);
  }
  m_stretches = std::move(longer);
  m_length *= 2;
}

}  // namespace rivulet::pipeline
