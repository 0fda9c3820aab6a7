// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/plots/time_window.h"

#include <algorithm>

namespace rivulet::widgets {

namespace {

constexpr double kLiveSpanS = 15.0;
constexpr double kSpanMinS = 0.002;  // a few cycles of the control
constexpr double kSpanMaxS = 1e6;

}  // namespace

TimeWindow::TimeWindow(QObject* parent)
    : QObject(parent), m_toS(kLiveSpanS), m_liveSpanS(kLiveSpanS) {
}

void TimeWindow::setEnd(double endS) {
  m_endS = std::max(m_endS, endS);
  if (m_isLive) {
    const double to = std::max(m_endS, m_liveSpanS);
    show(to - m_liveSpanS, to);
  }
}

void TimeWindow::setLength(double lengthS) {
  m_endS = lengthS;
  showAll();
}

void TimeWindow::clear() {
  m_endS = 0.0;
  goLive();
}

void TimeWindow::goLive() {
  m_isLive = true;
  const double to = std::max(m_endS, m_liveSpanS);
  show(to - m_liveSpanS, to);
  Q_EMIT changed();
}

void TimeWindow::showAll() {
  m_isLive = false;
  show(0.0, std::max(m_endS, kSpanMinS));
}

void TimeWindow::pan(double byS) {
  m_isLive = false;
  const double span = m_toS - m_fromS;
  // Part of the data always stays visible.
  const double from = std::clamp(m_fromS + byS, -0.9 * span, std::max(m_endS - 0.1 * span, 0.0));
  show(from, from + span);
}

void TimeWindow::zoom(double factor, double aroundS) {
  m_isLive = false;
  const double span = m_toS - m_fromS;
  const double spanMax = std::clamp(4.0 * m_endS, kLiveSpanS, kSpanMaxS);
  const double newSpan = std::clamp(span * factor, kSpanMinS, spanMax);
  const double from = aroundS - (aroundS - m_fromS) * newSpan / span;
  show(from, from + newSpan);
}

void TimeWindow::showRange(double fromS, double toS) {
  m_isLive = false;
  show(fromS, std::max(toS, fromS + kSpanMinS));
}

void TimeWindow::reveal(double atS) {
  const double span = m_toS - m_fromS;
  if (m_isLive || atS < m_fromS + span / 3.0 || atS > m_toS - span / 3.0) {
    showRange(atS - span / 2.0, atS + span / 2.0);
  }
}

void TimeWindow::show(double fromS, double toS) {
  if (fromS != m_fromS || toS != m_toS) {
    m_fromS = fromS;
    m_toS = toS;
    Q_EMIT changed();
  }
}

}  // namespace rivulet::widgets
