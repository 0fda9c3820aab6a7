// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/median.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

base::Duration medianStepOf(const PackedTimes& at) {
  if (at.size() < 2) {
    return {};
  }
  const std::uint64_t ns = base::medianOfEach([&at](const auto& take) {
    PackedReader<PackedTimes> times(at);
    base::Instant before = times[0];
    for (std::size_t i = 1; i < times.size(); ++i) {
      const base::Instant now = times[i];
      take(static_cast<std::uint64_t>((now - before).count()));
      before = now;
    }
  });
  return base::Duration{static_cast<std::int64_t>(ns)};
}

/// A signal with its times and its factor to internal units, read at ascending instants.
class SignalReader {
 public:
  SignalReader(const SignalTrace& trace, std::size_t signal, double factor)
      : m_signal(&trace.signalList[signal]),
        m_at(trace.timeBases[m_signal->timeBase].at),
        m_values(m_signal->values),
        m_factor(factor) {}

  [[nodiscard]] std::size_t timeBase() const { return m_signal->timeBase; }
  [[nodiscard]] const PackedValues& values() const { return m_signal->values; }
  [[nodiscard]] double factor() const { return m_factor; }
  /// Linear between two samples; NaN outside.
  [[nodiscard]] double at(base::Instant instant) {
    advance(instant);
    if (m_next == m_at.size() || (m_next == 0 && instant < m_at[0])) {
      return kNoValue;
    }
    const double later = m_factor * m_values[m_next];
    const base::Instant laterAt = m_at[m_next];
    if (laterAt == instant || m_next == 0) {
      return later;
    }
    const double earlier = m_factor * m_values[m_next - 1];
    const base::Instant earlierAt = m_at[m_next - 1];
    const double share =
        base::toSeconds(instant - earlierAt) / base::toSeconds(laterAt - earlierAt);
    return earlier + share * (later - earlier);
  }
  /// The last sample before or at the instant; NaN before the first.
  [[nodiscard]] double lastAt(base::Instant instant) {
    advance(instant);
    if (m_next < m_at.size() && m_at[m_next] == instant) {
      return m_factor * m_values[m_next];
    }
    return m_next == 0 ? kNoValue : m_factor * m_values[m_next - 1];
  }

 private:
  void advance(base::Instant instant) {
    while (m_next < m_at.size() && m_at[m_next] < instant) {
      ++m_next;
    }
  }

  const Signal* m_signal;
  PackedReader<PackedTimes> m_at;
  PackedReader<PackedValues> m_values;
  double m_factor;
  std::size_t m_next = 0;  ///< first sample at the instant or later
};

using Readers = std::array<std::optional<SignalReader>, kSignalRoleCount>;

std::optional<SignalReader>& readerOf(Readers& readers, SignalRole role) {
  return readers[static_cast<std::size_t>(role)];
}

Readers readersOf(const ImportedTrace& imported) {
  Readers readers;
  for (const ColumnRole& column : imported.columns) {
    const auto signal =
        std::find_if(imported.trace.signalList.begin(), imported.trace.signalList.end(),
                     [&column](const Signal& one) { return one.name == column.column; });
    if (signal == imported.trace.signalList.end()) {
      continue;  // a column of time
    }
    const double factor = unitFactor(column.unit, column.role).value_or(1.0);
    readerOf(readers, column.role)
        .emplace(imported.trace,
                 static_cast<std::size_t>(signal - imported.trace.signalList.begin()), factor);
  }
  return readers;
}

/// @return nothing if a recorded axis has no value there
std::optional<base::Vec3> positionAt(Readers& readers, SignalRole ofX, base::Instant at) {
  base::Vec3 position{};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (auto& reader = readerOf(readers, roleForAxis(ofX, axis))) {
      const double value = reader->at(at);
      if (!std::isfinite(value)) {
        return std::nullopt;
      }
      position.set(axis, value);
    }
  }
  return position;
}

bool hasAnyAxis(Readers& readers, SignalRole ofX) {
  return readerOf(readers, ofX) || readerOf(readers, roleForAxis(ofX, 1)) ||
         readerOf(readers, roleForAxis(ofX, 2));
}

/// That of the first axis that is not much sparser than another one. @param ofX  of an axis that
/// was recorded
std::size_t baseOf(const SignalTrace& trace, Readers& readers, SignalRole ofX) {
  std::vector<std::size_t> bases;
  std::size_t most = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (const auto& reader = readerOf(readers, roleForAxis(ofX, axis))) {
      bases.push_back(reader->timeBase());
      most = std::max(most, trace.timeBases[bases.back()].at.size());
    }
  }
  return *std::find_if(bases.begin(), bases.end(), [&trace, most](std::size_t base) {
    return 2 * trace.timeBases[base].at.size() >= most;
  });
}

/// Indices of the instants of the section that lasts longest: [first, second).
std::pair<std::size_t, std::size_t> longestSection(const SignalTrace& trace,
                                                   const PackedTimes& at) {
  std::pair<std::size_t, std::size_t> longest{0, at.size()};
  base::Duration lasts{-1};
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= trace.sections.size() && !trace.sections.empty(); ++i) {
    const std::size_t end =
        i == trace.sections.size()
            ? at.size()
            : static_cast<std::size_t>(
                  std::lower_bound(at.begin() + static_cast<std::ptrdiff_t>(begin), at.end(),
                                   trace.sections[i]) -
                  at.begin());
    if (begin != end && at[end - 1] - at[begin] > lasts) {
      lasts = at[end - 1] - at[begin];
      longest = {begin, end};
    }
    begin = end;
  }
  return longest;
}

/// The recorded path speed, or that of the axes; NaN: neither was recorded.
double speedAt(Readers& readers, base::Instant at) {
  if (auto& path = readerOf(readers, SignalRole::PathSpeed)) {
    return std::abs(path->at(at));
  }
  double squares = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (auto& reader = readerOf(readers, roleForAxis(SignalRole::XSpeed, axis))) {
      const double speed = reader->at(at);
      squares += speed * speed;
    }
  }
  return std::sqrt(squares);
}

/// From the place of the sample before. @param motion  holds the samples before this one
double derivedSpeed(const Motion& motion, const MotionSample& before, const MotionSample& sample) {
  return base::distance(motion.placeMm(sample), motion.placeMm(before)) /
         base::toSeconds(sample.at - before.at);
}

std::uint32_t lineOf(double value) {
  return value >= 1.0 && value < 4e9 ? static_cast<std::uint32_t>(value) : 0;
}

/// Whether all that was recorded of the motion belongs to one time base, and has a value at each of
/// its instants.
bool isAligned(Readers& readers, std::size_t timeBase) {
  for (std::size_t i = 0; i < readers.size(); ++i) {
    const auto& reader = readers[i];
    const auto role = static_cast<SignalRole>(i);
    if (!reader || role == SignalRole::Time) {
      continue;
    }
    if (reader->timeBase() != timeBase) {
      return false;
    }
    const bool isHeld = role >= SignalRole::ProgrammedFeed;
    PackedReader<PackedValues> values(reader->values());
    for (std::size_t row = 0; !isHeld && row < values.size(); ++row) {
      if (!std::isfinite(reader->factor() * values[row])) {
        return false;
      }
    }
  }
  return true;
}

/// The values of a signal in another unit. @param convert  of one value
template <class Convert>
PackedValues converted(const PackedValues& from, const Convert& convert) {
  PackedValues values;
  PackedReader<PackedValues> reader(from);
  for (std::size_t i = 0; i < reader.size(); ++i) {
    values.push_back(convert(reader[i]));
  }
  return values;
}

PackedValues scaled(const PackedValues& from, double factor) {
  return factor == 1.0 ? from : converted(from, [factor](double value) { return factor * value; });
}

/// Of samples whose places are known, in the same columns.
PackedValues derivedSpeeds(const Motion& motion) {
  PackedValues speeds;
  MotionReader samples(motion.samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    speeds.push_back(i == 0 ? 0.0 : derivedSpeed(motion, samples[i - 1], samples[i]));
  }
  return speeds;
}

/// The signals as they are, where `isAligned`. @param motion  says what was recorded
MotionSamples alignedSamples(const Motion& motion, Readers& readers, const PackedTimes& at) {
  MotionSamples::Columns columns;
  const auto column = [&columns](MotionColumn of) -> MotionSamples::Column& {
    return columns[static_cast<std::size_t>(of)];
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    for (const auto& [role, of] : {std::pair(SignalRole::XSet, MotionColumn::SetX),
                                   std::pair(SignalRole::XActual, MotionColumn::ActualX)}) {
      if (const auto& reader = readerOf(readers, roleForAxis(role, axis))) {
        columns[static_cast<std::size_t>(of) + axis].values =
            scaled(reader->values(), reader->factor());
      }
    }
  }
  column(MotionColumn::Feed).constant = kNoValue;
  column(MotionColumn::Override).constant = 1.0;
  if (const auto& feed = readerOf(readers, SignalRole::ProgrammedFeed)) {
    column(MotionColumn::Feed).values = scaled(feed->values(), feed->factor());
  }
  if (const auto& factor = readerOf(readers, SignalRole::Override)) {
    column(MotionColumn::Override).values = scaled(factor->values(), factor->factor());
  }
  if (const auto& line = readerOf(readers, SignalRole::Line)) {
    column(MotionColumn::Line).values = converted(line->values(), [&line](double value) {
      return static_cast<double>(lineOf(line->factor() * value));
    });
  }
  if (motion.hasSpeed) {
    PackedReader<PackedTimes> times(at);
    for (std::size_t i = 0; i < times.size(); ++i) {
      column(MotionColumn::Speed).values.push_back(speedAt(readers, times[i]));
    }
    return {at, std::move(columns)};
  }
  Motion places = motion;
  places.samples = MotionSamples(at, columns);
  column(MotionColumn::Speed).values = derivedSpeeds(places);
  return {at, std::move(columns)};
}

/// The samples of a section in which all positions are known.
/// @param motion  says what was recorded
MotionSamples joinedSamples(const Motion& motion, Readers& readers, const PackedTimes& at,
                            std::pair<std::size_t, std::size_t> section) {
  MotionSamples samples;
  PackedReader<PackedTimes> times(at);
  MotionSample before;
  for (std::size_t i = section.first; i < section.second; ++i) {
    const base::Instant now = times[i];
    const auto set = positionAt(readers, SignalRole::XSet, now);
    const auto actual = positionAt(readers, SignalRole::XActual, now);
    const double speed = motion.hasSpeed ? speedAt(readers, now) : 0.0;
    if (!set || !actual || std::isnan(speed)) {
      continue;
    }
    MotionSample sample{now, *set, *actual, speed, kNoValue, 1.0, 0};
    if (motion.hasFeed) {
      sample.feedMmPerS = readerOf(readers, SignalRole::ProgrammedFeed)->lastAt(now);
    }
    if (motion.hasOverride) {
      sample.overrideFactor = readerOf(readers, SignalRole::Override)->lastAt(now);
    }
    if (motion.hasLine) {
      sample.line = lineOf(readerOf(readers, SignalRole::Line)->lastAt(now));
    }
    if (!motion.hasSpeed && !samples.empty()) {
      sample.pathMmPerS = derivedSpeed(motion, before, sample);
    }
    samples.push_back(sample);
    before = sample;
  }
  return samples;
}

}  // namespace

Motion motionOf(const ImportedTrace& imported) {
  Readers readers = readersOf(imported);
  Motion motion;
  motion.hasSet = hasAnyAxis(readers, SignalRole::XSet);
  motion.hasActual = hasAnyAxis(readers, SignalRole::XActual);
  if (!motion.hasSet && !motion.hasActual) {
    return motion;
  }
  motion.hasSpeed =
      readerOf(readers, SignalRole::PathSpeed) || hasAnyAxis(readers, SignalRole::XSpeed);
  motion.hasLine = readerOf(readers, SignalRole::Line).has_value();
  motion.hasFeed = readerOf(readers, SignalRole::ProgrammedFeed).has_value();
  motion.hasOverride = readerOf(readers, SignalRole::Override).has_value();
  const std::size_t base =
      baseOf(imported.trace, readers, motion.hasSet ? SignalRole::XSet : SignalRole::XActual);
  const PackedTimes& at = imported.trace.timeBases[base].at;
  const auto section = longestSection(imported.trace, at);
  const bool isWhole = section.first == 0 && section.second == at.size();
  motion.samples = isWhole && isAligned(readers, base)
                       ? alignedSamples(motion, readers, at)
                       : joinedSamples(motion, readers, at, section);
  motion.notes = imported.trace.events;
  motion.step = medianStepOf(motion.samples.times());
  return motion;
}

Motion motionOf(const ControlTrace& trace) {
  Motion motion;
  motion.hasSet = motion.hasActual = motion.hasSpeed = motion.hasLine = true;
  std::optional<base::Instant> before;
  for (const ControlSample& sample : trace.samples) {
    if (before && sample.at <= *before) {
      continue;  // a file that was changed, or put together
    }
    motion.samples.push_back({sample.at, sample.commandMm, sample.actualMm, sample.feedMmPerS,
                              kNoValue, 1.0, sample.line.value});
    before = sample.at;
  }
  motion.events = trace.events;
  motion.step = medianStepOf(motion.samples.times());
  return motion;
}

}  // namespace rivulet::trace
