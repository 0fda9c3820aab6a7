// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Compares what two readers make of a program, and makes a program that is read differently as
/// small as it can be. @threadsafety pure.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "nc/rs274/path_reading.h"

namespace rivulet::tests {

enum class Agreement {
  Equal,         ///< both move alike
  BothRefuse,    ///< neither accepts it
  NotSupported,  ///< Rivulet refuses by name what LinuxCNC accepts
  Different,     ///< LinuxCNC refuses what Rivulet accepts, or the paths or feeds differ
};

struct Comparison {
  Agreement agreement = Agreement::Equal;
  /// The word that is not supported, why both refuse, or in which way they differ: the same for
  /// programs that are read differently for one reason.
  std::string kind;
};

[[nodiscard]] Comparison compared(const PathReading& linuxCnc, const PathReading& rivulet);

/// Leaves out lines, then words, as long as `isSame` holds. The first line stays: it says where
/// the axes stand.
[[nodiscard]] std::string shrunk(std::string_view text,
                                 const std::function<bool(const std::string&)>& isSame);

}  // namespace rivulet::tests
