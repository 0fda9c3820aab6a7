// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All that is agreed on before a live run: where its points come from, what may move, and how long
/// the machine waits for them. @threadsafety plain values; pure.
#pragma once

#include <string>

#include "base/result.h"
#include "live/agreement.h"
#include "live/point_stream.h"

namespace rivulet::live {

struct Setup {
  std::string address = "tcp:4001";  ///< see `sources::openSource`
  Agreement agreement;
  Limits limits;
  base::RotarySet rotaryAxes{};  ///< that points may turn

  friend bool operator==(const Setup&, const Setup&) = default;
};

/// @return NotAgreed: what nobody can keep, such as a box whose least X is above its largest
[[nodiscard]] base::Result<void> requireSound(const Setup& setup);

/// Every value in one line. Two setups are the same if their texts are.
[[nodiscard]] std::string textOf(const Setup& setup);

}  // namespace rivulet::live
