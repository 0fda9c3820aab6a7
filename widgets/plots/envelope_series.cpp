// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/envelope_series.h"

#include <cmath>

namespace rivulet::widgets {

namespace {

base::Instant instant(double seconds) {
  return base::Instant{base::fromSeconds(seconds)};
}

}  // namespace

void EnvelopeSeries::append(double atS, double value) {
  // Samples of different sources may have the same time, but are never older than the previous one.
  base::Instant at = instant(atS);
  if (!m_envelope.empty() && at < m_envelope[m_envelope.size() - 1].at) {
    at = m_envelope[m_envelope.size() - 1].at;
  }
  m_envelope.append(at, value);
}

std::vector<QList<QPointF>> EnvelopeSeries::lines(double fromS, double toS,
                                                  std::size_t columns) const {
  std::vector<QList<QPointF>> lines;
  if (m_envelope.empty() || !(toS > fromS)) {
    return lines;
  }
  QList<QPointF> line;
  for (const trace::SeriesPoint& point :
       m_envelope.visible(instant(fromS), instant(toS), columns)) {
    if (std::isfinite(point.value)) {
      line.append(QPointF(base::toSeconds(point.at), point.value));
    } else if (!line.isEmpty()) {
      lines.push_back(std::move(line));
      line = {};
    }
  }
  if (!line.isEmpty()) {
    lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<trace::ValueRange> EnvelopeSeries::range(double fromS, double toS) const {
  if (m_envelope.empty() || !(toS >= fromS)) {
    return std::nullopt;
  }
  return m_envelope.range(instant(fromS), instant(toS));
}

}  // namespace rivulet::widgets
