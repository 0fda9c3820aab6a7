// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The lines of a page, for pictures of it: between its places and its transitions, and between its
/// places and the pages that stand on it. @threadsafety pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "petri/net.h"

namespace rivulet::petri {

/// All arcs between a place and a transition, or a page and those on it, as one line.
struct PageArc {
  std::size_t place = 0;           ///< index among the nodes of the page
  std::size_t node = 0;            ///< the transition or substitution, likewise
  bool takes = false;              ///< tokens go from the place
  bool puts = false;               ///< tokens go to the place
  std::vector<std::string> taken;  ///< inscriptions; none for a substitution
  std::vector<std::string> put;
};

/// @param page  index in `net.pages`
[[nodiscard]] std::vector<PageArc> arcsOfPage(const Net& net, std::size_t page);

/// Whether a transition is on a page or on one that stands on it.
[[nodiscard]] bool isOnPage(const Net& net, std::size_t transition, std::size_t page);

}  // namespace rivulet::petri
