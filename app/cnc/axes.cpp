// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/axes.h"

#include <optional>

#include "pipeline/tasks/position.h"

namespace rivulet::cnc {

namespace {

/// An auxiliary function as the control's trace has it; nothing for T alone.
std::optional<trace::ControlEvent> eventOf(const pipeline::Auxiliary& auxiliary, base::Instant at) {
  using Kind = machine::MachineAction::Kind;
  trace::ControlEvent event;
  event.from = at;
  event.to = at;
  event.line = auxiliary.line;
  event.value = auxiliary.value;
  event.name = auxiliary.toolName.view();
  switch (auxiliary.kind) {
    case Kind::SelectTool:
      return std::nullopt;
    case Kind::ChangeTool:
      event.kind = trace::ControlEvent::Kind::ToolChange;
      event.value = auxiliary.tool;
      break;
    case Kind::SelectEdge:
      event.kind = trace::ControlEvent::Kind::Edge;
      break;
    case Kind::WorkOffset:
      event.kind = trace::ControlEvent::Kind::WorkOffset;
      break;
    case Kind::SpindleSpeed:
    case Kind::SpindleTurn:
      event.kind = trace::ControlEvent::Kind::Spindle;
      break;
    case Kind::Coolant:
      event.kind = trace::ControlEvent::Kind::Coolant;
      break;
    case Kind::Stop:
      break;
  }
  return event;
}

}  // namespace

base::Result<Axes> Axes::open(pipeline::RingMemory<AxisPoint>& ring,
                              const machine::MachineConfig& config) {
  auto in = pipeline::RingReader<AxisPoint>::open(ring);
  if (!in) {
    return base::fail(in.error());
  }
  return Axes(*in, config);
}

Axes::Axes(pipeline::RingReader<AxisPoint> in, const machine::MachineConfig& config)
    : m_in(in),
      m_servo(config, config.start()),
      m_at(config.start()),
      m_interval(config.interpolationCycle) {
  m_trace.cycle = m_interval;
  m_trace.rotaryAxes = config.rotarySet();
}

base::Result<void> Axes::follow() {
  for (;;) {
    const auto sent = m_in.pop();
    if (!sent) {
      return base::fail(sent.error());
    }
    if (!*sent) {
      return {};
    }
    const pipeline::SetPoint& point = (*sent)->point;
    if (auto follows = pipeline::checkFollows(point, m_cycle); !follows) {
      return follows;
    }
    m_cycle = point.head.cycle;
    m_last = point.head;
    trace::ControlSample sample;
    sample.at = base::Instant{m_interval * static_cast<base::Duration::rep>(m_cycle)};
    sample.commandMm = point.positionMm - point.head.zeroMm;
    sample.commandDeg = point.positionDeg;
    sample.actualMm = m_servo.follow(m_at.mm, point.positionMm) - point.head.zeroMm;
    sample.actualDeg = m_servo.followDeg(m_at.deg, point.positionDeg);
    sample.feedMmPerS = point.head.speedMmPerS;
    sample.line = point.head.line;
    m_at = {point.positionMm, point.positionDeg};
    for (std::size_t i = 0; i < point.head.auxiliaryCount; ++i) {
      if (const auto event = eventOf(point.head.auxiliaries[i], sample.at)) {
        m_trace.events.push_back(*event);
      }
    }
    m_trace.samples.push_back(sample);
    m_sentNs.push_back((*sent)->sentNs);
  }
}

}  // namespace rivulet::cnc
