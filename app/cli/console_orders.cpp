// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/console_orders.h"

#include <fmt/format.h>

#include "cli/status_line.h"
#include "platform/interrupt.h"

namespace rivulet::cli {

bool ConsoleOrders::stopRequested(base::Instant now) {
  m_first = m_first.value_or(now);
  if ((interrupt::wasSeen() || m_feed.hasGone()) && !m_continues) {
    m_continues = m_feed.continues();
    if (m_feed.hasKeys()) {
      sayOverStatus(
          "Stop. c: to the end of the window, and end there. Ctrl-C: leave the axes held.");
    }
  }
  return m_continues.has_value() ||
         (m_stopAfterS > 0.0 && now - *m_first >= base::fromSeconds(m_stopAfterS));
}

streaming::FeedOrder ConsoleOrders::feed(base::Instant now) {
  return m_feed.order(now);
}

bool ConsoleOrders::letsEnd(base::Instant) {
  return !m_continues || m_feed.continues() > *m_continues;
}

bool ConsoleOrders::leaves(base::Instant) {
  return interrupt::count() > 1 || m_feed.hasGone() || (interrupt::wasSeen() && !m_feed.hasKeys());
}

std::string leftHeldText(const std::string& endpoint) {
  return fmt::format(
      "The axes are held on the path. The program goes on to the end of its window, and ends "
      "there, "
      "with \"rivulet-cli runs --end --endpoint {}\"; it ends where it is with a reset at the "
      "control.",
      endpoint);
}

}  // namespace rivulet::cli
