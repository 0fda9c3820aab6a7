// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/commissioning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.h"
#include "opcua/await.h"
#include "streaming/control/control_alarm.h"
#include "streaming/run/run.h"
#include "streaming/start/program_transfer.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using opcua::VariableKind;

/// Above every number of a flexible program (`templates::layoutNumber` is below 2^24): the two
/// cannot be confused.
constexpr int kLayoutNumber = 1 << 24;

/// The dwells that keep the main run busy, and the one before which it reports its progress.
constexpr int kDwells = 4;
constexpr int kMarkedDwell = 2;
constexpr int kDwellS = 1;
/// Passes of the asking loop if the buffer never seems to become empty: a minute or more.
constexpr int kPassesMax = 50'000;
/// Passes of the waiting loop, 20 ms or more each, before the program ends without a client.
constexpr int kWaitingPassesMax = 1500;

constexpr int kQuestions = 20;
/// With fewer answers within seconds, the control was not observed often enough.
constexpr int kAnswersMin = 5;
/// From the beginning of the dwells to the end of the program.
constexpr Duration kRunMax = std::chrono::minutes{3};
constexpr Duration kDwellPoll = std::chrono::milliseconds{50};

/// R-parameters of the test, counted from its first.
enum Cell { Question, Echo, Begin, Cycles, Layout, Phase, Passes, Buffer, CyclesSeen, Mark };
/// Values of `Phase`.
constexpr double kAsking = 1.0;
constexpr double kThrough = 2.0;

/// One reading of the cells while the program asks.
struct Look {
  Instant at{};
  double answer = 0.0;
  double cycles = 0.0;
  double phase = 0.0;
  double buffer = 0.0;
  double cyclesSeen = 0.0;
  double mark = 0.0;
};

class Test {
 public:
  Test(opcua::Link& link, opcua::Control& control, const CommissioningPlan& plan,
       const std::function<bool(CommissioningStep)>& progress)
      : m_link(link), m_control(control), m_plan(plan), m_progress(progress) {}

  Result<Commissioning> run() {
    for (const auto step : {&Test::transfer, &Test::awaitStart, &Test::ask, &Test::awaitEnd}) {
      if (Result<void> done = (this->*step)(); !done) {
        return base::fail(done.error());
      }
    }
    judge();
    return std::move(m_result);
  }

 private:
  [[nodiscard]] Variable cell(Cell which) const {
    return opcua::rParameter(m_plan.firstCell + static_cast<int>(which));
  }

  Result<void> set(Cell which, double value) {
    const opcua::Assignment assignment{cell(which), value};
    return opcua::writeNow(m_link, {&assignment, 1}, m_plan.requestDeadline);
  }

  Result<void> proceed(CommissioningStep step) {
    if (m_progress && !m_progress(step)) {
      return base::fail(StreamError::Cancelled,
                        "The test was aborted. Reset the control if its program is still running.");
    }
    return {};
  }

  Result<std::vector<double>> numbers(std::span<const Variable> variables) {
    return opcua::readNumbers(m_link, variables, m_plan.requestDeadline);
  }

  void pause() {
    const Instant until = m_link.now() + kDwellPoll;
    while (m_link.now() < until) {
      m_link.wait(until);
    }
  }

  Result<void> transfer() {
    const std::array<Variable, 2> watched{
        {{VariableKind::ChannelStatus, 0}, {VariableKind::Alarm, 0}}};
    const auto state = numbers(watched);
    if (!state) {
      return base::fail(state.error());
    }
    if ((*state)[0] != opcua::kChannelReset) {
      return base::fail(StreamError::ChannelBusy,
                        "A program is running on the control. Wait until it has ended, or reset "
                        "the control, then start again.");
    }
    if (Result<void> fine = requireNoAlarm((*state)[1]); !fine) {
      return fine;
    }
    const std::string name = commissioningFileName();
    const std::string text = commissioningProgram(m_plan.firstCell);
    if (const auto there = transferProgram(m_control, name, text, m_plan.transfer); !there) {
      return base::fail(there.error());
    }
    // A number left from an earlier test must not pass for the program's own.
    return set(Layout, 0.0);
  }

  Result<void> awaitStart() {
    if (m_control.abilities().startsOnRequest) {
      if (Result<void> done = m_control.cycleStart(); !done) {
        return done;
      }
    }
    const Instant until = m_link.now() + m_plan.startDeadline;
    const std::array<Variable, 3> watched{
        {{VariableKind::ChannelStatus, 0}, {VariableKind::Alarm, 0}, cell(Layout)}};
    while (m_link.now() < until) {
      if (Result<void> on = proceed(CommissioningStep::CycleStart); !on) {
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
        if ((*state)[2] != static_cast<double>(kLayoutNumber)) {
          return base::fail(
              StreamError::WrongProgram,
              "The control runs another program, not the test. Reset it and select the test.",
              commissioningFileName());
        }
        return set(Begin, 1.0);
      }
      pause();
    }
    return base::fail(
        StreamError::NotStarted,
        "Cycle start was not pressed in time. Start again when the machine is ready.");
  }

  Result<Look> look() {
    const std::array<Variable, 6> watched{cell(Echo),   cell(Cycles),     cell(Phase),
                                          cell(Buffer), cell(CyclesSeen), cell(Mark)};
    const auto values = numbers(watched);
    if (!values) {
      return base::fail(values.error());
    }
    return Look{m_link.now(), (*values)[0], (*values)[1], (*values)[2],
                (*values)[3], (*values)[4], (*values)[5]};
  }

  /// One number after another, until the main run has finished.
  Result<void> ask() {
    const Instant until = m_link.now() + kRunMax;
    Instant askedAt{};
    bool isOpen = false;  // a number has not been answered
    while (m_link.now() < until) {
      if (Result<void> on = proceed(CommissioningStep::Running); !on) {
        return on;
      }
      const Result<Look> seen = look();
      if (!seen) {
        return base::fail(seen.error());
      }
      if (seen->phase == kThrough) {
        return {};
      }
      if (seen->phase != kAsking) {
        continue;  // it has not yet seen the client
      }
      m_looks.push_back(*seen);
      // Numbers that no counter can reach.
      if (isOpen && seen->answer == questionOf(m_result.asked)) {
        ++m_result.answered;
        m_result.slowestAnswer = std::max(m_result.slowestAnswer, seen->at - askedAt);
        isOpen = false;
      }
      if (!isOpen && m_result.asked < kQuestions) {
        ++m_result.asked;
        askedAt = m_link.now();
        isOpen = true;
        if (Result<void> done = set(Question, questionOf(m_result.asked)); !done) {
          return done;
        }
      }
    }
    return base::fail(StreamError::StreamStalled,
                      "The test did not finish. Reset the control and start again.");
  }

  static double questionOf(int number) { return 0.375 + 1000.0 * number; }

  Result<void> awaitEnd() {
    const std::array<Variable, 2> watched{
        {{VariableKind::ChannelStatus, 0}, {VariableKind::Alarm, 0}}};
    const Instant until = m_link.now() + kRunMax;
    while (m_link.now() < until) {
      const auto state = numbers(watched);
      if (!state) {
        return base::fail(state.error());
      }
      if (Result<void> fine = requireNoAlarm((*state)[1]); !fine) {
        return fine;
      }
      if ((*state)[0] == opcua::kChannelReset) {
        const Variable passes = cell(Passes);
        const auto value = numbers({&passes, 1});
        if (!value) {
          return base::fail(value.error());
        }
        m_passes = value->front();
        return {};
      }
      pause();
    }
    return base::fail(StreamError::StreamStalled,
                      "The program of the test did not end. Reset the control and start again.");
  }

  void add(const char* name, bool passed, std::string message) {
    m_result.checks.push_back({name, passed, std::move(message)});
  }

  void judge() {
    const auto grows = [this](double Look::*value) {
      return m_looks.size() >= 2 && m_looks.back().*value > m_looks.front().*value;
    };
    add("answers-while-busy", m_result.answered >= kAnswersMin,
        fmt::format("{} of {} numbers written by the client came back while blocks were waiting to "
                    "be executed, the slowest after {:.0f} ms.",
                    m_result.answered, m_result.asked,
                    base::toMilliseconds(m_result.slowestAnswer)));
    add("main-run-seen-by-client", grows(&Look::cycles),
        "What a synchronized action writes reaches the client.");
    add("main-run-seen-by-program", grows(&Look::cyclesSeen),
        "What a synchronized action writes reaches the program without a stop.");
    // The mark is set while its dwell is executed: not when it is interpreted, which was before
    // the first answer, and not at the end.
    const auto marked = std::find_if(m_looks.begin(), m_looks.end(),
                                     [](const Look& look) { return look.mark > 0.0; });
    const bool hasMark = marked != m_looks.end() && marked - m_looks.begin() >= 2;
    const bool inStep = hasMark && marked->mark > std::prev(marked)->cycles - 1.0 &&
                        std::prev(marked)->cycles > m_looks.front().cycles;
    add("action-with-its-block", inStep,
        "A synchronized action before a block is executed with that block.");
    const bool fed = std::any_of(m_looks.begin(), m_looks.end(),
                                 [](const Look& look) { return look.buffer > 0.0; });
    add("buffer-level", fed && m_passes > 1.0 && m_passes < kPassesMax,
        "$AC_IPO_BUF tells the program, without a stop, whether blocks are waiting.");
  }

  opcua::Link& m_link;
  opcua::Control& m_control;
  const CommissioningPlan& m_plan;
  const std::function<bool(CommissioningStep)>& m_progress;
  std::vector<Look> m_looks;
  double m_passes = 0.0;
  Commissioning m_result;
};

}  // namespace

bool Commissioning::passed() const {
  return !checks.empty() && std::all_of(checks.begin(), checks.end(),
                                        [](const CommissioningCheck& one) { return one.passed; });
}

std::string commissioningProgram(int firstCell) {
  RIVULET_ASSERT(firstCell >= 0);
  const auto r = [firstCell](Cell which) {
    return fmt::format("R{}", firstCell + static_cast<int>(which));
  };
  std::string text;
  const auto line = [&text](const std::string& block) { text += block + '\n'; };
  line("; RIVULET TEST FOR METHOD CREDIT: MOVES NO AXIS");
  line("; Do not edit: the client relies on every line.");
  line("; Does this control read R-parameters each time it passes a block, while others wait?");
  line(";");
  line(fmt::format("; {}  question of the client, {}  the answer: the same number", r(Question),
                   r(Echo)));
  line(fmt::format("; {}  the client writes 1 to begin", r(Begin)));
  line(
      fmt::format("; {}  interpolation cycles, counted by the main run, {}  as the program sees it",
                  r(Cycles), r(CyclesSeen)));
  line(fmt::format("; {}  number of this program, {}  1 asking, 2 through", r(Layout), r(Phase)));
  line(fmt::format("; {}  passes, {}  blocks in the buffer, {}  the main run has come to its mark",
                   r(Passes), r(Buffer), r(Mark)));
  line(";");
  line("DEF INT RIV_TURN");
  for (const Cell which :
       {Question, Echo, Begin, Cycles, Phase, Passes, Buffer, CyclesSeen, Mark}) {
    line(r(which) + "=0");
  }
  line("RIV_TURN=0");
  line("STOPRE");
  line(fmt::format("ID=1 DO ${}=${}+1", r(Cycles), r(Cycles)));
  line(fmt::format("{}={}", r(Layout), kLayoutNumber));
  line("RIV_WAIT:");
  line("STOPRE");
  line("RIV_TURN=RIV_TURN+1");
  line(fmt::format("IF RIV_TURN>{} GOTOF RIV_END", kWaitingPassesMax));
  line("G4 F0.02");
  line(fmt::format("IF {}<1 GOTOB RIV_WAIT", r(Begin)));
  line(fmt::format("{}=1", r(Phase)));
  line("; The main run is kept busy.");
  for (int dwell = 0; dwell < kDwells; ++dwell) {
    if (dwell == kMarkedDwell) {
      line(fmt::format("DO ${}=${}", r(Mark), r(Cycles)));
    }
    line(fmt::format("G4 F{}", kDwellS));
  }
  line("RIV_TURN=0");
  line("RIV_ASK:");
  line(fmt::format("{}={}", r(Echo), r(Question)));
  line(fmt::format("{}={}", r(CyclesSeen), r(Cycles)));
  line(fmt::format("{}=$AC_IPO_BUF", r(Buffer)));
  line("RIV_TURN=RIV_TURN+1");
  line(fmt::format("IF ($AC_IPO_BUF>0) AND (RIV_TURN<{}) GOTOB RIV_ASK", kPassesMax));
  line(fmt::format("{}=RIV_TURN", r(Passes)));
  line("STOPRE");
  line(fmt::format("{}={:.0f}", r(Phase), kThrough));
  line("RIV_END:");
  line("M30");
  return text;
}

std::string commissioningFileName() {
  return "RIVULET_CREDIT_TEST.MPF";
}

Result<Commissioning> commission(opcua::Link& link, opcua::Control& control,
                                 const CommissioningPlan& plan,
                                 const std::function<bool(CommissioningStep)>& progress) {
  return Test(link, control, plan, progress).run();
}

}  // namespace rivulet::streaming
