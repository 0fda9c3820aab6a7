// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The text of a SINUMERIK program as a tree. @threadsafety pure.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "nc/syntax/tree.h"

namespace rivulet::nc {

/// Never fails: see tree.h. @param file  number of the text, for the places in it
[[nodiscard]] Tree parseSinumerik(std::string_view text, std::uint16_t file = 0);

/// Reads what steers a program, for a reader that takes the words of a block itself.
class SteeringParser {
 public:
  virtual ~SteeringParser() = default;
  /// Adds the statements of one jump, condition, loop, definition or call.
  /// @param text  from its first word on
  virtual void steer(std::string_view text, Place place) = 0;
  /// Complains about what was not closed.
  virtual void finish() = 0;
};

/// @param tree  outlives the parser
[[nodiscard]] std::unique_ptr<SteeringParser> sinumerikSteering(Tree& tree);
/// IF, WHILE ... DO and GOTO of the ISO dialects, O words of RS-274/NGC.
[[nodiscard]] std::unique_ptr<SteeringParser> hashSteering(Tree& tree);

}  // namespace rivulet::nc
