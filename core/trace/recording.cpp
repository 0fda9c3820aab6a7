// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/recording.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "base/contract.h"
#include "base/text.h"
#include "trace/frames.h"
#include "trace/import/compression.h"
#include "trace/lines.h"

namespace rivulet::trace {
namespace {

using lines::Fields;

constexpr std::string_view kRecordingName = "rivulet-recording";
constexpr int kRecordingVersion = 2;
/// Rotary axes came with format 2; a recording without them is still one of format 1.
constexpr int kRecordingVersionWithoutRotary = 1;
/// Long lists go to the sink in pieces of about this size.
constexpr std::size_t kFlushBytes = 64 * 1024;

std::int64_t nanoseconds(base::Instant at) {
  return at.time_since_epoch().count();
}

base::RotarySet rotaryOf(std::string_view axes) {
  base::RotarySet set{};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    set[axis] = axes.find(base::kRotaryAxisNames[axis]) != std::string_view::npos;
  }
  return set;
}

void appendText(std::string& out, std::string_view key, std::string_view text) {
  out += ' ';
  out += key;
  out += '=';
  lines::appendQuoted(out, text);
}

/// "12>13>14,20>21": each block can follow the one before it.
std::string printContinuations(const std::vector<base::Continuation>& continuations) {
  std::string text;
  base::LineNumber last;
  for (const base::Continuation& one : continuations) {
    if (text.empty() || one.from != last) {
      text += fmt::format("{}{}", text.empty() ? "" : ",", one.from.value);
    }
    text += fmt::format(">{}", one.to.value);
    last = one.to;
  }
  return text;
}

std::optional<std::vector<base::Continuation>> parseContinuations(std::string_view text) {
  std::vector<base::Continuation> continuations;
  while (!text.empty()) {
    std::string_view chain = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), chain.size() + 1));
    base::LineNumber before;
    while (!chain.empty()) {
      const std::string_view digits = chain.substr(0, chain.find('>'));
      chain.remove_prefix(std::min(chain.size(), digits.size() + 1));
      const auto line = base::parseInteger(digits);
      if (!line || *line < 1) {
        return std::nullopt;
      }
      const base::LineNumber now{static_cast<std::uint32_t>(*line)};
      if (before.value != 0) {
        continuations.push_back({before, now});
      }
      before = now;
    }
  }
  return continuations;
}

template <class Number>
void appendNumber(std::string& out, std::string_view key, Number value) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE(" {}={}"), key, value);
}

/// Reading: each function adds the fields after the keyword to the recording, or returns false and
/// changes nothing.
class Reader {
 public:
  bool read(std::string_view line);
  /// So far, with what the analysis will take, without texts.
  [[nodiscard]] std::size_t memoryBytes() const;
  [[nodiscard]] Recording take(std::size_t unreadableLines) &&;

 private:
  bool readRun(Fields fields);
  bool readPoints(Fields fields);
  bool readPoint(Fields fields);
  bool readLive(Fields fields);
  bool readAccess(Fields fields);
  bool readPause(Fields fields);
  bool readNote(Fields fields);
  bool readTrace(Fields fields);
  bool readTraceEnd(Fields fields);
  bool readEnd(Fields fields);

  Recording m_recording;
  std::optional<std::size_t> m_pointsAnnounced;
  bool m_traceWhole = false;
};

std::size_t Reader::memoryBytes() const {
  const Recording& so = m_recording;
  const auto bytesOf = [](const auto& list) { return base::Budget::bytesOf(list, kLinesUnasked); };
  return bytesOf(so.points.points) + bytesOf(so.samples) +
         so.samples.size() * kAnalysedSampleBytes + bytesOf(so.accesses) + bytesOf(so.pauses) +
         bytesOf(so.notes) + (so.controlTrace ? trace::memoryBytes(*so.controlTrace) : 0);
}

bool Reader::read(std::string_view line) {
  Fields fields(line);
  const std::string_view keyword = fields.word();
  std::optional<ControlTrace>& trace = m_recording.controlTrace;
  if (keyword == "s") {
    const auto sample = lines::readSample(fields, trace ? trace->rotaryAxes : base::RotarySet{});
    if (sample && trace) {
      trace->samples.push_back(*sample);
    }
    return sample && trace;
  }
  if (keyword == "b") {
    const auto block = lines::readBlock(fields, trace ? trace->rotaryAxes : base::RotarySet{});
    if (block && trace) {
      trace->blocks.push_back(*block);
    }
    return block && trace;
  }
  if (keyword == "e") {
    std::optional<ControlEvent> event = lines::readEvent(fields);
    if (event && trace) {
      trace->events.push_back(std::move(*event));
    }
    return event && trace;
  }
  if (keyword == "l") {
    return readLive(fields);
  }
  if (keyword == "a") {
    return readAccess(fields);
  }
  if (keyword == "p") {
    return readPoint(fields);
  }
  if (keyword == "z") {
    return readPause(fields);
  }
  if (keyword == "n") {
    return readNote(fields);
  }
  if (keyword == "run") {
    return readRun(fields);
  }
  if (keyword == "points") {
    return readPoints(fields);
  }
  if (keyword == "trace") {
    return readTrace(fields);
  }
  if (keyword == "trace-end") {
    return readTraceEnd(fields);
  }
  return keyword == "end" && readEnd(fields);
}

bool Reader::readRun(Fields fields) {
  RunStart start;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "tool") {
      start.toolVersion = fields.quoted();
    } else if (key == "method") {
      start.method = fields.quoted();
    } else if (key == "points_per_loop") {
      start.pointsPerLoop = fields.integer<int>();
    } else if (key == "layout") {
      start.layout = fields.quoted();
    } else if (key == "axes") {
      start.axes = fields.quoted();
    } else if (key == "delta_mm") {
      start.deltaMm = fields.number();
    } else if (key == "feed_mm_per_s") {
      start.feedMmPerS = fields.number();
    } else if (key == "feed_override") {
      start.feedOverride = fields.number();
    } else if (key == "program") {
      start.programName = fields.quoted();
    } else if (key == "hash") {
      start.programHash = fields.quoted();
    } else if (key == "endpoint") {
      start.endpoint = fields.quoted();
    } else if (key == "started_utc") {
      start.startedAtUtc = fields.quoted();
    } else if (key == "run_number") {
      start.runNumber = fields.integer<int>();
    } else if (key == "continues") {
      const auto continuations = parseContinuations(fields.quoted());
      if (continuations) {
        start.continuations = *continuations;
      } else {
        fields.refuse();
      }
    } else if (key == "user") {
      start.user = fields.quoted();
    } else if (key == "computer") {
      start.computer = fields.quoted();
    } else {
      fields.skipValue();
    }
  }
  if (fields.ok()) {
    m_recording.start = std::move(start);
  }
  return fields.ok();
}

bool Reader::readPoints(Fields fields) {
  std::size_t count = 0;
  std::size_t merged = 0;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "count") {
      count = fields.integer<std::size_t>();
    } else if (key == "merged") {
      merged = fields.integer<std::size_t>();
    } else {
      fields.skipValue();
    }
  }
  if (fields.ok()) {
    m_pointsAnnounced = m_pointsAnnounced.value_or(0) + count;  // a job has one list per stretch
    m_recording.points.merged += merged;
  }
  return fields.ok();
}

bool Reader::readPoint(Fields fields) {
  gcode::StreamPoint point;
  point.line.value = fields.integer<std::uint32_t>();
  point.positionMm = fields.vector();
  point.rotaryDeg = lines::readAngles(fields, rotaryOf(m_recording.start.axes));
  if (!fields.ok() || !fields.atEnd()) {
    return false;
  }
  m_recording.points.points.push_back(point);
  return true;
}

bool Reader::readLive(Fields fields) {
  LiveSample sample;
  sample.at = fields.instant();
  Fields ahead = fields;
  if (ahead.word() == "-") {
    fields = ahead;
  } else {
    sample.positionMm = fields.vector();
    if (const base::RotarySet axes = rotaryOf(m_recording.start.axes); base::any(axes)) {
      sample.rotaryDeg = lines::readAngles(fields, axes);
    }
  }
  ahead = fields;
  if (ahead.word() == "-") {
    fields = ahead;
  } else {
    sample.feedMmPerS = fields.number();
  }
  if (!fields.ok() || !fields.atEnd()) {
    return false;
  }
  m_recording.samples.push_back(sample);
  return true;
}

bool Reader::readAccess(Fields fields) {
  Access access;
  access.sent = fields.instant();
  access.took = fields.duration();
  const std::string_view kind = fields.word();
  access.write = kind == "w";
  access.nodes = fields.integer<int>();
  if (!fields.ok() || !fields.atEnd() || (kind != "w" && kind != "r")) {
    return false;
  }
  m_recording.accesses.push_back(access);
  return true;
}

bool Reader::readPause(Fields fields) {
  Pause pause;
  pause.start = fields.instant();
  pause.duration = fields.duration();
  const std::string_view name = fields.word();
  if (!fields.ok() || !fields.atEnd()) {
    return false;
  }
  for (const PauseOrigin origin :
       {PauseOrigin::Measured, PauseOrigin::Inferred, PauseOrigin::Predicted}) {
    if (pauseOriginName(origin) == name) {
      pause.origin = origin;
      m_recording.pauses.push_back(pause);
      return true;
    }
  }
  return false;
}

bool Reader::readNote(Fields fields) {
  Note note;
  note.at = fields.instant();
  note.text = fields.quoted();
  if (!fields.ok() || !fields.atEnd()) {
    return false;
  }
  m_recording.notes.push_back(std::move(note));
  return true;
}

bool Reader::readTrace(Fields fields) {
  ControlTrace trace;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "cycle_ns") {
      trace.cycle = fields.duration();
    } else if (key == "truncated") {
      trace.truncated = fields.integer<int>() != 0;
    } else if (key == "own_blocks") {
      trace.hasOwnBlocksOnly = fields.integer<int>() != 0;
    } else if (key == "rotary") {
      trace.rotaryAxes = lines::readRotaryNames(fields);
    } else {
      fields.skipValue();
    }
  }
  if (fields.ok()) {
    m_recording.controlTrace = std::move(trace);
    m_traceWhole = false;
  }
  return fields.ok();
}

bool Reader::readTraceEnd(Fields fields) {
  std::size_t samples = 0;
  std::size_t blocks = 0;
  std::size_t events = 0;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "samples") {
      samples = fields.integer<std::size_t>();
    } else if (key == "blocks") {
      blocks = fields.integer<std::size_t>();
    } else if (key == "events") {
      events = fields.integer<std::size_t>();
    } else {
      fields.skipValue();
    }
  }
  if (!fields.ok() || !m_recording.controlTrace) {
    return false;
  }
  m_traceWhole = m_recording.controlTrace->samples.size() == samples &&
                 m_recording.controlTrace->blocks.size() == blocks &&
                 m_recording.controlTrace->events.size() == events;
  return true;
}

bool Reader::readEnd(Fields fields) {
  RunEnd end;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "outcome") {
      end.outcome = fields.quoted();
    } else if (key == "sent") {
      end.sent = fields.integer<std::size_t>();
    } else if (key == "accepted") {
      end.accepted = fields.integer<std::size_t>();
    } else if (key == "executed") {
      end.executed = fields.integer<std::size_t>();
    } else if (key == "total") {
      end.total = fields.integer<std::size_t>();
    } else if (key == "duration_ns") {
      end.duration = fields.duration();
    } else if (key == "error") {
      end.errorText = fields.quoted();
    } else {
      fields.skipValue();
    }
  }
  if (fields.ok()) {
    m_recording.end = std::move(end);
  }
  return fields.ok();
}

Recording Reader::take(std::size_t unreadableLines) && {
  m_recording.unreadableLines = unreadableLines;
  m_recording.complete = m_recording.end.has_value();
  m_recording.pointsComplete = m_pointsAnnounced == m_recording.points.points.size();
  if (m_recording.controlTrace && !m_traceWhole) {
    // Whatever the reason, a part of the trace is missing: it must not be used to judge the run.
    m_recording.controlTrace->truncated = true;
  }
  return std::move(m_recording);
}

}  // namespace

RecordingWriter::RecordingWriter(RecordingSink sink) : m_sink(std::move(sink)) {
  RIVULET_ASSERT(m_sink != nullptr);
}

bool RecordingWriter::flush() {
  if (m_ok && !m_lines.empty()) {
    m_ok = m_sink(m_lines);
  }
  m_lines.clear();
  return m_ok;
}

bool RecordingWriter::flushIfLarge() {
  return m_lines.size() < kFlushBytes ? m_ok : flush();
}

bool RecordingWriter::start(const RunStart& start) {
  m_rotaryAxes = rotaryOf(start.axes);
  fmt::format_to(std::back_inserter(m_lines), "{} {}\nrun", kRecordingName,
                 base::any(m_rotaryAxes) ? kRecordingVersion : kRecordingVersionWithoutRotary);
  appendText(m_lines, "tool", start.toolVersion);
  appendText(m_lines, "method", start.method);
  appendNumber(m_lines, "points_per_loop", start.pointsPerLoop);
  appendText(m_lines, "layout", start.layout);
  if (!start.axes.empty()) {
    appendText(m_lines, "axes", start.axes);
  }
  appendNumber(m_lines, "delta_mm", start.deltaMm);
  appendNumber(m_lines, "feed_mm_per_s", start.feedMmPerS);
  if (start.feedOverride > 0.0) {
    appendNumber(m_lines, "feed_override", start.feedOverride);
  }
  appendText(m_lines, "program", start.programName);
  appendText(m_lines, "hash", start.programHash);
  appendText(m_lines, "endpoint", start.endpoint);
  appendText(m_lines, "started_utc", start.startedAtUtc);
  if (start.runNumber != 0) {
    appendNumber(m_lines, "run_number", start.runNumber);
  }
  if (!start.continuations.empty()) {
    appendText(m_lines, "continues", printContinuations(start.continuations));
  }
  if (!start.user.empty()) {
    appendText(m_lines, "user", start.user);
    appendText(m_lines, "computer", start.computer);
  }
  m_lines += '\n';
  return flush();
}

bool RecordingWriter::points(const gcode::PointList& points) {
  m_lines += "points";
  appendNumber(m_lines, "count", points.points.size());
  appendNumber(m_lines, "merged", points.merged);
  m_lines += '\n';
  for (const gcode::StreamPoint& point : points.points) {
    fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE("p {} {} {} {}"), point.line.value,
                   point.positionMm.x, point.positionMm.y, point.positionMm.z);
    lines::appendAngles(m_lines, point.rotaryDeg, m_rotaryAxes);
    m_lines += '\n';
    flushIfLarge();
  }
  return flush();
}

bool RecordingWriter::sample(const LiveSample& sample) {
  fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE("l {}"), nanoseconds(sample.at));
  if (sample.positionMm) {
    fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE(" {} {} {}"), sample.positionMm->x,
                   sample.positionMm->y, sample.positionMm->z);
    lines::appendAngles(m_lines, sample.rotaryDeg.value_or(base::RotaryDeg{}), m_rotaryAxes);
  } else {
    m_lines += " -";
  }
  if (sample.feedMmPerS) {
    fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE(" {}\n"), *sample.feedMmPerS);
  } else {
    m_lines += " -\n";
  }
  return flush();
}

bool RecordingWriter::access(const Access& access) {
  fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE("a {} {} {} {}\n"),
                 nanoseconds(access.sent), access.took.count(), access.write ? 'w' : 'r',
                 access.nodes);
  return flush();
}

bool RecordingWriter::pause(const Pause& pause) {
  fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE("z {} {} {}\n"), nanoseconds(pause.start),
                 pause.duration.count(), pauseOriginName(pause.origin));
  return flush();
}

bool RecordingWriter::note(const Note& note) {
  fmt::format_to(std::back_inserter(m_lines), FMT_COMPILE("n {} "), nanoseconds(note.at));
  lines::appendQuoted(m_lines, note.text);
  m_lines += '\n';
  return flush();
}

bool RecordingWriter::controlTrace(const ControlTrace& trace) {
  controlTraceBegin(trace);
  controlTracePiece(trace);
  return controlTraceEnd();
}

bool RecordingWriter::controlTraceBegin(const ControlTrace& trace) {
  m_traceSamples = 0;
  m_traceBlocks = 0;
  m_traceEvents = 0;
  m_lines += "trace";
  appendNumber(m_lines, "cycle_ns", trace.cycle.count());
  appendNumber(m_lines, "truncated", trace.truncated ? 1 : 0);
  if (trace.hasOwnBlocksOnly) {
    appendNumber(m_lines, "own_blocks", 1);
  }
  if (base::any(trace.rotaryAxes)) {
    m_lines += " rotary=" + base::rotaryNames(trace.rotaryAxes);
  }
  m_lines += '\n';
  return flush();
}

bool RecordingWriter::controlTracePiece(const ControlTrace& trace) {
  m_traceSamples += trace.samples.size();
  m_traceBlocks += trace.blocks.size();
  m_traceEvents += trace.events.size();
  for (const ControlSample& sample : trace.samples) {
    lines::appendSample(m_lines, sample, trace.rotaryAxes);
    flushIfLarge();
  }
  for (const ExecutedBlock& block : trace.blocks) {
    lines::appendBlock(m_lines, block, trace.rotaryAxes);
    flushIfLarge();
  }
  for (const ControlEvent& event : trace.events) {
    lines::appendEvent(m_lines, event);
    flushIfLarge();
  }
  return flush();
}

bool RecordingWriter::controlTraceEnd() {
  m_lines += "trace-end";
  appendNumber(m_lines, "samples", m_traceSamples);
  appendNumber(m_lines, "blocks", m_traceBlocks);
  if (m_traceEvents > 0) {
    appendNumber(m_lines, "events", m_traceEvents);
  }
  m_lines += '\n';
  return flush();
}

bool RecordingWriter::end(const RunEnd& end) {
  m_lines += "end";
  appendText(m_lines, "outcome", end.outcome);
  appendNumber(m_lines, "sent", end.sent);
  appendNumber(m_lines, "accepted", end.accepted);
  appendNumber(m_lines, "executed", end.executed);
  appendNumber(m_lines, "total", end.total);
  appendNumber(m_lines, "duration_ns", end.duration.count());
  appendText(m_lines, "error", end.errorText);
  m_lines += '\n';
  return flush();
}

std::string printRecording(const Recording& recording) {
  std::string text;
  RecordingWriter writer([&text](std::string_view lines) {
    text += lines;
    return true;
  });
  writer.start(recording.start);
  writer.points(recording.points);
  for (const LiveSample& sample : recording.samples) {
    writer.sample(sample);
  }
  for (const Access& access : recording.accesses) {
    writer.access(access);
  }
  for (const Pause& pause : recording.pauses) {
    writer.pause(pause);
  }
  for (const Note& note : recording.notes) {
    writer.note(note);
  }
  if (recording.controlTrace) {
    writer.controlTrace(*recording.controlTrace);
  }
  if (recording.end) {
    writer.end(*recording.end);
  }
  return text;
}

base::Result<Recording> parseRecording(std::string_view bytes, const base::Budget& budget) {
  Frames frames;
  std::string_view text = bytes;
  if (isCompressed(bytes)) {
    auto unpacked = readFrames(bytes, budget);
    if (!unpacked) {
      return base::fail(unpacked.error());
    }
    frames = std::move(*unpacked);
    text = frames.text;
  }
  const base::Budget rest = budget.without(frames.text.capacity());
  lines::LineReader reader(text);
  const auto first = reader.next();
  const std::string_view begin = first ? first->text : std::string_view();
  const lines::Header header = lines::readHeader(begin, kRecordingName);
  if (first && !first->whole &&
      (header.known || kRecordingName.substr(0, begin.size()) == begin ||
       (begin.substr(0, kRecordingName.size()) == kRecordingName &&
        begin.size() == kRecordingName.size() + 1 && begin.back() == ' '))) {
    return base::fail(TraceError::Damaged,
                      "The recording was cut off in its first line: it holds nothing of the run.");
  }
  if (!header.known) {
    return base::fail(
        TraceError::NotATrace,
        fmt::format("This is not a recording of a run: its first line does not begin with \"{}\".",
                    kRecordingName));
  }
  if (header.version > kRecordingVersion) {
    return base::fail(TraceError::NewerVersion,
                      fmt::format("The recording has format {}; this Rivulet reads formats up to "
                                  "{}. Use a newer Rivulet.",
                                  header.version, kRecordingVersion));
  }
  Reader recording;
  // A cut that left part of a line is counted with the lines.
  const bool isCutBetweenLines = frames.isCut && (text.empty() || text.back() == '\n');
  std::size_t unreadable = frames.damaged + static_cast<std::size_t>(isCutBetweenLines);
  std::size_t read = 0;
  while (const auto line = reader.next()) {
    if (!line->whole || (!line->text.empty() && !recording.read(line->text))) {
      ++unreadable;
    }
    read += line->text.size();  // notes and names are at most this
    if (line->number % kLinesUnasked == 0 && recording.memoryBytes() + read > rest.left()) {
      return base::fail(budget.exceeded("The recording"));
    }
  }
  return std::move(recording).take(unreadable);
}

}  // namespace rivulet::trace
