// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// From traces to an emulator, from the emulator to a virtual machine, and from this to what a
/// program will do: on recordings of another controller, and on virtual machines whose parameters
/// are known. @threadsafety pure.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "base/result.h"
#include "emulator/emulator.h"
#include "machine/config.h"
#include "papers/experiment.h"
#include "trace/control_trace.h"

namespace rivulet::papers {

/// Recorded designs, predicted from its program alone: set
/// points by the look-ahead of the virtual machine, positions by the emulator as its servo.
/// @param folder  with `programs` (see recorded_run.h)
/// @param designs  as recorded; named as the programs
/// @return training::RecordedRunError
[[nodiscard]] base::Result<void> addPredictedDesigns(
    Experiment& experiment, const std::filesystem::path& folder, const emulator::Emulator& emulator,
    std::span<const emulator::TrainingRun> designs);

/// A virtual machine with known axes runs a program; an emulator is learned from the control's
/// trace and is the servo of another virtual machine. Both then run another program.
/// @return errors of emulator and machine
[[nodiscard]] base::Result<void> addKnownMachines(Experiment& experiment);

/// dmu75 with axes as a cascade has them: gains, feed-forward of X, friction, delay of Y and Z.
[[nodiscard]] machine::MachineConfig cascadeMachine();

/// Lines, corners, reversals and arcs, slow and fast: enough to learn X, Y and Z from.
[[nodiscard]] std::string_view programToLearnFrom();

/// What the control of this machine records of a program.
/// @return errors of the machine
[[nodiscard]] base::Result<trace::ControlTrace> controlTraceOf(const machine::MachineConfig& config,
                                                               std::string_view program);

}  // namespace rivulet::papers
