// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the bytes of a live source come from. Sockets, pipes and OPC UA servers implement it
/// outside of core. @threadsafety one object, on the thread of the run.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/result.h"
#include "live/progress.h"

namespace rivulet::live {

class Source {
 public:
  virtual ~Source() = default;

  /// "standard input", "tcp:4001": for messages and reports.
  [[nodiscard]] virtual std::string name() const = 0;
  /// What has arrived; never waits. What is not read waits in the source.
  /// @return bytes written to `into`; 0: nothing now
  [[nodiscard]] virtual std::size_t read(std::span<char> into) = 0;
  /// True when nothing more can come, after everything has been read.
  [[nodiscard]] virtual bool isClosed() const = 0;
  /// True if closing it is as good as `end`, as with a pipe.
  [[nodiscard]] virtual bool endsByClosing() const { return false; }
  /// False if what is not read at once may be lost. Its points have to be numbered.
  [[nodiscard]] virtual bool canWait() const { return true; }
  /// True if the other side can be told how far the run is.
  [[nodiscard]] virtual bool takesReplies() const { return false; }
  /// Never waits. What has no room is left out.
  virtual void tell(const Progress& /*progress*/) {}
  /// Asked once before each run; may take as long as a connection. @return why it cannot be read
  [[nodiscard]] virtual base::Result<void> prepare() { return {}; }
};

}  // namespace rivulet::live
