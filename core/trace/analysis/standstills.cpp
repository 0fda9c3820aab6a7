// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/analysis/standstills.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/median.h"
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
  const PackedValues speeds = motion.samples.valuesOf(MotionColumn::Speed);
  bool isAny = false;
  const auto forEachMoving = [&](const auto& take) {
    PackedReader<PackedValues> reader(speeds);
    for (std::size_t i = 0; i < reader.size(); ++i) {
      const double speed = reader[i];
      if (speed > exact) {
        take(speed);
      }
    }
  };
  forEachMoving([&isAny](double) { isAny = true; });
  if (!isAny) {
    return exact;
  }
  // The bits of positive numbers are in the order of the numbers.
  const double usual = std::bit_cast<double>(base::medianOfEach([&](const auto& take) {
    forEachMoving([&take](double speed) { take(std::bit_cast<std::uint64_t>(speed)); });
  }));
  return std::max(exact, kTrembleShare * usual);
}

/// How long the path stood between samples i and i + 1, by the ramps before and after; nothing: it
/// did not stop. @param i >= 1, two samples follow
std::optional<Duration> momentAfter(MotionReader& samples, std::size_t i) {
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

/// @param sample  the first of the stop
Standstill standstillAt(const Motion& motion, const MotionSample& sample, Duration duration,
                        Duration uncertainty) {
  Standstill stop;
  stop.start = sample.at;
  stop.duration = duration;
  stop.uncertainty = uncertainty;
  stop.placeMm = motion.placeMm(sample);
  stop.line = sample.line;
  return stop;
}

/// Where the tool was, so that the nearest sample far from a place is found without a look at all
/// those between: a tool that trembles in one place makes many stops there.
class Surroundings {
 public:
  explicit Surroundings(const Motion& motion) : m_motion(motion), m_samples(motion.samples) {}

  /// The last sample before `end` that is more than `kReachMm` away.
  [[nodiscard]] std::optional<base::Vec3> before(std::size_t end, base::Vec3 place) {
    makeBoxes();
    while (end > 0) {
      const std::size_t skipped = lengthWithin(place, [end](std::size_t length) {
        return end % length == 0 ? std::optional(end / length - 1) : std::nullopt;
      });
      if (skipped > 0) {
        end -= skipped;
        continue;
      }
      const base::Vec3 at = m_motion.placeMm(m_samples[--end]);
      if (base::distance(at, place) > kReachMm) {
        return at;
      }
    }
    return std::nullopt;
  }
  /// The first sample from `begin` on that is more than `kReachMm` away.
  [[nodiscard]] std::optional<base::Vec3> after(std::size_t begin, base::Vec3 place) {
    makeBoxes();
    while (begin < m_samples.size()) {
      const std::size_t skipped = lengthWithin(place, [begin](std::size_t length) {
        return begin % length == 0 ? std::optional(begin / length) : std::nullopt;
      });
      if (skipped > 0) {
        begin += skipped;
        continue;
      }
      const base::Vec3 at = m_motion.placeMm(m_samples[begin++]);
      if (base::distance(at, place) > kReachMm) {
        return at;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr double kReachMm = 0.05;
  static constexpr std::size_t kLowest = 64;  // samples of a box of the lowest level
  static constexpr std::size_t kFanOut = 16;

  struct Box {
    base::Vec3 min;
    base::Vec3 max;
  };

  static void include(Box& box, const Box& more) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      box.min.set(axis, std::min(box.min[axis], more.min[axis]));
      box.max.set(axis, std::max(box.max[axis], more.max[axis]));
    }
  }

  /// Of complete boxes only.
  void makeBoxes() {
    if (!m_levels.empty()) {
      return;
    }
    m_levels.emplace_back();
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      const base::Vec3 place = m_motion.placeMm(m_samples[i]);
      if (i % kLowest == 0) {
        m_levels[0].push_back({place, place});
      }
      include(m_levels[0].back(), {place, place});
    }
    m_levels[0].resize(m_samples.size() / kLowest);
    while (m_levels.back().size() >= kFanOut) {
      const std::vector<Box>& below = m_levels.back();
      std::vector<Box> level(below.size() / kFanOut);
      for (std::size_t i = 0; i < level.size(); ++i) {
        level[i] = below[i * kFanOut];
        for (std::size_t j = 1; j < kFanOut; ++j) {
          include(level[i], below[i * kFanOut + j]);
        }
      }
      m_levels.push_back(std::move(level));
    }
  }

  /// Samples of the largest box that is near the place as a whole; 0: none is.
  /// @param boxOf  index of the box of so many samples, if one begins or ends where it should
  template <class BoxOf>
  [[nodiscard]] std::size_t lengthWithin(base::Vec3 place, const BoxOf& boxOf) const {
    constexpr double kSure = 0.999;  // rounding must not hide a sample
    std::size_t within = 0;
    std::size_t length = kLowest;
    for (const std::vector<Box>& level : m_levels) {
      const std::optional<std::size_t> box = boxOf(length);
      if (!box || *box >= level.size()) {
        break;
      }
      base::Vec3 farthest;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        farthest.set(axis, std::max(std::abs(level[*box].min[axis] - place[axis]),
                                    std::abs(level[*box].max[axis] - place[axis])));
      }
      if (!(base::norm(farthest) <= kSure * kReachMm)) {
        break;
      }
      within = length;
      length *= kFanOut;
    }
    return within;
  }

  const Motion& m_motion;
  MotionReader m_samples;
  std::vector<std::vector<Box>> m_levels;  ///< level k: one box per 64 * 16^k samples
};

/// Angle between the directions in which the tool arrives and leaves, degrees.
std::optional<double> turnAt(const Motion& motion, Surroundings& surroundings,
                             const Standstill& stop) {
  const base::Vec3 place = stop.placeMm;
  const std::size_t count = motion.samples.size();
  const auto from =
      surroundings.before(std::min(motion.samples.indexAt(stop.start), count - 1), place);
  const auto to = surroundings.after(motion.samples.indexAt(stop.start + stop.duration), place);
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

/// Spans of time in the order in which they begin. @tparam Event  has `from` and `to`
template <class Event>
class Spans {
 public:
  void add(const Event* event) { m_events.push_back(event); }
  void sort() {
    std::ranges::stable_sort(m_events, {}, [](const Event* one) { return one->from; });
    for (const Event* event : m_events) {
      m_latest.push_back(m_latest.empty() ? event->to : std::max(m_latest.back(), event->to));
    }
  }
  /// The first that touches a stop, or comes as near as a step. Null: none does.
  [[nodiscard]] const Event* touching(const Standstill& stop, Duration step) const {
    // The first that ends late enough begins before all others that do.
    const auto found = std::ranges::upper_bound(m_latest, stop.start - step);
    if (found == m_latest.end()) {
      return nullptr;
    }
    const Event* const event = m_events[static_cast<std::size_t>(found - m_latest.begin())];
    return event->from < stop.start + stop.duration + step ? event : nullptr;
  }

 private:
  std::vector<const Event*> m_events;
  std::vector<base::Instant> m_latest;  ///< end of these and all before
};

bool findEvent(Standstill& stop, const Motion& motion, const Spans<ControlEvent>& events) {
  const ControlEvent* const event = events.touching(stop, motion.step);
  if (event == nullptr) {
    return false;
  }
  using EventKind = ControlEvent::Kind;
  const double seconds = base::toSeconds(event->to - event->from);
  if (event->kind == EventKind::Dwell) {
    setCause(stop, StopCause::Dwell,
             fmt::format("the control recorded a dwell of {:.3f} s in line {}", seconds,
                         event->line.value));
  } else if (event->kind == EventKind::Stop) {
    setCause(
        stop, StopCause::ProgrammedStop,
        fmt::format("the control recorded M{:.0f} in line {}", event->value, event->line.value));
  } else {
    setCause(stop, StopCause::ToolChange,
             fmt::format("the control recorded an auxiliary function of {:.3f} s in line {}",
                         seconds, event->line.value));
  }
  return true;
}

/// The cause that a note of a file names, if it names one that is known.
std::optional<StopCause> causeNamed(std::string_view kind) {
  const auto found = std::find(kStopCauseNames.begin() + 1, kStopCauseNames.end(), kind);
  return found == kStopCauseNames.end()
             ? std::nullopt
             : std::optional(static_cast<StopCause>(found - kStopCauseNames.begin()));
}

/// The file says why.
bool findNote(Standstill& stop, const Motion& motion, const Spans<SignalEvent>& notes) {
  const SignalEvent* const note = notes.touching(stop, motion.step);
  if (note == nullptr) {
    return false;
  }
  setCause(stop, *causeNamed(note->kind), note->text);
  return true;
}

bool findHold(Standstill& stop, const Motion& motion, MotionReader& samples) {
  constexpr double kHeld = 1e-3;
  if (!motion.hasOverride) {
    return false;
  }
  const base::Instant end = stop.start + stop.duration;
  for (std::size_t i = motion.samples.indexAt(stop.start);
       i < samples.size() && samples[i].at <= end; ++i) {
    if (samples[i].overrideFactor <= kHeld) {
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
  const std::size_t next = motion.samples.indexAt(stop.start + stop.duration) + 1;
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
  MotionReader samples(motion.samples);
  const double standing = standstillMmPerS(motion);
  // Speeds from actual positions are too uneven to be continued.
  const bool seesMoments = motion.hasSpeed || motion.hasSet;
  std::vector<Standstill> stops;
  std::optional<std::size_t> moving;
  MotionSample lastMoving;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].pathMmPerS <= standing) {
      continue;
    }
    if (moving && i - *moving > 1) {
      stops.push_back(
          standstillAt(motion, lastMoving, samples[i - 1].at - lastMoving.at, motion.step));
    } else if (moving && seesMoments && *moving > 0 && i + 1 < samples.size()) {
      const bool isNew = stops.empty() || stops.back().start < samples[*moving - 1].at;
      if (const auto rest = momentAfter(samples, *moving); rest && isNew) {
        stops.push_back(standstillAt(motion, lastMoving, *rest, motion.step));
      }
    }
    moving = i;
    lastMoving = samples[i];
  }
  return stops;
}

void findCauses(std::vector<Standstill>& stops, const Motion& motion, const Recording* recording) {
  const Evidence evidence(recording);
  Spans<ControlEvent> events;
  for (const ControlEvent& event : motion.events) {
    events.add(&event);
  }
  events.sort();
  Spans<SignalEvent> notes;
  for (const SignalEvent& note : motion.notes) {
    if (causeNamed(note.kind)) {
      notes.add(&note);
    }
  }
  notes.sort();
  MotionReader samples(motion.samples);
  Surroundings surroundings(motion);
  for (Standstill& stop : stops) {
    if (findEvent(stop, motion, events) || findNote(stop, motion, notes) ||
        findHold(stop, motion, samples) || findData(stop, evidence) ||
        findLoop(stop, motion, evidence)) {
      continue;
    }
    const auto turn =
        stop.duration <= kExactStopMax ? turnAt(motion, surroundings, stop) : std::nullopt;
    if (turn && *turn > kTurnDegMin) {
      setCause(stop, StopCause::ExactStop,
               fmt::format("the path turns by {:.1f} degrees there", *turn));
    }
  }
}

}  // namespace rivulet::trace
