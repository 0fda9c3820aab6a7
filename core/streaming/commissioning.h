// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test a control has to pass before method credit is offered on it. That method rests on what
/// is published of no control: that the interpreter reads an R-parameter each time it passes a
/// block, though other blocks wait to be executed, and that neither a question nor a jump stops it.
///
/// The test is an NC program that moves no axis. Its main run is kept busy with dwells; meanwhile
/// the program repeats what the client asks, over and over, without a STOPRE. The answers must come
/// while the dwells last. Where they do not, the program ends by itself all the same.
/// @threadsafety runs on the calling thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/link.h"
#include "streaming/program_transfer.h"

namespace rivulet::streaming {

struct CommissioningPlan {
  int firstCell = 0;  ///< of ten R-parameters in a row that nobody else uses
  TransferWay transfer = TransferWay::Link;
  base::Duration requestDeadline = std::chrono::seconds{2};
  base::Duration startDeadline = std::chrono::minutes{5};  ///< for cycle start at the control
};

/// What was looked at, and what was seen.
struct CommissioningCheck {
  std::string name;  ///< "answers-while-busy", ...
  bool passed = false;
  std::string message;
};

struct Commissioning {
  std::vector<CommissioningCheck> checks;
  int asked = 0;
  int answered = 0;                ///< while the main run was busy
  base::Duration slowestAnswer{};  ///< of those

  /// Every check holds.
  [[nodiscard]] bool passed() const;
};

/// What the test waits for.
enum class CommissioningStep {
  CycleStart,  ///< the operator, at the control
  Running,
};

/// The NC program: LF line ends, ASCII. @param firstCell  as in the plan
[[nodiscard]] std::string commissioningProgram(int firstCell);
/// Its name on the control.
[[nodiscard]] std::string commissioningFileName();

/// Transfers the program, reads it back, selects it, has it started (a virtual machine: starts it),
/// asks, and judges what came back. A control that fails the test is a result, not an error.
/// @param progress  told what is waited for; false ends the test
/// @return ChannelBusy, ControlAlarm, NotStarted, WrongProgram, TransferRefused, StreamStalled,
///         Cancelled, or what the link says
[[nodiscard]] base::Result<Commissioning> commission(
    opcua::Link& link, opcua::Control& control, const CommissioningPlan& plan,
    const std::function<bool(CommissioningStep)>& progress = {});

}  // namespace rivulet::streaming
