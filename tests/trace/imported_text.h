// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What an import has made of a text, in words that a test compares.
#pragma once

#include <QtTest>
#include <string>
#include <string_view>
#include <utility>

#include "trace/import/import.h"

namespace rivulet::tests {

/// Empty, with a warning, if it is refused.
inline trace::ImportedTrace imported(std::string_view text,
                                     const trace::TableMapping& mapping = {}) {
  auto result = trace::importTrace(text, mapping);
  if (!result) {
    qWarning("%s", result.error().message.c_str());
    return {};
  }
  return std::move(*result);
}

inline std::string roles(const trace::ImportedTrace& trace) {
  return trace::printColumnRoles(trace.columns);
}

/// One a line.
inline std::string remarks(const trace::ImportedTrace& trace) {
  std::string text;
  for (const trace::Remark& remark : trace.trace.remarks) {
    text += (text.empty() ? "" : "\n") + trace::remarkText(remark);
  }
  return text;
}

}  // namespace rivulet::tests
