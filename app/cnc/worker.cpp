// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/worker.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "cnc/program_input.h"
#include "cnc/real_time.h"
#include "machine/config.h"
#include "pipeline/tasks/transfer.h"

namespace rivulet::cnc {

namespace {

using pipeline::Need;
using pipeline::Task;

/// How long task 1 waits for bytes before it looks for instructions.
constexpr base::Duration kInputWait = std::chrono::milliseconds{5};

/// Position control sends to the axes through one more ring.
class AxisWriter final : public pipeline::AxisOutput {
 public:
  explicit AxisWriter(pipeline::RingWriter<AxisPoint> out) : m_out(out) {}
  [[nodiscard]] base::Result<void> send(const pipeline::SetPoint& point) override {
    return pipeline::give(m_out, AxisPoint{point, monotonicNs()});
  }

 private:
  pipeline::RingWriter<AxisPoint> m_out;
};

class Worker {
 public:
  Worker(Segment& segment, Task task)
      : m_segment(segment), m_mailbox(segment.mailbox(task)), m_task(task) {}

  void run() {
    if (const auto ready = prepare(); !ready) {
      fail(ready.error());
      return;
    }
    m_mailbox.isReady.store(true);
    m_segment.bell.post();
    while (waitForInstruction()) {
      if (!step()) {
        return;
      }
    }
  }

 private:
  [[nodiscard]] base::Result<void> prepare() {
    auto config = machineOf(m_segment.setup);
    if (!config) {
      return base::fail(config.error());
    }
    auto axes = pipeline::RingWriter<AxisPoint>::open(m_segment.axes);
    if (!axes) {
      return base::fail(axes.error());
    }
    m_output.emplace(*axes);
    auto stage = pipeline::makeStage(m_task, m_segment.rings, *config, *m_output);
    if (!stage) {
      return base::fail(stage.error());
    }
    m_stage = std::move(*stage);
    if (m_task == Task::Receive) {
      m_receive = static_cast<pipeline::ReceiveTask*>(m_stage.get());
      return openInput();
    }
    if (m_task == Task::Position) {
      for (const std::string& sentence :
           makeRealTime({m_segment.setup.priority, m_segment.setup.core})) {
        std::fputs((sentence + "\n").c_str(), stderr);
      }
    }
    return {};
  }

  [[nodiscard]] base::Result<void> openInput() {
    const std::string path(m_segment.setup.program.view());
    auto input = path.empty()
                     ? ProgramInput::listen(static_cast<std::uint16_t>(m_segment.port.load()))
                     : ProgramInput::ofFile(path);
    if (!input) {
      return base::fail(input.error());
    }
    m_input.emplace(std::move(*input));
    m_segment.port.store(m_input->port());
    return {};
  }

  /// @return false if there is to be no more step
  [[nodiscard]] bool waitForInstruction() {
    for (;;) {
      const bool reads = m_receive != nullptr && m_stage->need() == Need::Input;
      if (m_mailbox.wake.wait(reads ? std::optional(monotonicNs()) : std::nullopt)) {
        const Instruction instruction = m_mailbox.instruction.exchange(Instruction::None);
        if (instruction == Instruction::Quit) {
          return false;
        }
        if (instruction == Instruction::Run) {
          return true;
        }
      } else if (reads) {
        readInput();
      }
    }
  }

  void readInput() {
    if (const std::optional<std::string> bytes = m_input->read(kInputWait)) {
      m_receive->feed(*bytes);
    } else {
      m_receive->endInput();
    }
    if (m_stage->need() != Need::Input) {
      m_mailbox.inputHasArrived.store(true);
      m_segment.bell.post();
    }
  }

  [[nodiscard]] bool step() {
    if (const std::int64_t due = m_mailbox.notBeforeNs.load(); due > 0) {
      sleepUntil(due);
    }
    m_mailbox.beganNs = monotonicNs();
    const auto done = m_stage->step();
    m_mailbox.endedNs = monotonicNs();
    if (!done) {
      fail(done.error());
      return false;
    }
    m_mailbox.made = done->made ? 1 : 0;
    m_mailbox.next = static_cast<std::uint8_t>(done->next);
    m_mailbox.hasAnswered.store(true);
    m_segment.bell.post();
    return true;
  }

  void fail(const base::Error& error) {
    m_mailbox.error = decltype(m_mailbox.error)(error.text());
    m_mailbox.hasFailed = true;
    m_mailbox.hasAnswered.store(true);
    m_segment.bell.post();
  }

  Segment& m_segment;
  Mailbox& m_mailbox;
  Task m_task;
  std::optional<AxisWriter> m_output;
  std::unique_ptr<pipeline::Stage> m_stage;
  pipeline::ReceiveTask* m_receive = nullptr;
  std::optional<ProgramInput> m_input;
};

}  // namespace

base::Result<machine::MachineConfig> machineOf(const Setup& setup) {
  auto config = machine::loadPreset(std::string(setup.preset.view()));
  if (config) {
    // Position control sends one point of the interpolation per cycle, and the servo follows it.
    config->interpolationCycle = base::Duration{setup.cycleNs};
    config->positionCycle = config->interpolationCycle;
  }
  return config;
}

void runWorker(Segment& segment, Task task) {
  Worker(segment, task).run();
}

}  // namespace rivulet::cnc
