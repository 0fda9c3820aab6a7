// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Why the control executes a block itself, in the language of the operator.
/// @threadsafety GUI thread.
#pragma once

#include <QString>

#include "job/plan.h"

namespace rivulet::widgets {

/// "tool change", in the middle of a sentence.
[[nodiscard]] QString nativeReasonText(job::NativeReason reason);
/// Who executes the block, why, and what is known afterwards.
[[nodiscard]] QString nativeBlockText(const job::NativeBlock& block);
/// Number, lines and points.
[[nodiscard]] QString stretchText(const job::Stretch& stretch, std::size_t stretches);

}  // namespace rivulet::widgets
