// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/prediction/durations.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/contract.h"

namespace rivulet::feasibility {

namespace {

/// Sums of so many node times are taken as normal.
constexpr int kNormalFrom = 8;
/// Grid of the time of one node.
constexpr double kFineMs = 0.1;

/// Moves what a request would do in no time to the first step: without that a client would never
/// let the time go on. Then drops both ends below `kNegligible`.
void trim(Kernel& kernel) {
  if (kernel.first == 0) {
    if (kernel.mass.size() == 1) {
      kernel.mass.push_back(0.0);
    }
    kernel.mass[1] += kernel.mass[0];
    kernel.mass.erase(kernel.mass.begin());
    kernel.first = 1;
  }
  while (kernel.mass.size() > 1 && kernel.mass.back() < kNegligible) {
    kernel.mass.pop_back();
  }
  const auto begin = std::find_if(kernel.mass.begin(), kernel.mass.end() - 1,
                                  [](double mass) { return mass >= kNegligible; });
  kernel.first += static_cast<int>(begin - kernel.mass.begin());
  kernel.mass.erase(kernel.mass.begin(), begin);
}

/// From the fine grid, of any sum, to one of `stepMs` with sum 1.
Kernel onGrid(const std::vector<double>& fine, double originMs, double stepMs) {
  Kernel kernel;
  kernel.first = std::max(0, static_cast<int>(std::floor(originMs / stepMs)));
  const double lastMs = originMs + static_cast<double>(fine.size() - 1) * kFineMs;
  const int last = static_cast<int>(std::floor(lastMs / stepMs)) + 1;
  kernel.mass.assign(static_cast<std::size_t>(std::max(1, last - kernel.first + 1)), 0.0);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double at = std::max(0.0, (originMs + static_cast<double>(i) * kFineMs) / stepMs);
    const double floor = std::floor(at);
    const auto cell = static_cast<std::size_t>(static_cast<int>(floor) - kernel.first);
    kernel.mass[cell] += fine[i] * (1.0 - (at - floor));
    if (cell + 1 < kernel.mass.size()) {
      kernel.mass[cell + 1] += fine[i] * (at - floor);
    }
  }
  trim(kernel);
  const double sum = std::accumulate(kernel.mass.begin(), kernel.mass.end(), 0.0);
  for (double& mass : kernel.mass) {
    mass /= sum;
  }
  return kernel;
}

/// Distribution of the sum of `count` independent values of distribution `one`.
std::vector<double> sumOf(const std::vector<double>& one, int count) {
  std::vector<double> sum{1.0};
  for (int n = 0; n < count; ++n) {
    std::vector<double> next(sum.size() + one.size() - 1, 0.0);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      for (std::size_t j = 0; sum[i] > kNegligible && j < one.size(); ++j) {
        next[i + j] += sum[i] * one[j];
      }
    }
    sum = std::move(next);
  }
  return sum;
}

/// Normal, up to a factor, around the middle of an odd number of cells.
std::vector<double> bellOf(double deviationMs) {
  const int half = static_cast<int>(std::ceil(kDeviationsKept * deviationMs / kFineMs));
  std::vector<double> bell;
  for (int i = -half; i <= half; ++i) {
    const double off = half == 0 ? 0.0 : i * kFineMs / deviationMs;
    bell.push_back(std::exp(-0.5 * off * off));
  }
  return bell;
}

}  // namespace

double normalBelow(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

double Kernel::mean() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    sum += mass[i] * (first + static_cast<double>(i));
  }
  return sum;
}

double Kernel::upTo(double steps) const {
  const int last = static_cast<int>(std::floor(steps + 1e-9)) - first;
  double sum = 0.0;
  for (int i = 0; i <= last && i < static_cast<int>(mass.size()); ++i) {
    sum += mass[static_cast<std::size_t>(i)];
  }
  return std::min(sum, 1.0);
}

NodeTimes::NodeTimes(const AccessTimes& access) {
  const double meanMs = base::toMilliseconds(access.nodeMean);
  const double deviationMs = base::toMilliseconds(access.nodeDeviation);
  m_originMs =
      std::max(base::toMilliseconds(access.nodeMin), meanMs - kDeviationsKept * deviationMs);
  const double toMs = std::max(m_originMs, meanMs + kDeviationsKept * deviationMs);
  if (deviationMs <= 0.0) {
    m_one.assign(1, 1.0);
    return;
  }
  // Cell i holds what lies around originMs + i·fine; all that is below goes to the first.
  const int cells = std::max(1, static_cast<int>(std::ceil((toMs - m_originMs) / kFineMs)) + 1);
  double below = 0.0;
  for (int i = 0; i < cells; ++i) {
    const double edge =
        i + 1 == cells ? 1.0
                       : normalBelow((m_originMs + (i + 0.5) * kFineMs - meanMs) / deviationMs);
    m_one.push_back(edge - below);
    below = edge;
  }
}

double NodeTimes::meanMs() const {
  double mean = m_originMs;
  for (std::size_t i = 0; i < m_one.size(); ++i) {
    mean += m_one[i] * static_cast<double>(i) * kFineMs;
  }
  return mean;
}

double NodeTimes::varianceMs2() const {
  const double oneMs = meanMs();
  double variance = 0.0;
  for (std::size_t i = 0; i < m_one.size(); ++i) {
    const double off = m_originMs + static_cast<double>(i) * kFineMs - oneMs;
    variance += m_one[i] * off * off;
  }
  return variance;
}

Kernel NodeTimes::sum(double overheadMs, int nodes, double stepMs) const {
  RIVULET_ASSERT(nodes >= 1);
  if (nodes < kNormalFrom) {
    return onGrid(sumOf(m_one, nodes), overheadMs + nodes * m_originMs, stepMs);
  }
  const std::vector<double> bell = bellOf(std::sqrt(varianceMs2() * nodes));
  const double halfMs = kFineMs * static_cast<double>(bell.size() / 2);
  return onGrid(bell, overheadMs + nodes * meanMs() - halfMs, stepMs);
}

std::vector<double> residual(const Kernel& kernel) {
  const double mean = kernel.mean();
  std::vector<double> rest(static_cast<std::size_t>(kernel.end()), 0.0);
  double left = 1.0;
  for (int t = 0; t < kernel.end(); ++t) {
    rest[static_cast<std::size_t>(t)] = left / mean;
    if (t + 1 >= kernel.first && t + 1 < kernel.end()) {
      left -= kernel.mass[static_cast<std::size_t>(t + 1 - kernel.first)];
    }
  }
  const double sum = std::accumulate(rest.begin(), rest.end(), 0.0);
  for (double& mass : rest) {
    mass /= sum;
  }
  return rest;
}

}  // namespace rivulet::feasibility
