// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 2, interpreter: lines of a program become blocks. A program may jump, so it begins when it
/// is complete. It has no machine around it: R-parameters are its own, a call of another program is
/// an alarm, and so are synchronized actions and variables of the main run. M0 and M1 do not wait.
/// @threadsafety one object, one thread. @source [P3] II.B
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "machine/config.h"
#include "machine/interpreter.h"
#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class InterpretTask final : public Stage {
 public:
  InterpretTask(const machine::MachineConfig& config, RingReader<ProgramText> in,
                RingWriter<NcBlock> out);
  InterpretTask(const InterpretTask&) = delete;
  InterpretTask& operator=(const InterpretTask&) = delete;

  [[nodiscard]] Need need() const override;
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  [[nodiscard]] base::Result<StepDone> collect();
  void interpretNext();
  void add(const machine::Prepared& prepared);
  void addAlarm(const machine::Alarm& alarm);

  machine::MachineConfig m_config;
  RingReader<ProgramText> m_in;
  RingWriter<NcBlock> m_out;
  std::string m_text;
  machine::RParameters m_parameters;
  std::optional<machine::Interpreter> m_interpreter;  ///< once the program is complete
  std::deque<NcBlock> m_due;                          ///< of the block interpreted last
  bool m_hasEnded = false;
};

}  // namespace rivulet::pipeline
