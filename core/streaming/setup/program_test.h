// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the tests of a control have in common: a program on the control with R-parameters in a row,
/// which the operator starts, and a client that writes and reads them.
/// @threadsafety one object, one thread.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/link.h"
#include "streaming/setup/commissioning.h"

namespace rivulet::streaming {

/// The number of the program of a test: above every number of a flexible program
/// (`templates::layoutNumber` is below 2^24), so that the two cannot be confused.
inline constexpr int kTestLayout = 1 << 24;

class ProgramTest {
 public:
  /// @param progress  called with what the test is waiting for; false ends it
  ProgramTest(opcua::Link& link, opcua::Control& control, const CommissioningPlan& plan,
              const std::function<bool(CommissioningStep)>& progress)
      : m_link(link), m_control(control), m_plan(plan), m_progress(progress) {}

 protected:
  /// @param which  counted from the first cell of the test
  [[nodiscard]] opcua::Variable cell(int which) const {
    return opcua::rParameter(m_plan.firstCell + which);
  }
  [[nodiscard]] base::Result<void> set(int which, double value);
  [[nodiscard]] base::Result<std::vector<double>> numbers(
      std::span<const opcua::Variable> variables);
  [[nodiscard]] base::Result<void> proceed(CommissioningStep step);
  void pause();

  /// The control is a SINUMERIK, and its channel in reset, without an alarm.
  [[nodiscard]] base::Result<void> requireReset();
  /// A number left from an earlier test must not pass for the program's own: its cell is cleared.
  [[nodiscard]] base::Result<void> transfer(const std::string& name, const std::string& text,
                                            int layoutCell);
  /// Has the program started, or waits for the operator. @param name  of the program
  [[nodiscard]] base::Result<void> awaitStart(CommissioningStep step, int layoutCell, int layout,
                                              const std::string& name);
  /// Waits until the channel is in reset again.
  [[nodiscard]] base::Result<void> awaitEnd(CommissioningStep step, base::Duration longest);

  opcua::Link& m_link;
  opcua::Control& m_control;
  const CommissioningPlan& m_plan;

 private:
  const std::function<bool(CommissioningStep)>& m_progress;
};

}  // namespace rivulet::streaming
