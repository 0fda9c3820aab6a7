// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/job_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "base/axes.h"
#include "opcua/await.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/run.h"
#include "streaming/run/whole_job.h"
#include "streaming/setup/job_test_job.h"
#include "streaming/setup/job_test_round.h"
#include "streaming/setup/program_test.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using job::NativeReason;
using opcua::Variable;
using opcua::VariableKind;
using templates::FeedCell;

constexpr Duration kSteady = std::chrono::milliseconds{500};
constexpr Duration kBrakes = std::chrono::seconds{3};
constexpr Duration kStaysFor = std::chrono::seconds{2};
/// A dwell as the client sees it: it looks every 20 ms, twice.
constexpr double kDwellToleranceS = 0.1;

/// One start of the job, when it has ended.
struct Played {
  std::unique_ptr<JobTestRound> round;
  WholeJobReport report;
};

class JobTest : ProgramTest {
 public:
  JobTest(opcua::Link& link, opcua::Control& control, const JobTestPlan& plan,
          const JobTestTalk& talk)
      : ProgramTest(link, control, plan, talk.progress), m_jobPlan(plan), m_talk(talk) {
    m_result.move = plan.move;
  }

  Result<JobCommissioning> run() {
    if (Result<void> free = requireReset(); !free) {
      return base::fail(free.error());
    }
    const auto start = place();
    if (!start) {
      return base::fail(start.error());
    }
    auto job = makeJobTestJob(m_jobPlan, *start);
    if (!job) {
      return base::fail(job.error());
    }
    m_job = std::move(*job);
    for (const auto scene : {&JobTest::stopInBlock, &JobTest::stopInStretch, &JobTest::loseInBlock,
                             &JobTest::loseInStretch, &JobTest::goThrough}) {
      if (!m_result.checks.empty() && !m_result.passed()) {
        break;
      }
      Result<void> done = (this->*scene)();
      if (!done) {
        return base::fail(done.error());
      }
    }
    if (!m_result.passed()) {
      leave();
    }
    return std::move(m_result);
  }

 private:
  void add(const char* name, bool passed, std::string message) {
    m_result.checks.push_back({name, passed, std::move(message)});
  }

  Result<base::Vec3> place() {
    constexpr std::array<Variable, base::kAxisCount> kPlace{{{VariableKind::ActualPosition, 0},
                                                             {VariableKind::ActualPosition, 1},
                                                             {VariableKind::ActualPosition, 2}}};
    const auto read = numbers(kPlace);
    if (!read) {
      return base::fail(read.error());
    }
    return base::Vec3{(*read)[0], (*read)[1], (*read)[2]};
  }

  Result<bool> isReset() {
    constexpr std::array<Variable, 1> kStatus{{{VariableKind::ChannelStatus, 0}}};
    const auto read = numbers(kStatus);
    if (!read) {
      return base::fail(read.error());
    }
    return (*read)[0] == opcua::kChannelReset;
  }

  /// A control that has failed is not left with a program in it, as far as that can be commanded.
  void leave() {
    const auto ended = isReset();
    if (ended && !*ended && m_control.abilities().startsOnRequest) {
      (void)m_control.reset();
    }
  }

  [[nodiscard]] std::size_t axis() const { return static_cast<std::size_t>(m_jobPlan.move.axis); }

  /// Runs the job once, from where the axis stands now.
  /// @return the error if it says nothing of what is tested
  Result<Played> play(JobTestScene scene) {
    const auto before = place();
    if (!before) {
      return base::fail(before.error());
    }
    const double beforeMm = (*before)[axis()];
    Played played{std::make_unique<JobTestRound>(m_link, m_control, m_job, m_jobPlan, scene,
                                                 beforeMm, m_isFirst, m_talk),
                  {}};
    JobTestRound& round = *played.round;
    m_isFirst = false;
    played.report = runWholeJob(round.link(), m_control, m_job.plan, m_job.programs, m_job.settings,
                                round, round);
    if (round.isCancelled()) {
      return base::fail(StreamError::Cancelled,
                        "The test was aborted. Reset the control if its program is still running.");
    }
    if (round.countsFromMm()) {
      return base::fail(
          job::JobError::PositionDiffers,
          fmt::format("In a program {} is at {:.3f} mm, and without one at {:.3f} mm: another work "
                      "offset or tool length is active there. Nothing was moved. Activate before "
                      "the test what a program begins with.",
                      base::kAxisNames[axis()], *round.countsFromMm(), beforeMm));
    }
    if (isNoVerdict(played.report.error.code, round)) {
      return base::fail(played.report.error);
    }
    return played;
  }

  /// What ended the job says nothing of the control.
  static bool isNoVerdict(const std::error_code& code, const JobTestRound& round) {
    const bool isOfLink =
        code && code.category() == make_error_code(opcua::LinkError::NotReachable).category();
    return (isOfLink && !round.isLost()) || code == StreamError::NotStarted ||
           code == StreamError::ChannelBusy || code == StreamError::TransferRefused ||
           (code == StreamError::ControlAlarm && round.isTrying());
  }

  /// The job came as far as the scene wants it. @return false: a check has failed
  bool handedOver(const JobTestRound& round, const WholeJobReport& report) {
    if (round.isStalled()) {
      add("hand-over", false,
          fmt::format("The job did not go on ({}). Reset the control.", describe(report.reached)));
      return false;
    }
    if (report.outcome == Outcome::Failed && !round.isLost()) {
      add("hand-over", false, report.error.text());
      return false;
    }
    return true;
  }

  Result<void> stopInBlock() {
    const auto played = play(JobTestScene::StopInBlock);
    if (!played) {
      return base::fail(played.error());
    }
    const auto& [roundOf, report] = *played;
    const JobTestRound& round = *roundOf;
    const std::optional<int> early = round.earlyAfter();
    add("waits-for-client", early != 0,
        early == 0 ? "The control executed blocks before the client had permitted it."
                   : "Before the permission of the client nothing was executed.");
    if (early == 0 || !handedOver(round, report)) {
      return {};
    }
    add("waits-after-stretch", early != 1,
        early == 1 ? "After a stretch the control executed blocks before the client had permitted "
                     "it."
                   : "After a stretch nothing was executed before the permission of the client.");
    return early == 1 ? Result<void>()
                      : judgeStop("stopped-in-block", round, report, m_job.farMm,
                                  "the block in motion was executed, and none after it");
  }

  Result<void> stopInStretch() {
    const auto played = play(JobTestScene::StopInStretch);
    if (!played) {
      return base::fail(played.error());
    }
    const auto& [roundOf, report] = *played;
    const JobTestRound& round = *roundOf;
    return handedOver(round, report)
               ? judgeStop("stopped-in-stretch", round, report, m_job.nearMm,
                           "the window in motion was executed, and no block after it")
               : Result<void>();
  }

  Result<void> judgeStop(const char* name, const JobTestRound& round, const WholeJobReport& report,
                         double endMm, const char* what) {
    const auto ended = isReset();
    const auto there = place();
    if (!ended || !there) {
      return base::fail(ended ? there.error() : ended.error());
    }
    const bool isThere = std::abs((*there)[axis()] - endMm) <= kTestPlaceMm;
    const bool passed = round.hasActed() && report.outcome == Outcome::Stopped && *ended && isThere;
    add(name, passed,
        passed ? fmt::format("After the stop {}.", what)
        : !round.hasActed()
            ? "The axis was not seen on its way, so that nothing could be stopped."
            : fmt::format("After the stop {} stood at {:.3f} mm instead of {:.3f} mm{}.",
                          base::kAxisNames[axis()], (*there)[axis()], endMm,
                          *ended ? "" : ", and the program had not ended"));
    return {};
  }

  Result<void> loseInBlock() {
    return lose(JobTestScene::LoseInBlock, "silence-in-block", m_job.farMm);
  }
  Result<void> loseInStretch() {
    return lose(JobTestScene::LoseInStretch, "silence-in-stretch", m_job.nearMm);
  }

  /// The client is gone: the axes stand on their way, and the program can be ended by another one.
  Result<void> lose(JobTestScene scene, const char* name, double endMm) {
    const auto played = play(scene);
    if (!played) {
      return base::fail(played.error());
    }
    const auto& [roundOf, report] = *played;
    const JobTestRound& round = *roundOf;
    if (!handedOver(round, report)) {
      return {};
    }
    const auto stood = awaitStanding();
    if (!stood) {
      return base::fail(stood.error());
    }
    const auto ended = isReset();
    if (!ended) {
      return base::fail(ended.error());
    }
    const bool isOnTheWay = *stood && !*ended && std::abs((**stood)[axis()] - endMm) > kTestPlaceMm;
    if (!isOnTheWay) {
      add(name, false,
          fmt::format(
              "Without signs of the client the axis did not stand on its way within {:g} s.",
              m_job.settings.parameters.silenceLimitS + base::toSeconds(kBrakes)));
      return {};
    }
    return endLost(name, endMm);
  }

  /// @return where the axes have stood for a while; nothing: they did not
  Result<std::optional<base::Vec3>> awaitStanding() {
    const Duration limit = base::fromSeconds(m_job.settings.parameters.silenceLimitS);
    const Instant until = m_link.now() + limit + kBrakes + kStaysFor;
    Instant since = m_link.now();
    std::optional<base::Vec3> last;
    while (m_link.now() < until) {
      const auto here = place();
      if (!here) {
        return base::fail(here.error());
      }
      if (!last || base::distance(*here, *last) > kTestStandsMm) {
        since = m_link.now();
        last = *here;
      }
      pause();
    }
    return m_link.now() - since >= kStaysFor ? last : std::nullopt;
  }

  Result<void> endLost(const char* name, double endMm) {
    const auto found =
        findRun(m_link, m_control, m_job.settings.parameters.baseCell, kHeartbeatWatch);
    if (!found) {
      return base::fail(found.error());
    }
    if (!*found || (*found)->hasClient) {
      add(name, false,
          "The axes stood without signs of the client, but its job was not found on the control.");
      return {};
    }
    const Result<void> ended = endRun(m_link, **found, m_job.settings);
    const auto there = place();
    if (!there) {
      return base::fail(there.error());
    }
    const bool isThere = std::abs((*there)[axis()] - endMm) <= kTestPlaceMm;
    add(name, ended && isThere,
        ended && isThere
            ? "Without signs of the client the axes stood on their way, and another client ended "
              "the job."
            : fmt::format(
                  "The job of a lost client was not ended as it should: {} at {:.3f} mm. {}",
                  base::kAxisNames[axis()], (*there)[axis()],
                  ended ? std::string() : ended.error().text()));
    return {};
  }

  Result<void> goThrough() {
    const auto played = play(JobTestScene::Whole);
    if (!played) {
      return base::fail(played.error());
    }
    const auto& [roundOf, report] = *played;
    const JobTestRound& round = *roundOf;
    for (const auto& [name, held, what] :
         {std::tuple{"held-in-block", round.heldInBlock(), "a block of the control"},
          std::tuple{"held-in-stretch", round.heldInStretch(), "a stretch"}}) {
      if (held) {
        add(name, *held,
            fmt::format("In {} the axis {}.", what,
                        *held ? "stood on its way for as long as it was held"
                              : "did not stand, or not for as long as it was held"));
      }
    }
    if (!m_result.passed() || !handedOver(round, report)) {
      return {};
    }
    const bool isThrough = report.outcome == Outcome::Completed || round.isElsewhere();
    const bool isHeld = round.heldInBlock() && round.heldInStretch();
    const trace::Integrity& trace = report.integrity;
    const bool isFaulty = trace.judged && !trace.isFaultless();
    add("hand-over", isThrough && isHeld && !isFaulty,
        isFaulty     ? "By the control's trace not every point was executed once and in order."
        : !isThrough ? "The job was ended before its last block."
        : !isHeld    ? "The axis was not seen on its way, so that it could not be held."
                     : fmt::format("Blocks and {} stretches were executed in turns, once and in "
                                      "order{}.",
                                   report.stretches.size(),
                                trace.judged ? ", by the control's trace too" : ""));
    judgeDwell(report);
    m_result.tried = round.tried();
    askOperator();
    return m_result.passed() ? endsWithJob() : Result<void>();
  }

  void judgeDwell(const WholeJobReport& report) {
    const double lasted = base::toSeconds(report.partTimes[m_job.dwellPart].native);
    add("executes-blocks", lasted >= kTestDwellS - kDwellToleranceS,
        fmt::format("A dwell of {:g} s lasted {:.2f} s.", kTestDwellS, lasted));
  }

  /// What the control does not show. A block that it has passed over without a word fails it.
  void askOperator() {
    for (TriedBlock& block : m_result.tried) {
      if (block.witness != Witness::Nobody || !m_talk.hasSeen) {
        continue;
      }
      const std::optional<bool> seen = m_talk.hasSeen(block.text);
      if (seen && *seen) {
        block.witness = Witness::Operator;
        block.message = "The operator has seen it.";
      } else if (seen) {
        add("executes-blocks", false,
            fmt::format("The operator has seen that \"{}\" was not executed.", block.text));
      }
    }
  }

  /// Another value in the cell: what still follows it has not ended.
  Result<void> endsWithJob() {
    const auto& cells = m_job.programs.loop.cells;
    const std::array<Variable, 1> acts{opcua::rParameter(cells.overrideActs)};
    const auto before = numbers(acts);
    if (!before) {
      return base::fail(before.error());
    }
    const double other = (*before)[0] == FeedCell::kHold ? FeedCell::kProgrammed : FeedCell::kHold;
    const opcua::Assignment wanted{opcua::rParameter(cells.overrideWanted), other};
    if (Result<void> done = opcua::writeNow(m_link, {&wanted, 1}, m_plan.requestDeadline); !done) {
      return done;
    }
    const Instant until = m_link.now() + kSteady;
    bool follows = false;
    while (m_link.now() < until) {
      const auto now = numbers(acts);
      if (!now) {
        return base::fail(now.error());
      }
      follows = follows || (*now)[0] != (*before)[0];
      pause();
    }
    add("ends-with-job", !follows,
        follows ? "After the end of the job its synchronized actions go on."
                : "The synchronized actions have ended with the job.");
    return {};
  }

  const JobTestPlan& m_jobPlan;
  const JobTestTalk& m_talk;
  JobTestJob m_job;
  JobCommissioning m_result;
  bool m_isFirst = true;  ///< start of the job
};

/// What such a block does is known for each text alone.
bool isOneMachines(NativeReason reason) {
  return reason == NativeReason::Other || reason == NativeReason::Subprogram ||
         reason == NativeReason::Probing;
}

}  // namespace

std::string jobTestName() {
  return std::string(kJobTestSource);
}

std::string_view witnessName(Witness witness) {
  switch (witness) {
    case Witness::Nobody:
      return "nobody";
    case Witness::Control:
      return "control";
    case Witness::Operator:
      return "operator";
  }
  return {};
}

std::optional<Witness> witnessFromName(std::string_view name) {
  for (const Witness witness : {Witness::Nobody, Witness::Control, Witness::Operator}) {
    if (witnessName(witness) == name) {
      return witness;
    }
  }
  return std::nullopt;
}

bool JobCommissioning::releases(const job::NativeBlock& block) const {
  if (!passed()) {
    return false;
  }
  return isOfTest(block.reason) ||
         std::any_of(tried.begin(), tried.end(), [&block](const TriedBlock& each) {
           const bool isOfKind =
               std::find(each.kinds.begin(), each.kinds.end(), block.reason) != each.kinds.end();
           return each.witness != Witness::Nobody && isOfKind &&
                  (!isOneMachines(block.reason) || each.text == block.text);
         });
}

Result<void> requireJobTestPlan(const JobTestPlan& plan) {
  if (Result<void> fit = requireAirMove(plan.move); !fit) {
    return fit;
  }
  if (plan.move.liftMm != 0.0) {
    return base::fail(StreamError::BadAirMove,
                      "The tool is not lifted in the test of whole jobs: leave the lift out.");
  }
  const auto job = makeJobTestJob(plan, {});
  return job ? Result<void>() : base::fail(job.error());
}

Result<JobCommissioning> testJobs(opcua::Link& link, opcua::Control& control,
                                  const JobTestPlan& plan, const JobTestTalk& talk) {
  if (Result<void> fit = requireJobTestPlan(plan); !fit) {
    return base::fail(fit.error());
  }
  return JobTest(link, control, plan, talk).run();
}

}  // namespace rivulet::streaming
