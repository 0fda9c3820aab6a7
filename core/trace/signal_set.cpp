// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/signal_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/axes.h"
#include "base/quantile.h"
#include "trace/signals.h"

namespace rivulet::trace {

namespace {

using base::Instant;

constexpr std::size_t kRankedMax = 1'000'000;

std::string axisName(std::size_t axis, std::string_view suffix) {
  std::string name(1, static_cast<char>(base::kAxisNames[axis] - 'A' + 'a'));
  return name.append(suffix);
}

/// A name as a formula has to write it.
std::string quotedName(const std::string& name) {
  const bool isWord = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  }) && !(name[0] >= '0' && name[0] <= '9');
  return isWord ? name : "'" + name + "'";
}

/// A signal whose samples are those of the motion, or of a column.
std::shared_ptr<const Envelope> envelopeOf(const PackedTimes& at, PackedValues values,
                                           Instant origin) {
  return std::make_shared<const Envelope>(PackedPoints(at, std::move(values), origin));
}

void addMotion(SignalSet& signalSet, const Motion& motion, Instant origin) {
  const MotionSamples& samples = motion.samples;
  const auto add = [&](std::string name, const char* unit, PackedValues values) {
    signalSet.add({std::move(name), unit, envelopeOf(samples.times(), std::move(values), origin)});
  };
  const auto ofAxis = [&samples](MotionColumn ofX, std::size_t axis) {
    return samples.valuesOf(static_cast<MotionColumn>(static_cast<std::size_t>(ofX) + axis));
  };
  const auto converted = [&samples](MotionColumn column, double (*convert)(double)) {
    PackedValues values;
    const PackedValues from = samples.valuesOf(column);
    PackedReader<PackedValues> reader(from);
    for (std::size_t i = 0; i < reader.size(); ++i) {
      values.push_back(convert(reader[i]));
    }
    return values;
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (motion.hasSet) {
      add(axisName(axis, "_set"), "mm", ofAxis(MotionColumn::SetX, axis));
    }
    if (motion.hasActual) {
      add(axisName(axis, "_act"), "mm", ofAxis(MotionColumn::ActualX, axis));
    }
  }
  add("path_speed", "mm/s", samples.valuesOf(MotionColumn::Speed));
  if (motion.hasFeed) {
    add("programmed_feed", "mm/s", samples.valuesOf(MotionColumn::Feed));
  }
  if (motion.hasOverride) {
    add("override", "%",
        converted(MotionColumn::Override, [](double factor) { return 100.0 * factor; }));
  }
  if (motion.hasLine) {
    add("line", "",
        converted(MotionColumn::Line, [](double line) { return line == 0.0 ? kNoValue : line; }));
  }
}

void addColumns(SignalSet& signalSet, const SignalTrace& imported, Instant origin) {
  for (const Signal& signal : imported.signalList) {
    auto samples = envelopeOf(imported.timeBases[signal.timeBase].at, signal.values, origin);
    // A column that is called as a signal of ours is still to be found.
    const bool isTaken = signalSet.find(signal.name) != nullptr;
    signalSet.add(
        {isTaken ? signal.name + " (file)" : signal.name, signal.unit, std::move(samples)});
  }
}

void addAccesses(SignalSet& signalSet, const Recording& recording, Instant origin) {
  const auto add = [&](const char* name, bool write) {
    auto samples = std::make_shared<Envelope>();
    for (const Access& access : recording.accesses) {
      const Instant at{access.sent - origin};
      const bool isLater = samples->empty() || (*samples)[samples->size() - 1].at <= at;
      if (access.write == write && isLater) {
        samples->append(at, base::toMilliseconds(access.took));
      }
    }
    if (!samples->empty()) {
      signalSet.add({name, "ms", std::move(samples)});
    }
  };
  add("write_ms", true);
  add("read_ms", false);
}

/// Samples that do not move have no place of their own on the path.
void addContour(SignalSet& signalSet, const TraceAnalysis& analysis, Instant origin) {
  if (analysis.programPath == nullptr || !analysis.path.judged) {
    return;
  }
  const auto distances = contourDistances(analysis.motion, *analysis.programPath, analysis.path);
  const auto add = [&](const char* name, bool has, double ContourDistance::*mm) {
    auto samples = std::make_shared<Envelope>();
    PackedReader<PackedTimes> times(analysis.motion.samples.times());
    for (const ContourDistance& one : distances) {
      samples->append(Instant{times[one.sample] - origin}, one.*mm);
    }
    if (has && !samples->empty()) {
      signalSet.add({name, "mm", std::move(samples)});
    }
  };
  add("contour_error", analysis.motion.hasActual, &ContourDistance::actualMm);
  add("contour_error_set", analysis.motion.hasSet, &ContourDistance::setMm);
  const bool hasBoth = analysis.motion.hasSet && analysis.motion.hasActual;
  auto points = std::make_shared<Envelope>();
  auto lines = std::make_shared<Envelope>();
  auto lengths = std::make_shared<Envelope>();
  auto actualLengths = std::make_shared<Envelope>();
  PackedReader<PackedTimes> times(analysis.motion.samples.times());
  for (const ContourDistance& one : distances) {
    const Instant at{times[one.sample] - origin};
    points->append(at, static_cast<double>(one.segment));
    lines->append(at, static_cast<double>(analysis.programPath->points()[one.segment].line.value));
    lengths->append(at, one.lengthMm);
    if (hasBoth) {
      actualLengths->append(at, one.actualLengthMm);
    }
  }
  if (!points->empty()) {
    signalSet.add({"program_point", "", std::move(points)});
    signalSet.add({"program_line", "", std::move(lines)});
    signalSet.add({"program_length", "mm", std::move(lengths)});
    if (hasBoth) {
      signalSet.add({"program_length_act", "mm", std::move(actualLengths)});
    }
  }
}

/// Of whatever begins first; earlier, if the first sample is to have a later place.
Instant originOf(const Trace& trace, const Motion& motion) {
  const base::Duration offset = base::fromSeconds(
      trace.imported() != nullptr ? trace.imported()->table.mapping.offsetS : 0.0);
  if (!motion.samples.empty()) {
    return Instant{motion.samples.front().at - offset};
  }
  Instant origin = Instant::max();
  if (trace.imported() != nullptr) {
    for (const TimeBase& base : trace.imported()->trace.timeBases) {
      origin = base.at.empty() ? origin : std::min(origin, base.at.front());
    }
  }
  if (trace.recording() != nullptr && !trace.recording()->accesses.empty()) {
    origin = std::min(origin, trace.recording()->accesses.front().sent);
  }
  return origin == Instant::max() ? Instant{} : Instant{origin - offset};
}

/// @param shown  with its stops and pauses
void addEvents(ShownTrace& shown, const Trace& trace, Instant origin) {
  std::vector<SignalEvent>& events = shown.events;
  for (const Standstill& stop : shown.stops) {
    const std::string_view kind =
        stop.cause == StopCause::Unknown ? "stop" : stopCauseName(stop.cause);
    events.push_back({stop.start, stop.start + stop.duration, std::string(kind), stop.evidence});
  }
  for (const Pause& pause : shown.pauses) {
    events.push_back({pause.start, pause.start + pause.duration, "pause",
                      std::string(pauseOriginName(pause.origin))});
  }
  if (trace.recording() != nullptr) {
    for (const Note& note : trace.recording()->notes) {
      events.push_back({Instant{note.at - origin}, Instant{note.at - origin}, "note", note.text});
    }
  }
  if (trace.imported() != nullptr) {
    for (const SignalEvent& event : trace.imported()->trace.events) {
      const SignalEvent moved{Instant{event.from - origin}, Instant{event.to - origin}, event.kind,
                              event.text};
      // Stops that were found again are there.
      const bool isKnown =
          moved.kind != "note" &&
          std::any_of(events.begin(), events.end(), [&](const SignalEvent& one) {
            return one.kind == moved.kind && one.from <= moved.to && one.to >= moved.from;
          });
      if (!isKnown) {
        events.push_back(moved);
      }
    }
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const SignalEvent& a, const SignalEvent& b) { return a.from < b.from; });
}

void addRemarks(ShownTrace& shown, const Trace& of, const TraceAnalysis* analysis) {
  if (of.imported() != nullptr) {
    shown.remarks = of.imported()->trace.remarks;
  }
  if (const Recording* recording = of.recording()) {
    if (!recording->complete) {
      shown.remarks.push_back({RemarkCode::RecordingCut});
    }
    if (recording->unreadableLines > 0) {
      shown.remarks.push_back(
          {RemarkCode::UnreadableLines, {std::to_string(recording->unreadableLines)}});
    }
  }
  const ControlTrace* trace = of.control();
  if (trace != nullptr && trace->truncated) {
    shown.remarks.push_back({RemarkCode::TraceTruncated});
  }
  if (trace != nullptr) {
    std::size_t leftOut = 0;  // of the motion
    const ControlSample* latest = nullptr;
    for (const ControlSample& sample : trace->samples) {
      const bool isLater = latest == nullptr || sample.at > latest->at;
      latest = isLater ? &sample : latest;
      leftOut += isLater ? 0 : 1;
    }
    if (leftOut > 0) {
      shown.remarks.push_back({RemarkCode::ValuesBackwards, {std::to_string(leftOut)}});
    }
  }
  if (analysis != nullptr && analysis->path.departure) {
    const double atS =
        base::toSeconds(analysis->path.departure->at - originOf(of, analysis->motion));
    shown.remarks.push_back({RemarkCode::OtherProgram, {std::to_string(static_cast<long>(atS))}});
  }
}

ShownTrace shownOf(const Motion& motion, Instant origin) {
  ShownTrace shown;
  if (!motion.samples.empty()) {
    addMotion(shown.signalSet, motion, origin);
  }
  shown.step = motion.step;
  return shown;
}

void setLength(ShownTrace& shown) {
  for (const Channel& channel : shown.signalSet.channels()) {
    if (!channel.samples->empty()) {
      const Instant last = channel.samples->timeAt(channel.samples->size() - 1);
      shown.length = std::max(shown.length, last.time_since_epoch());
    }
  }
}

/// @param analysis  null: not yet made
ShownTrace shownOf(const Trace& trace, const Motion& motion, const TraceAnalysis* analysis) {
  const Instant origin = originOf(trace, motion);
  ShownTrace shown = shownOf(motion, origin);
  if (analysis != nullptr) {
    addContour(shown.signalSet, *analysis, origin);
    shown.programPath = analysis->path.judged ? analysis->programPath : nullptr;
    shown.stops = analysis->stops;
    for (Standstill& stop : shown.stops) {
      stop.start = Instant{stop.start - origin};
    }
    shown.isAnalysed = true;
  }
  if (trace.recording() != nullptr) {
    shown.programHash = trace.recording()->start.programHash;
    addAccesses(shown.signalSet, *trace.recording(), origin);
  }
  if (trace.imported() != nullptr) {
    shown.table = trace.imported()->table;
    shown.tableLayout = trace.imported()->layout;
    addColumns(shown.signalSet, trace.imported()->trace, origin);
  }
  setLength(shown);
  if (trace.recording() != nullptr && !trace.recording()->controlTrace) {
    shown.isObserved = true;
    shown.pauses = trace.recording()->pauses;
    for (Pause& pause : shown.pauses) {
      pause.start = Instant{pause.start - origin};
    }
  }
  addEvents(shown, trace, origin);
  addRemarks(shown, trace, analysis);
  return shown;
}

}  // namespace

const Channel* SignalSet::find(std::string_view name) const {
  const auto found = std::find_if(m_channels.begin(), m_channels.end(),
                                  [name](const Channel& one) { return one.name == name; });
  return found == m_channels.end() ? nullptr : &*found;
}

std::vector<SignalOffer> SignalSet::offers() const {
  std::vector<SignalOffer> offers;
  std::vector<std::string> used;
  const auto offer = [&](SignalGroup group, std::string label, const std::string& formula,
                         std::string unit, const std::string& needs) {
    if (find(needs) != nullptr) {
      offers.push_back({group, std::move(label), formula, std::move(unit)});
      used.push_back(needs);
    }
  };
  const auto perAxis = [&](SignalGroup group, std::string_view before, std::string_view after,
                           const char* unit) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const std::string actual = axisName(axis, "_act");
      const std::string name = find(actual) != nullptr ? actual : axisName(axis, "_set");
      offer(group, std::string(1, base::kAxisNames[axis]),
            std::string(before) + name + std::string(after), unit, name);
    }
  };
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    offer(SignalGroup::SetPoint, std::string(1, base::kAxisNames[axis]), axisName(axis, "_set"),
          "mm", axisName(axis, "_set"));
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    offer(SignalGroup::Actual, std::string(1, base::kAxisNames[axis]), axisName(axis, "_act"), "mm",
          axisName(axis, "_act"));
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (find(axisName(axis, "_set")) != nullptr) {
      offer(SignalGroup::Lag, std::string(1, base::kAxisNames[axis]),
            axisName(axis, "_set - ") + axisName(axis, "_act"), "mm", axisName(axis, "_act"));
    }
  }
  offer(SignalGroup::Speed, "", "per_min(path_speed)", "mm/min", "path_speed");
  perAxis(SignalGroup::Speed, "per_min(d(", "))", "mm/min");
  offer(SignalGroup::Acceleration, "", "d(path_speed)", "mm/s²", "path_speed");
  perAxis(SignalGroup::Acceleration, "d(d(", "))", "mm/s²");
  perAxis(SignalGroup::Jerk, "d(d(d(", ")))", "mm/s³");
  offer(SignalGroup::ContourError, "", "contour_error", "mm", "contour_error");
  offer(SignalGroup::ContourError, "set", "contour_error_set", "mm", "contour_error_set");
  for (const char* name : {"line", "program_line", "program_point"}) {
    offer(SignalGroup::Program, name, name, "", name);
  }
  for (const char* name : {"program_length", "program_length_act"}) {
    offer(SignalGroup::Program, name, name, "mm", name);
  }
  if (!m_channels.empty() && find(kTimeSignal) == nullptr) {
    offers.push_back(
        {SignalGroup::Program, std::string(kTimeSignal), std::string(kTimeSignal), "s"});
  }
  offer(SignalGroup::Program, "programmed_feed", "per_min(programmed_feed)", "mm/min",
        "programmed_feed");
  offer(SignalGroup::Program, "override", "override", "%", "override");
  for (const char* name : {"write_ms", "read_ms"}) {
    offer(SignalGroup::Client, name, name, "ms", name);
  }
  for (const Channel& channel : m_channels) {
    if (std::find(used.begin(), used.end(), channel.name) == used.end()) {
      // The unit is shown anyway.
      NameAndUnit heading = splitUnit(channel.name);
      offers.push_back({SignalGroup::Column, heading.name.empty() ? channel.name : heading.name,
                        quotedName(channel.name), channel.unit});
    }
  }
  return offers;
}

base::Result<std::shared_ptr<const Envelope>> SignalSet::calculate(std::string_view text) const {
  auto formula = Formula::parse(text);
  if (!formula) {
    return base::fail(formula.error());
  }
  std::vector<const Envelope*> inputs;  // null: the time
  const Envelope* first = nullptr;
  for (const std::string& name : formula->names()) {
    const Channel* channel = find(name);
    if (channel == nullptr && name == kTimeSignal) {
      inputs.push_back(nullptr);
      continue;
    }
    if (channel == nullptr) {
      return base::fail(
          FormulaError::UnknownSignal,
          "The trace has no such signal. The tool tips of the signals have their names.", name);
    }
    if (formula->isName()) {
      return channel->samples;
    }
    inputs.push_back(channel->samples.get());
    first = first != nullptr ? first : inputs.back();
  }
  if (inputs.empty()) {
    return base::fail(FormulaError::NotUnderstood, "The formula names no signal.",
                      std::string(text));
  }
  if (first == nullptr && m_channels.empty()) {
    return std::make_shared<const Envelope>();
  }
  first = first != nullptr ? first : m_channels.front().samples.get();
  const std::size_t count = first->size();
  std::vector<Instant> at(count);
  std::vector<std::vector<double>> values(inputs.size(), std::vector<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    at[i] = first->timeAt(i);
  }
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    for (std::size_t i = 0; i < count; ++i) {
      if (inputs[input] == nullptr) {
        values[input][i] = base::toSeconds(at[i]);
        continue;
      }
      // Nearly always both have the same samples.
      const Envelope& samples = *inputs[input];
      const bool isSame = i < samples.size() && samples.timeAt(i) == at[i];
      values[input][i] = isSame ? samples.valueAt(i) : valueAt(samples, at[i]);
    }
  }
  const std::vector<double> results = formula->evaluate(at, values);
  auto samples = std::make_shared<Envelope>();
  for (std::size_t i = 0; i < count; ++i) {
    samples->append(at[i], results[i]);
  }
  return samples;
}

std::size_t SignalSet::memoryBytes() const {
  std::size_t bytes = 0;
  for (const Channel& channel : m_channels) {
    bytes += channel.samples->memoryBytes();
  }
  return bytes;
}

ShownTrace makeShownTrace(const Motion& motion) {
  ShownTrace shown =
      shownOf(motion, motion.samples.empty() ? Instant{} : motion.samples.front().at);
  setLength(shown);
  return shown;
}

ShownTrace makeShownTrace(const Trace& trace) {
  return shownOf(trace, motionOf(trace), nullptr);
}

ShownTrace makeShownTrace(const Trace& trace, const TraceAnalysis& analysis) {
  return shownOf(trace, analysis.motion, &analysis);
}

SampleStatistics sampleStatistics(const Envelope& samples, Instant from, Instant to) {
  SampleStatistics figures;
  const std::size_t begin = samples.firstAt(from);
  const std::size_t end = samples.firstAt(to + base::Duration{1});
  const std::size_t stride = (end - begin) / kRankedMax + 1;
  std::vector<double> ranked;
  ranked.reserve((end - begin) / stride + 1);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    const double value = samples.valueAt(i);
    if (std::isnan(value)) {
      continue;
    }
    figures.min = figures.count == 0 ? value : std::min(figures.min, value);
    figures.max = figures.count == 0 ? value : std::max(figures.max, value);
    ++figures.count;
    sum += value;
    squares += value * value;
    if ((i - begin) % stride == 0) {
      ranked.push_back(value);
    }
  }
  if (figures.count == 0) {
    return figures;
  }
  const auto count = static_cast<double>(figures.count);
  figures.mean = sum / count;
  figures.rms = std::sqrt(squares / count);
  std::sort(ranked.begin(), ranked.end());
  const auto quantile = [&ranked, &figures](std::size_t perMille) {
    return ranked.empty() ? figures.min : base::quantile(ranked, perMille);
  };
  figures.p50 = quantile(500);
  figures.p95 = quantile(950);
  figures.p99 = quantile(990);
  return figures;
}

double valueAt(const Envelope& samples, Instant at) {
  const std::size_t next = samples.firstAt(at);
  if (next == samples.size()) {
    return kNoValue;
  }
  const SeriesPoint later = samples[next];
  if (later.at == at || next == 0) {
    return later.at == at ? later.value : kNoValue;
  }
  const SeriesPoint earlier = samples[next - 1];
  const double share = base::toSeconds(at - earlier.at) / base::toSeconds(later.at - earlier.at);
  return earlier.value + share * (later.value - earlier.value);
}

double heldValueAt(const Envelope& samples, Instant at) {
  const std::size_t next = samples.firstAt(at + base::Duration{1});
  return next == 0 ? kNoValue : samples.valueAt(next - 1);
}

std::vector<ValueSpan> spansOf(const Envelope& samples, double value) {
  std::vector<ValueSpan> spans;
  bool isWithin = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool has = samples.valueAt(i) == value;
    if (has && !isWithin) {
      spans.push_back({samples.timeAt(i), samples.timeAt(i)});
    } else if (isWithin) {
      spans.back().to = samples.timeAt(i);
    }
    isWithin = has;
  }
  return spans;
}

}  // namespace rivulet::trace
