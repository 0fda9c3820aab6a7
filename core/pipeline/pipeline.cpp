// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/pipeline.h"

#include "base/contract.h"

namespace rivulet::pipeline {

namespace {

using StageResult = base::Result<std::unique_ptr<Stage>>;

/// A task between two rings.
template <class StageType, class In, class Out, class... Arguments>
StageResult between(RingMemory<In>& before, RingMemory<Out>& after, const Arguments&... arguments) {
  auto in = RingReader<In>::open(before);
  if (!in) {
    return base::fail(in.error());
  }
  auto out = RingWriter<Out>::open(after);
  if (!out) {
    return base::fail(out.error());
  }
  return std::make_unique<StageType>(arguments..., *in, *out);
}

}  // namespace

StageResult makeStage(Task task, Rings& rings, const machine::MachineConfig& config,
                      AxisOutput& output) {
  switch (task) {
    case Task::Receive: {
      auto out = RingWriter<ProgramText>::open(rings.b1);
      if (!out) {
        return base::fail(out.error());
      }
      return std::make_unique<ReceiveTask>(*out);
    }
    case Task::Interpret:
      return between<InterpretTask>(rings.b1, rings.b2, config);
    case Task::Discrete:
      return between<DiscreteTask>(rings.b2, rings.b3, config);
    case Task::LookAhead:
      return between<LookAheadTask>(rings.b3, rings.b4, config);
    case Task::Interpolate:
      return between<InterpolateTask>(rings.b4, rings.b5);
    case Task::Position:
      break;
  }
  auto in = RingReader<SetPoint>::open(rings.b5);
  if (!in) {
    return base::fail(in.error());
  }
  return std::make_unique<PositionTask>(*in, output);
}

Pipeline::Pipeline(const machine::MachineConfig& config, AxisOutput& output)
    : m_rings(std::make_unique<Rings>()) {
  for (std::size_t i = 0; i < kTaskCount; ++i) {
    auto stage = makeStage(static_cast<Task>(i), *m_rings, config, output);
    RIVULET_ASSERT(stage.has_value());
    m_stages[i] = std::move(*stage);
  }
  m_receive = static_cast<ReceiveTask*>(m_stages[indexOf(Task::Receive)].get());
}

std::array<Stage*, kTaskCount> Pipeline::stages() const {
  std::array<Stage*, kTaskCount> stages{};
  for (std::size_t i = 0; i < kTaskCount; ++i) {
    stages[i] = m_stages[i].get();
  }
  return stages;
}

}  // namespace rivulet::pipeline
