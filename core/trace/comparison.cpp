// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

using base::Instant;
using Runs = std::vector<std::shared_ptr<const ShownTrace>>;
using Places = std::shared_ptr<const Envelope>;

/// An actual position that trembles by less goes nowhere.
constexpr double kTrembleMm = 0.01;
/// Two programs of this many equal points and lengths are the same one.
constexpr double kSameLengthMm = 1e-3;

constexpr std::array<std::string_view, 3> kAxisNames{"time", "path", "point"};

Instant axisInstant(double place) {
  return Instant{base::fromSeconds(place)};
}

/// The length that a run has moved. Null: it has no positions.
Places movedLength(const SignalSet& signalSet) {
  for (const std::string_view suffix : {"_set", "_act"}) {
    std::array<const Envelope*, 3> axes{};
    const Envelope* any = nullptr;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const std::string name = std::string(1, "xyz"[axis]).append(suffix);
      const Channel* channel = signalSet.find(name);
      axes[axis] = channel != nullptr ? channel->samples.get() : nullptr;
      any = any != nullptr ? any : axes[axis];
    }
    if (any == nullptr || any->empty()) {
      continue;
    }
    const double leastMm = suffix == "_act" ? kTrembleMm : 0.0;
    auto places = std::make_shared<Envelope>();
    base::Vec3 before;
    double lengthMm = 0.0;
    for (std::size_t i = 0; i < any->size(); ++i) {
      base::Vec3 here;
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (axes[axis] != nullptr && i < axes[axis]->size()) {
          here.set(axis, axes[axis]->valueAt(i));
        }
      }
      const double step = i == 0 ? 0.0 : base::distance(before, here);
      if (i == 0 || step > leastMm) {
        lengthMm += std::isfinite(step) ? step : 0.0;
        before = here;
      }
      places->append(any->timeAt(i), lengthMm);
    }
    return places;
  }
  return nullptr;
}

/// The samples of the positions. Null: there are none.
const Envelope* positionsOf(const SignalSet& signalSet) {
  for (const char* name : {"x_set", "x_act", "y_set", "y_act", "z_set", "z_act"}) {
    if (const Channel* channel = signalSet.find(name)) {
      return channel->samples.get();
    }
  }
  return nullptr;
}

/// Places along the program. Samples that stand, or that go back, have no place of their own: the
/// place before lasts until the last of them.
Places programPlaces(const ShownTrace& run, RunAxis axis) {
  const Envelope& lengths = *run.signalSet.find("program_length")->samples;
  const ProgramPath& path = *run.programPath;
  auto places = std::make_shared<Envelope>();
  const Envelope* positions = positionsOf(run.signalSet);
  double farthestMm = -1.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double lengthMm = lengths.valueAt(i);
    if (lengthMm < farthestMm) {
      continue;
    }
    farthestMm = lengthMm;
    double place = lengthMm;
    if (axis == RunAxis::Point) {
      const std::size_t segment = path.segmentAt(lengthMm);
      const double from = segment == 0 ? 0.0 : path.lengthTo(segment - 1);
      const double length = path.lengthTo(segment) - from;
      place = static_cast<double>(segment) +
              (length > 0.0 ? std::clamp((lengthMm - from) / length, 0.0, 1.0) : 1.0);
    }
    const Instant at = lengths.timeAt(i);
    const std::size_t own = positions != nullptr ? positions->firstAt(at) : 0;
    if (own > 0 && !places->empty()) {
      const SeriesPoint last = (*places)[places->size() - 1];
      if (positions->timeAt(own - 1) > last.at) {
        places->append(positions->timeAt(own - 1), last.value);
      }
    }
    places->append(at, place);
  }
  return places;
}

bool hasProgram(const ShownTrace& run) {
  const Channel* lengths = run.signalSet.find("program_length");
  return run.programPath != nullptr && lengths != nullptr && !lengths->samples->empty();
}

bool isSameProgram(const ProgramPath& a, const ProgramPath& b) {
  return a.points().size() == b.points().size() &&
         std::abs(a.lengthMm() - b.lengthMm()) <= kSameLengthMm;
}

/// What is compared if nobody says what.
bool isUsual(const SignalOffer& offer) {
  switch (offer.group) {
    case SignalGroup::SetPoint:
    case SignalGroup::Actual:
    case SignalGroup::Lag:
    case SignalGroup::ContourError:
    case SignalGroup::Client:
    case SignalGroup::Column:
      return true;
    case SignalGroup::Speed:
      return offer.label.empty();
    default:
      return false;
  }
}

}  // namespace

std::string_view runAxisName(RunAxis axis) {
  return kAxisNames[static_cast<std::size_t>(axis)];
}

std::optional<RunAxis> runAxisFrom(std::string_view name) {
  const auto found = std::find(kAxisNames.begin(), kAxisNames.end(), name);
  return found == kAxisNames.end()
             ? std::nullopt
             : std::optional(static_cast<RunAxis>(found - kAxisNames.begin()));
}

std::string_view runAxisUnit(RunAxis axis) {
  return axis == RunAxis::Time ? "s" : (axis == RunAxis::Path ? "mm" : "");
}

std::error_code make_error_code(ComparisonError code) {
  static const base::NamedCategory category("trace comparison");
  return {static_cast<int>(code), category};
}

base::Result<RunAlignment> alignRuns(const Runs& runs, RunAxis axis) {
  RunAlignment alignment{axis, false, {}};
  if (axis == RunAxis::Time) {
    alignment.places.resize(runs.size());
    return alignment;
  }
  const auto without =
      std::find_if(runs.begin(), runs.end(), [](const auto& run) { return !hasProgram(*run); });
  const auto different = std::find_if(runs.begin(), runs.end(), [&](const auto& run) {
    return without == runs.end() && !isSameProgram(*run->programPath, *runs.front()->programPath);
  });
  if (axis == RunAxis::Point && without != runs.end()) {
    return base::fail(ComparisonError::NoProgram,
                      "To compare by points, say which NC program the traces show.",
                      (*without)->name);
  }
  if (axis == RunAxis::Point && different != runs.end()) {
    return base::fail(ComparisonError::DifferentPrograms,
                      "The runs are of different programs: compare them by time or path.",
                      (*different)->name);
  }
  alignment.isOfProgram = without == runs.end() && different == runs.end();
  for (const auto& run : runs) {
    Places places = alignment.isOfProgram ? programPlaces(*run, axis) : movedLength(run->signalSet);
    if (!places) {
      return base::fail(ComparisonError::NoPositions,
                        "The trace has no positions: compare it by time.", run->name);
    }
    alignment.places.push_back(std::move(places));
  }
  return alignment;
}

std::shared_ptr<const Envelope> onAxis(const std::shared_ptr<const Envelope>& samples,
                                       const Envelope* places) {
  if (places == nullptr) {
    return samples;
  }
  auto moved = std::make_shared<Envelope>();
  std::size_t next = 0;
  for (std::size_t i = 0; i < samples->size(); ++i) {
    const SeriesPoint point = (*samples)[i];
    while (next < places->size() && places->timeAt(next) < point.at) {
      ++next;
    }
    if (next == places->size()) {
      break;
    }
    const SeriesPoint after = (*places)[next];
    double place = after.value;
    if (after.at != point.at) {
      if (next == 0) {
        continue;
      }
      const SeriesPoint before = (*places)[next - 1];
      place = before.value + (after.value - before.value) * base::toSeconds(point.at - before.at) /
                                 base::toSeconds(after.at - before.at);
    }
    moved->append(axisInstant(place), point.value);
  }
  return moved;
}

std::shared_ptr<const Envelope> differenceOf(const Envelope& reference, const Envelope& run) {
  auto difference = std::make_shared<Envelope>();
  for (std::size_t i = 0; i < run.size(); ++i) {
    const SeriesPoint point = run[i];
    const bool isCommon = !reference.empty() && point.at >= reference.timeAt(0) &&
                          point.at <= reference.timeAt(reference.size() - 1);
    if (isCommon) {
      difference->append(point.at, point.value - valueAt(reference, point.at));
    }
  }
  return difference;
}

DifferenceFigures differenceFigures(const Envelope& difference, Instant from, Instant to) {
  DifferenceFigures figures;
  double length = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  SeriesPoint before{{}, kNoValue};
  for (std::size_t i = difference.firstAt(from);
       i < difference.size() && difference.timeAt(i) <= to; ++i) {
    const SeriesPoint point = difference[i];
    if (!std::isfinite(point.value)) {
      before = point;
      continue;
    }
    if (figures.count == 0 || std::abs(point.value) > std::abs(figures.max)) {
      figures.max = point.value;
      figures.atAxis = base::toSeconds(point.at);
    }
    ++figures.count;
    if (std::isfinite(before.value)) {
      // Linear between the samples: the integrals are exact.
      const double step = base::toSeconds(point.at - before.at);
      const double a = before.value;
      const double b = point.value;
      length += step;
      sum += step * (a + b) / 2.0;
      squares += step * (a * a + a * b + b * b) / 3.0;
    }
    before = point;
  }
  if (figures.count > 0) {
    figures.mean = length > 0.0 ? sum / length : figures.max;
    figures.rms = length > 0.0 ? std::sqrt(squares / length) : std::abs(figures.max);
  }
  return figures;
}

base::Result<std::vector<SignalDifference>> compareRuns(const Runs& runs,
                                                        const RunAlignment& alignment,
                                                        std::size_t reference, std::size_t run,
                                                        const std::vector<std::string>& formulas) {
  RIVULET_ASSERT(reference < runs.size() && run < runs.size());
  RIVULET_ASSERT(alignment.places.size() == runs.size());
  const std::vector<SignalOffer> offers = runs[reference]->signalSet.offers();
  const std::vector<SignalOffer> others = runs[run]->signalSet.offers();
  const auto find = [](const std::vector<SignalOffer>& among, const std::string& formula) {
    return std::find_if(among.begin(), among.end(),
                        [&](const SignalOffer& one) { return one.formula == formula; });
  };
  std::vector<SignalOffer> wanted;
  for (const SignalOffer& offer : offers) {
    const bool isTime = offer.formula == kTimeSignal && alignment.axis != RunAxis::Time;
    if (formulas.empty() && (isUsual(offer) || isTime) &&
        find(others, offer.formula) != others.end()) {
      wanted.push_back(offer);
    }
  }
  for (const std::string& formula : formulas) {
    const auto known = find(offers, formula);
    wanted.push_back(
        known != offers.end() ? *known : SignalOffer{SignalGroup::Column, formula, formula, ""});
  }
  std::vector<SignalDifference> differences;
  for (SignalOffer& offer : wanted) {
    std::array<std::shared_ptr<const Envelope>, 2> samples;
    for (const std::size_t which : {reference, run}) {
      auto calculated = runs[which]->signalSet.calculate(offer.formula);
      if (!calculated) {
        return base::fail(calculated.error());
      }
      samples[which == reference ? 0 : 1] = onAxis(*calculated, alignment.places[which].get());
    }
    const auto difference = differenceOf(*samples[0], *samples[1]);
    differences.push_back(
        {std::move(offer), differenceFigures(*difference, Instant::min(), Instant::max())});
  }
  return differences;
}

}  // namespace rivulet::trace
