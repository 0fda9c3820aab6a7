// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/control_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "trace/lines.h"

namespace rivulet::trace {
namespace {

constexpr std::string_view kName = "rivulet-control-trace";
constexpr int kVersion = 3;
/// Rotary axes came with format 2, events with format 3.
constexpr int kVersionWithoutEvents = 2;
constexpr int kVersionWithoutRotary = 1;
/// Approximate length of a sample's line: one reservation instead of many reallocations.
constexpr std::size_t kSampleBytes = 120;
constexpr std::size_t kBlockBytes = 90;

tl::unexpected<base::Error> damaged(std::size_t line, std::string_view what) {
  return base::fail(
      TraceError::Damaged,
      fmt::format("The control's trace is damaged in line {}: {}. Fetch it again.", line, what));
}

/// The content of the last line.
struct EndLine {
  std::size_t samples = 0;
  std::size_t blocks = 0;
  std::size_t events = 0;
  bool truncated = false;
};

std::optional<EndLine> readEnd(lines::Fields fields) {
  EndLine end;
  while (fields.ok() && !fields.atEnd()) {
    const std::string_view key = fields.key();
    if (key == "samples") {
      end.samples = fields.integer<std::size_t>();
    } else if (key == "blocks") {
      end.blocks = fields.integer<std::size_t>();
    } else if (key == "events") {
      end.events = fields.integer<std::size_t>();
    } else if (key == "truncated") {
      end.truncated = fields.integer<int>() != 0;
    } else {
      fields.skipValue();
    }
  }
  return fields.ok() ? std::optional(end) : std::nullopt;
}

/// @return whether the header line could be read
bool readHead(std::string_view rest, ControlTrace& trace) {
  lines::Fields head(rest);
  while (head.ok() && !head.atEnd()) {
    const std::string_view key = head.key();
    if (key == "cycle_ns") {
      trace.cycle = head.duration();
    } else if (key == "rotary") {
      trace.rotaryAxes = lines::readRotaryNames(head);
    } else {
      head.skipValue();
    }
  }
  return head.ok() && trace.cycle >= base::Duration::zero();
}

/// One line after the header. @param ended  set by the end line @return why it cannot be read
std::string readLine(std::string_view text, ControlTrace& trace, bool& ended) {
  lines::Fields fields(text);
  const std::string_view keyword = fields.word();
  if (keyword == "s") {
    const auto sample = lines::readSample(fields, trace.rotaryAxes);
    if (!sample) {
      return "the sample cannot be read";
    }
    trace.samples.push_back(*sample);
    return {};
  }
  if (keyword == "b") {
    const auto block = lines::readBlock(fields, trace.rotaryAxes);
    if (!block) {
      return "the block cannot be read";
    }
    trace.blocks.push_back(*block);
    return {};
  }
  if (keyword == "e") {
    std::optional<ControlEvent> event = lines::readEvent(fields);
    if (!event) {
      return "the event cannot be read";
    }
    trace.events.push_back(std::move(*event));
    return {};
  }
  if (keyword != "end") {
    return "the line has an unknown keyword";
  }
  const auto end = readEnd(fields);
  if (!end) {
    return "the end line cannot be read";
  }
  if (end->samples != trace.samples.size() || end->blocks != trace.blocks.size()) {
    return fmt::format("{} samples and {} blocks were written, but the file has {} and {}",
                       end->samples, end->blocks, trace.samples.size(), trace.blocks.size());
  }
  if (end->events != trace.events.size()) {
    return fmt::format("{} events were written, but the file has {}", end->events,
                       trace.events.size());
  }
  trace.truncated = end->truncated;
  ended = true;
  return {};
}

}  // namespace

std::error_code make_error_code(TraceError code) {
  static const base::NamedCategory category("trace");
  return {static_cast<int>(code), category};
}

std::string printControlTrace(const ControlTrace& trace) {
  std::string out;
  out.reserve(trace.samples.size() * kSampleBytes + trace.blocks.size() * kBlockBytes + 100);
  const bool hasRotary = base::any(trace.rotaryAxes);
  const int version = !trace.events.empty() ? kVersion
                      : hasRotary           ? kVersionWithoutEvents
                                            : kVersionWithoutRotary;
  fmt::format_to(std::back_inserter(out), "{} {} cycle_ns={}{}{}\n", kName, version,
                 trace.cycle.count(), hasRotary ? " rotary=" : "",
                 base::rotaryNames(trace.rotaryAxes));
  for (const ControlSample& sample : trace.samples) {
    lines::appendSample(out, sample, trace.rotaryAxes);
  }
  for (const ExecutedBlock& block : trace.blocks) {
    lines::appendBlock(out, block, trace.rotaryAxes);
  }
  for (const ControlEvent& event : trace.events) {
    lines::appendEvent(out, event);
  }
  fmt::format_to(std::back_inserter(out), "end samples={} blocks={}{} truncated={}\n",
                 trace.samples.size(), trace.blocks.size(),
                 trace.events.empty() ? "" : fmt::format(" events={}", trace.events.size()),
                 trace.truncated ? 1 : 0);
  return out;
}

std::size_t memoryBytes(const ControlTrace& trace) {
  const auto bytesOf = [](const auto& list) { return base::Budget::bytesOf(list, kLinesUnasked); };
  return bytesOf(trace.samples) + trace.samples.size() * kAnalysedSampleBytes +
         bytesOf(trace.blocks) + bytesOf(trace.events);
}

base::Result<ControlTrace> parseControlTrace(std::string_view text, const base::Budget& budget) {
  lines::LineReader reader(text);
  const auto first = reader.next();
  const lines::Header header = first ? lines::readHeader(first->text, kName) : lines::Header{};
  if (!header.known) {
    return base::fail(TraceError::NotATrace,
                      fmt::format("This is not a trace of the control: its first line does not "
                                  "begin with \"{}\".",
                                  kName));
  }
  if (header.version > kVersion) {
    return base::fail(TraceError::NewerVersion,
                      fmt::format("The control's trace has format {}; this Rivulet reads formats "
                                  "up to {}. Use a newer Rivulet.",
                                  header.version, kVersion));
  }
  ControlTrace trace;
  if (!first->whole || !readHead(header.rest, trace)) {
    return damaged(1, "the header cannot be read");
  }
  trace.samples.reserve(
      std::min(text.size() / (2 * kSampleBytes), budget.items(sizeof(ControlSample))));

  std::size_t lastLine = 1;
  std::size_t read = 0;
  bool ended = false;
  while (const auto line = reader.next()) {
    lastLine = line->number;
    read += line->text.size();  // names are at most this
    if (lastLine % kLinesUnasked == 0 && memoryBytes(trace) + read > budget.left()) {
      return base::fail(budget.exceeded("The trace of the control"));
    }
    if (!line->whole) {
      return damaged(line->number, "the file was cut off here");
    }
    if (line->text.empty()) {
      continue;
    }
    if (ended) {
      return damaged(line->number, "there is text after the end line");
    }
    if (const std::string why = readLine(line->text, trace, ended); !why.empty()) {
      return damaged(line->number, why);
    }
  }
  if (!ended) {
    return damaged(lastLine, "the end line is missing: the file was cut off");
  }
  return trace;
}

}  // namespace rivulet::trace
