// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The forms of access that a control understands, as found by `access_probe`.
/// @threadsafety plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "opcua/grouping.h"

namespace rivulet::streaming {

/// The result for one form.
struct FormProof {
  opcua::Grouping form = opcua::Grouping::Single;
  bool writes = false;
  bool reads = false;
  std::string why;  ///< why it does not work; in English, for the report

  [[nodiscard]] bool works() const { return writes && reads; }
};

struct AccessForms {
  std::vector<FormProof> proofs;  ///< of every form, the best first

  /// The first that works. Single always works; otherwise there is no result.
  [[nodiscard]] opcua::Grouping best() const;
  /// The best array form; nothing if arrays do not work.
  [[nodiscard]] std::optional<opcua::Grouping> array() const;
};

}  // namespace rivulet::streaming
