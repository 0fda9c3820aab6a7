// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A thread that writes, so that nobody else waits for the disk. What it is given is done in order;
/// the destructor waits until all of it is done. @threadsafety `add` and the destructor: one
/// thread.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "base/result.h"

namespace rivulet::journal {

class Writer {
 public:
  using Job = std::function<base::Result<void>()>;
  /// More jobs than this do not wait: the disk hangs. `failed` is called instead.
  static constexpr std::size_t kJobsMax = 1000;

  Writer();
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// @param done  called on the thread that writes, or at once if there is no room
  void add(Job job, std::function<void(const base::Result<void>&)> done);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace rivulet::journal
