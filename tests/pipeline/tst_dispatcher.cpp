// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The scheduler does what the net of [P3] does, event for event, and keeps its promises.

#include <QtTest>

#include "base/random.h"
#include "petri/net_file.h"
#include "petri/simulator.h"
#include "pipeline/error.h"
#include "pipeline/policy_study.h"
#include "pipeline/virtual_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using pipeline::kBufferCount;
using pipeline::kTaskCount;
using pipeline::Task;

namespace {

/// Level of each buffer at the end of each moment at which one changed: "us: 1 0 2 0 1".
using Course = std::map<std::int64_t, std::array<int, kBufferCount>>;

struct NetCourse {
  Course levels;
  std::uint64_t points = 0;
  std::uint64_t preemptions = 0;
  std::int64_t waitedUs = 0;  ///< position control, for data
};

NetCourse courseOfNet(const petri::ParameterValues& parameters, std::int64_t untilUs) {
  const auto net = petri::loadNet("p3", parameters);
  if (!net) {
    qFatal("%s", net.error().text().c_str());
  }
  NetCourse course;
  const std::size_t place = net->placeOf("datarec");
  const petri::ColourId drec = net->places[place].colour;
  std::array<int, kBufferCount> levels{};
  petri::Simulator simulator(*net);
  simulator.setRecorder([&](const petri::Recorded& recorded) {
    if (recorded.place != place) {
      return;
    }
    const petri::Words& value = *recorded.value;
    levels[static_cast<std::size_t>(value[net->offsetOf(drec, "BNO")] - 1)] =
        static_cast<int>(value[net->offsetOf(drec, "data")]);
    course.levels[value[net->offsetOf(drec, "tm")]] = levels;
  });
  simulator.run(untilUs);
  for (std::size_t i = 0; i < net->places.size(); ++i) {
    if (!net->places[i].name.ends_with(".record")) {
      continue;
    }
    const petri::Words& record = simulator.marking()[i][0].value;
    const petri::ColourId trec = net->places[i].colour;
    course.preemptions += static_cast<std::uint64_t>(record[net->offsetOf(trec, "ppt")]);
    if (net->places[i].name == "Top.CNC.Position.record") {
      course.points = static_cast<std::uint64_t>(record[net->offsetOf(trec, "cnt")]);
      course.waitedUs = record[net->offsetOf(trec, "ttwd")];
    }
  }
  return course;
}

NetCourse courseOfPipeline(pipeline::PolicyKind kind, const pipeline::DispatchOptions& dispatch,
                           std::int64_t untilUs) {
  pipeline::UnitStages stages;
  NetCourse course;
  pipeline::VirtualOptions options;
  options.dispatch = dispatch;
  options.until = base::Instant{std::chrono::microseconds{untilUs}};
  options.duration = [](Task task, std::uint64_t) -> base::Duration {
    return task == Task::Position ? 5ms : 10ms;
  };
  options.recorder = [&](const pipeline::Event& event) {
    if (event.took || event.made) {
      course.levels[event.at.time_since_epoch() / 1us] = event.levels;
    }
  };
  const auto policy = pipeline::factsOf(kind).make();
  const auto run = pipeline::runVirtual(stages.all(), *policy, options);
  if (!run) {
    qFatal("%s", run.error().text().c_str());
  }
  for (const pipeline::TaskRecord& record : run->records) {
    course.preemptions += record.preemptions;
  }
  course.points = run->records[indexOf(Task::Position)].count;
  course.waitedUs = run->records[indexOf(Task::Position)].waitedData / 1us;
  return course;
}

}  // namespace

class TestDispatcher : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Figure 13 and many settings around it: the same level at the same microsecond.
  void levelsAreThoseOfTheNet_data() {
    QTest::addColumn<int>("policy");
    for (const pipeline::PolicyKind policy :
         {pipeline::PolicyKind::TaskDependency, pipeline::PolicyKind::DataFlow}) {
      QTest::newRow(std::string(pipeline::factsOf(policy).name).c_str())
          << static_cast<int>(policy);
    }
  }
  void levelsAreThoseOfTheNet() {
    QFETCH(int, policy);
    constexpr std::int64_t kUntilUs = 1'000'000;
    std::uint64_t preemptions = 0;
    int compared = 0;
    for (const int cycleMs : {2, 10, 15, 40, 100}) {
      for (int processors = 1; processors <= 6; ++processors) {
        for (const int capacity : {1, 3, 50}) {
          for (const int taskCycleMs : {0, 5}) {
            const NetCourse net = courseOfNet({{"policy", policy},
                                               {"position_cycle", 1000 * cycleMs},
                                               {"processors", processors},
                                               {"capacity", capacity},
                                               {"task_cycle", 1000 * taskCycleMs}},
                                              kUntilUs);
            pipeline::DispatchOptions dispatch;
            dispatch.processors = processors;
            dispatch.capacity = capacity;
            dispatch.positionCycle = std::chrono::milliseconds{cycleMs};
            dispatch.taskCycle = std::chrono::milliseconds{taskCycleMs};
            const NetCourse ours =
                courseOfPipeline(static_cast<pipeline::PolicyKind>(policy), dispatch, kUntilUs);
            const QByteArray where = QByteArray::number(cycleMs) + " ms, " +
                                     QByteArray::number(processors) + " processors, " +
                                     QByteArray::number(capacity) + " places, task cycle " +
                                     QByteArray::number(taskCycleMs);
            if (processors > 1 && net.preemptions > 0) {
              continue;  // the net may take the processor from any task; see tst_conformance
            }
            QVERIFY2(ours.levels == net.levels, where.constData());
            QVERIFY2(ours.points == net.points, where.constData());
            QVERIFY2(ours.waitedUs == net.waitedUs, where.constData());
            preemptions += ours.preemptions;
            ++compared;
          }
        }
      }
    }
    QVERIFY(preemptions > 0);  // these settings would show a wrong preemption
    QVERIFY(compared > 60);
  }

  /// Whatever the durations are: no more tasks than processors, no buffer beyond its bounds,
  /// position control before all others, and no task twice at a time.
  void promisesAreKept() {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      base::Random random(seed);
      pipeline::UnitStages stages;
      pipeline::VirtualOptions options;
      options.dispatch.processors = 1 + static_cast<int>(random.below(6));
      options.dispatch.capacity = 1 + static_cast<int>(random.below(8));
      options.dispatch.positionCycle = std::chrono::milliseconds{2 + random.below(14)};
      options.until = base::Instant{2s};
      options.duration = [&](Task, std::uint64_t) {
        return base::Duration{1'000 + static_cast<std::int64_t>(random.below(20'000'000))};
      };
      int running = 0;
      bool isKept = true;
      std::array<bool, kTaskCount> isWaiting{};
      options.recorder = [&](const pipeline::Event& event) {
        using Kind = pipeline::Event::Kind;
        const std::size_t task = indexOf(event.task);
        running += event.kind == Kind::Select ? 1 : event.kind == Kind::Complete ? -1 : 0;
        isKept = isKept && running >= 0 && running <= options.dispatch.processors;
        isKept = isKept && (event.kind != Kind::Start || !isWaiting[task]);
        if (event.kind == Kind::Start) {
          isWaiting[task] = true;
        } else {
          // Nobody gets a processor while position control waits for one.
          isKept = isKept && (event.kind == Kind::Complete || event.task == Task::Position ||
                              !isWaiting[indexOf(Task::Position)]);
          isWaiting[task] = false;
        }
        for (const int level : event.levels) {
          isKept = isKept && level >= 0 && level <= options.dispatch.capacity;
        }
      };
      const auto policy = pipeline::policies()[seed % pipeline::policies().size()].make();
      const auto run = pipeline::runVirtual(stages.all(), *policy, options);
      QVERIFY(run.has_value());
      QVERIFY2(isKept, QByteArray::number(static_cast<qulonglong>(seed)).constData());
      QVERIFY(run->records[indexOf(Task::Position)].count > 0);
    }
  }

  void aStepThatWasNotBegunIsRefused() {
    const auto policy = pipeline::factsOf(pipeline::PolicyKind::TaskDependency).make();
    pipeline::DispatchOptions options;
    options.positionCycle = 2ms;
    std::array<pipeline::Need, kTaskCount> needs{};
    needs.fill(pipeline::Need::Data);
    pipeline::Dispatcher dispatcher(options, *policy, needs);
    const auto done = dispatcher.complete(Task::LookAhead, {}, base::Instant{});
    QVERIFY(!done);
    QVERIFY(done.error().code == pipeline::PipelineError::TaskBroken);
    QVERIFY(done.error().message.find("forward-looking") != std::string::npos);
  }
};

RIVULET_TEST(TestDispatcher)
#include "tst_dispatcher.moc"
