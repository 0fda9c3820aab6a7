// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run that nobody watches and nobody stops.
#pragma once

#include "streaming/run/driver.h"

namespace rivulet::tests {

class SilentRun final : public streaming::RunSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return false; }
};

}  // namespace rivulet::tests
