// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/tasks/receive.h"

#include <algorithm>

#include "pipeline/tasks/transfer.h"

namespace rivulet::pipeline {

namespace {

/// What has been passed on is dropped in parts of this size.
constexpr std::size_t kDropBytes = 1U << 16U;

}  // namespace

std::size_t ReceiveTask::nextBytes() const {
  const std::string_view rest = std::string_view(m_pending).substr(m_at);
  const std::size_t end = rest.substr(0, ProgramText::kBytes).find('\n');
  if (end != std::string_view::npos) {
    return end + 1;
  }
  return m_isComplete || rest.size() >= ProgramText::kBytes
             ? std::min(rest.size(), ProgramText::kBytes)
             : 0;
}

Need ReceiveTask::need() const {
  if (m_hasEnded) {
    return Need::Ended;
  }
  return m_isComplete || nextBytes() > 0 ? Need::Nothing : Need::Input;
}

base::Result<StepDone> ReceiveTask::step() {
  const std::size_t bytes = nextBytes();
  ProgramText item;
  item.text = BoundedText<ProgramText::kBytes>(std::string_view(m_pending).substr(m_at, bytes));
  item.endsProgram = bytes == 0;
  if (auto given = give(m_out, item); !given) {
    return base::fail(given.error());
  }
  m_at += bytes;
  m_hasEnded = item.endsProgram;
  if (m_at >= kDropBytes) {
    m_pending.erase(0, m_at);
    m_at = 0;
  }
  return StepDone{true, need()};
}

}  // namespace rivulet::pipeline
