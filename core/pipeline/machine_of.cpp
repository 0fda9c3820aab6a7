// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/machine_of.h"

namespace rivulet::pipeline {

machine::MachineConfig pipelineMachine(machine::MachineConfig config) {
  config.programStop = false;
  config.optionalStop = false;
  if (config.tools) {
    config.tools->acceptsMissing = true;
  }
  return config;
}

machine::InterpreterOptions interpreterOptions(const machine::MachineConfig& config) {
  const base::AxisPosition start = config.start();
  machine::InterpreterOptions options;
  options.startMm = start.mm;
  options.startDeg = start.deg;
  options.rotaryAxes = config.rotarySet();
  options.rapidMmPerS = config.rapidMmPerS;
  options.feedMmPerS = config.defaultFeedMmPerS;
  options.roundingMm = config.roundingMm;
  options.dynamics = config.resetDynamics;
  options.machine = &config;
  return options;
}

}  // namespace rivulet::pipeline
