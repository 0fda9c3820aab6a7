// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What every run of the command line obeys: its keys or its file of orders, Ctrl-C, and a time at
/// which it stops. Ctrl-C, SIGTERM and a closed terminal hold the axes at once. On a terminal,
/// "continue" then lets the program go on to the end of its window, where it ends; a second Ctrl-C
/// leaves it held. Without keys nobody can say so, and it is left held. @threadsafety the thread of
/// the run
#pragma once

#include <optional>

#include "base/instant.h"
#include "cli/feed_source.h"
#include "streaming/run/driver.h"

namespace rivulet::cli {

class ConsoleOrders : public streaming::RunOrders {
 public:
  /// @param stopAfterS  the run ends before its next window then; 0: never
  /// @param feed  outlives this object
  ConsoleOrders(double stopAfterS, FeedSource& feed) : m_stopAfterS(stopAfterS), m_feed(feed) {}

  bool stopRequested(base::Instant now) override;
  streaming::FeedOrder feed(base::Instant now) override;
  bool letsEnd(base::Instant now) override;
  bool leaves(base::Instant now) override;

 protected:
  /// Says on standard error what has become of the orders.
  void tell(const streaming::LiveUpdate& update) { m_feed.tell(update); }

 private:
  double m_stopAfterS;
  FeedSource& m_feed;
  std::optional<base::Instant> m_first;
  std::optional<int> m_continues;  ///< orders to continue before the interrupt
};

/// What a person does next with a run that was left held. @param endpoint  of the control
[[nodiscard]] std::string leftHeldText(const std::string& endpoint);

}  // namespace rivulet::cli
