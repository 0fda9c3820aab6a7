// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Task 1, G code receiving: the bytes of a program, from wherever they come, as lines.
/// @threadsafety one object, one thread. @source [P3] Fig. 6
#pragma once

#include <string>
#include <string_view>

#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class ReceiveTask final : public Stage {
 public:
  explicit ReceiveTask(RingWriter<ProgramText> out) : m_out(out) {}

  /// More of the program; in parts of any size.
  void feed(std::string_view bytes) { m_pending += bytes; }
  /// The program is complete.
  void endInput() { m_isComplete = true; }

  [[nodiscard]] Need need() const override;
  [[nodiscard]] base::Result<StepDone> step() override;

 private:
  /// Length of the next item; 0: it is not there yet.
  [[nodiscard]] std::size_t nextBytes() const;

  RingWriter<ProgramText> m_out;
  std::string m_pending;
  std::size_t m_at = 0;
  bool m_isComplete = false;
  bool m_hasEnded = false;
};

}  // namespace rivulet::pipeline
