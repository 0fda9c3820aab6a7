// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/access_policy.h"

#include "streaming/setup/calibration.h"

namespace rivulet::streaming {

opcua::Grouping AccessPlan::expected(const Calibration* calibration) const {
  return choice == AccessChoice::Fixed || calibration == nullptr ? grouping : calibration->best();
}

AccessPlan accessPlan(AccessPreference preference, base::MethodKind method) {
  switch (preference) {
    case AccessPreference::Array:
      return {AccessChoice::Array, opcua::Grouping::List};
    case AccessPreference::Single:
      return {AccessChoice::Fixed, opcua::Grouping::Single};
    case AccessPreference::List:
      return {AccessChoice::Fixed, opcua::Grouping::List};
    case AccessPreference::Automatic:
      break;
  }
  const AccessChoice choice = base::isPublished(method) ? AccessChoice::Fixed : AccessChoice::Best;
  return {choice, opcua::Grouping::List};
}

}  // namespace rivulet::streaming
