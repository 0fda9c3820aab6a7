// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::base {

std::error_code make_error_code(ShareError code) {
  static const NamedCategory category("share");
  return {static_cast<int>(code), category};
}

Result<ShareNumbers> merged(std::span<const ShareNumbers> shares) {
  if (shares.empty()) {
    return fail(ShareError::Missing, "There is no part to put together.");
  }
  const ShareNumbers& first = shares.front();
  std::vector<const ShareNumbers*> byNumber(first.share.of, nullptr);
  for (const ShareNumbers& one : shares) {
    const Share& share = one.share;
    if (share.of != first.share.of || one.jobs != first.jobs || one.width != first.width ||
        share.number < 1 || share.number > share.of ||
        one.numbers.size() != share.size(one.jobs) * one.width) {
      return fail(
          ShareError::Unlike,
          fmt::format("Part {} of {} does not belong to part {} of {}: they are of different "
                      "sweeps. Compute all parts with the same options.",
                      share.number, share.of, first.share.number, first.share.of));
    }
    if (byNumber[share.number - 1] != nullptr) {
      return fail(ShareError::Missing,
                  fmt::format("Part {} of {} is there twice. Name each part once.", share.number,
                              share.of));
    }
    byNumber[share.number - 1] = &one;
  }
  if (const auto gap = std::ranges::find(byNumber, nullptr); gap != byNumber.end()) {
    return fail(ShareError::Missing,
                fmt::format("Part {0} of {1} is missing. Compute it with --shard {0}/{1}, and name "
                            "all parts.",
                            gap - byNumber.begin() + 1, first.share.of));
  }
  ShareNumbers all{{}, first.jobs, first.width, std::vector<double>(first.jobs * first.width)};
  for (const ShareNumbers* one : byNumber) {
    for (std::size_t place = 0; place < one->share.size(one->jobs); ++place) {
      std::copy_n(
          one->numbers.begin() + static_cast<std::ptrdiff_t>(place * one->width), one->width,
          all.numbers.begin() + static_cast<std::ptrdiff_t>(one->share.job(place) * one->width));
    }
  }
  return all;
}

std::optional<std::vector<double>> ShareExecutor::numbersOf(std::size_t count, std::size_t width,
                                                            const NumberJob& job) {
  RIVULET_ASSERT(!m_numbers);  // the first ended the sweep
  std::vector<double> numbers(m_share.size(count) * width);
  m_executor.forEach(m_share.size(count), [&](std::size_t place) {
    job(m_share.job(place), std::span(numbers).subspan(place * width, width));
  });
  m_numbers = ShareNumbers{m_share, count, width, std::move(numbers)};
  return std::nullopt;
}

std::optional<std::vector<double>> MergedExecutor::numbersOf(std::size_t count, std::size_t width,
                                                             const NumberJob& job) {
  if (std::exchange(m_wasTaken, true)) {
    return m_executor.numbersOf(count, width, job);
  }
  m_fits = m_numbers.jobs == count && m_numbers.width == width;
  if (!m_fits) {
    return std::nullopt;
  }
  return std::move(m_numbers.numbers);
}

}  // namespace rivulet::base
