// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/virtual_run.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/contract.h"

namespace rivulet::pipeline {

namespace {

/// Steps in progress: the data are moved at once, the time passes afterwards.
struct Work {
  std::optional<base::Instant> end;  ///< nothing: it does not run
  base::Duration left{};             ///< while it has lost its processor
  StepDone done;
  std::uint64_t steps = 0;
  std::uint64_t switches = 0;  ///< paid so far
};

/// How full the buffers are, over time.
class Levels {
 public:
  void pass(base::Instant at) {
    for (std::size_t i = 0; i < kBufferCount; ++i) {
      m_areas[i] += m_levels[i] * base::toSeconds(at - m_since);
    }
    m_since = at;
  }
  void take(const Event& event) {
    pass(event.at);
    m_levels = event.levels;
  }
  /// Of all that has passed.
  [[nodiscard]] double mean(std::size_t buffer) const {
    return m_since > base::Instant{} ? m_areas[buffer] / base::toSeconds(m_since) : 0.0;
  }

 private:
  std::array<double, kBufferCount> m_areas{};
  std::array<int, kBufferCount> m_levels{};
  base::Instant m_since{};
};

}  // namespace

base::Result<VirtualRun> runVirtual(const std::array<Stage*, kTaskCount>& stages,
                                    const SchedulingPolicy& policy, const VirtualOptions& options) {
  std::array<Need, kTaskCount> needs{};
  for (std::size_t i = 0; i < kTaskCount; ++i) {
    needs[i] = stages[i]->need();
  }
  Dispatcher dispatcher(options.dispatch, policy, needs);
  VirtualRun run;
  base::Instant now{};
  Levels levels;
  dispatcher.setRecorder([&](const Event& event) {
    levels.take(event);
    if (options.recorder) {
      options.recorder(event);
    }
  });
  std::array<Work, kTaskCount> works{};
  std::vector<Command> commands;
  while (!dispatcher.hasEnded()) {
    commands.clear();
    dispatcher.advance(now, commands);
    for (const Command& command : commands) {
      Work& work = works[indexOf(command.task)];
      if (command.kind == Command::Kind::Suspend) {
        work.left = *work.end - now;
        work.end.reset();
        continue;
      }
      if (command.kind == Command::Kind::Run) {
        auto done = stages[indexOf(command.task)]->step();
        if (!done) {
          return base::fail(done.error());
        }
        work.done = *done;
        work.left = options.duration(command.task, work.steps++);
        RIVULET_ASSERT(work.left > base::Duration{});
      }
      const std::uint64_t switches = dispatcher.record(command.task).switches;
      if (switches != work.switches) {
        work.switches = switches;
        work.left += options.switchCost;
      }
      work.end = now + work.left;
    }
    std::optional<base::Instant> next = dispatcher.nextRelease(now);
    for (const Work& work : works) {
      if (work.end && (!next || *work.end < *next)) {
        next = work.end;
      }
    }
    if (!next || *next > options.until) {
      now = next ? options.until : now;
      break;
    }
    now = *next;
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      if (works[i].end && *works[i].end <= now) {
        works[i].end.reset();
        if (auto ended = dispatcher.complete(static_cast<Task>(i), works[i].done, now); !ended) {
          return base::fail(ended.error());
        }
      }
    }
  }
  levels.pass(now);
  run.end = now;
  run.hasEnded = dispatcher.hasEnded();
  for (std::size_t i = 0; i < kTaskCount; ++i) {
    run.records[i] = dispatcher.record(static_cast<Task>(i));
  }
  for (std::size_t i = 0; i < kBufferCount; ++i) {
    run.meanLevels[i] = levels.mean(i);
  }
  return run;
}

}  // namespace rivulet::pipeline
