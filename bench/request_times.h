// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long the requests of a stream take on a link: the same ones for every link that is compared.
#pragma once

#include <array>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "measuring.h"
#include "opcua/await.h"
#include "opcua/link.h"

namespace rivulet::bench {

inline constexpr int kRounds = 20;
inline constexpr int kRequestsPerRound = 100;
/// As many as a window of 7 points has in three axes, with its header.
inline constexpr int kValues = 28;

struct RequestTimes {
  std::vector<double> writeUs;  ///< kValues values
  std::vector<double> readUs;   ///< three values
};

/// One round.
inline void measureRequests(opcua::Link& link, RequestTimes& times) {
  constexpr base::Duration kDeadline = std::chrono::seconds{20};
  std::vector<opcua::Assignment> assignments;
  for (int i = 0; i < kValues; ++i) {
    assignments.push_back({opcua::rParameter(i), 0.5 * i});
  }
  const std::array variables{opcua::rParameter(0), opcua::rParameter(1), opcua::rParameter(2)};
  for (int i = 0; i < kRequestsPerRound; ++i) {
    times.writeUs.push_back(microseconds([&] {
      if (!opcua::writeNow(link, assignments, kDeadline)) {
        std::exit(1);
      }
    }));
    times.readUs.push_back(
        microseconds([&] { required(opcua::readNumbers(link, variables, kDeadline)); }));
  }
}

}  // namespace rivulet::bench
