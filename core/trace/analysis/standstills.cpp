// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/standstills.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "trace/analysis/pauses.h"

namespace rivulet::trace {

namespace {

using base::Duration;

/// A moment of rest may be missing that share of a step: the ramps are not quite straight.
constexpr double kRampSlack = 0.12;
/// A dip to more than this share of the speed around it is none that leads to a stop.
constexpr double kDipShare = 0.5;
/// Speeds from actual positions: slower than this share of the usual speed, the tool stands. Axes
/// at rest tremble.
constexpr double kTrembleShare = 0.02;
/// A turn of the path by more than this is a corner.
constexpr double kTurnDegMin = 0.1;
/// A longer stop is more than braking and accelerating at a corner.
constexpr Duration kExactStopMax = std::chrono::milliseconds{30};
/// Data that arrived this long before the end of a stop ended it.
constexpr Duration kDataLeadMax = std::chrono::milliseconds{60};

constexpr std::array<std::string_view, 8> kStopCauseNames{
    "unknown",          "exact stop",       "dwell", "programmed stop", "tool change", "hold",
    "waiting for data", "preprocessor stop"};

double standstillMmPerS(const Motion& motion) {
  const double exact = PauseOptions{}.standstillMmPerSMax;
  if (motion.hasSpeed || motion.hasSet) {
    return exact;
  }
  std::vector<double> speeds;
  for (const MotionSample& sample : motion.samples) {
    if (sample.pathMmPerS > exact) {
      speeds.push_back(sample.pathMmPerS);
    }
  }
  if (speeds.empty()) {
    return exact;
  }
  const auto usual = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), usual, speeds.end());
  return std::max(exact, kTrembleShare * *usual);
}

/// How long the path stood between samples i and i + 1, by the ramps before and after; nothing: it
/// did not stop. @param i >= 1, two samples follow
std::optional<Duration> momentAfter(const std::vector<MotionSample>& samples, std::size_t i) {
  const double before = samples[i - 1].pathMmPerS;
  const double last = samples[i].pathMmPerS;
  const double first = samples[i + 1].pathMmPerS;
  const double after = samples[i + 2].pathMmPerS;
  if (before <= last || after <= first ||
      std::min(last, first) >= kDipShare * std::max(before, after)) {
    return std::nullopt;
  }
  const double stepS = base::toSeconds(samples[i + 1].at - samples[i].at);
  const double brakingS =
      last * base::toSeconds(samples[i].at - samples[i - 1].at) / (before - last);
  const double leavingS =
      first * base::toSeconds(samples[i + 2].at - samples[i + 1].at) / (after - first);
  const double restS = stepS - brakingS - leavingS;
  if (restS < -kRampSlack * stepS) {
    return std::nullopt;
  }
  return base::fromSeconds(std::max(0.0, restS));
}

Standstill standstillAt(const Motion& motion, std::size_t begin, Duration duration,
                        Duration uncertainty) {
  const MotionSample& sample = motion.samples[begin];
  Standstill stop;
  stop.start = sample.at;
  stop.duration = duration;
  stop.uncertainty = uncertainty;
  stop.placeMm = motion.placeMm(sample);
  stop.line = sample.line;
  return stop;
}

/// First sample at the instant or later.
std::size_t indexAt(const Motion& motion, base::Instant at) {
  const auto found = std::lower_bound(
      motion.samples.begin(), motion.samples.end(), at,
      [](const MotionSample& sample, base::Instant instant) { return sample.at < instant; });
  return static_cast<std::size_t>(found - motion.samples.begin());
}

/// Angle between the directions in which the tool arrives and leaves, degrees.
std::optional<double> turnAt(const Motion& motion, const Standstill& stop) {
  constexpr double kReachMm = 0.05;
  const base::Vec3 place = stop.placeMm;
  std::optional<base::Vec3> from;
  std::optional<base::Vec3> to;
  for (std::size_t i = std::min(indexAt(motion, stop.start), motion.samples.size() - 1);
       i > 0 && !from; --i) {
    const base::Vec3 at = motion.placeMm(motion.samples[i - 1]);
    from = base::distance(at, place) > kReachMm ? std::optional(at) : std::nullopt;
  }
  for (std::size_t i = indexAt(motion, stop.start + stop.duration);
       i < motion.samples.size() && !to; ++i) {
    const base::Vec3 at = motion.placeMm(motion.samples[i]);
    to = base::distance(at, place) > kReachMm ? std::optional(at) : std::nullopt;
  }
  if (!from || !to) {
    return std::nullopt;
  }
  const base::Vec3 arriving = place - *from;
  const base::Vec3 leaving = *to - place;
  const double cosine = base::dot(arriving, leaving) / (base::norm(arriving) * base::norm(leaving));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

void setCause(Standstill& stop, StopCause cause, std::string evidence) {
  stop.cause = cause;
  stop.evidence = std::move(evidence);
}

bool findEvent(Standstill& stop, const Motion& motion) {
  const base::Instant end = stop.start + stop.duration + motion.step;
  for (const ControlEvent& event : motion.events) {
    if (event.from >= end || event.to <= stop.start - motion.step) {
      continue;
    }
    using EventKind = ControlEvent::Kind;
    const double seconds = base::toSeconds(event.to - event.from);
    if (event.kind == EventKind::Dwell) {
      setCause(stop, StopCause::Dwell,
               fmt::format("the control recorded a dwell of {:.3f} s in line {}", seconds,
                           event.line.value));
    } else if (event.kind == EventKind::Stop) {
      setCause(
          stop, StopCause::ProgrammedStop,
          fmt::format("the control recorded M{:.0f} in line {}", event.value, event.line.value));
    } else {
      setCause(stop, StopCause::ToolChange,
               fmt::format("the control recorded an auxiliary function of {:.3f} s in line {}",
                           seconds, event.line.value));
    }
    return true;
  }
  return false;
}

/// The file says why.
bool findNote(Standstill& stop, const Motion& motion) {
  const base::Instant end = stop.start + stop.duration + motion.step;
  for (const SignalEvent& note : motion.notes) {
    if (note.from >= end || note.to <= stop.start - motion.step) {
      continue;
    }
    for (std::size_t cause = 1; cause < kStopCauseNames.size(); ++cause) {
      if (note.kind == kStopCauseNames[cause]) {
        setCause(stop, static_cast<StopCause>(cause), note.text);
        return true;
      }
    }
  }
  return false;
}

bool findHold(Standstill& stop, const Motion& motion) {
  constexpr double kHeld = 1e-3;
  const base::Instant end = stop.start + stop.duration;
  for (std::size_t i = indexAt(motion, stop.start);
       motion.hasOverride && i < motion.samples.size() && motion.samples[i].at <= end; ++i) {
    if (motion.samples[i].overrideFactor <= kHeld) {
      setCause(stop, StopCause::Hold, "the override was 0 while the axes stood");
      return true;
    }
  }
  return false;
}

/// What a recording tells, in the order of time: each stop looks at what is near it.
class Evidence {
 public:
  explicit Evidence(const Recording* recording) : m_recording(recording) {
    if (recording == nullptr) {
      return;
    }
    const std::vector<Access>& accesses = recording->accesses;
    for (std::size_t i = 0; i < accesses.size(); ++i) {
      if (accesses[i].write) {
        m_writes.emplace_back(accesses[i].sent + accesses[i].took, i);
      }
    }
    std::sort(m_writes.begin(), m_writes.end());
    if (recording->controlTrace) {
      for (const ExecutedBlock& block : recording->controlTrace->blocks) {
        m_blockEnds.push_back(block.to);
      }
      std::sort(m_blockEnds.begin(), m_blockEnds.end());
    }
  }
  /// Null: there is none.
  [[nodiscard]] const Recording* recording() const { return m_recording; }
  /// Of the writes that were answered after `from`, and not after `to`, the first that was sent.
  [[nodiscard]] const Access* writeWithin(base::Instant from, base::Instant to) const {
    const Access* first = nullptr;
    const auto behind = [](base::Instant at, const Write& write) { return at < write.first; };
    for (auto write = std::upper_bound(m_writes.begin(), m_writes.end(), from, behind);
         write != m_writes.end() && write->first <= to; ++write) {
      const Access* const access = &m_recording->accesses[write->second];
      first = first == nullptr ? access : std::min(first, access);
    }
    return first;
  }
  [[nodiscard]] bool hasBlockEndWithin(base::Instant from, base::Instant to) const {
    const auto end = std::lower_bound(m_blockEnds.begin(), m_blockEnds.end(), from);
    return end != m_blockEnds.end() && *end <= to;
  }

 private:
  using Write = std::pair<base::Instant, std::size_t>;  ///< when it was answered, and which it is
  const Recording* m_recording;
  std::vector<Write> m_writes;
  std::vector<base::Instant> m_blockEnds;
};

bool findData(Standstill& stop, const Evidence& evidence) {
  const base::Instant end = stop.start + stop.duration;
  // A lead of exactly the greatest still counts.
  const base::Instant earliest = end - kDataLeadMax - Duration{1};
  const Access* const write = evidence.writeWithin(std::max(stop.start, earliest), end);
  if (write == nullptr) {
    return false;
  }
  setCause(stop, StopCause::WaitingForData,
           fmt::format("a write of {} values was answered {:.1f} ms before the axes moved again",
                       write->nodes, base::toMilliseconds(end - (write->sent + write->took))));
  return true;
}

/// Whether blocks that follow each other lead from a line to another one. Short blocks between them
/// may have no sample.
bool isReached(const std::vector<base::Continuation>& continuations, std::uint32_t from,
               std::uint32_t to) {
  std::vector<bool> isSeen(continuations.size(), false);
  std::vector<std::uint32_t> next{from};
  while (!next.empty()) {
    const base::LineNumber line{next.back()};
    next.pop_back();
    const auto first = std::lower_bound(
        continuations.begin(), continuations.end(), line,
        [](const base::Continuation& one, base::LineNumber wanted) { return one.from < wanted; });
    for (auto one = first; one != continuations.end() && one->from == line; ++one) {
      const auto index = static_cast<std::size_t>(one - continuations.begin());
      if (one->to.value == to) {
        return true;
      }
      if (!isSeen[index]) {
        isSeen[index] = true;
        next.push_back(one->to.value);
      }
    }
  }
  return false;
}

/// Whether a block ends within the stop. Without one, the axes stood in the middle of a block.
bool isBetweenBlocks(const Standstill& stop, const Motion& motion, const Evidence& evidence) {
  return evidence.hasBlockEndWithin(stop.start - motion.step,
                                    stop.start + stop.duration + motion.step);
}

/// The recording says which blocks of the program on the control follow each other without a
/// STOPRE. @param after  line behind the stop
bool findStopre(Standstill& stop, std::uint32_t after, const Motion& motion,
                const Evidence& evidence) {
  const std::vector<base::Continuation>& continuations = evidence.recording()->start.continuations;
  if (continuations.empty() || isReached(continuations, stop.line, after) ||
      !isBetweenBlocks(stop, motion, evidence)) {
    return false;
  }
  setCause(stop, StopCause::PreprocessorStop,
           fmt::format("the program on the control has a STOPRE between line {} and line {}",
                       stop.line, after));
  return true;
}

/// The STOPRE of a flexible program. Where it is not known, a line before the stop that is after
/// the line behind it tells: the program jumps back to its loop.
bool findLoop(Standstill& stop, const Motion& motion, const Evidence& evidence) {
  const std::size_t next = indexAt(motion, stop.start + stop.duration) + 1;
  if (!motion.hasLine || next >= motion.samples.size()) {
    return false;
  }
  const std::uint32_t after = motion.samples[next].line;
  if (stop.line == 0 || after == 0) {
    return false;
  }
  if (evidence.recording() != nullptr && findStopre(stop, after, motion, evidence)) {
    return true;
  }
  if (after >= stop.line) {
    return false;
  }
  setCause(stop, StopCause::PreprocessorStop,
           fmt::format("the program on the control jumps from line {} back to line {}", stop.line,
                       after));
  return true;
}

}  // namespace

std::string_view stopCauseName(StopCause cause) {
  return kStopCauseNames[static_cast<std::size_t>(cause)];
}

std::vector<Standstill> findStandstills(const Motion& motion) {
  const std::vector<MotionSample>& samples = motion.samples;
  const double standing = standstillMmPerS(motion);
  // Speeds from actual positions are too uneven to be continued.
  const bool seesMoments = motion.hasSpeed || motion.hasSet;
  std::vector<Standstill> stops;
  std::optional<std::size_t> moving;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].pathMmPerS <= standing) {
      continue;
    }
    if (moving && i - *moving > 1) {
      stops.push_back(
          standstillAt(motion, *moving, samples[i - 1].at - samples[*moving].at, motion.step));
    } else if (moving && seesMoments && *moving > 0 && i + 1 < samples.size()) {
      const bool isNew = stops.empty() || stops.back().start < samples[*moving - 1].at;
      if (const auto rest = momentAfter(samples, *moving); rest && isNew) {
        stops.push_back(standstillAt(motion, *moving, *rest, motion.step));
      }
    }
    moving = i;
  }
  return stops;
}

void findCauses(std::vector<Standstill>& stops, const Motion& motion, const Recording* recording) {
  const Evidence evidence(recording);
  for (Standstill& stop : stops) {
    if (findEvent(stop, motion) || findNote(stop, motion) || findHold(stop, motion) ||
        findData(stop, evidence) || findLoop(stop, motion, evidence)) {
      continue;
    }
    const auto turn = stop.duration <= kExactStopMax ? turnAt(motion, stop) : std::nullopt;
    if (turn && *turn > kTurnDegMin) {
      setCause(stop, StopCause::ExactStop,
               fmt::format("the path turns by {:.1f} degrees there", *turn));
    }
  }
}

}  // namespace rivulet::trace
