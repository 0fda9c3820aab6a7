// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The signals of one trace, ready to be drawn: those that were recorded, packed, and what can be
/// calculated from them on request. Everything counts from the first sample. @threadsafety plain
/// values; several threads may read.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/envelope.h"
#include "trace/formula.h"
#include "trace/pause.h"
#include "trace/remark.h"
#include "trace/signals.h"

namespace rivulet::trace {

/// What a signal says, for the headings of a list.
enum class SignalGroup {
  SetPoint,
  Actual,
  Lag,  ///< set point minus actual position
  Speed,
  Acceleration,
  Jerk,
  ContourError,
  Program,  ///< line, programmed feed, override
  Client,   ///< what the requests took
  Column,   ///< of a file of another tool, as it is
};

/// A recorded signal.
struct Channel {
  std::string name;  ///< by which formulas know it
  std::string unit;
  std::shared_ptr<const Envelope> samples;  ///< never null
};

/// A signal that can be shown.
struct SignalOffer {
  SignalGroup group = SignalGroup::Column;
  std::string label;    ///< "X"; empty: that of the group says all
  std::string formula;  ///< `Formula`
  std::string unit;
};

/// Seconds since the first sample, as formulas know them.
inline constexpr std::string_view kTimeSignal = "time";

class SignalSet {
 public:
  void add(Channel channel) { m_channels.push_back(std::move(channel)); }
  /// Null: there is none of that name.
  [[nodiscard]] const Channel* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Channel>& channels() const { return m_channels; }

  /// In the order of the groups.
  [[nodiscard]] std::vector<SignalOffer> offers() const;
  /// The samples are those of the first signal in the formula; others are interpolated there.
  /// `kTimeSignal` has those of the first channel.
  /// O(samples). @return error UnknownSignal; as `Formula::parse`
  [[nodiscard]] base::Result<std::shared_ptr<const Envelope>> calculate(
      std::string_view formula) const;

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  std::vector<Channel> m_channels;
};

/// A trace as the window shows it; immutable once it is made.
struct ShownTrace {
  std::string name;  ///< of the file, or of the run
  SignalSet signalSet;
  base::Duration length{};
  base::Duration step{};          ///< median time between two samples of the position
  std::vector<Standstill> stops;  ///< with their causes
  /// Stops with what shows their causes, pauses, notes of the recording or of the file, in time
  /// order.
  std::vector<SignalEvent> events;
  std::shared_ptr<const ProgramPath> programPath;  ///< null: not compared with a program
  std::string programHash;  ///< of the program that was run, as recorded; empty: not known
  /// Nothing but what the client read during the run; then `pauses` are those it noticed.
  bool isObserved = false;
  std::vector<Pause> pauses;
  std::vector<Remark> remarks;
  /// Of a file of another tool; without columns if it is no table.
  TablePreview table;
  std::string tableLayout;  ///< by which its mapping is remembered
  bool isAnalysed = false;  ///< stops, and contour error if there is a program
};

/// Not analysed.
[[nodiscard]] ShownTrace makeShownTrace(const Motion& motion);
[[nodiscard]] ShownTrace makeShownTrace(const Trace& trace);
[[nodiscard]] ShownTrace makeShownTrace(const Trace& trace, const TraceAnalysis& analysis);

/// Figures of the values between two instants, both included.
struct SampleStatistics {
  std::size_t count = 0;  ///< values; gaps do not count. 0: all others are 0
  double min = 0.0;
  double max = 0.0;
  double mean = 0.0;
  double rms = 0.0;
  double p50 = 0.0;  ///< nearest rank
  double p95 = 0.0;
  double p99 = 0.0;
};
/// O(values between). Beyond a million values, percentiles are those of every second, fourth, ...
[[nodiscard]] SampleStatistics sampleStatistics(const Envelope& samples, base::Instant from,
                                                base::Instant to);

/// Linear between the neighbours; NaN outside and beside gaps.
[[nodiscard]] double valueAt(const Envelope& samples, base::Instant at);
/// That of the last sample until then, for signals that change in steps, such as a line. NaN: there
/// is none, or it is a gap.
[[nodiscard]] double heldValueAt(const Envelope& samples, base::Instant at);

/// From the first sample with a value to the next one with another value.
struct ValueSpan {
  base::Instant from{};
  base::Instant to{};
};
/// When a signal that changes in steps had this very value, in time order. O(samples).
[[nodiscard]] std::vector<ValueSpan> spansOf(const Envelope& samples, double value);

}  // namespace rivulet::trace
