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

}  // namespace rivulet::pipeline
