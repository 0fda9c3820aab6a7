// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The settings of a run, its state while it is in progress, and its result.
/// @threadsafety plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "base/method_kind.h"
#include "base/result.h"
#include "base/vec3.h"
#include "gcode/feeds.h"
#include "gcode/program.h"
#include "live/feed_factor.h"
#include "live/summary.h"
#include "opcua/link.h"
#include "streaming/control/access_forms.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/run/equipment_watch.h"
#include "streaming/run/feed_order.h"
#include "streaming/start/program_transfer.h"
#include "templates/cells.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/statistics.h"
#include "trace/control_trace.h"
#include "trace/pause.h"
#include "trace/recording.h"

namespace rivulet::streaming {

struct Calibration;

enum class StreamError {
  ProgramNotStreamable = 1,  ///< findings of severity error, or fewer than one point
  WrongProgram,              ///< the control does not run the expected template
  ChannelBusy,               ///< another program runs on the control
  NotStarted,                ///< cycle start was not pressed in time
  StreamStalled,             ///< the control runs, but the method got no sign of progress
  StopNotConfirmed,          ///< stop was written, the control did not confirm it in time
  ControlAlarm,              ///< the control ended the program with an alarm
  EndedEarly,                ///< the program on the control ended before all of it was executed
  OtherClient,               ///< another client has the cells (method window)
  Restarted,                 ///< the program was restarted during a run (method window)
  WindowDamaged,             ///< the control rejected a window that did not match its check number
  ClientSilent,              ///< the control stopped waiting for the client (method window)
  CannotResume,              ///< it is not known for certain where the run was left
  TransferRefused,           ///< no right to write part programs through the server
  Cancelled,                 ///< by whoever waits for it
  NotCommissioned,           ///< method credit on a control that has not passed its test
  AxesNotChosen,             ///< the program moves axes that are not among those to be streamed
  AxisMissing,               ///< the control has no such axis
  OverlayLeft,               ///< an overlay is already active on the axes (online correction)
  OverlayIntegrates,         ///< the control adds up overlaid values (online correction)
  ProgramChanged,            ///< the points differ from those of the run to be resumed
  Claimed,                   ///< another client has claimed the cells and is about to start
  FeedUnknown,               ///< a move of the program has no known feed
  OneFeedOnly,               ///< the method has one feed for all moves
  BadOverride,               ///< out of range
  CutOnTheWay,               ///< the first move would pass within what the program cuts
  FeedCellIgnored,           ///< the control does not obey the feed cell
  BadAirMove,                ///< the test of the feed cell cannot be made with this move
  BadTestBlock,              ///< the test of whole jobs cannot be made with this block
};

[[nodiscard]] std::error_code make_error_code(StreamError code);

/// The states an operator sees.
enum class RunState { Idle, Armed, Running, Stopping, Done, Aborted, Holding, Stopped };

/// Six digits: a checkpoint, the claim of the cells and the control know a run by its number.
inline constexpr int kRunNumberMax = 999'999;

/// The number of a run: 1 to 999 983.
[[nodiscard]] int runNumberFrom(std::uint64_t entropy);

/// "A program is running on the control …"
[[nodiscard]] base::Error channelBusy();

/// "idle", "armed", ...
[[nodiscard]] std::string_view runStateName(RunState state);

/// Where a run is resumed. The list of points depends on the tool's position before the first run;
/// it must be the same list.
struct Resume {
  std::size_t point = 0;  ///< the first to be streamed, counted in that list
  base::Vec3 startMm;     ///< the tool's position before the first run
  base::RotaryDeg startDeg{};
  /// First point, not before `point`, at which the program differs from that of the interrupted
  /// run; nothing: no difference. The operator must have confirmed it.
  std::optional<std::size_t> changedFrom{};
  /// The program of the run still stands on the control: the length of the path that it executes,
  /// at most, before it has ended and the run goes on. Nothing: it has ended.
  std::optional<double> restMm{};
};

/// Who started a run.
struct RunOrigin {
  std::string user;
  std::string computer;
  std::string startedAtUtc;  ///< ISO 8601

  friend bool operator==(const RunOrigin&, const RunOrigin&) = default;
};

/// What is needed to resume a run of method window or credit (`resumeFrom`).
struct Checkpoint {
  int runNumber = 0;           ///< the number that the control was asked to obey
  std::size_t firstPoint = 0;  ///< of the first window, counted in the whole program
  base::Vec3 startMm;          ///< where the tool stood before the first run
  bool granted = false;        ///< the control is known to have obeyed this run
  bool pausesPlaced = true;    ///< its windows were cut by `placePauses`, else evenly
  base::RotaryDeg startDeg{};
  /// See `WindowCut`; 0: any.
  double windowSMax = 0.0;
  double windowFeedMmPerS = 0.0;
  std::size_t pointCount = 0;    ///< of the whole program
  std::uint64_t pointsHash = 0;  ///< `hashOfPoints` of them; 0: not known
};

/// What method position watches to see that a point has been passed.
enum class PassedBy {
  Position,      ///< the tool's position, compared with the point
  DistanceToGo,  ///< the distance to the end of the block, as Algorithm II of [P1] has it
};

/// "position", "distance-to-go".
[[nodiscard]] std::string_view passedByName(PassedBy passedBy);
/// Inverse of `passedByName`; nothing for an unknown name.
[[nodiscard]] std::optional<PassedBy> passedByFromName(std::string_view name);

/// How the form of access of a run is chosen.
enum class AccessChoice {
  Fixed,  ///< `RunSettings::grouping` as set, not tested
  Best,   ///< the best that is proved on the control before anything moves
  Array,  ///< the best array form, or the run does not start
};

/// Deadline of a request while the machine does not need it: a network that stalls ends nothing
/// before the link itself takes it for lost.
inline constexpr base::Duration kSetupDeadline = std::chrono::seconds{12};

struct RunSettings {
  templates::TemplateParameters parameters;  ///< method, N, layout, axes
  double deltaMm = 0.3;                      ///< δ, > 0
  PassedBy passedBy = PassedBy::Position;    ///< method position only
  /// > 0. Of all moves; with `programFeeds` the largest one, to which verdict and scales refer.
  double feedMmPerS = 10.0;
  /// Each move has the feed of its own block; nothing: all have the same. Not for the methods of
  /// [P1]. See `planFeeds`.
  std::optional<gcode::ProgramFeeds> programFeeds;
  /// Within it, fewer points are streamed than the program has, see `moveRules`; mm, and degrees of
  /// rotary axes. 0: all.
  double tolerance = 0.0;
  opcua::Grouping grouping = opcua::Grouping::List;
  /// If it is not Fixed, the forms are tested on the cells of the first window (or on the slots,
  /// which must be contiguous) before the program on the control is started, and `grouping` is set
  /// to the result.
  AccessChoice access = AccessChoice::Fixed;
  base::Duration requestDeadline = std::chrono::seconds{2};     ///< while the machine moves
  base::Duration setupDeadline = kSetupDeadline;                ///< before and after
  base::Duration startDeadline = std::chrono::minutes{5};       ///< for cycle start at the control
  base::Duration stopDeadline = std::chrono::seconds{30};       ///< for the confirmation of a stop
  base::Duration stallDeadline = std::chrono::seconds{20};      ///< without a sign of progress
  base::Duration accessTime = std::chrono::microseconds{4300};  ///< estimate, for slack
  /// The measured cost of access to this control with this version of its server; null: not
  /// measured. Replaces `accessTime`, and the 99th percentile of the live margin as long as the run
  /// has too few accesses of its own.
  std::shared_ptr<const Calibration> calibration;
  base::Duration nominalPause = std::chrono::milliseconds{40};  ///< of an inferred pause
  /// Method credit: this control has passed the commissioning test. Without it nothing starts.
  bool isCommissioned = false;
  /// Methods window and credit: identifies this run for the control, 1 to `kRunNumberMax`; 0:
  /// derived from the time and the program.
  int runNumber = 0;
  std::optional<Resume> resume;  ///< nothing: from the beginning
  TransferWay transfer = TransferWay::Link;
  /// Multiplies the override, within the bounds of `parameters`.
  live::FactorSource factor{};
  /// Methods with windows, where a stop acts before the next window: no window of several moves
  /// takes longer, s, at 100 %; 0: any. Method credit: all that may be executed after a stop.
  double windowSMax = 0.0;
  /// Method window: end windows where the path stops or turns. Method credit has no pauses there.
  bool placePauses = true;
  /// The tool has been seen to be lifted by so much on this control, mm: a program that may lift it
  /// further does not start.
  double liftMmMax = 0.0;
  bool monitor = true;  ///< read position and feed for the display when the stream has slack
  /// Stored on the control next to the program (`storeRunLabel`) and in the recording. Without a
  /// user, nothing is stored on the control, and the cells are not claimed (`CellClaim`).
  RunOrigin origin{};
};

/// As many are still executed after a stop that only the run cell tells.
[[nodiscard]] int windowsAfterStop(const templates::TemplateParameters& parameters);

/// How a run is cut into windows by its client.
[[nodiscard]] WindowCut windowCut(const RunSettings& settings);

struct Counters {
  std::size_t sent = 0;      ///< points written to the control
  std::size_t accepted = 0;  ///< points whose write the control confirmed
  std::size_t executed = 0;  ///< points the method knows to be passed
  std::size_t total = 0;     ///< points of the program
};

/// The cost of the accesses of a run. "Per node" is the access time of [P1]: the duration of a
/// request divided by the number of its variables.
struct AccessStatistics {
  std::size_t requests = 0;
  std::size_t nodes = 0;
  trace::DurationStatistics perNode;
  trace::DurationStatistics perRequest;
};

/// Online correction, X Y Z. Axes without one are 0.
struct Correction {
  base::Vec3 askedMm;      ///< the requested value, within the limit
  base::Vec3 confirmedMm;  ///< the value that the control has confirmed in its cells

  friend bool operator==(const Correction&, const Correction&) = default;
};

/// Wrong motion that showed while the run was in progress.
struct WrongMotion {
  enum class Kind {
    Repeated,  ///< by its signals, the control has executed points again
    OffPath,   ///< the tool is not where the points that it may execute lead
  };
  Kind kind = Kind::OffPath;
  std::size_t point = 0;  ///< points of this run that were known to be executed
  double offMm = 0.0;     ///< OffPath: distance of the tool to the path

  friend bool operator==(const WrongMotion&, const WrongMotion&) = default;
};

/// "after point 12 the tool is 3.412 mm off the path".
[[nodiscard]] std::string describe(const WrongMotion& wrong);

/// A snapshot of the run, for the display.
struct LiveUpdate {
  RunState state = RunState::Idle;
  base::Instant at{};
  Counters counters;
  std::optional<trace::LiveSample> sample;
  std::optional<EquipmentSeen> equipment;  ///< just read
  std::optional<trace::Pause> pause;       ///< a newly detected pause
  std::optional<base::Duration> margin;    ///< time until the next point is needed minus p99
  std::string waitingFor;  ///< English key of what the run is waiting for; may be empty
  std::optional<base::Duration> stopConfirmedAfter;
  std::optional<Correction> correction;  ///< nothing: the program has none
  std::optional<WrongMotion> wrong;      ///< the first that was seen; nothing: none so far
  std::optional<FeedSeen> feed;          ///< nothing: the program has no feed cell
  std::optional<live::Level> source;     ///< nothing: all points were there before the start
};

enum class Outcome { Completed, Stopped, Failed };

/// The state of a run that has ended so.
[[nodiscard]] RunState endState(Outcome outcome);

/// "completed", "stopped", "failed".
[[nodiscard]] std::string_view outcomeName(Outcome outcome);

/// What is known of the motion of a run.
enum class RunFinding {
  Faultless,  ///< judged by the control's trace: each point once, in order
  /// The control keeps no trace, a part of it was lost before it was fetched, or the connection was
  /// lost during the run; no wrong motion was seen.
  NotJudged,
  /// The trace shows points repeated, skipped or foreign, or that some are missing; without a
  /// trace: wrong motion was seen during the run.
  Faulty,
};

/// "faultless", "not judged", "faulty".
[[nodiscard]] std::string_view runFindingName(RunFinding finding);

struct RunReport {
  Outcome outcome = Outcome::Failed;
  base::Error error;  ///< why, for Failed; code clear otherwise
  Counters counters;
  trace::Integrity integrity;
  std::vector<trace::Pause> pauses;
  base::Duration duration{};  ///< first motion to end of program
  AccessStatistics access;
  std::optional<base::Duration> stopConfirmedAfter;
  /// Method window, from the moment the control was changed for it. `counters` and `integrity` of a
  /// run that was resumed speak of the points from `firstPoint` on.
  std::optional<Checkpoint> checkpoint;
  std::string programName;
  std::optional<gcode::MergedMoves> merged;  ///< of the program; nothing: its points as they are
  RunSettings settings;                      ///< with the grouping that was used
  std::optional<AccessForms> accessForms;    ///< the forms that were tried; nothing if none were
  std::optional<ProgramTransfer> transfer;
  /// The beginning of the trace, as much as RunTrace keeps; null if there was none. What is judged
  /// is the whole trace.
  std::shared_ptr<const trace::ControlTrace> controlTrace;
  std::string slowedBy;  ///< what slowed the accesses of the run; in English; empty: nothing did
  /// Seen while the run was in progress. The trace of the control, if there is one, overrules it.
  std::optional<WrongMotion> wrong;
  std::optional<live::Summary> live;   ///< nothing: all points were there before the start
  std::vector<FeedEvent> feed;         ///< what was ordered by the feed cell
  std::optional<FactorReport> factor;  ///< nothing: the program has no factor of the override
  std::vector<trace::Pause> holds;     ///< standstills of `pauses` that an order made; not in these
  /// Stopped: the axes are held where they are, and the program ends before its next window when
  /// somebody lets it (`endRun`), or with a reset.
  bool leftHeld = false;

  /// A stopped run is judged by the points up to the stop.
  [[nodiscard]] RunFinding finding() const;
  [[nodiscard]] bool isFaultless() const { return finding() == RunFinding::Faultless; }
};

}  // namespace rivulet::streaming

template <>
struct std::is_error_code_enum<rivulet::streaming::StreamError> : std::true_type {};
