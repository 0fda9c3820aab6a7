// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which control a program is written for. @threadsafety pure.
#pragma once

#include <string_view>

#include "templates/cells.h"

namespace rivulet::templates {

/// What a server in front of a LinuxCNC calls itself: its application URI.
inline constexpr std::string_view kLinuxCncApplicationUri = "urn:rivulet:linuxcnc";

/// The control behind a server. @param applicationUri  of the server; empty: not known
[[nodiscard]] constexpr TargetControl targetOf(std::string_view applicationUri) {
  return applicationUri == kLinuxCncApplicationUri ? TargetControl::LinuxCnc
                                                   : TargetControl::Sinumerik;
}

/// Where whole jobs run without a test of the machine: on virtual machines, whose wrong motion does
/// no harm, and on LinuxCNC, against which they are tested.
[[nodiscard]] constexpr bool runsWholeJobs(std::string_view applicationUri, bool isVirtual) {
  return isVirtual || targetOf(applicationUri) == TargetControl::LinuxCnc;
}

/// The same settings for a control, without what it does not have.
[[nodiscard]] inline TemplateParameters forTarget(TemplateParameters parameters,
                                                  TargetControl target) {
  parameters.target = target;
  // The planner of LinuxCNC brakes when its queue ends.
  parameters.slowDown = parameters.slowDown && target == TargetControl::Sinumerik;
  return parameters;
}

}  // namespace rivulet::templates
