// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The part of the test of the feed cell that lifts the tool, while the axis of the air move is
/// held on its way. What it must see before a run may lift: see `templates/overlay.h`.
/// @threadsafety one object, one thread.
#pragma once

#include "base/result.h"
#include "streaming/setup/feed_test_steps.h"

namespace rivulet::streaming {

/// The overlay of Z can lift the tool, as the program has read before its first move. Adds its
/// check. @return the error of the link
[[nodiscard]] base::Result<void> requireOverlay(FeedTestSteps& test);

/// The axis is held, and stands. Adds its checks; behind a failed one nothing is lifted any more.
/// Afterwards the tool is still lifted if all have passed: the next order lets the axis go.
/// @return the error of the link
[[nodiscard]] base::Result<void> liftWhileHeld(FeedTestSteps& test);

/// The axis has come to the end of its move, with the tool lifted when it was let go.
/// @param seen  then
void judgeLowered(FeedTestSteps& test, const FeedTestSteps::Look& seen);

}  // namespace rivulet::streaming
