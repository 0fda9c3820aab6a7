// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run of the six tasks of a CNC, as the window shows it. @threadsafety plain values.
#pragma once

#include <QString>
#include <array>

#include "pipeline/dispatcher.h"
#include "pipeline/event.h"
#include "pipeline/level_history.h"
#include "pipeline/policy.h"

namespace rivulet::widgets {

struct PipelineView {
  enum class State {
    Nothing,
    Running,
    Ended,     ///< at the end of the program
    Stopped,   ///< by the operator
    Failed,    ///< `message` says why
    Recorded,  ///< it was read from a file
  };
  State state = State::Nothing;
  QString name;  ///< of the program or file, without folders
  QString message;
  pipeline::PolicyKind policy = pipeline::PolicyKind::TaskDependency;
  pipeline::DispatchOptions dispatch;
  std::array<pipeline::TaskRecord, pipeline::kTaskCount> records;
  std::array<int, pipeline::kBufferCount> levels{};  ///< now
  pipeline::LevelHistory history;
  base::Duration length{};  ///< so far
  bool canBeSaved = false;
};

/// What the operator can choose for a run.
struct PipelineChoice {
  bool isExample = false;  ///< else the program that is open
  pipeline::PolicyKind policy = pipeline::PolicyKind::TaskDependency;
  int processors = 2;
  double cycleMs = 4.0;
  bool isRealTime = false;
};

}  // namespace rivulet::widgets
