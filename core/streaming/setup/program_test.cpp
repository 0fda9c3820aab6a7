// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/program_test.h"

#include <array>

#include "opcua/await.h"
#include "streaming/control/control_alarm.h"
#include "streaming/run/run.h"
#include "streaming/start/program_transfer.h"
#include "templates/target.h"

namespace rivulet::streaming {

namespace {

using base::Instant;
using base::Result;
using opcua::Variable;
using opcua::VariableKind;

constexpr base::Duration kPoll = std::chrono::milliseconds{50};
constexpr std::array<Variable, 2> kState{
    {{VariableKind::ChannelStatus, 0}, {VariableKind::Alarm, 0}}};

}  // namespace

Result<void> ProgramTest::set(int which, double value) {
  const opcua::Assignment assignment{cell(which), value};
  return opcua::writeNow(m_link, {&assignment, 1}, m_plan.requestDeadline);
}

Result<std::vector<double>> ProgramTest::numbers(std::span<const Variable> variables) {
  return opcua::readNumbers(m_link, variables, m_plan.requestDeadline);
}

Result<void> ProgramTest::proceed(CommissioningStep step) {
  if (m_progress && !m_progress(step)) {
    return base::fail(StreamError::Cancelled,
                      "The test was aborted. Reset the control if its program is still running.");
  }
  return {};
}

void ProgramTest::pause() {
  const Instant until = m_link.now() + kPoll;
  while (m_link.now() < until) {
    m_link.wait(until);
  }
}

Result<void> ProgramTest::requireReset() {
  const auto identity = m_control.identity();
  if (identity &&
      templates::targetOf(identity->applicationUri) != templates::TargetControl::Sinumerik) {
    return base::fail(
        opcua::LinkError::NamespaceMissing,
        "This test is a program for a SINUMERIK. LinuxCNC needs none: its feed cell is "
        "tried at each start, and whole jobs are released.");
  }
  const auto state = numbers(kState);
  if (!state) {
    return base::fail(state.error());
  }
  if ((*state)[0] != opcua::kChannelReset) {
    return base::fail(StreamError::ChannelBusy,
                      "A program is running on the control. Wait until it has ended, or reset "
                      "the control, then start again.");
  }
  return requireNoAlarm((*state)[1]);
}

Result<void> ProgramTest::transfer(const std::string& name, const std::string& text,
                                   int layoutCell) {
  if (const auto there = transferProgram(m_control, name, text, m_plan.transfer); !there) {
    return base::fail(there.error());
  }
  return set(layoutCell, 0.0);
}

Result<void> ProgramTest::awaitStart(CommissioningStep step, int layoutCell, int layout,
                                     const std::string& name) {
  if (m_control.abilities().startsOnRequest) {
    if (Result<void> done = m_control.cycleStart(); !done) {
      return done;
    }
  }
  const Instant until = m_link.now() + m_plan.startDeadline;
  const std::array<Variable, 3> watched{kState[0], kState[1], cell(layoutCell)};
  while (m_link.now() < until) {
    if (Result<void> on = proceed(step); !on) {
      return on;
    }
    const auto state = numbers(watched);
    if (!state) {
      return base::fail(state.error());
    }
    if (Result<void> fine = requireNoAlarm((*state)[1]); !fine) {
      return fine;
    }
    if ((*state)[0] != opcua::kChannelReset && (*state)[2] != 0.0) {
      return (*state)[2] == static_cast<double>(layout)
                 ? Result<void>()
                 : base::fail(StreamError::WrongProgram,
                              "The control runs another program, not the test. Reset it and "
                              "select the test.",
                              name);
    }
    pause();
  }
  return base::fail(StreamError::NotStarted,
                    "Cycle start was not pressed in time. Start again when the machine is ready.");
}

Result<void> ProgramTest::awaitEnd(CommissioningStep step, base::Duration longest) {
  const Instant until = m_link.now() + longest;
  while (m_link.now() < until) {
    if (Result<void> on = proceed(step); !on) {
      return on;
    }
    const auto state = numbers(kState);
    if (!state) {
      return base::fail(state.error());
    }
    if (Result<void> fine = requireNoAlarm((*state)[1]); !fine) {
      return fine;
    }
    if ((*state)[0] == opcua::kChannelReset) {
      return {};
    }
    pause();
  }
  return base::fail(StreamError::StreamStalled,
                    "The program of the test did not end. Reset the control and start again.");
}

}  // namespace rivulet::streaming
