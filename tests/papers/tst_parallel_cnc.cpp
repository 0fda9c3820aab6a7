// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 13 of [P3] on its net.

#include <QtTest>
#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <vector>

#include "papers/parallel_cnc.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

/// The six tasks again, without a net: six states, five numbers and a list of who waits.
class SixTasks {
 public:
  enum class Policy { Ordered, Printed, DataFlow };
  struct Settings {
    Policy policy = Policy::Ordered;
    int processors = 5;
    long executionUs = 10'000;
    long taskCycleUs = 0;
    long positionCycleUs = 10'000;
  };
  struct Counts {
    long setPoints = 0;
    long waitedUs = 0;
    long preemptions = 0;
    std::array<double, 5> mean{};
  };

  explicit SixTasks(const Settings& settings) : m_settings(settings) {}

  Counts run(long untilUs) {
    for (long now = 0; now <= untilUs;) {
      finish(now);
      while (start(now)) {
      }
      dispatch(now);
      const long next = std::min(nextEvent(now), untilUs + 1);
      const auto lasts = static_cast<double>(std::min(next, untilUs) - now);
      for (std::size_t b = 0; b < 5; ++b) {
        m_counts.mean[b] +=
            lasts * static_cast<double>(m_level[b + 1]) / static_cast<double>(untilUs);
      }
      now = next;
    }
    return m_counts;
  }

 private:
  static constexpr int kPosition = 6;
  static constexpr long kCapacity = 50;
  enum class State { Idle, Waiting, Running };
  struct Task {
    State state = State::Idle;
    long from = 0;  ///< idle: may start then; running: ends then
    long left = 0;
    long preempted = 0;  ///< in this step; the net counts it when the step is complete
  };

  Task& task(int id) { return m_tasks[static_cast<std::size_t>(id)]; }
  long& level(int buffer) { return m_level[static_cast<std::size_t>(buffer)]; }
  long before(int id) { return id == 1 ? kCapacity : level(id - 1); }

  void finish(long now) {
    for (int id = 1; id <= 6; ++id) {
      if (task(id).state != State::Running || task(id).from > now) {
        continue;
      }
      m_running.erase(std::find(m_running.begin(), m_running.end(), id));
      id == kPosition ? ++m_counts.setPoints : ++level(id);
      m_counts.preemptions += task(id).preempted;
      const long cycle = id == kPosition ? m_settings.positionCycleUs
                         : id == 1       ? 0
                                         : m_settings.taskCycleUs;
      task(id) = {State::Idle, cycle == 0 ? now : (now + cycle - 1) / cycle * cycle, 0, 0};
    }
  }

  bool start(long now) {
    for (int id = 1; id <= 6; ++id) {
      const bool hasData = before(id) > 0;
      const bool hasRoom = id == kPosition || level(id) < kCapacity;
      if (task(id).state != State::Idle || task(id).from > now || !hasData || !hasRoom) {
        continue;
      }
      if (id > 1) {
        --level(id - 1);
      }
      m_counts.waitedUs += id == kPosition ? now - task(id).from : 0;
      task(id) = {State::Waiting, 0, id == kPosition ? 5'000 : m_settings.executionUs, 0};
      m_waiting.push_back(id);
      return true;
    }
    return false;
  }

  /// The smallest goes first.
  std::tuple<int, long, int> rank(int id) {
    if (id == kPosition) {
      return {0, 0, id};
    }
    switch (m_settings.policy) {
      case Policy::Ordered:
        return {1, -id, id};
      case Policy::Printed:
        return {1, 0, id};
      case Policy::DataFlow:
        return {1, level(id) - before(id), id};
    }
    return {};
  }

  void dispatch(long now) {
    while (!m_waiting.empty()) {
      const auto first = std::min_element(m_waiting.begin(), m_waiting.end(),
                                          [&](int a, int b) { return rank(a) < rank(b); });
      const int id = *first;
      if (static_cast<int>(m_running.size()) == m_settings.processors) {
        if (id != kPosition) {
          return;
        }
        Task& other = task(m_running.front());  // the net takes the one that runs longest
        other = {State::Waiting, 0, other.from - now, other.preempted + 1};
        m_waiting.push_back(m_running.front());
        m_running.erase(m_running.begin());
      }
      m_waiting.erase(std::find(m_waiting.begin(), m_waiting.end(), id));
      m_running.push_back(id);
      task(id) = {State::Running, now + task(id).left, 0, task(id).preempted};
    }
  }

  long nextEvent(long now) {
    long next = std::numeric_limits<long>::max();
    for (int id = 1; id <= 6; ++id) {
      if (task(id).state != State::Waiting && task(id).from > now) {
        next = std::min(next, task(id).from);
      }
    }
    return next;
  }

  Settings m_settings;
  std::array<Task, 7> m_tasks{};
  std::array<long, 7> m_level{};
  std::vector<int> m_waiting;
  std::vector<int> m_running;  ///< in the order in which they got their processor
  Counts m_counts;
};

SixTasks::Settings settingsOf(const pipeline::Figure13Reading& reading, petri::Word cycleMs,
                              bool dataFlow) {
  using Policy = SixTasks::Policy;
  return {dataFlow ? Policy::DataFlow : (reading.asPrinted ? Policy::Printed : Policy::Ordered),
          static_cast<int>(reading.processors), 1000 * reading.executionMs,
          1000 * reading.taskCycleMs, 1000 * cycleMs};
}

QByteArray textOf(const pipeline::Figure13Reading& reading, petri::Word cycleMs, bool dataFlow) {
  return QByteArray(reading.asPrinted ? "printed" : "ordered") + ", " +
         QByteArray::number(static_cast<int>(reading.executionMs)) + " ms, " +
         QByteArray::number(static_cast<int>(reading.taskCycleMs)) + " ms, " +
         QByteArray::number(static_cast<int>(reading.processors)) + " processors, cycle " +
         QByteArray::number(static_cast<int>(cycleMs)) + (dataFlow ? " ms, flow" : " ms");
}

/// One letter for each finding: yes or no.
std::string verdicts(const papers::Figure13Runs& runs) {
  std::string text;
  for (const papers::Figure13Finding& finding : papers::findingsOf(runs)) {
    text += finding.isSupported ? 'y' : 'n';
  }
  return text;
}

papers::Figure13Runs runsWith(const pipeline::Figure13Reading& reading,
                              const petri::ParameterValues& changes) {
  papers::Figure13Runs runs;
  for (std::size_t i = 0; i < pipeline::kFigure13CyclesMs.size(); ++i) {
    for (const bool dataFlow : {false, true}) {
      petri::ParameterValues values =
          pipeline::figure13Parameters(reading, pipeline::kFigure13CyclesMs[i], dataFlow);
      for (const auto& [name, value] : changes) {
        values[name] = value;
      }
      (dataFlow ? runs.byDataFlow : runs.byDependency)[i] =
          *papers::runParallelCnc(values, pipeline::kFigure13S);
    }
  }
  return runs;
}

}  // namespace

class TestParallelCnc : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The net and the small simulation have nothing in common but [P3].
  void netAgreesWithAnIndependentSimulation() {
    int cells = 0;
    for (const pipeline::Figure13Reading& reading : pipeline::figure13Readings()) {
      for (const petri::Word cycleMs : {2, 10, 12, 13, 15}) {
        for (const bool dataFlow : {false, true}) {
          const QByteArray where = textOf(reading, cycleMs, dataFlow);
          const auto net = papers::runParallelCnc(
              pipeline::figure13Parameters(reading, cycleMs, dataFlow), pipeline::kFigure13S);
          QVERIFY(net.has_value());
          const SixTasks::Counts other =
              SixTasks(settingsOf(reading, cycleMs, dataFlow)).run(3'000'000);
          QVERIFY2(net->setPoints == static_cast<double>(other.setPoints), where.constData());
          QVERIFY2(net->preemptions == static_cast<double>(other.preemptions), where.constData());
          QVERIFY2(std::abs(net->waitingShare - static_cast<double>(other.waitedUs) / 3e6) < 1e-9,
                   where.constData());
          for (std::size_t b = 0; b < pipeline::kBufferCount; ++b) {
            QVERIFY2(std::abs(net->mean[b] - other.mean[b]) < 1e-6, where.constData());
          }
          ++cells;
        }
      }
    }
    QCOMPARE(cells, 18 * 5 * 2);
  }

  /// What the page says of Table 1 as printed, and of its text's order.
  void verdictsDependOnTheReading() {
    QCOMPARE(verdicts(*papers::runFigure13({true, 10, 0, 5})), std::string("ynnyynn"));
    QCOMPARE(verdicts(*papers::runFigure13({false, 10, 0, 5})), std::string("ynyynyn"));
    QCOMPARE(verdicts(*papers::runFigure13({true, 10, 0, 6})), std::string("yyynnyn"));
    const auto result = papers::parallelCncExperiment();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QCOMPARE(result->plots.size(), std::size_t(9));
    QCOMPARE(result->tables[1].rows.size(), std::size_t(18));
    // What a check counts is what its column of the table shows.
    for (std::size_t i = 0; i < result->checks.size(); ++i) {
      const auto shown = std::ranges::count_if(
          result->tables[1].rows,
          [&](const std::vector<std::string>& row) { return row[1 + i].starts_with("yes"); });
      QCOMPARE(result->checks[i].ours, static_cast<double>(shown));
      QCOMPARE(result->checks[i].passed(), shown > 0);
    }
  }

  /// A finding that no wrong machine contradicts would say nothing.
  void eachFindingCanFail() {
    struct Wrong {
      const char* name;
      pipeline::Figure13Reading reading;
      petri::ParameterValues changes;
    };
    const pipeline::Figure13Reading printed;
    pipeline::Figure13Reading ordered;
    ordered.asPrinted = false;
    pipeline::Figure13Reading enough;
    enough.processors = 6;
    const std::vector<Wrong> machines{
        {"tasks three times as slow", ordered, {{"execution", 30'000}}},
        {"tasks twice as fast", ordered, {{"execution", 5'000}}},
        {"slow position control", ordered, {{"position_execution", 20'000}}},
        {"buffers for one", printed, {{"capacity", 1}}},
        {"a processor for each, slow position control", enough, {{"position_execution", 12'000}}},
    };
    std::set<std::size_t> caught;
    for (const Wrong& machine : machines) {
      const auto right = papers::findingsOf(*papers::runFigure13(machine.reading));
      const auto wrong = papers::findingsOf(runsWith(machine.reading, machine.changes));
      bool isCaught = false;
      for (std::size_t i = 0; i < right.size(); ++i) {
        if (right[i].isSupported && !wrong[i].isSupported) {
          qInfo("%s: caught by \"%s\" (%s, not %s)", machine.name, right[i].what,
                wrong[i].ours.c_str(), right[i].ours.c_str());
          caught.insert(i);
          isCaught = true;
        }
      }
      QVERIFY2(isCaught, machine.name);
    }
    // The last finding holds on no machine of the list: see `lastFindingCanHold`.
    for (std::size_t i = 0; i + 1 < papers::findingsOf(*papers::runFigure13(printed)).size(); ++i) {
      QVERIFY2(caught.contains(i), QByteArray::number(static_cast<int>(i)).constData());
    }
  }

  /// Runs that show it: the balance differs at 10 ms only.
  void lastFindingCanHold() {
    papers::Figure13Runs runs;
    for (papers::ParallelRun* run : {&runs.byDependency[0], &runs.byDataFlow[0]}) {
      run->setPoints = 300.0;
    }
    runs.byDataFlow[1].mean.fill(8.0);
    QVERIFY(papers::findingsOf(runs).back().isSupported);
    runs.byDataFlow[2].mean.fill(8.0);
    QVERIFY(!papers::findingsOf(runs).back().isSupported);
    runs.byDataFlow[2].mean.fill(0.0);
    runs.byDataFlow[0].mean.fill(5.0);
    QVERIFY(!papers::findingsOf(runs).back().isSupported);
  }

  /// With tasks of 10 ms and the cycles of [P3] a task ends whenever position control gets ready.
  void preemptsOnlyOffTheGrid() {
    for (const bool asPrinted : {true, false}) {
      pipeline::Figure13Reading reading;
      reading.asPrinted = asPrinted;
      for (const petri::Word cycleMs : pipeline::kFigure13CyclesMs) {
        for (const bool dataFlow : {false, true}) {
          const auto run = papers::runParallelCnc(
              pipeline::figure13Parameters(reading, cycleMs, dataFlow), pipeline::kFigure13S);
          QCOMPARE(run->preemptions, 0.0);
          QVERIFY(run->releases > 100.0);
        }
      }
      const auto off = papers::runParallelCnc(pipeline::figure13Parameters(reading, 13, false),
                                              pipeline::kFigure13S);
      QVERIFY(off->preemptions > 0.0);
      QVERIFY(off->preemptions <= off->releases - off->releasesAtEnd);
    }
  }

  void sixProcessorsLeaveNothingToSchedule() {
    const auto byTask = papers::runParallelCnc({{"processors", 6}, {"policy", 0}}, 1.0);
    const auto byFlow = papers::runParallelCnc({{"processors", 6}, {"policy", 1}}, 1.0);
    QVERIFY(byTask.has_value() && byFlow.has_value());
    QCOMPARE(byTask->mean, byFlow->mean);
    QCOMPARE(byTask->setPoints, byFlow->setPoints);
    // Fewer processors make fewer set points.
    const auto one = papers::runParallelCnc({{"processors", 1}, {"policy", 0}}, 1.0);
    QVERIFY(one->setPoints < byTask->setPoints);
  }

  void aSlowerMachineFillsTheLastBuffer() {
    const auto run = papers::runParallelCnc({{"position_cycle", 50'000}}, 1.0);
    QVERIFY(run.has_value());
    double highest = 0.0;
    for (const auto& level : run->levels[4]) {
      highest = std::max(highest, level.level);
    }
    QCOMPARE(highest, 50.0);
    QVERIFY(run->setPoints <= 20.0);
  }
};

RIVULET_TEST(TestParallelCnc)
#include "tst_parallel_cnc.moc"
