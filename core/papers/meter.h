// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Counts the finished jobs of an experiment, reports the share done, and remembers that it is to
/// be cancelled. @threadsafety any thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "base/result.h"
#include "papers/catalogue.h"

namespace rivulet::papers {

class Meter {
 public:
  Meter(const ExperimentOptions& options, std::size_t total)
      : m_options(options), m_total(std::max<std::size_t>(total, 1)) {}
  void add() {
    const std::size_t done = ++m_done;
    if (m_options.progress &&
        !m_options.progress(static_cast<double>(done) / static_cast<double>(m_total))) {
      m_cancelled = true;
    }
  }
  [[nodiscard]] bool isCancelled() const { return m_cancelled; }
  [[nodiscard]] static tl::unexpected<base::Error> cancelled() {
    return base::fail(ExperimentError::Cancelled, "The experiment was cancelled.");
  }
  /// @param hasNumbers  of all jobs, see base::Executor::numbersOf
  /// @return Cancelled, OnlyShare
  [[nodiscard]] base::Result<void> endOf(bool hasNumbers) const {
    if (m_cancelled) {
      return cancelled();
    }
    return hasNumbers ? base::Result<void>{} : onlyShare();
  }
  [[nodiscard]] static tl::unexpected<base::Error> onlyShare() {
    return base::fail(ExperimentError::OnlyShare, "Only a part of the experiment was computed.");
  }

 private:
  const ExperimentOptions& m_options;
  std::size_t m_total;
  std::atomic<std::size_t> m_done{0};
  std::atomic<bool> m_cancelled{false};
};

}  // namespace rivulet::papers
