// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test that a control must pass before method credit is offered on it. The method relies on
/// two properties that are not published for any control: that the interpreter reads an R-parameter
/// each time it passes a block, even if other blocks wait to be executed, and that neither a
/// condition nor a jump stops it.
///
/// The test is an NC program that moves no axis. Its main run is kept busy with dwells; meanwhile
/// the program repeats the client's numbers in a loop, without a STOPRE. The answers must arrive
/// while the dwells are in progress. If they do not, the program ends by itself all the same.
/// @threadsafety runs on the calling thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/link.h"
#include "streaming/start/program_transfer.h"

namespace rivulet::streaming {

/// R-parameters in a row that the test of method credit needs.
inline constexpr int kCreditTestCells = 10;

struct CommissioningPlan {
  int firstCell = 0;  ///< of the R-parameters of the test, in a row, that nobody else uses
  TransferWay transfer = TransferWay::Link;
  base::Duration requestDeadline = std::chrono::seconds{2};
  base::Duration startDeadline = std::chrono::minutes{5};  ///< for cycle start at the control
};

/// One check and its result.
struct CommissioningCheck {
  std::string name;  ///< "answers-while-busy", ...
  bool passed = false;
  std::string message;
};

/// What a test of a control has found.
struct ChecksOfControl {
  std::vector<CommissioningCheck> checks;

  /// There are checks, and every one has passed.
  [[nodiscard]] bool passed() const;
};

struct Commissioning : ChecksOfControl {
  int asked = 0;
  int answered = 0;                ///< while the main run was busy
  base::Duration slowestAnswer{};  ///< of those
};

/// What the test is waiting for.
enum class CommissioningStep {
  CycleStart,  ///< the operator, at the control
  Running,
  CycleStartAgain,  ///< the same, a second time
};

/// The NC program: LF line ends, ASCII. @param firstCell  as in the plan
[[nodiscard]] std::string commissioningProgram(int firstCell);
/// Its name on the control.
[[nodiscard]] std::string commissioningFileName();

/// Transfers the program, reads it back, selects it, has it started (a virtual machine: starts it),
/// sends numbers, and judges the answers. A control that fails the test is a result, not an error.
/// @param progress  called with what the test is waiting for; false ends the test
/// @return ChannelBusy, ControlAlarm, NotStarted, WrongProgram, TransferRefused, StreamStalled,
/// Cancelled, or the error of the link
[[nodiscard]] base::Result<Commissioning> commission(
    opcua::Link& link, opcua::Control& control, const CommissioningPlan& plan,
    const std::function<bool(CommissioningStep)>& progress = {});

}  // namespace rivulet::streaming
