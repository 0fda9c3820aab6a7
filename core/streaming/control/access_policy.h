// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which form of access a run uses: the rule for command line and HMI. @threadsafety pure.
#pragma once

#include "base/method_kind.h"
#include "opcua/grouping.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

/// What the user prefers.
enum class AccessPreference {
  Automatic,  ///< the best form the control is shown to understand; methods of [P1]: lists
  Array,      ///< the best array form, or no run
  List,       ///< several variables in one request, one node each
  Single,     ///< one request per variable
};

struct AccessPlan {
  AccessChoice choice = AccessChoice::Fixed;
  opcua::Grouping grouping = opcua::Grouping::List;  ///< used where `choice` is Fixed

  /// The form the run will probably use. @param calibration of this control; null: none
  [[nodiscard]] opcua::Grouping expected(const Calibration* calibration) const;
};

/// The methods of [P1] stay as published: with Automatic they use lists, and nothing is tried on
/// the control.
[[nodiscard]] AccessPlan accessPlan(AccessPreference preference, base::MethodKind method);

}  // namespace rivulet::streaming
