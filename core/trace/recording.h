// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The recording of one run: what was requested, sent and seen, and the result. It is the interface
/// between streaming and everything that looks at a run afterwards. Format: docs/formats.md.
/// @threadsafety plain values; one writer, one thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/continuation.h"
#include "base/instant.h"
#include "base/result.h"
#include "base/vec3.h"
#include "gcode/trajectory.h"
#include "trace/control_trace.h"
#include "trace/pause.h"

namespace rivulet::trace {

/// Settings of the run.
struct RunStart {
  std::string toolVersion;
  std::string method;  ///< `base::methodName`
  int pointsPerLoop = 0;
  std::string layout;
  double deltaMm = 0.0;
  double feedMmPerS = 0.0;  ///< of all moves; with `feedOverride` the largest one
  std::string programName;
  std::string programHash;
  std::string endpoint;      ///< of the OPC UA server, or "simulated <preset> <seed>"
  std::string startedAtUtc;  ///< ISO 8601, given by the caller (core reads no clock); may be empty
  std::string axes{};        ///< letters of the axes that were streamed, "XYZAC"; empty: XYZ
  int runNumber = 0;         ///< by which the control knows the run; 0: none
  std::string user{};        ///< who started it; may be empty
  std::string computer{};    ///< where; may be empty
  /// Of the program on the control, ascending. Between all other motion blocks of it the axes stop
  /// for a STOPRE. Empty: not known.
  std::vector<base::Continuation> continuations{};
  double feedOverride = 0.0;  ///< factor on the feeds of the program; 0: one feed for all moves
};

/// One live observation. Values that were not read stay empty.
struct LiveSample {
  base::Instant at{};
  std::optional<base::Vec3> positionMm;
  std::optional<double> feedMmPerS;
  /// Angles of the rotary axes of the run, together with `positionMm`.
  std::optional<base::RotaryDeg> rotaryDeg{};
};

/// One request to the control.
struct Access {
  base::Instant sent{};
  base::Duration took{};
  bool write = false;
  int nodes = 0;
};

/// A change of state, a fault, a line of the log.
struct Note {
  base::Instant at{};
  std::string text;
};

struct RunEnd {
  std::string outcome;  ///< "completed", "stopped", "failed"
  std::size_t sent = 0;
  std::size_t accepted = 0;
  std::size_t executed = 0;
  std::size_t total = 0;
  base::Duration duration{};  ///< first motion to end of program
  std::string errorText;      ///< why, for "failed"
};

struct Recording {
  RunStart start;
  gcode::PointList points;
  std::vector<LiveSample> samples;
  std::vector<Access> accesses;
  std::vector<Pause> pauses;
  std::vector<Note> notes;
  std::optional<ControlTrace> controlTrace;
  std::optional<RunEnd> end;

  bool complete = false;  ///< an end record was found: the writer was not interrupted
  /// False if points are missing or could not be read. Then the list must not be used to judge a
  /// run, because the indices of the points would be wrong.
  bool pointsComplete = false;
  std::size_t unreadableLines = 0;  ///< left out; a last line that was cut off counts too
};

/// Takes text that ends with a whole line. @return false if it could not be stored
using RecordingSink = std::function<bool(std::string_view)>;

/// Writes a recording during the run. Every call passes whole lines to the sink, so that a file
/// that is cut off anywhere can be read up to its last whole line. After the sink has refused once,
/// it gets nothing more: a recording has no holes.
class RecordingWriter {
 public:
  /// @param sink  not empty; called on the thread that calls the functions below
  explicit RecordingWriter(RecordingSink sink);

  /// Header and settings; first, and once.
  bool start(const RunStart& start);
  bool points(const gcode::PointList& points);
  bool sample(const LiveSample& sample);
  bool access(const Access& access);
  bool pause(const Pause& pause);
  bool note(const Note& note);
  bool controlTrace(const ControlTrace& trace);
  /// The same in pieces, between the other records. Without `controlTraceEnd`, whoever reads the
  /// recording knows that a part is missing.
  bool controlTraceBegin(const ControlTrace& head);
  bool controlTracePiece(const ControlTrace& piece);
  bool controlTraceEnd();
  /// The last record.
  bool end(const RunEnd& end);

  /// False once the sink has refused: the recording ends there.
  [[nodiscard]] bool ok() const { return m_ok; }

 private:
  bool flush();
  /// Passes the buffered text on once it is large enough.
  bool flushIfLarge();

  RecordingSink m_sink;
  base::RotarySet m_rotaryAxes{};  ///< of the run
  std::string m_lines;
  std::size_t m_traceSamples = 0;
  std::size_t m_traceBlocks = 0;
  std::size_t m_traceEvents = 0;
  bool m_ok = true;
};

/// The same text as that of a writer, record by record. Without `end` the recording stays open.
[[nodiscard]] std::string printRecording(const Recording& recording);

/// Reads as much as possible: unreadable lines and frames are left out and counted.
/// @param bytes   the text, or a file of frames (`trace/frames`)
/// @param budget  without the bytes
/// @return error NotATrace, NewerVersion; Damaged if not even the first line is whole;
/// BudgetError::Exceeded, also if only its analysis would take more
[[nodiscard]] base::Result<Recording> parseRecording(std::string_view bytes,
                                                     const base::Budget& budget = {});

}  // namespace rivulet::trace
