// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/trace.h"

#include <algorithm>

#include "trace/analysis/trace_analysis.h"
#include "trace/import/compression.h"

namespace rivulet::trace {

namespace {

constexpr std::string_view kRecording = "rivulet-recording";
constexpr std::string_view kControlTrace = "rivulet-control-trace";

struct Span {
  base::Instant from;
  base::Instant until;

  template <class List, class InstantOf>
  void keepIn(List& list, InstantOf instantOf) const {
    std::erase_if(list,
                  [&](const auto& one) { return instantOf(one) < from || instantOf(one) > until; });
  }
};

constexpr auto kAt = [](const auto& one) { return one.at; };

void cutTo(const Span& span, ControlTrace& trace) {
  span.keepIn(trace.samples, kAt);
  span.keepIn(trace.blocks, [](const auto& block) { return block.from; });
  span.keepIn(trace.events, [](const auto& event) { return event.from; });
  trace.truncated = true;
}

void cutTo(const Span& span, Recording& recording) {
  span.keepIn(recording.samples, kAt);
  span.keepIn(recording.notes, kAt);
  span.keepIn(recording.accesses, [](const auto& access) { return access.sent; });
  span.keepIn(recording.pauses, [](const auto& pause) { return pause.start; });
  if (recording.controlTrace) {
    cutTo(span, *recording.controlTrace);
  }
}

void cutTo(const Span& span, ImportedTrace& imported) {
  SignalTrace& file = imported.trace;
  for (std::size_t base = 0; base < file.timeBases.size(); ++base) {
    PackedTimes& times = file.timeBases[base].at;
    const auto first = std::lower_bound(times.begin(), times.end(), span.from) - times.begin();
    const auto last = std::upper_bound(times.begin(), times.end(), span.until) - times.begin();
    const auto cutList = [&](auto& list) {
      list = list.part(static_cast<std::size_t>(first),
                       static_cast<std::size_t>(std::max(first, last)));
    };
    cutList(times);
    for (Signal& signal : file.signalList) {
      if (signal.timeBase == base) {
        cutList(signal.values);
      }
    }
  }
}

template <class T>
base::Result<Trace> traceOf(base::Result<T> parsed) {
  if (!parsed) {
    return base::fail(parsed.error());
  }
  return Trace(std::move(*parsed));
}

}  // namespace

const ControlTrace* Trace::control() const {
  if (const Recording* of = recording()) {
    return of->controlTrace ? &*of->controlTrace : nullptr;
  }
  return get<ControlTrace>();
}

Trace Trace::cut(double fromS, double untilS) const {
  const Motion motion = motionOf(*this);
  const base::Instant origin = motion.samples.empty() ? base::Instant{} : motion.samples.front().at;
  const Span span{origin + base::fromSeconds(fromS), origin + base::fromSeconds(untilS)};
  return std::visit(
      [&span](const auto& whole) {
        auto part = *whole;
        cutTo(span, part);
        return Trace(std::move(part));
      },
      m_of);
}

base::Result<Trace> parseTrace(std::string_view bytes, const TableMapping& mapping,
                               const base::Budget& budget, base::Executor* executor) {
  // Recordings are compressed in frames, but for those of earlier versions.
  if (isCompressed(bytes) ? unpackFirst(bytes, kRecording.size()) == kRecording
                          : bytes.starts_with(kRecording)) {
    return traceOf(parseRecording(bytes, budget));
  }
  if (bytes.starts_with(kControlTrace)) {
    return traceOf(parseControlTrace(bytes, budget));
  }
  return traceOf(importTrace(bytes, mapping, budget, executor));
}

base::Result<std::optional<Trace>> readLargeTrace(base::ByteSource& bytes,
                                                  const TableMapping& mapping,
                                                  const base::Budget& budget,
                                                  base::Executor* executor) {
  const auto head = bytes.read(0, kControlTrace.size());
  if (!head) {
    return base::fail(head.error());
  }
  if (head->starts_with(kRecording) || head->starts_with(kControlTrace)) {
    return std::nullopt;
  }
  auto imported = importLargeTable(bytes, mapping, budget, executor);
  if (!imported) {
    return base::fail(imported.error());
  }
  return *imported ? std::optional(Trace(std::move(**imported))) : std::nullopt;
}

}  // namespace rivulet::trace
