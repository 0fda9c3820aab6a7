// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The only loop that performs a method's accesses on a link. It adds what a method does not know:
/// the operator's stop, the online correction, reads for the display when the stream has slack, and
/// the end of the program on the control. The same driver is used for real and simulated runs.
/// @threadsafety runs on the thread that calls `run`; the sink is called on that thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "streaming/methods/method.h"
#include "streaming/run/access_times.h"
#include "streaming/run/correction.h"
#include "streaming/run/feed_control.h"
#include "streaming/run/monitor_reads.h"
#include "streaming/run/path_watch.h"
#include "streaming/run/pause_log.h"
#include "streaming/run/run_trace.h"
#include "trace/analysis/pauses.h"
#include "trace/recording.h"

namespace rivulet::streaming {

/// Notes that repeat what the operator has requested: a display that has said so leaves them out.
inline constexpr std::string_view kStopNote = "stop requested";
inline constexpr std::string_view kHoldNote = "hold requested";
/// A request was refused, or not answered, and is made again.
inline constexpr std::string_view kRefusedNote = "refused: asked again";
inline constexpr std::string_view kLostNote = "no answer in time: asked again";
inline constexpr std::string_view kContinueNote = "continue requested";

/// A program that waits for its client ends within this time after it has been told to.
inline constexpr base::Duration kEndsAtOnce = std::chrono::milliseconds{300};

/// Receives the reports of a run in progress. @threadsafety called on the streaming thread only
class RunSink {
 public:
  virtual ~RunSink() = default;
  virtual void update(const LiveUpdate& update) = 0;
  virtual void access(const trace::Access& access) = 0;
  virtual void note(const trace::Note& note) = 0;
  /// Methods with windows: the control obeys the run from now on. No window has been delivered yet,
  /// and none is before this returns.
  virtual void granted() {}
};

/// Source of the operator's requests to a run. @threadsafety asked on the streaming thread only
class RunOrders {
 public:
  virtual ~RunOrders() = default;
  /// True from the moment the operator wants the run to stop. @param now the link's time
  [[nodiscard]] virtual bool stopRequested(base::Instant now) = 0;
  /// True while the machine is to wait before its next window (methods with windows).
  [[nodiscard]] virtual bool holdRequested(base::Instant /*now*/) { return false; }
  /// What the feed cell is to say, if the program has one: it acts at once. By default the axes
  /// stand while the machine is to wait.
  [[nodiscard]] virtual FeedOrder feed(base::Instant now) { return {holdRequested(now)}; }
  /// After a stop: somebody lets the program go on to its end, before its next window. Until then
  /// the stop holds the axes, at once. By default nobody is there to be asked.
  [[nodiscard]] virtual bool letsEnd(base::Instant /*now*/) { return true; }
  /// Nobody will order anything more: a run that is held at a stop ends here when its axes stand,
  /// and leaves its program held.
  [[nodiscard]] virtual bool leaves(base::Instant /*now*/) { return false; }
  /// Online correction requested now, mm, X Y Z. It is clamped to the limit of the template; a
  /// value that is not a number leaves the axis unchanged. Called only if the template has a
  /// correction.
  [[nodiscard]] virtual base::Vec3 correctionMm(base::Instant /*now*/) { return {}; }
};

/// What the feed cell is to say: whatever stops a run holds its axes first.
[[nodiscard]] FeedOrder feedOrdered(RunOrders& orders, base::Instant now);

/// When a stopped run is left with its axes held: nobody will let it go on, and its program has had
/// the time to end by itself.
class LeftHeld {
 public:
  /// @param isTold  the program has been told to end
  [[nodiscard]] bool isDue(bool isTold, const FeedControl& feed, RunOrders& orders,
                           base::Instant now);

 private:
  std::optional<base::Instant> m_since;
};

/// How the stream ended, as far as the client can know.
struct StreamEnd {
  bool programEnded = false;  ///< the control's channel is in reset again
  bool leftHeld = false;      ///< stopped: the axes stand, and the program is to end
  bool stopped = false;       ///< because the operator wanted it
  std::optional<base::Duration> stopConfirmedAfter;
  base::Error error;     ///< code clear: none
  std::string slowedBy;  ///< see `RunReport`
  std::optional<WrongMotion> wrong;
};

class Driver {
 public:
  /// @param total  points of the program, for the counters
  /// @param cells  for the online correction, and to end the program when the stream has to be
  ///               abandoned  @param feed  of the program, outlives the driver
  Driver(opcua::Link& link, Method& method, const RunSettings& settings, RunOrders& orders,
         RunSink& sink, std::size_t total, const templates::CellMap& cells, FeedControl& feed);

  /// The path, so that a tool that leaves it is noticed. Without it only the method's own signs of
  /// wrong motion are.
  void watchPath(PathWatch path) { m_place.path = std::move(path); }
  /// Fetches the control's own trace while the stream has slack, if the control gives it in pieces.
  void watchTrace(TraceTaker& trace) { m_trace.begin(trace, m_link.now() + kTraceInterval); }
  /// Where the method pulls its windows from, if points arrive during the run.
  void watchSupplier(live::PointSupplier& supplier) { m_supplier = &supplier; }
  /// Rotary axes to be shown beside X, Y and Z. @param axisOf  see `ControlAxes`
  void watchRotary(const std::array<int, base::kRotaryAxisCount>& axisOf) {
    m_reads.showRotary(axisOf);
    m_feed.watchRotary(axisOf);
  }

  /// Streams until the program on the control has ended, or until nothing more can be done.
  [[nodiscard]] StreamEnd run();

  [[nodiscard]] const Counters& counters() const { return m_counters; }
  /// Pauses seen during the run: measured from feed samples or inferred from handshake edges.
  [[nodiscard]] const std::vector<trace::Pause>& pauses() const { return m_pauses.pauses(); }

 private:
  struct Pending {
    base::RequestId id;
    bool write = false;
    int nodes = 0;
    std::size_t points = 0;
    bool beats = false;  ///< with signs of life
  };
  /// The end of the program on the control, by command.
  struct Ending {
    opcua::Assignment stop;
    std::optional<base::Instant> wantedAt;     ///< by the operator
    std::optional<base::Instant> abandonedAt;  ///< because the stream cannot continue
    LeftHeld held;
    std::optional<base::RequestId> pending;
    bool isSent = false;
    base::Duration lostBefore{};  ///< time lost by the override until then
  };
  /// An access to the feed cell, beside all others.
  struct FeedAccess {
    base::RequestId id;
    bool write = false;
    int nodes = 0;
  };

  void submitMethod();
  /// Reads status, tool and spindle, or display. Between two such reads the method has its turn,
  /// however slow the control is.
  void submitMonitor();
  void submitMonitorRead(MonitorReads::Kind kind);
  void noticeSilence();
  void noticeOwnSilence();
  void loseConnection(base::Error error);
  void noticeSlowness();
  [[nodiscard]] base::Instant nextWakeUp() const;
  /// The feed cell comes before everything else, whatever is outstanding.
  /// What the order says of the tool: it is lifted while the axes are held, and they are held until
  /// it is back.
  void takeLift(FeedOrder& order);
  /// The tool is not on the path, or not known to be.
  [[nodiscard]] bool isLifted() const;
  void submitFeed();
  void submitBeat();
  /// What takes longer than signs of life may be apart takes them along.
  [[nodiscard]] std::span<const opcua::Assignment> withBeats(
      std::span<const opcua::Assignment> cells);
  void takeFeed(const opcua::Event& event);
  void noteFeed();
  /// Time that is lost by hold and override does not count. @param since  `FeedControl::lostTime`
  ///        at the beginning
  [[nodiscard]] base::Duration lostSince(base::Duration since) const;
  /// What the method expects of the motion comes so much later than it knows.
  [[nodiscard]] base::Duration late() const { return lostSince(m_lastProgress.lost); }
  /// @return true if a correction has been sent
  bool submitCorrection();
  void noteCorrection(bool now);
  void handle(const opcua::Event& event);
  void noteAccess(const opcua::Event& event, const Pending& pending);
  void handleMethod(const opcua::Event& event);
  void handleMonitor(const opcua::Event& event);
  void checkOrders();
  /// Gives the supplier of points its turn.
  void turnSupplier();
  [[nodiscard]] RunState state() const;
  /// No answer in time does no harm where the machine waits for its client: it is asked again.
  [[nodiscard]] bool forgives(const opcua::Event& event, bool forMethod);
  /// The first item of an answer that could not be read or written; clear: none.
  [[nodiscard]] static std::error_code refusedItem(const opcua::Event& event);
  /// One variable of a request could not be accessed: the remedy depends on the reason.
  [[nodiscard]] base::Error itemError(const std::error_code& status, bool isRead) const;
  /// Asks again for an item that has been refused. @return false if that makes no sense
  [[nodiscard]] bool repeats(const opcua::Event& event, bool forMethod);
  void checkDeadlines();
  [[nodiscard]] bool hasSlackFor(int nodes) const;
  [[nodiscard]] bool wantsStatus() const;
  [[nodiscard]] bool wantsDisplay() const;
  /// Tool, spindle and coolant: only where the stream has time, whatever their age.
  [[nodiscard]] bool wantsEquipment() const;
  void publish(std::optional<trace::LiveSample> sample = std::nullopt,
               std::optional<EquipmentSeen> equipment = std::nullopt);
  void publishPause(const trace::Pause& pause);
  /// Looks whether the tool has left the path.
  void checkPlace(base::Vec3 positionMm, base::Instant at);
  void confirmSuspicion();
  void noteWrong(WrongMotion wrong);
  /// A position that the method has read, with the feed as far as the position shows it.
  void publishPosition(base::Vec3 positionMm, base::Instant at);
  void settlePauses(bool all);
  /// The stream cannot continue: command the control to end its program, and wait for that.
  void abandon(base::Error error);
  void submitStop();
  void submitTrace();

  opcua::Link& m_link;
  Method& m_method;
  const RunSettings& m_settings;
  RunOrders& m_orders;
  RunSink& m_sink;
  Counters m_counters;
  Ending m_ending;
  /// Accesses that are not answered yet.
  struct Outstanding {
    std::optional<Pending> method;
    std::optional<Pending> monitor;
    /// What the latter is; nothing: the online correction.
    std::optional<MonitorReads::Kind> monitorKind;
    std::optional<FeedAccess> feed;
    std::optional<base::RequestId> beat;
  };
  Outstanding m_outstanding;
  bool m_methodsTurn = false;  ///< the last access was not the method's
  AccessTimes m_access;
  MonitorReads m_reads;
  CorrectionCells m_correction;
  FeedControl& m_feed;
  std::vector<opcua::Assignment> m_withBeats;
  /// Of the method.
  struct LastProgress {
    std::optional<base::Instant> at;
    base::Duration lost{};  ///< lost time at that moment
  };
  LastProgress m_lastProgress;
  base::Instant m_nextSample{};  ///< of the positions that the method reads
  base::Instant m_turnedAt{};    ///< when this program last had its turn
  base::Instant m_lastPublished{};
  int m_refusals = 0;       ///< answers in a row with a refused item
  bool m_isSilent = false;  ///< nothing comes from the control
  struct Holds {
    bool inForce = false;
    bool bySupplier = false;  ///< it has asked for it, or is silent
  };
  Holds m_holds;
  bool m_grantSeen = false;
  std::size_t m_brokenSeen = 0;
  PauseLog m_pauses;
  trace::StandstillByPosition m_standstill;
  struct Suspicion {
    WrongMotion wrong;
    base::Instant at;
  };
  struct PlaceCheck {
    std::optional<PathWatch> path;
    std::optional<Suspicion> suspicion;
  };
  PlaceCheck m_place;
  live::PointSupplier* m_supplier = nullptr;
  TraceFetch m_trace;
  StreamEnd m_end;
  bool m_done = false;
};

}  // namespace rivulet::streaming
