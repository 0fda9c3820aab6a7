// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which frequencies a signal has. @threadsafety pure.
#pragma once

#include <cstddef>
#include <functional>
#include <system_error>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "trace/envelope.h"

namespace rivulet::trace {

/// Mean amplitude per frequency of regular samples: windows of Hann, half overlapping.
/// @param windowSize  samples of one window, >= 4 and <= regular.size()
/// @param size  of the transform, a power of two >= windowSize; larger ones interpolate
/// @return size / 2 values, for the frequencies k / (size * step): a sine of amplitude 1 has 1 at
/// its own
[[nodiscard]] std::vector<double> meanAmplitudes(const std::vector<double>& regular,
                                                 std::size_t windowSize, std::size_t size);
/// The same of samples that are in no list. @param count  of the samples  @param valueAt  one of
/// them; each is asked for twice, nearly in order
[[nodiscard]] std::vector<double> meanAmplitudes(std::size_t count,
                                                 const std::function<double(std::size_t)>& valueAt,
                                                 std::size_t windowSize, std::size_t size);

struct FrequencyPeak {
  double hz = 0.0;
  double amplitude = 0.0;  ///< in the unit of the signal
};

struct Spectrum {
  double stepHz = 0.0;             ///< between two amplitudes; the first is at 0
  std::vector<double> amplitudes;  ///< in the unit of the signal, of its deviation from a line
  double rateHz = 0.0;             ///< of the samples; half of it is the highest frequency
  std::size_t count = 0;           ///< samples used
  /// The samples were not regular or had gaps: straight lines between them were sampled instead,
  /// which takes from the highest frequencies.
  bool isResampled = false;
  std::vector<FrequencyPeak> peaks;  ///< the largest first, at most five
};

enum class SpectrumError {
  TooFewSamples = 1,
};
[[nodiscard]] std::error_code make_error_code(SpectrumError code);

/// Of the samples between two instants, both included.
/// @return error TooFewSamples: less than 16
[[nodiscard]] base::Result<Spectrum> spectrumOf(const Envelope& samples, base::Instant from,
                                                base::Instant to);

}  // namespace rivulet::trace

template <>
struct std::is_error_code_enum<rivulet::trace::SpectrumError> : std::true_type {};
