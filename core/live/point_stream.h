// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The growing list of points of a live source: reads lines while there is room, lets pass what has
/// been agreed, and gives a method window after window. Nothing here knows the control.
///
/// The source is read only as fast as windows are taken, so a source that can wait is slowed down.
/// A window that is not full is given out when its oldest point has waited for a short time.
/// A move that takes longer than a window may is given out in parts, which are points of the run:
/// the source, and the displays of it, know only the points that it has sent.
/// @threadsafety one object, on the thread of the run.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "base/instant.h"
#include "base/recent_values.h"
#include "live/agreement.h"
#include "live/line_reader.h"
#include "live/point_supplier.h"
#include "live/rate.h"
#include "live/source.h"
#include "live/summary.h"

namespace rivulet::live {

struct Limits {
  base::Duration fullWithin = std::chrono::milliseconds{100};  ///< else a window goes as it is
  base::Duration holdAfter = std::chrono::seconds{5};          ///< of silence the run holds
  base::Duration endAfter = std::chrono::seconds{60};          ///< of silence it ends
  /// Points that wait for a window, at least those of one. 0: those of two windows.
  std::size_t queuedMax = 0;

  friend bool operator==(const Limits&, const Limits&) = default;
};

class PointStream final : public PointSupplier {
 public:
  /// @param source  outlives this object
  PointStream(Source& source, const Agreement& agreement, const Limits& limits);

  /// From now on the source is read.
  void begin(const SupplyStart& start, base::Instant now) override;
  /// Reads what there is room for, and tells the source how far the run is.
  void turn(base::Instant now) override;

  [[nodiscard]] std::optional<std::size_t> takeWindow(base::Instant now) override;
  /// All points of the windows that were taken, parts of long moves among them.
  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const override { return m_points; }
  [[nodiscard]] const std::vector<std::size_t>& windowBegins() const override { return m_begins; }
  /// The source has ended and every point has been taken.
  [[nodiscard]] bool isDry() const override { return m_summary.hasEnded && m_queue.empty(); }
  /// Everything has been executed, and the source has asked for a hold or is silent.
  [[nodiscard]] bool wantsHold(base::Instant now) const override;

  void windowMoves(base::Instant now) override;
  void executed(std::size_t points) override;
  /// The last reply.
  void finish(std::string_view outcome, const std::string& error) override;

  [[nodiscard]] Summary summary() const override;
  /// Points that have passed, without those that were merged, with the parts of their moves.
  [[nodiscard]] std::size_t accepted() const override { return m_parts; }
  [[nodiscard]] Level level() const override;

 private:
  /// Points whose delays a display shows.
  static constexpr std::size_t kRecentDelays = 500;

  struct Queued {
    gcode::StreamPoint point;
    std::size_t parts = 1;  ///< of the move to it, >= 1
    base::Instant arrived{};
    bool isAfterHold = false;
  };
  /// A point of the source whose move does not begin yet.
  struct Arrival {
    std::size_t part = 0;  ///< index of its first part
    base::Instant at{};
  };

  /// What the sender was told last.
  struct Reported {
    base::Instant at{};
    std::size_t accepted = 0;
    std::size_t executed = 0;
  };

  /// @return false: nothing has come
  bool readBytes(base::Instant now);
  void takeLine(std::string_view text);
  void takePoint(const Line& line);
  [[nodiscard]] base::Result<void> requireNumber(const Line& line);
  [[nodiscard]] bool hasRoom() const;
  /// The machine has not yet come to where the source wants it to wait.
  [[nodiscard]] bool isBeforeHold() const;
  /// It cannot be in the window that the first point in the queue begins.
  [[nodiscard]] bool beginsWindow(const Queued& queued) const;
  /// Parts of the queue that the next window has, >= 1. @pre there are any
  [[nodiscard]] std::size_t windowSize() const;
  /// Where the move to the first point in the queue begins.
  [[nodiscard]] base::AxisPosition front() const;
  /// A part of a move in the queue, counted from 1. @param from  where the move begins
  [[nodiscard]] gcode::StreamPoint partOf(const base::AxisPosition& from, const Queued& queued,
                                          std::size_t number) const;
  /// The next part in the queue becomes a point of the run.
  void givePart();
  void refuse(const base::Error& error, std::size_t line);
  void checkSilence(base::Instant now);
  void closed();
  void report(base::Instant now);
  [[nodiscard]] Progress progress() const;
  /// Points of the source that have been executed as a whole.
  [[nodiscard]] std::size_t executedOfSource() const;
  /// The last of them; null: none.
  [[nodiscard]] const gcode::StreamPoint* lastOfSource() const;
  [[nodiscard]] SourceState state() const;
  /// Times of windows and what follows from them.
  void addTheory(base::Duration& windowTime, base::Duration& least, base::Duration& most) const;

  Source& m_source;
  Agreement m_agreement;
  Limits m_limits;
  std::optional<Gate> m_gate;
  WindowPlan m_plan;
  base::AxisPosition m_tool;
  LineReader m_reader;
  base::Instant m_readAt{};   ///< of the newest bytes
  base::Instant m_heardAt{};  ///< the source was last seen to live, or was not asked
  base::Instant m_now{};      ///< of the last turn
  std::deque<Queued> m_queue;
  std::size_t m_given = 0;  ///< parts of the move to its first point
  std::size_t m_parts = 0;  ///< of all points that have passed
  /// For each point of the source that has been given out as a whole: points of the run until then.
  std::vector<std::size_t> m_ends;
  std::vector<gcode::StreamPoint> m_points;
  std::vector<std::size_t> m_begins{0};
  std::deque<Arrival> m_arrivals;  ///< of points that have been taken but do not move yet
  std::size_t m_begun = 0;         ///< windows in motion or executed
  std::optional<base::Instant> m_firstBegun;
  base::Instant m_lastBegun{};
  std::size_t m_executed = 0;
  bool m_holdAsked = false;  ///< and no point has come since
  std::optional<double> m_number;
  trace::DurationCounter m_delays;
  base::RecentValues<base::Duration> m_recentDelays{kRecentDelays};
  Rate m_acceptedRate;
  Rate m_executedRate;
  Summary m_summary;
  std::optional<Reported> m_reported;  ///< nothing: the sender does not know where the tool is
};

}  // namespace rivulet::live
