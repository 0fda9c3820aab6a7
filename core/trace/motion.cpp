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

base::Duration medianStepOf(const std::vector<MotionSample>& samples) {
  std::vector<base::Duration> steps;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    steps.push_back(samples[i].at - samples[i - 1].at);
  }
  if (steps.empty()) {
    return {};
  }
  return base::median(std::move(steps));
}

/// A signal with its times and its factor to internal units, read at ascending instants.
class SignalReader {
 public:
  SignalReader(const SignalTrace& trace, std::size_t signal, double factor)
      : m_signal(&trace.signalList[signal]),
        m_at(&trace.timeBases[m_signal->timeBase].at),
        m_factor(factor) {}

  [[nodiscard]] std::size_t timeBase() const { return m_signal->timeBase; }
  /// Linear between two samples; NaN outside.
  [[nodiscard]] double at(base::Instant instant) {
    advance(instant);
    if (m_next == m_at->size() || m_at->empty() || instant < m_at->front()) {
      return kNoValue;
    }
    const double later = m_factor * m_signal->values[m_next];
    if ((*m_at)[m_next] == instant || m_next == 0) {
      return later;
    }
    const double earlier = m_factor * m_signal->values[m_next - 1];
    const double share = base::toSeconds(instant - (*m_at)[m_next - 1]) /
                         base::toSeconds((*m_at)[m_next] - (*m_at)[m_next - 1]);
    return earlier + share * (later - earlier);
  }
  /// The last sample before or at the instant; NaN before the first.
  [[nodiscard]] double lastAt(base::Instant instant) {
    advance(instant);
    if (m_next < m_at->size() && (*m_at)[m_next] == instant) {
      return m_factor * m_signal->values[m_next];
    }
    return m_next == 0 ? kNoValue : m_factor * m_signal->values[m_next - 1];
  }

 private:
  void advance(base::Instant instant) {
    while (m_next < m_at->size() && (*m_at)[m_next] < instant) {
      ++m_next;
    }
  }

  const Signal* m_signal;
  const std::vector<base::Instant>* m_at;
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
const TimeBase& baseOf(const SignalTrace& trace, Readers& readers, SignalRole ofX) {
  std::vector<const TimeBase*> bases;
  std::size_t most = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (const auto& reader = readerOf(readers, roleForAxis(ofX, axis))) {
      bases.push_back(&trace.timeBases[reader->timeBase()]);
      most = std::max(most, bases.back()->at.size());
    }
  }
  return **std::find_if(bases.begin(), bases.end(),
                        [most](const TimeBase* base) { return 2 * base->at.size() >= most; });
}

using Instants = std::vector<base::Instant>::const_iterator;

/// The instants of the section that lasts longest.
std::pair<Instants, Instants> longestSection(const SignalTrace& trace, const TimeBase& base) {
  std::pair<Instants, Instants> longest{base.at.begin(), base.at.end()};
  base::Duration lasts{-1};
  Instants begin = base.at.begin();
  for (std::size_t i = 0; i <= trace.sections.size() && !trace.sections.empty(); ++i) {
    const Instants end = i == trace.sections.size()
                             ? base.at.end()
                             : std::lower_bound(begin, base.at.end(), trace.sections[i]);
    if (begin != end && *(end - 1) - *begin > lasts) {
      lasts = *(end - 1) - *begin;
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

void deriveSpeed(Motion& motion) {
  for (std::size_t i = 1; i < motion.samples.size(); ++i) {
    MotionSample& sample = motion.samples[i];
    const MotionSample& before = motion.samples[i - 1];
    sample.pathMmPerS = base::distance(motion.placeMm(sample), motion.placeMm(before)) /
                        base::toSeconds(sample.at - before.at);
  }
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
  const TimeBase& base =
      baseOf(imported.trace, readers, motion.hasSet ? SignalRole::XSet : SignalRole::XActual);
  const auto [begin, end] = longestSection(imported.trace, base);
  motion.samples.reserve(static_cast<std::size_t>(end - begin));
  for (auto next = begin; next != end; ++next) {
    const base::Instant at = *next;
    const auto set = positionAt(readers, SignalRole::XSet, at);
    const auto actual = positionAt(readers, SignalRole::XActual, at);
    const double speed = motion.hasSpeed ? speedAt(readers, at) : 0.0;
    if (!set || !actual || std::isnan(speed)) {
      continue;
    }
    MotionSample sample{at, *set, *actual, speed, kNoValue, 1.0, 0};
    if (motion.hasFeed) {
      sample.feedMmPerS = readerOf(readers, SignalRole::ProgrammedFeed)->lastAt(at);
    }
    if (motion.hasOverride) {
      sample.overrideFactor = readerOf(readers, SignalRole::Override)->lastAt(at);
    }
    if (motion.hasLine) {
      const double line = readerOf(readers, SignalRole::Line)->lastAt(at);
      sample.line = line >= 1.0 && line < 4e9 ? static_cast<std::uint32_t>(line) : 0;
    }
    motion.samples.push_back(sample);
  }
  motion.notes = imported.trace.events;
  motion.step = medianStepOf(motion.samples);
  if (!motion.hasSpeed) {
    deriveSpeed(motion);
  }
  return motion;
}

Motion motionOf(const ControlTrace& trace) {
  Motion motion;
  motion.hasSet = motion.hasActual = motion.hasSpeed = motion.hasLine = true;
  motion.samples.reserve(trace.samples.size());
  for (const ControlSample& sample : trace.samples) {
    if (!motion.samples.empty() && sample.at <= motion.samples.back().at) {
      continue;  // a file that was changed, or put together
    }
    motion.samples.push_back({sample.at, sample.commandMm, sample.actualMm, sample.feedMmPerS,
                              kNoValue, 1.0, sample.line.value});
  }
  motion.events = trace.events;
  motion.step = medianStepOf(motion.samples);
  return motion;
}

}  // namespace rivulet::trace
