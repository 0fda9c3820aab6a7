// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/commissioning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.h"
#include "streaming/run/run.h"
#include "streaming/setup/program_test.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;

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

/// R-parameters of the test, counted from its first.
enum Cell { Question, Echo, Begin, Cycles, Layout, Phase, Passes, Buffer, CyclesSeen, Mark };
static_assert(Mark + 1 == kCreditTestCells);
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

class Test : ProgramTest {
 public:
  using ProgramTest::ProgramTest;

  Result<Commissioning> run() {
    for (const auto step : {&Test::begin, &Test::ask, &Test::end}) {
      if (Result<void> done = (this->*step)(); !done) {
        return base::fail(done.error());
      }
    }
    judge();
    return std::move(m_result);
  }

 private:
  Result<void> begin() {
    Result<void> done = requireReset();
    done = done ? transfer(commissioningFileName(), commissioningProgram(m_plan.firstCell), Layout)
                : done;
    done = done ? awaitStart(CommissioningStep::CycleStart, Layout, kTestLayout,
                             commissioningFileName())
                : done;
    return done ? set(Begin, 1.0) : done;
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

  Result<void> end() {
    if (Result<void> done = awaitEnd(CommissioningStep::Running, kRunMax); !done) {
      return done;
    }
    const Variable passes = cell(Passes);
    const auto value = numbers({&passes, 1});
    if (!value) {
      return base::fail(value.error());
    }
    m_passes = value->front();
    return {};
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

  std::vector<Look> m_looks;
  double m_passes = 0.0;
  Commissioning m_result;
};

}  // namespace

bool ChecksOfControl::passed() const {
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
  line(fmt::format("{}={}", r(Layout), kTestLayout));
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
