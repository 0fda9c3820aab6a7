// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the time of a whole job is spent on, estimated or measured. @threadsafety plain values.
#pragma once

#include "base/instant.h"

namespace rivulet::streaming {

struct JobTimes {
  base::Duration streamed{};    ///< stretches, from the client's first check to their end
  base::Duration pauses{};      ///< of that, standstills between windows: not in `streamed`
  base::Duration native{};      ///< blocks of the control, without those that change the tool
  base::Duration toolChange{};  ///< native blocks with the reason `tool`
  base::Duration handover{};    ///< control and client wait for each other between the two

  [[nodiscard]] base::Duration total() const {
    return streamed + pauses + native + toolChange + handover;
  }
  JobTimes& operator+=(const JobTimes& other) {
    streamed += other.streamed;
    pauses += other.pauses;
    native += other.native;
    toolChange += other.toolChange;
    handover += other.handover;
    return *this;
  }
};

}  // namespace rivulet::streaming
