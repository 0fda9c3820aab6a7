// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A sweep on several computers: each does a share of the jobs of the first `numbersOf`, and one
/// puts the numbers together and does the rest. The result is that of one computer, to the last
/// digit. @threadsafety as of the executor that does the jobs.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/executor.h"
#include "base/result.h"

namespace rivulet::base {

enum class ShareError {
  Missing = 1,  ///< the shares are not one of each
  Unlike,       ///< they are of different sweeps, or not of the sweep that is done
};

[[nodiscard]] std::error_code make_error_code(ShareError code);

/// Which jobs: neighbours go to different computers, because they take similarly long.
struct Share {
  std::size_t number = 1;  ///< 1 to `of`
  std::size_t of = 1;

  /// How many of `count` jobs.
  [[nodiscard]] std::size_t size(std::size_t count) const { return (count + of - number) / of; }
  /// @param place  0 to size() - 1
  [[nodiscard]] std::size_t job(std::size_t place) const { return place * of + number - 1; }
};

/// What was computed of a sweep.
struct ShareNumbers {
  Share share;
  std::size_t jobs = 0;         ///< of the whole sweep
  std::size_t width = 0;        ///< numbers of each job
  std::vector<double> numbers;  ///< of the jobs of the share, in their order
};

/// Puts shares together. @return the numbers of all jobs as one share of one; Missing, Unlike
[[nodiscard]] Result<ShareNumbers> merged(std::span<const ShareNumbers> shares);

/// Does a share of the first `numbersOf` that it is asked for, and keeps its numbers.
class ShareExecutor final : public Executor {
 public:
  ShareExecutor(Executor& executor, Share share) : m_executor(executor), m_share(share) {}
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    m_executor.forEach(count, job);
  }
  [[nodiscard]] std::optional<std::vector<double>> numbersOf(std::size_t count, std::size_t width,
                                                             const NumberJob& job) override;
  /// Nothing: no job had numbers as its result, so all was done here.
  [[nodiscard]] const std::optional<ShareNumbers>& numbers() const { return m_numbers; }

 private:
  Executor& m_executor;
  Share m_share;
  std::optional<ShareNumbers> m_numbers;
};

/// Takes the numbers of the first `numbersOf` as they were computed elsewhere.
class MergedExecutor final : public Executor {
 public:
  /// @param numbers  of a whole sweep
  MergedExecutor(Executor& executor, ShareNumbers numbers)
      : m_executor(executor), m_numbers(std::move(numbers)) {}
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    m_executor.forEach(count, job);
  }
  [[nodiscard]] std::optional<std::vector<double>> numbersOf(std::size_t count, std::size_t width,
                                                             const NumberJob& job) override;
  /// Whether the sweep that was done was the one that the numbers are of.
  [[nodiscard]] bool didFit() const { return m_wasTaken && m_fits; }

 private:
  Executor& m_executor;
  ShareNumbers m_numbers;
  bool m_wasTaken = false;
  bool m_fits = true;
};

}  // namespace rivulet::base

template <>
struct std::is_error_code_enum<rivulet::base::ShareError> : std::true_type {};
