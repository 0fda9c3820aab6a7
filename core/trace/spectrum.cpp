// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "base/contract.h"
#include "base/median.h"

namespace rivulet::trace {

namespace {

constexpr std::size_t kSamplesMin = 16;
/// Of one window: finer steps of frequency say nothing about a machine.
constexpr std::size_t kWindowMax = 65536;
/// Samples between which lines are sampled again: this bounds the memory.
constexpr std::size_t kResampledMax = 4'000'000;
constexpr std::size_t kNamedPeaksMax = 5;
/// Side lobes of the window are smaller.
constexpr double kPeakShareMin = 0.05;

/// The samples between two instants, without gaps.
std::vector<SeriesPoint> pointsBetween(const Envelope& samples, base::Instant from,
                                       base::Instant to, bool& hasGaps) {
  std::vector<SeriesPoint> points;
  for (std::size_t i = samples.firstAt(from); i < samples.size() && samples.timeAt(i) <= to; ++i) {
    const SeriesPoint point = samples[i];
    const bool isNew = points.empty() || point.at > points.back().at;
    if (std::isfinite(point.value) && isNew) {
      points.push_back(point);
    } else {
      hasGaps = true;
    }
  }
  return points;
}

double medianStepS(const std::vector<SeriesPoint>& points) {
  std::vector<double> steps;
  steps.reserve(points.size());
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps.push_back(base::toSeconds(points[i].at - points[i - 1].at));
  }
  return base::median(std::move(steps));
}

bool isRegular(const std::vector<SeriesPoint>& points, double stepS) {
  // A late sample counts as much as a lost one: every phase after it is wrong.
  const base::Instant first = points.front().at;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double expected = stepS * static_cast<double>(i);
    if (std::abs(base::toSeconds(points[i].at - first) - expected) > 0.1 * stepS) {
      return false;
    }
  }
  return true;
}

std::vector<double> resampled(const std::vector<SeriesPoint>& points, double stepS) {
  const double spanS = base::toSeconds(points.back().at - points.front().at);
  const auto count = static_cast<std::size_t>(std::floor(spanS / stepS)) + 1;
  std::vector<double> values;
  values.reserve(count);
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = stepS * static_cast<double>(i);
    const auto secondsTo = [&](std::size_t point) {
      return base::toSeconds(points[point].at - points.front().at);
    };
    while (next + 1 < points.size() && secondsTo(next) < at) {
      ++next;
    }
    const double before = secondsTo(next - 1);
    const double share = std::min((at - before) / (secondsTo(next) - before), 1.0);
    values.push_back(points[next - 1].value +
                     share * (points[next].value - points[next - 1].value));
  }
  return values;
}

/// Takes away the line of least squares: a slope is no vibration.
void removeLine(std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double middle = (count - 1.0) / 2.0;
  double mean = 0.0;
  double slope = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    mean += values[i] / count;
    slope += (static_cast<double>(i) - middle) * values[i];
  }
  slope /= count * (count * count - 1.0) / 12.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] -= mean + slope * (static_cast<double>(i) - middle);
  }
}

void findPeaks(Spectrum& spectrum, std::size_t first) {
  const std::vector<double>& of = spectrum.amplitudes;
  const double least = kPeakShareMin * *std::max_element(of.begin(), of.end());
  for (std::size_t k = std::max<std::size_t>(first, 1); k + 1 < of.size(); ++k) {
    if (!(of[k] > of[k - 1] && of[k] >= of[k + 1] && of[k] > least)) {
      continue;
    }
    // The top of the parabola through the logarithms of the three amplitudes.
    const double before = std::log(std::max(of[k - 1], 1e-300));
    const double here = std::log(of[k]);
    const double after = std::log(std::max(of[k + 1], 1e-300));
    const double bend = before - 2.0 * here + after;
    const double offset = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
    spectrum.peaks.push_back({spectrum.stepHz * (static_cast<double>(k) + offset),
                              std::exp(here - 0.25 * (before - after) * offset)});
  }
  std::sort(
      spectrum.peaks.begin(), spectrum.peaks.end(),
      [](const FrequencyPeak& a, const FrequencyPeak& b) { return a.amplitude > b.amplitude; });
  spectrum.peaks.resize(std::min(spectrum.peaks.size(), kNamedPeaksMax));
}

}  // namespace

std::error_code make_error_code(SpectrumError code) {
  static const base::NamedCategory category("trace spectrum");
  return {static_cast<int>(code), category};
}

std::vector<double> meanAmplitudes(const std::vector<double>& regular, std::size_t windowSize,
                                   std::size_t size) {
  return meanAmplitudes(
      regular.size(), [&regular](std::size_t i) { return regular[i]; }, windowSize, size);
}

std::vector<double> meanAmplitudes(std::size_t count,
                                   const std::function<double(std::size_t)>& valueAt,
                                   std::size_t windowSize, std::size_t size) {
  RIVULET_ASSERT(windowSize >= 4 && windowSize <= count);
  RIVULET_ASSERT(size >= windowSize && std::has_single_bit(size));
  std::vector<double> hann(windowSize);
  double weight = 0.0;
  for (std::size_t i = 0; i < windowSize; ++i) {
    hann[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) /
                                   static_cast<double>(windowSize));
    weight += hann[i];
  }
  std::vector<double> mean(size / 2, 0.0);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transformed;
  std::size_t windows = 0;
  for (std::size_t begin = 0; begin + windowSize <= count; begin += windowSize / 2) {
    std::vector<double> values(size, 0.0);
    for (std::size_t i = 0; i < windowSize; ++i) {
      values[i] = hann[i] * valueAt(begin + i);
    }
    fft.fwd(transformed, values);
    for (std::size_t k = 0; k < mean.size(); ++k) {
      mean[k] += 2.0 * std::abs(transformed[k]) / weight;
    }
    ++windows;
  }
  for (double& amplitude : mean) {
    amplitude /= static_cast<double>(windows);
  }
  return mean;
}

base::Result<Spectrum> spectrumOf(const Envelope& samples, base::Instant from, base::Instant to) {
  Spectrum spectrum;
  const std::vector<SeriesPoint> points = pointsBetween(samples, from, to, spectrum.isResampled);
  if (points.size() < kSamplesMin) {
    return base::fail(SpectrumError::TooFewSamples,
                      "A spectrum needs 16 samples or more between the cursors.");
  }
  double stepS = medianStepS(points);
  std::vector<double> values;
  if (!spectrum.isResampled && isRegular(points, stepS)) {
    for (const SeriesPoint& point : points) {
      values.push_back(point.value);
    }
  } else {
    spectrum.isResampled = true;
    const double spanS = base::toSeconds(points.back().at - points.front().at);
    stepS = std::max(stepS, spanS / static_cast<double>(kResampledMax));
    values = resampled(points, stepS);
  }
  if (values.size() < kSamplesMin) {
    return base::fail(SpectrumError::TooFewSamples,
                      "A spectrum needs 16 samples or more between the cursors.");
  }
  removeLine(values);
  const std::size_t windowSize = std::min(values.size(), kWindowMax);
  spectrum.amplitudes = meanAmplitudes(values, windowSize, std::bit_ceil(2 * windowSize));
  spectrum.rateHz = 1.0 / stepS;
  spectrum.stepHz = spectrum.rateHz / static_cast<double>(2 * spectrum.amplitudes.size());
  spectrum.count = values.size();
  // The peak of a sine lies between two steps: at half a step, a parabola meets it within 1 %.
  // Below two periods in the window, the window itself is what is seen.
  findPeaks(spectrum, 2 * 2 * spectrum.amplitudes.size() / windowSize);
  return spectrum;
}

}  // namespace rivulet::trace
