// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Taking and giving items where the scheduler has promised that there is one, or room for one.
/// @threadsafety as the rings.
#pragma once

#include "base/result.h"
#include "pipeline/ring.h"

namespace rivulet::pipeline {

template <class T>
[[nodiscard]] base::Result<T> take(RingReader<T>& from) {
  auto item = from.pop();
  if (!item) {
    return base::fail(item.error());
  }
  if (!*item) {
    return base::fail(ringError(PipelineError::RingRubbish, ringName<T>(),
                                "it is empty, but its consumer was called"));
  }
  return **item;
}

template <class T>
[[nodiscard]] base::Result<void> give(RingWriter<T>& to, const T& item) {
  const auto done = to.push(item);
  if (!done) {
    return base::fail(done.error());
  }
  if (!*done) {
    return base::fail(ringError(PipelineError::RingRubbish, ringName<T>(),
                                "it is full, but its producer was called"));
  }
  return {};
}

}  // namespace rivulet::pipeline
