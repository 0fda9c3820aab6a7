// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feed cell in the text of a program for SINUMERIK: see `FeedCell`. @threadsafety pure.
#pragma once

#include <string>
#include <vector>

#include "templates/cells.h"

namespace rivulet::templates {

/// The axes stand when the client gives no sign for `silenceLimitS`.
[[nodiscard]] bool watchesClient(const CellMap& cells);

/// A time after which they may stand: 0, or within the limits.
[[nodiscard]] bool isSilenceLimit(double seconds);

/// Bounds that can be agreed: 1 is among them.
[[nodiscard]] bool areFactorBounds(double least, double most);

/// What the actions make of both cells while the client lives, percent. Values that hold are 0.
[[nodiscard]] double overrideOf(const CellMap& cells, double percent, double factor);

/// The blocks that put it into force: before the first motion, and before the client is waited for.
/// The main run executes the actions from the next block on, until the program ends.
/// @return empty: the program has no feed cell
[[nodiscard]] std::vector<std::string> feedCellBlocks(const CellMap& cells);

/// The block that lowers the override in force to a limit while a condition holds.
/// @param condition, percent  of a synchronized action: the latter is the limit
[[nodiscard]] std::string feedLimitBlock(const CellMap& cells, int action,
                                         const std::string& condition, const std::string& percent);

}  // namespace rivulet::templates
