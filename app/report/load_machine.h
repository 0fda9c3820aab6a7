// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What loading a program asks of the machine that is to run it: for command line, window and
/// service. @threadsafety plain values; what is read from the store is said there.
#pragma once

#include <optional>
#include <string>

#include "gcode/program.h"
#include "job/plan.h"
#include "machine/config.h"
#include "opcua/server_identity.h"
#include "report/machine_store.h"

namespace rivulet::report {

struct LoadMachine {
  job::Profile words;                       ///< what it does for words of other machines
  std::optional<machine::ToolTable> tools;  ///< nothing: the control alone knows them
  /// It will be set up for the program (`streaming::fitMachine`): what is not in its table has
  /// radius 0, and it has a feed until the program names one.
  bool isFitted = false;

  /// Radii, mm, and the feed of a machine that is set up.
  void tell(gcode::LoadOptions& options) const;

  /// The same points come out: numbers, names and radii of the tools are the same.
  friend bool operator==(const LoadMachine& a, const LoadMachine& b);
};

/// @param endpoint  empty: none is connected  @param isVirtual  nothing moves
/// @param profile  the limits and tools that were entered for it; null: none
[[nodiscard]] LoadMachine loadMachineOf(const MachineStore& store, const std::string& endpoint,
                                        const opcua::ServerIdentity& server, bool isVirtual,
                                        const streaming::MachineProfile* profile);

}  // namespace rivulet::report
