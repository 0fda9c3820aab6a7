// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/travel.h"

#include "opcua/await.h"
#include "report/known_machine.h"
#include "streaming/run/run.h"
#include "templates/linuxcnc_protocol.h"
#include "templates/target.h"

namespace rivulet::run {

base::Result<std::optional<machine::MachineConfig>> machineOf(opcua::Control& control,
                                                              const std::string& name,
                                                              const report::MachineStore& store) {
  const auto identity = control.identity();
  if (!identity) {
    return base::fail(identity.error());
  }
  const auto profile = store.profile(name, *identity);
  if (!profile) {
    return base::fail(profile.error());
  }
  if (templates::targetOf(identity->applicationUri) == templates::TargetControl::LinuxCnc) {
    const auto text = control.downloadProgram(templates::LinuxCncProtocol::kMachineFile);
    if (!text) {
      return base::fail(text.error());
    }
    const auto told = machine::parsePreset(*text, templates::LinuxCncProtocol::kMachineFile);
    return told ? base::Result<std::optional<machine::MachineConfig>>(*told)
                : base::fail(told.error());
  }
  return report::knownMachine(*identity, *profile ? &**profile : nullptr);
}

base::Result<std::string> checkTravel(opcua::Link& link, opcua::Control& control,
                                      const std::optional<machine::MachineConfig>& machine,
                                      std::span<const gcode::StreamPoint> points) {
  if (!machine) {
    return std::string(
        "The travel was not checked: the limits of this machine are not known. Watch the first "
        "pass, or enter them.");
  }
  std::optional<base::Vec3> zeroMm;
  // Which numbers a real control has for its offsets is not known here.
  if (control.isVirtualMachine()) {
    streaming::EquipmentWatch watch;
    const auto readings = opcua::readNow(link, watch.variables(), streaming::kSetupDeadline);
    if (!readings) {
      return base::fail(readings.error());
    }
    zeroMm = forecast::activeZero(*machine, watch.take(*readings));
  }
  if (base::Result<void> within = forecast::requireWithinTravel(points, *machine, zeroMm);
      !within) {
    return base::fail(within.error());
  }
  return zeroMm ? std::string()
                : std::string(
                      "Only the length of the path was compared with the travel: where the "
                      "workpiece lies on this machine is not known.");
}

}  // namespace rivulet::run
