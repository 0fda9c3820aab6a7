// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Jobs that were interrupted go on where they were left: each motion of the source is made once.

#include <QtTest>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "forecast/job_forecast.h"
#include "job/dry_plan.h"
#include "job/main_program.h"
#include "machine/machine.h"
#include "opcua/await.h"
#include "opcua/forwarding_link.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/simulated_link.h"
#include "support/drawn_job.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "templates/window_protocol.h"

using namespace rivulet;
using namespace rivulet::tests;
using streaming::Outcome;

namespace {

const char* const kPart =
    "G54\n"
    "T1 D1 M6\n"
    "S3000 M3\n"
    "G0 X5 Y5 Z20\n"
    "G1 Z-1 F2000\n"
    "X20\nY20\nX6\nY7\nX18\nY18\nX8\nY9\nX16\nY16\n"
    "G0 Z20\n"
    "M8\n"
    "G0 X60 Y5\n"
    "G1 Z-2\n"
    "X80\nY25\nX62\nY8\nX78\n"
    "G0 Z20\n"
    "SUPA G0 Z200 D0\n"
    "T2 D1 M6\n"
    "G55\n"
    "S5000 M4\n"
    "G0 X-5 Y-5\n"
    "Z25\n"
    "G1 Z-3 F1500\n"
    "X-25\nY-25\nX-8\nY-9\nX-21\n"
    "G4 F2\n"
    "Y-11\nX-12\n"
    "G0 Z25\n"
    "M5 M9\n"
    "M30\n";

/// Interrupts a job at a moment.
class Watcher final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int next) override {
    if (next == resetBefore) {
      at = reset->now() + delay;
    }
  }
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
  bool stopRequested(base::Instant now) override {
    if (!at || now < *at) {
      return false;
    }
    if (reset != nullptr) {
      reset->reset();
      reset = nullptr;
    }
    return stops;
  }

  std::optional<base::Instant> at;
  bool stops = false;
  machine::Machine* reset = nullptr;
  int resetBefore = 0;  ///< stretch; `delay` after the client knows of the blocks before it
  base::Duration delay{};
};

streaming::RunSettings settings() {
  streaming::RunSettings all;
  all.parameters.pointsPerLoop = 4;
  all.feedMmPerS = 50.0;
  all.isCommissioned = true;
  return all;
}

/// An answer is falsified on its way: it tells of an alarm that there is not.
class FalseAlarm final : public opcua::ForwardingLink {
 public:
  FalseAlarm(opcua::Link& link, base::Instant from) : ForwardingLink(link), m_from(from) {}
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override {
    const base::RequestId request = ForwardingLink::read(variables, deadline, grouping);
    const opcua::Variable alarm{opcua::VariableKind::Alarm, 0};
    if (const auto found = std::ranges::find(variables, alarm); found != variables.end()) {
      m_alarms.emplace_back(request, found - variables.begin());
    }
    return request;
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    std::optional<opcua::Event> event = ForwardingLink::wait(until);
    if (event && event->kind == opcua::EventKind::ReadDone && !m_isDone && now() >= m_from) {
      const auto read = std::ranges::find(m_alarms, event->request,
                                          &std::pair<base::RequestId, std::ptrdiff_t>::first);
      if (read != m_alarms.end()) {
        event->readings[static_cast<std::size_t>(read->second)].number = 4096.0;
        m_isDone = true;
      }
    }
    return event;
  }

 private:
  base::Instant m_from;
  std::vector<std::pair<base::RequestId, std::ptrdiff_t>> m_alarms;
  bool m_isDone = false;
};

/// What the machine has done since; a start that did not come about leaves the trace before it.
trace::ControlTrace traceSince(opcua::Control& control, base::Instant from) {
  trace::ControlTrace trace = *control.fetchTrace();
  std::erase_if(trace.blocks, [from](const auto& block) { return block.from < from; });
  std::erase_if(trace.events, [from](const auto& event) { return event.from < from; });
  return trace;
}

QString stepsText(const forecast::Restart& restart) {
  QStringList steps;
  for (const std::string& step : restart.steps) {
    steps << QString::fromStdString(step);
  }
  return steps.join(QStringLiteral("; "));
}

void awaitReset(machine::Machine& machine) {
  streaming::SimulatedLink link(machine);
  while (machine.state().channel != machine::ChannelStatus::Reset) {
    (void)link.wait(link.now() + std::chrono::milliseconds{100});
  }
}

/// Until the program has ended, or its axes have stood so long without a client.
void leaveAlone(machine::Machine& machine, base::Duration stands) {
  streaming::SimulatedLink link(machine);
  base::Instant movesAt = link.now();
  while (machine.state().channel != machine::ChannelStatus::Reset &&
         link.now() - movesAt < stands) {
    (void)link.wait(link.now() + std::chrono::milliseconds{100});
    if (machine.ncRParameter(templates::WindowProtocol::OverrideActs) !=
        templates::FeedCell::kHold) {
      movesAt = link.now();
    }
  }
}

/// Somebody comes soon; or so late that a program that waits for its client has ended.
base::Duration standsBeforeSomebodyComes(int draw) {
  return draw % 2 == 0 ? base::Duration(std::chrono::seconds{3}) : std::chrono::minutes{2};
}

}  // namespace

class TestJobRestart : public QObject {
  Q_OBJECT

  trace::ControlTrace m_trace;
  std::vector<std::string> m_source;
  job::Plan m_plan;

  [[nodiscard]] auto zeroAt() const {
    return [this](std::size_t part) { return forecast::zeroAt(m_plan, mill(), part); };
  }

 private Q_SLOTS:
  void initTestCase() {
    m_trace = traceOfSource(kPart);
    m_source = motions(m_trace);
    m_plan = planOf(kPart);
    QVERIFY(m_source.size() > 30);
    QVERIFY(m_plan.stretchCount() >= 4);
  }

  void everywhere_data() {
    QTest::addColumn<QString>("how");
    QTest::newRow("stop") << QStringLiteral("stop");
    QTest::newRow("reset at the control") << QStringLiteral("reset");
    QTest::newRow("client killed") << QStringLiteral("kill");
  }

  /// Interrupted at every half second of the job, and once more at a moment of what is left.
  void everywhere() {
    QFETCH(const QString, how);
    int resumed = 0;
    int refused = 0;
    int standing = 0;
    int withinWindow = 0;
    for (int half = 1; half < 200; ++half) {
      machine::Machine machine(mill(), 1);
      LeftJob left{m_plan};
      JobJudge judge(m_source, 4);
      bool isRefused = false;
      for (const int interruption : {0, 1, 2}) {
        streaming::FaultyLink link(machine, {}, 1);
        Watcher watcher;
        if (interruption < 2) {
          const int halves = interruption == 0 ? half : 1 + (7 * half) % 29;
          watcher.at = link.now() + std::chrono::milliseconds{507 * halves};
        }
        watcher.stops = how == QStringLiteral("stop");
        watcher.reset = how == QStringLiteral("reset") ? &machine : nullptr;
        if (how == QStringLiteral("kill") && watcher.at) {
          link.onTime = [&] {
            if (link.now() >= *watcher.at) {
              link.setFaults({.disconnectProbability = 1.0});
            }
          };
        }
        const base::Instant from = link.now();
        const std::optional<streaming::Resume> resume =
            left.restart ? left.restart->rest.resume : std::nullopt;
        const streaming::WholeJobReport ended =
            streaming::runWholeJob(link, link, left.begin(), settings(), watcher, watcher,
                                   {.resume = resume, .keeper = &left.keeper});
        leaveAlone(machine, standsBeforeSomebodyComes(half));
        streaming::SimulatedLink again(machine);
        const std::string name = std::to_string(half) + "." + std::to_string(interruption) + ": ";
        if (ended.outcome == Outcome::Completed) {
          judge.add(motions(traceSince(again, from)));
          break;
        }
        QVERIFY2(interruption < 2, (name + ended.error.text()).c_str());
        QVERIFY2(left.keeper.last, name.c_str());
        if (const auto went = left.goOn(again, again, settings()); !went) {
          QVERIFY2(went.error().code == streaming::StreamError::CannotResume,
                   (name + went.error().text()).c_str());
          isRefused = true;
          qInfo("%s%s", name.c_str(), went.error().text().c_str());
          break;
        }
        QCOMPARE(machine.state().channel, machine::ChannelStatus::Reset);
        const std::vector<std::string> done = motions(traceSince(again, from));
        JobJudge soFar = judge;
        soFar.add(done);
        judge.add(done, isAtNextEnd(m_trace, soFar.done(), left.restart->rest, zeroAt()));
      }
      standing += left.standing;
      withinWindow += left.withinWindow;
      if (isRefused) {
        ++refused;
        continue;
      }
      const std::string wrong = judge.verdict();
      QVERIFY2(wrong.empty(), (std::to_string(half) + ": " + wrong).c_str());
      if (!left.restart) {
        break;  // the job is shorter
      }
      ++resumed;
    }
    qInfo("%d resumed, %d refused; %d stood on the control, %d of them within a window", resumed,
          refused, standing, withinWindow);
    QVERIFY(resumed > 20);
    QVERIFY(how != QStringLiteral("kill") || withinWindow > 5);
    QVERIFY(refused <= resumed / 10);
  }

  /// The control interprets what comes behind a cycle while it drills: a reset there leaves holes
  /// that nobody may take for drilled.
  void resetWhileDrilling_data() {
    QTest::addColumn<QString>("behind");
    QTest::newRow("retraction") << QStringLiteral("SUPA G0 Z150\n");
    QTest::newRow("retraction, no tool") << QStringLiteral("SUPA G0 Z200 D0\n");
    QTest::newRow("retraction before the cycle is off") << QStringLiteral("SUPA G0 Z100\nMCALL\n");
    QTest::newRow("spindle") << QStringLiteral("M5\n");
    QTest::newRow("motion") << QStringLiteral("G0 Z30\nX1 Y1\n");
    QTest::newRow("spindle and end") << QStringLiteral("M5 M30\n");
    QTest::newRow("motion and end") << QStringLiteral("G0 Z30 M30\n");
    QTest::newRow("assigned end") << QStringLiteral("M5 M=30\n");
    QTest::newRow("return, with an end in a text") << QStringLiteral("M5 MSG(\"M30\")\nRET\n");
    QTest::newRow("coolant and increment")
        << QStringLiteral("G0 X50 Y10\nG91 G1 X40 F900 M8\nG90 G0 X5\n");
    QTest::newRow("coolant and arc")
        << QStringLiteral("G0 X50 Y10\nG2 X90 Y10 CR=25 F900 M8\nG0 X5\n");
    QTest::newRow("coolant and straight") << QStringLiteral("G0 X50 Y10\nG1 X90 F900 M8\nG0 X5\n");
  }
  void resetWhileDrilling() {
    QFETCH(const QString, behind);
    const std::string text =
        "G54\nT1 D1 M6\nS3000 M3\nG0 X5 Y5 Z30\nF300\nMCALL CYCLE81(20,0,2,-5)\nX10 "
        "Y10\nX30\nX50\n" +
        std::string(behind.contains("MCALL") ? "" : "MCALL\n") + behind.toStdString() + "M30\n";
    const job::Plan plan = planOf(text);
    const trace::ControlTrace source = traceOfSource(text);
    int resumed = 0;
    int interrupted = 0;
    for (base::Duration at = std::chrono::seconds{6};; at += std::chrono::milliseconds{210}) {
      machine::Machine machine(mill(), 1);
      streaming::SimulatedLink link(machine);
      LeftJob left{plan};
      Watcher watcher;
      watcher.at = link.now() + at;
      watcher.reset = &machine;
      const auto first = streaming::runWholeJob(link, link, plan, settings(), watcher, watcher,
                                                {.keeper = &left.keeper});
      const std::vector<std::string> done = motions(*link.fetchTrace());
      JobJudge judge(motions(source), 4);
      judge.add(done);
      const std::string name = std::to_string(base::toSeconds(at)) + " s: ";
      if (first.outcome == Outcome::Completed) {
        QVERIFY2(judge.verdict().empty(), (name + judge.verdict()).c_str());
        if (watcher.reset != nullptr) {
          break;
        }
        continue;
      }
      ++interrupted;
      if (const auto went = left.goOn(link, link, settings()); !went) {
        QVERIFY2(went.error().code == streaming::StreamError::CannotResume,
                 (name + went.error().text()).c_str());
        continue;
      }
      ++resumed;
      const std::size_t doneCount = judge.done();
      judge = JobJudge(motions(source), 4);
      judge.add(done, isAtNextEnd(source, doneCount, left.restart->rest, [&plan](std::size_t part) {
                  return forecast::zeroAt(plan, mill(), part);
                }));
      const base::Instant from = link.now();
      Watcher onwards;
      const auto second = streaming::runWholeJob(link, link, left.begin(), settings(), onwards,
                                                 onwards, {.resume = left.restart->rest.resume});
      QVERIFY2(second.outcome == Outcome::Completed, second.error.text().c_str());
      judge.add(motions(traceSince(link, from)));
      const std::string wrong = judge.verdict();
      QVERIFY2(wrong.empty(), (name + wrong).c_str());
    }
    QVERIFY(resumed > 3 && interrupted > resumed + 3);
  }

  /// A finished job whose run has the number that tells the end: nothing of it is left to be made.
  void theNumberOfTheRunIsNotThatOfTheEnd() {
    machine::Machine machine(mill(), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    LastCheckpoint keeper;
    const auto done = streaming::runWholeJob(link, link, m_plan, settings(), watcher, watcher,
                                             {.keeper = &keeper});
    QVERIFY2(done.outcome == Outcome::Completed, done.error.text().c_str());
    awaitReset(machine);
    const auto programs = job::makePrograms(m_plan, settings().parameters);
    QVERIFY(programs);
    const std::array<opcua::Variable, 1> owner{opcua::rParameter(programs->loop.cells.owner)};
    const auto before = opcua::readNumbers(link, owner, std::chrono::seconds{1});
    QVERIFY(before);
    const int number = job::doneNumber(m_plan);
    const std::array<opcua::Assignment, 1> same{{{owner[0], static_cast<double>(number)}}};
    QVERIFY(opcua::writeNow(link, same, std::chrono::seconds{1}));
    keeper.last->runNumber += number - streaming::runNumberOf(before->front());
    const auto rest = streaming::whereJobWasLeft(link, m_plan, settings(), *keeper.last, zeroAt());
    QVERIFY(!rest);
    QCOMPARE(rest.error().code, make_error_code(streaming::StreamError::CannotResume));
  }

  /// The client is lost while it begins a job that the control has executed before: the control's
  /// cells tell of the earlier run until it is allowed to begin.
  void theSameJobOnceMore() {
    constexpr int kMoments = 50;
    constexpr std::chrono::milliseconds kStep{4};
    int early = 0;
    int moved = 0;
    for (int moment = 0; moment < kMoments; ++moment) {
      machine::Machine machine(mill(), 1);
      streaming::FaultyLink link(machine, {}, 1);
      Watcher watcher;
      const auto earlier =
          streaming::runWholeJob(link, link, m_plan, settings(), watcher, watcher, {});
      QVERIFY2(earlier.outcome == Outcome::Completed, earlier.error.text().c_str());
      awaitReset(machine);
      LeftJob left{m_plan};
      const base::Instant from = link.now();
      const base::Instant lostAt = from + moment * moment * kStep;
      link.onTime = [&] {
        if (link.now() >= lostAt) {
          link.setFaults({.disconnectProbability = 1.0});
        }
      };
      const auto begun = streaming::runWholeJob(link, link, m_plan, settings(), watcher, watcher,
                                                {.keeper = &left.keeper});
      QVERIFY(begun.outcome != Outcome::Completed);
      leaveAlone(machine, std::chrono::minutes{2});
      if (!left.keeper.last) {
        continue;  // nothing was begun
      }
      early += left.keeper.last->granted ? 0 : 1;
      streaming::SimulatedLink again(machine);
      JobJudge judge(m_source, 4);
      const std::string name = std::to_string(moment) + ": ";
      const auto went = left.goOn(again, again, settings());
      QVERIFY2(went, went ? "" : (name + went.error().text()).c_str());
      // With the rest of the window in which the silent client's axes were held.
      const std::vector<std::string> before = motions(traceSince(again, from));
      moved += before.empty() ? 0 : 1;
      judge.add(before, isAtNextEnd(m_trace, before.size(), left.restart->rest, zeroAt()));
      Watcher onwards;
      const auto rest = streaming::runWholeJob(again, again, left.begin(), settings(), onwards,
                                               onwards, {.resume = left.restart->rest.resume});
      QVERIFY2(rest.outcome == Outcome::Completed, (name + rest.error.text()).c_str());
      judge.add(motions(*rest.controlTrace));
      const std::string wrong = judge.verdict();
      QVERIFY2(wrong.empty(), (name + wrong).c_str());
    }
    QVERIFY2(early > 3 && moved > 3, qPrintable(QStringLiteral("%1 %2").arg(early).arg(moved)));
  }

  /// A client that has read of an alarm that there is not leaves the control in the middle of its
  /// program.
  void aFalseAlarmLosesNoJob() {
    int resumed = 0;
    for (int half = 1; half < 60; ++half) {
      machine::Machine machine(mill(), 1);
      streaming::SimulatedLink control(machine);
      FalseAlarm link(control, control.now() + half * std::chrono::milliseconds{507});
      LeftJob left{m_plan};
      JobJudge judge(m_source, 4);
      Watcher watcher;
      const base::Instant from = control.now();
      const auto begun = streaming::runWholeJob(link, control, left.begin(), settings(), watcher,
                                                watcher, {.keeper = &left.keeper});
      if (begun.outcome == Outcome::Completed) {
        break;  // the job is shorter
      }
      leaveAlone(machine, std::chrono::seconds{2});
      const std::string name = std::to_string(half) + ": " + begun.error.text() + ": ";
      QVERIFY2(left.keeper.last, name.c_str());
      const auto went = left.goOn(control, control, settings());
      QVERIFY2(went, went ? "" : (name + went.error().text()).c_str());
      awaitReset(machine);
      const std::vector<std::string> before = motions(traceSince(control, from));
      judge.add(before, isAtNextEnd(m_trace, before.size(), left.restart->rest, zeroAt()));
      Watcher onwards;
      const auto rest = streaming::runWholeJob(control, control, left.begin(), settings(), onwards,
                                               onwards, {.resume = left.restart->rest.resume});
      QVERIFY2(rest.outcome == Outcome::Completed, (name + rest.error.text()).c_str());
      judge.add(motions(*rest.controlTrace));
      const std::string wrong = judge.verdict();
      QVERIFY2(wrong.empty(), (name + wrong).c_str());
      ++resumed;
    }
    QVERIFY(resumed > 20);
  }

  /// Interrupted after a stretch and before the next block for the control has begun, at every
  /// cycle of that time: nothing is in doubt.
  void betweenStretchAndBlock() {
    constexpr int kCycles = 40;
    const base::Duration cycle = mill().interpolationCycle;
    for (int cycles = 0; cycles < kCycles; ++cycles) {
      machine::Machine machine(mill(), 1);
      streaming::SimulatedLink link(machine);
      Watcher watcher;
      LastCheckpoint keeper;
      watcher.reset = &machine;
      watcher.resetBefore = 2;
      watcher.delay = cycles * cycle;
      const auto first = streaming::runWholeJob(link, link, m_plan, settings(), watcher, watcher,
                                                {.keeper = &keeper});
      QVERIFY(first.outcome != Outcome::Completed && keeper.last);
      awaitReset(machine);
      const std::vector<std::string> before = motions(*link.fetchTrace());
      const auto rest =
          streaming::whereJobWasLeft(link, m_plan, settings(), *keeper.last, zeroAt());
      QVERIFY2(rest, rest ? "" : (std::to_string(cycles) + ": " + rest.error().text()).c_str());
      const auto restart = forecast::restartAt(m_plan, mill(), *rest);
      QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
      Watcher onwards;
      const streaming::WholeJobReport second = streaming::runWholeJob(
          link, link, restart->plan, settings(), onwards, onwards, {.resume = rest->resume});
      QVERIFY2(second.outcome == Outcome::Completed, second.error.text().c_str());
      JobJudge judge(m_source, 4);
      judge.add(before);
      judge.add(motions(*second.controlTrace));
      const std::string wrong = judge.verdict();
      QVERIFY2(wrong.empty(), (std::to_string(cycles) + ": " + wrong).c_str());
    }
  }

  /// Drawn parts, late and lost requests, broken connections, stops and resets at any time, up to
  /// three in a row. A number of scenarios and the first seed from the environment:
  /// RIVULET_SCENARIOS, RIVULET_FIRST.
  void drawnJobs() {
    const int scenarios = setting("RIVULET_SCENARIOS", 40);
    const int first = setting("RIVULET_FIRST", 1);
    std::size_t points = 0;
    std::size_t natives = 0;
    int completed = 0;
    int resumed = 0;
    int refused = 0;
    int resumes = 0;
    std::vector<int> seeds(static_cast<std::size_t>(scenarios));
    std::iota(seeds.begin(), seeds.end(), first);
    seeds.push_back(937);  // a resumed run that waits within the move to its first point
    for (const int seed : seeds) {
      base::Random random = base::Random(static_cast<std::uint64_t>(seed)).fork(1);
      const std::string text = drawPart(static_cast<std::uint64_t>(seed));
      const job::Plan plan = planOf(text);
      const trace::ControlTrace source = traceOfSource(text);
      const base::Duration sourceTime = source.samples.back().at - source.samples.front().at;
      machine::Machine machine(mill(), static_cast<std::uint64_t>(seed));
      streaming::RunSettings run = settings();
      run.parameters.pointsPerLoop = 3 + seed % 6;
      if (seed % 5 == 0) {
        run.parameters.method = base::MethodKind::Credit;
      }
      LeftJob left{plan};
      JobJudge judge(motions(source), 4);
      JobJudge tools(toolChanges(source), 1);
      natives += plan.nativeCount();
      bool isRefused = false;
      constexpr int kInterruptions = 3;
      for (int interruption = 0; interruption <= kInterruptions; ++interruption) {
        const int kind = (seed + interruption) % 4;
        const bool isCertain = interruption == kInterruptions;
        streaming::LinkFaults faults;
        if (!isCertain) {
          faults.delayProbability = 0.05;
          faults.delayMax = std::chrono::milliseconds{500};
          faults.lostRequestProbability = seed % 3 == 0 ? 0.0 : 0.0002;
          faults.lostAnswerProbability = seed % 3 == 0 ? 0.0 : 0.0002;
          faults.stallProbability = 0.003;
          faults.stallMax = std::chrono::seconds{2};
          faults.strayMax = std::chrono::seconds{5};
        }
        streaming::FaultyLink link(machine, faults,
                                   static_cast<std::uint64_t>(seed + 7919 * interruption));
        Watcher watcher;
        if (!isCertain) {
          watcher.at =
              link.now() + base::fromSeconds(base::toSeconds(sourceTime) * 1.5 * random.uniform());
          watcher.stops = kind == 1;
          watcher.reset = kind == 2 ? &machine : nullptr;
        }
        if (kind == 3 && !isCertain) {
          link.onTime = [&] {
            if (link.now() >= *watcher.at) {
              link.setFaults({.disconnectProbability = 1.0});
            }
          };
        }
        const base::Instant from = link.now();
        const std::optional<streaming::Resume> resume =
            left.restart ? left.restart->rest.resume : std::nullopt;
        const auto done = streaming::runWholeJob(link, link, left.begin(), run, watcher, watcher,
                                                 {.resume = resume, .keeper = &left.keeper});
        leaveAlone(machine, standsBeforeSomebodyComes(seed / 2));
        streaming::SimulatedLink again(machine);
        const std::string name =
            "seed " + std::to_string(seed) + "." + std::to_string(interruption) + ": ";
        const bool isCompleted = done.outcome == Outcome::Completed;
        QVERIFY2(isCompleted || !isCertain, (name + done.error.text()).c_str());
        // A fault before the job could be kept: nothing of it was to be executed.
        const bool isKept = left.keeper.last.has_value();
        const auto went =
            isCompleted || !isKept ? base::Result<void>() : left.goOn(again, again, run);
        awaitReset(machine);
        const trace::ControlTrace trace = traceSince(again, from);
        points += trace.blocks.size();
        tools.add(toolChanges(trace));
        if (isCompleted || !isKept) {
          judge.add(motions(trace));
          if (isCompleted) {
            break;
          }
          continue;
        }
        if (!went) {
          QVERIFY2(went.error().code == streaming::StreamError::CannotResume,
                   (name + went.error().text()).c_str());
          qInfo("%s%s", name.c_str(), went.error().text().c_str());
          isRefused = true;
          break;
        }
        JobJudge soFar = judge;
        soFar.add(motions(trace));
        judge.add(motions(trace),
                  isAtNextEnd(source, soFar.done(), left.restart->rest, [&plan](std::size_t part) {
                    return forecast::zeroAt(plan, mill(), part);
                  }));
        ++resumes;
      }
      if (isRefused) {
        ++refused;
        continue;
      }
      const std::string wrong = judge.verdict() + tools.verdict();
      QVERIFY2(wrong.empty(), ("seed " + std::to_string(seed) + ": " + wrong).c_str());
      ++(left.restart ? resumed : completed);
    }
    qInfo(
        "%zu blocks moved, %zu native blocks; %d jobs completed, %d after %d interruptions in all, "
        "%d refused",
        points, natives, completed, resumed, resumes, refused);
    QVERIFY(resumed > 0 && completed > 0);
  }

  /// The state is that of the source: what the machine turns, holds and cools with.
  void stateIsThatOfTheSource() {
    const auto restart = forecast::restartAtStretch(m_plan, mill(), 4);
    QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
    QCOMPARE(stepsText(*restart),
             QStringLiteral("G55; D1; G0 G90 Z=MAXVAL($AA_IW[Z],25); T2 M6; D1; "
                            "G0 G90 Z=MAXVAL($AA_IW[Z],25); S5000 M4; G0 G90 X-21 Y-9; M8; "
                            "G1 G90 G94 Z-3 F500"));
    QVERIFY(restart->notRestored.empty());
    QVERIFY(!forecast::restartAtStretch(m_plan, mill(), 99));
  }

  /// Motion alone, with what the program sets up before it: each difference is found, and nothing
  /// that the control does not report.
  void whatIsNotSetUpIsFound() {
    const job::Plan plan = planOf("G54\nT1 M6\nS3000 M3\nG0 X0 Y0 Z50\nT2 M6\nG1 X9 F500\nM30\n");
    job::Plan motion = plan;
    motion.program = {};
    const forecast::SetUp wanted = forecast::setUpOf(motion, mill());
    QCOMPARE(wanted.tool, std::string("1"));
    QCOMPARE(wanted.workOffset, std::string("G54"));
    QCOMPARE(wanted.perMin, std::optional(3000.0));
    using opcua::SpindleTurn;
    const streaming::EquipmentSeen right{
        1, "FACE_63", 1, "G54", 2990.0, 3000.0, SpindleTurn::Clockwise, false, false};
    QVERIFY(forecast::missingOf(wanted, right).isEmpty());
    QVERIFY(forecast::missingOf(wanted, {}).isEmpty());
    QVERIFY(forecast::missingOf(forecast::setUpOf(planOf("G0 X0 Y0 Z5\nM30\n"), mill()), right)
                .isEmpty());
    auto seen = right;
    seen.tool = 2;
    seen.toolName = "OTHER";
    QCOMPARE(forecast::missingOf(wanted, seen).tool, std::string("1"));
    seen = right;
    seen.workOffset = "G500";
    QCOMPARE(forecast::missingOf(wanted, seen).workOffset, std::string("G54"));
    for (const auto& [speed, turn] :
         {std::pair(0.0, SpindleTurn::Stands), std::pair(3000.0, SpindleTurn::Counterclockwise),
          std::pair(2900.0, SpindleTurn::Clockwise)}) {
      seen = right;
      seen.spindlePerMin = seen.spindleSetPerMin = speed;
      seen.turn = turn;
      QCOMPARE(forecast::missingOf(wanted, seen).perMin, std::optional(3000.0));
    }
  }

  /// The tool in the spindle stands low and is shorter than the one that follows: neither goes
  /// aside before it is above the path.
  void noToolGoesAsideBelowThePath() {
    machine::Machine machine(mill(), 1);
    streaming::SimulatedLink link(machine);
    QVERIFY(link.uploadProgram("LOW.MPF", "G54\nT1 D1 M6\nG0 X5 Y5 Z-1\nM30\n", true));
    QVERIFY(link.selectProgram("LOW.MPF") && link.cycleStart());
    awaitReset(machine);
    const auto restart = forecast::restartAtStretch(m_plan, mill(), 4);
    QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, restart->plan, settings(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    constexpr double kPathTopMm = 25.0;
    std::vector<double> risenMm;
    for (const trace::ExecutedBlock& block : report.controlTrace->blocks) {
      if (std::abs(block.targetMm.x - -21.0) < 1e-6) {
        // From 1 mm below the workpiece, then by what the second tool is longer.
        QCOMPARE(risenMm, (std::vector<double>{26.0, 15.0}));
        return;
      }
      QCOMPARE(block.targetMm.z, kPathTopMm);
      risenMm.push_back(block.lengthMm);
    }
    QFAIL("the tool never went to the path");
  }

  /// A dry run that begins in the middle is dry from its first block.
  void aDryRunStaysDry() {
    constexpr double kRaiseMm = 50.0;
    auto dry = job::dryPlan(m_plan, kRaiseMm);
    QVERIFY(dry);
    for (int stretch = 1; stretch <= static_cast<int>(m_plan.stretchCount()); ++stretch) {
      const auto wet = forecast::restartAtStretch(m_plan, mill(), stretch);
      const auto restart = forecast::restartAtStretch(*dry, mill(), stretch);
      QVERIFY2(restart && wet, restart ? "" : restart.error().text().c_str());
      const QString steps = stepsText(*restart);
      QVERIFY2(!steps.contains(QLatin1Char('S')) && !steps.contains(QStringLiteral("M8")),
               qPrintable(steps));
      const auto run = [](const job::Plan& plan) {
        machine::Machine machine(mill(), 1);
        streaming::SimulatedLink link(machine);
        Watcher watcher;
        return streaming::runWholeJob(link, link, plan, settings(), watcher, watcher);
      };
      const streaming::WholeJobReport made = run(restart->plan);
      const streaming::WholeJobReport other = run(wet->plan);
      QVERIFY2(made.outcome == Outcome::Completed, made.error.text().c_str());
      const auto lowest = [](const streaming::WholeJobReport& report) {
        double lowestMm = 1e9;
        for (const trace::ExecutedBlock& block : report.controlTrace->blocks) {
          lowestMm = std::min(lowestMm, block.targetMm.z);
        }
        return lowestMm;
      };
      QCOMPARE(std::lround(1000.0 * (lowest(made) - lowest(other))),
               std::lround(1000.0 * kRaiseMm));
    }
  }

  /// Where a stretch begins after blocks that hide it from the reader of the program: the tool goes
  /// there first, or the stretch is refused.
  void aStretchBeginsAtItsPlace() {
    const job::Plan plan = planOf(
        "G54\nT1 D1 M6\nG0 X5 Y5 Z20\nG1 Z-1 F500\nX20\nG0 Z20\nG0 X40 Y30 M8 M81\nZ30 M82\n"
        "Z2\nG1 Z-3 F500\nX50\nM30\n");
    const auto last = static_cast<int>(plan.stretchCount());
    const auto restart = forecast::restartAtStretch(plan, mill(), last);
    QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
    const QString steps = stepsText(*restart);
    QVERIFY2(steps.contains(QStringLiteral("G0 G90 X40 Y30")), qPrintable(steps));
    QCOMPARE(restart->notRestored.size(), std::size_t{2});
    // What is left can be checked against the machine, and can be restarted itself.
    machine::MachineConfig machine = mill();
    QVERIFY(forecast::hazardsOf(restart->plan, machine, {machine.start()}).empty());
    QVERIFY(forecast::zeroAt(restart->plan, machine, restart->plan.parts.size() - 1));
    const job::Plan unknown =
        planOf("G54\nT1 D1 M6\nG0 X5 Y5\nG1 X20 F500\nG0 X40 Y30 M81\nZ2\nG1 Z-3\nX50\nM30\n");
    const auto refused =
        forecast::restartAtStretch(unknown, mill(), static_cast<int>(unknown.stretchCount()));
    QVERIFY(!refused && refused.error().code == streaming::StreamError::CannotResume);
  }

  /// The gear of a spindle and its orientation are not established again, so the operator is told.
  void aGearIsNotRestored() {
    const job::Plan plan = planOf(
        "G54\nT1 D1 M6\nM41\nS800 M3\nM8\nG0 X5 Y5 Z20\nG1 Z-1 F500\nX20\nM19\nG4 F1\nS800 M3\n"
        "G1 X30\nM30\n");
    const auto last = static_cast<int>(plan.stretchCount());
    const auto restart = forecast::restartAtStretch(plan, mill(), last);
    QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
    QCOMPARE(restart->notRestored.size(), std::size_t{2});
    QCOMPARE(restart->notRestored.front(), std::string("line 3: M41"));
    QCOMPARE(restart->notRestored.back(), std::string("line 9: M19"));
  }

  /// Interrupted after the last stretch: only blocks of the control are left.
  void onlyBlocksAreLeft() {
    streaming::JobRest rest;
    rest.part = m_plan.parts.size() - 1;
    while (std::holds_alternative<job::NativeBlock>(m_plan.parts[rest.part - 1])) {
      --rest.part;
    }
    QVERIFY(rest.part < m_plan.parts.size() - 1);
    const auto restart = forecast::restartAt(m_plan, mill(), rest);
    QVERIFY2(restart, restart ? "" : restart.error().text().c_str());
    machine::Machine machine(mill(), 1);
    streaming::SimulatedLink link(machine);
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, restart->plan, settings(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QVERIFY(report.stretches.empty());
  }

  /// After a loss of power the control knows nothing: only a stretch can be chosen.
  void lossOfPower() {
    machine::Machine machine(mill(), 1);
    streaming::SimulatedLink link(machine);
    streaming::Checkpoint last;
    last.runNumber = 123;
    last.granted = true;
    const auto rest = streaming::whereJobWasLeft(link, m_plan, settings(), last, zeroAt());
    QVERIFY(!rest);
    QVERIFY(rest.error().text().find("--from-stretch") != std::string::npos);
    const auto restart = forecast::restartAtStretch(m_plan, mill(), 3);
    QVERIFY(restart);
    Watcher watcher;
    const streaming::WholeJobReport report =
        streaming::runWholeJob(link, link, restart->plan, settings(), watcher, watcher);
    QVERIFY2(report.outcome == Outcome::Completed, report.error.text().c_str());
    QCOMPARE(report.stretches.front().number, 3);
    QCOMPARE(motions(*report.controlTrace).back(), m_source.back());
  }
};

RIVULET_TEST(TestJobRestart)
#include "tst_job_restart.moc"
