// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All markings that a net can reach when its times are left out, and what follows from them:
/// bounds of places, deadlocks, transitions that never fire, invariants that do not hold.
///
/// The untimed net covers the timed one. A transition is *urgent* if neither a time stamp nor the
/// present time can delay it; time cannot go on while one is enabled. In a marking, the urgent
/// transitions of the lowest priority number are followed, and all others that are enabled and go
/// before them or with them: these may be ready or not. So markings that no timed run can reach are
/// left out in part, and none that a timed run reaches. Fields that are only measured count as 0.
/// Markings are told apart by a hash of 64 bits: with a million of them, two have the same one with
/// a probability of 3e-8. @threadsafety pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "petri/net.h"

namespace rivulet::petri {

struct StateSpaceOptions {
  std::size_t statesMax = 2'000'000;
  base::Budget budget{};
};

/// What a place holds in all markings.
struct PlaceBounds {
  std::size_t tokensMin = 0;
  std::size_t tokensMax = 0;
  bool hasValues = false;  ///< numbers: their range; lists: their length
  Word valueMin = 0;
  Word valueMax = 0;
};

struct StateSpace {
  std::size_t states = 0;
  std::size_t firings = 0;            ///< edges of the graph
  std::vector<PlaceBounds> bounds;    ///< by place; observer places hold nothing
  std::vector<std::uint64_t> fired;   ///< edges by transition; 0: it can never fire
  std::size_t deadlocks = 0;          ///< markings in which nothing can fire
  std::string deadlock;               ///< the first one: its places that hold something
  std::vector<std::string> violated;  ///< invariants, by name
};

/// @return TooManyStates, BudgetError::Exceeded
[[nodiscard]] base::Result<StateSpace> exploreStates(const Net& net,
                                                     const StateSpaceOptions& options = {});

}  // namespace rivulet::petri
