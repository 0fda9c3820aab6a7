// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/correction.h"

#include <algorithm>
#include <cmath>

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;

/// At most 20 writes a second: faster than any drift that is worth a correction, and a small part
/// of what the variable service can do.
constexpr Duration kWriteInterval = std::chrono::milliseconds{50};
/// If the stream leaves no slack, a correction waits at most this long.
constexpr Duration kAgeMax = std::chrono::milliseconds{500};
/// A correction that the control confirms is noted this often at most.
constexpr Duration kNoteInterval = std::chrono::seconds{1};

}  // namespace

CorrectionCells::CorrectionCells(const templates::CellMap& cells,
                                 const templates::TemplateParameters& parameters)
    : m_limitMm(templates::correctionSteps(parameters) / 1000.0), m_lifts(cells.lifts) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.correction[axis] >= 0) {
      m_axes.push_back(axis);
      m_writes.push_back({opcua::rParameter(cells.correction[axis]), 0.0});
    }
  }
}

void CorrectionCells::want(base::Vec3 wantedMm, Instant now) {
  const bool waited = m_value.askedMm != m_sentMm || m_isUnsure;
  for (const std::size_t axis : m_axes) {
    if (!std::isnan(wantedMm[axis])) {
      m_value.askedMm.set(axis, std::clamp(wantedMm[axis], -m_limitMm, m_limitMm));
    }
  }
  if (!waited && m_value.askedMm != m_sentMm) {
    m_waitsSince = now;
  }
}

bool CorrectionCells::isDue(Instant now) const {
  return exists() && (m_value.askedMm != m_sentMm || m_isUnsure) && now >= m_nextWrite;
}

bool CorrectionCells::isOverdue(Instant now) const {
  return isDue(now) && now - m_waitsSince >= kAgeMax;
}

std::span<const opcua::Assignment> CorrectionCells::take(Instant now) {
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    m_writes[i].value = m_value.askedMm[m_axes[i]];
  }
  m_sentMm = m_value.askedMm;
  m_isUnsure = false;
  m_waitsSince = now;
  m_nextWrite = now + kWriteInterval;
  return m_writes;
}

void CorrectionCells::confirm() {
  m_value.confirmedMm = m_sentMm;
}

std::optional<base::Vec3> CorrectionCells::toNote(Instant now, bool atOnce) {
  if (m_value.confirmedMm == m_notedMm || (!atOnce && now - m_notedAt < kNoteInterval)) {
    return std::nullopt;
  }
  m_notedMm = m_value.confirmedMm;
  m_notedAt = now;
  return m_notedMm;
}

void CorrectionCells::lost() {
  m_isUnsure = true;
}

}  // namespace rivulet::streaming
