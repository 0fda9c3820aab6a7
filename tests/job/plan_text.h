// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Prints plans as short text, so that a test reads like a listing.
#pragma once

#include <string>

#include "job/plan.h"

namespace rivulet::test {

/// "settings 1-2 | native 3 tool T1 M6 | stretch 1 4-9: 5 points": lines, reasons, texts.
inline std::string printParts(const job::Plan& plan) {
  std::string text;
  for (const job::Part& part : plan.parts) {
    text += text.empty() ? "" : " | ";
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      text += "native " + std::to_string(native->place.line.value) + " " +
              std::string(job::nativeReasonName(native->reason)) + " " + native->text;
      continue;
    }
    const auto& stretch = std::get<job::Stretch>(part);
    text += stretch.number > 0 ? "stretch " + std::to_string(stretch.number) : "settings";
    text += " " + std::to_string(stretch.blocks.front().line.value);
    if (stretch.blocks.size() > 1) {
      text += "-" + std::to_string(stretch.blocks.back().line.value);
    }
    if (stretch.number > 0) {
      text += ": " + std::to_string(stretch.pointCount) +
              (stretch.pointCount == 1 ? " point" : " points") +
              (stretch.startIsKnown() ? "" : " from ?");
    }
  }
  return text;
}

}  // namespace rivulet::test
