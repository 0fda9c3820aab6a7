// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The limits of a machine as JSON (docs/formats.md names every field), and as settings of the
/// virtual machine that stands for it. @threadsafety pure, except that presets are read.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "machine/config.h"
#include "streaming/control/machine_profile.h"

namespace rivulet::report {

/// What simulations are made with while nobody has entered the limits of a machine: the paper's.
inline constexpr const char* kAssumedPreset = machine::kDefaultPreset;

/// @param replaced  the limits that these take the place of: what a later version wrote there stays
[[nodiscard]] nlohmann::ordered_json profileJson(const streaming::MachineProfile& profile,
                                                 const nlohmann::ordered_json& replaced);
/// @param origin  named in the error @return Damaged
[[nodiscard]] base::Result<streaming::MachineProfile> profileOf(const nlohmann::ordered_json& json,
                                                                const std::string& origin);

/// The limits of a preset, as a profile of no machine yet. @return as `machine::loadPreset`
[[nodiscard]] base::Result<streaming::MachineProfile> profileOfPreset(const std::string& preset);

/// The preset of the profile with the limits of the profile. An unknown preset counts as
/// `kAssumedPreset`. @param profile  null: that preset as it is
[[nodiscard]] machine::MachineConfig configOf(const streaming::MachineProfile* profile);

/// The machine that a whole job is compared with: the limits that were entered for it, or the
/// preset that a virtual machine names as its build.
/// @param profile  null: nobody has entered limits  @return nothing: it is not known
[[nodiscard]] std::optional<machine::MachineConfig> knownMachine(
    const opcua::ServerIdentity& server, const streaming::MachineProfile* profile);

}  // namespace rivulet::report
