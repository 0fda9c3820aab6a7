// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "linuxcnc/sampler.h"

#include <array>
#include <optional>

#include "base/text.h"

namespace rivulet::linuxcnc {

bool isOverrun(std::string_view line) {
  return base::trim(line) == "overrun";
}

bool addSample(trace::ControlTrace& trace, std::string_view line, const SampleScale& scale) {
  if (isOverrun(line)) {
    trace.truncated = true;
    return true;
  }
  std::array<double, 9> numbers{};
  for (double& number : numbers) {
    line = base::trim(line);
    const std::string_view word = line.substr(0, line.find(' '));
    const std::optional<double> value = base::parseNumber(word);
    if (!value) {
      return false;
    }
    number = *value;
    line.remove_prefix(word.size());
  }
  // The sampler counts, and LinuxCNC its lines, in 32 bits.
  constexpr double kCountMax = 4'294'967'295.0;
  if (!(numbers[0] >= 0.0 && numbers[0] <= kCountMax && numbers[8] <= kCountMax)) {
    return false;
  }
  const auto place = [&](std::size_t first) {
    return scale.mmPerUnit * base::Vec3{numbers[first], numbers[first + 1], numbers[first + 2]} -
           scale.zeroMm;
  };
  trace::ControlSample sample;
  sample.at = base::Instant{} + scale.cycle * static_cast<base::Duration::rep>(numbers[0]);
  sample.commandMm = place(1);
  sample.actualMm = place(4);
  sample.feedMmPerS = numbers[7] * scale.mmPerUnit;
  sample.line = base::LineNumber{static_cast<unsigned>(numbers[8] < 0.0 ? 0.0 : numbers[8])};
  if (!trace.samples.empty() && sample.at <= trace.samples.back().at) {
    trace.truncated = true;  // the sampler has been started anew
    return true;
  }
  trace.samples.push_back(sample);
  return true;
}

}  // namespace rivulet::linuxcnc
