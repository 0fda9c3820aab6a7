// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which forms of access a control has been found to understand (`access_probe`).
/// @threadsafety plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "opcua/grouping.h"

namespace rivulet::streaming {

/// What was found out about one form.
struct FormProof {
  opcua::Grouping form = opcua::Grouping::Single;
  bool writes = false;
  bool reads = false;
  std::string why;  ///< where it does not work; in English, for the report

  [[nodiscard]] bool works() const { return writes && reads; }
};

struct AccessForms {
  std::vector<FormProof> proofs;  ///< of every form, the best first

  /// The first that works. Single always does, or there would be no result.
  [[nodiscard]] opcua::Grouping best() const;
  /// The best array form; nothing where arrays do not work.
  [[nodiscard]] std::optional<opcua::Grouping> array() const;
};

}  // namespace rivulet::streaming
