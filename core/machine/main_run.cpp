// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/main_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/vec3.h"

namespace rivulet::machine {

std::optional<SystemVariable> systemVariableOf(std::string_view name) {
  using enum SystemVariable;
  static constexpr std::array<std::pair<std::string_view, SystemVariable>, 14> kNames{
      {{"$AA_IM", AaIm},
       {"$AA_IW", AaIw},
       {"$AA_DTEW", AaDtew},
       {"$AA_OFF", AaOff},
       {"$AA_OFF_VAL", AaOffVal},
       {"$MA_AA_OFF_MODE", MaAaOffMode},
       {"$SA_AA_OFF_LIMIT", SaAaOffLimit},
       {"$AC_DTEW", AcDtew},
       {"$AC_PATHN", AcPathn},
       {"$AC_OVR", AcOvr},
       {"$AC_TIMER", AcTimer},
       {"$AC_MARKER", AcMarker},
       {"$AC_PARAM", AcParam},
       {"$AC_IPO_BUF", AcIpoBuf}}};
  const auto found = std::find_if(kNames.begin(), kNames.end(),
                                  [name](const auto& entry) { return entry.first == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->second);
}

nc::Expected<int> systemIndex(std::string_view name, std::span<const nc::Value> indices) {
  static constexpr std::array<std::string_view, 4> kWithoutIndex{"$AC_DTEW", "$AC_PATHN", "$AC_OVR",
                                                                 "$AC_IPO_BUF"};
  if (indices.empty()) {
    const bool needsNone =
        std::find(kWithoutIndex.begin(), kWithoutIndex.end(), name) != kWithoutIndex.end();
    return needsNone ? nc::Expected<int>(0)
                     : nc::fail(nc::FaultCode::IndexMissing, std::string(name));
  }
  if (const auto* axis = std::get_if<std::string>(&indices.front())) {
    const auto found = std::find_if(base::kAxisNames.begin(), base::kAxisNames.end(),
                                    [axis](char c) { return *axis == std::string(1, c); });
    return found != base::kAxisNames.end()
               ? nc::Expected<int>(static_cast<int>(found - base::kAxisNames.begin()))
               : nc::fail(nc::FaultCode::IndexOutsideArray);
  }
  const double index = std::round(std::get<double>(indices.front()));
  return std::abs(index) < 1e6 ? nc::Expected<int>(static_cast<int>(index))
                               : nc::fail(nc::FaultCode::IndexOutsideArray);
}

nc::Expected<nc::Value> systemValue(const MainRun& mainRun, std::string_view name,
                                    std::span<const nc::Value> indices) {
  const std::optional<SystemVariable> variable = systemVariableOf(name);
  if (!variable) {
    return nc::fail(nc::FaultCode::OnlyOnControl, std::string(name));
  }
  const nc::Expected<int> index = systemIndex(name, indices);
  if (!index) {
    return nc::fail(index.error());
  }
  const std::optional<double> value = mainRun.systemValue(*variable, *index);
  return value ? nc::Expected<nc::Value>(*value) : nc::fail(nc::FaultCode::IndexOutsideArray);
}

}  // namespace rivulet::machine
