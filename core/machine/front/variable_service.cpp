// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/variable_service.h"

namespace rivulet::machine {

VariableService::VariableService(ServedControl& control)
    : m_control(control), m_offset(control.now().time_since_epoch()) {
}

void VariableService::advance() {
  m_control.advance(now());
}

void VariableService::serve(AccessKind kind) {
  if (!m_live) {
    return;
  }
  if (m_request != kind) {
    m_request = kind;
    ++m_requests;
    // There is no need to wait for the returned turn: the first node is complete only after it. The
    // request was sent a moment ago. The time of transport and of waking both sides is part of the
    // request's overhead and must not be paid twice.
    m_control.beginRequest(kind, now() - kOnTheWay);
  }
  const base::Instant served = m_control.serveNode(now());
  m_clock.sleepUntil(served - m_offset);
  m_control.advance(served);
  ++m_nodes;
}

base::Instant VariableService::serveProgram(std::size_t bytes) {
  m_request.reset();
  return m_live ? now() - kOnTheWay + m_control.programTime(bytes) : now();
}

}  // namespace rivulet::machine
