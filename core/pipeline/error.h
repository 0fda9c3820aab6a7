// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What can go wrong between the tasks of a pipeline. @threadsafety plain values.
#pragma once

#include <system_error>

#include "base/error.h"

namespace rivulet::pipeline {

enum class PipelineError {
  RingLayout = 1,   ///< a ring was made by another version, or is none
  RingRubbish,      ///< what is in a ring cannot have been written by its producer
  SetPointMissing,  ///< position control got another set point than the next one
  TaskBroken,       ///< a task said something that cannot be
  TaskDied,
};

[[nodiscard]] std::error_code make_error_code(PipelineError code);

}  // namespace rivulet::pipeline

template <>
struct std::is_error_code_enum<rivulet::pipeline::PipelineError> : std::true_type {};
