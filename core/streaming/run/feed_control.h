// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The client's side of the feed cell: when it is written and read, whether the control obeys, and
/// when the axes stand; and the sign of life without which they do. No I/O: whoever has the link
/// asks what is due. One object lasts as long as the program on the control. @threadsafety one
/// object, one thread.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "base/vec3.h"
#include "opcua/link.h"
#include "streaming/run/feed_order.h"
#include "streaming/run/heartbeat.h"
#include "templates/cells.h"
#include "trace/pause.h"
#include "trace/recording.h"

namespace rivulet::streaming {

/// Before a factor in a note: the recording has them, a person is not told each.
inline constexpr std::string_view kFactorNote = "feed source: factor ";

class FeedControl {
 public:
  /// The cell has the value that a program begins with. @param cells  of the program
  explicit FeedControl(const templates::CellMap& cells);
  /// Rotary axes that have to stand as well. @param axisOf  see `ControlAxes`
  void watchRotary(const std::array<int, base::kRotaryAxisCount>& axisOf);

  /// False: the program has no feed cell. Nothing is due then, whatever is wanted.
  [[nodiscard]] bool exists() const { return m_exists; }

  /// What the operator wants now. An order that changes nothing writes nothing: a value that
  /// another client has written meanwhile stays.
  void want(const FeedOrder& order, base::Instant now);

  /// The cell has to be written, before anything else.
  [[nodiscard]] bool mustWrite(base::Instant now) const;
  /// Override, factor or both. Valid until the next call. To be followed by `written` or `lost`.
  [[nodiscard]] std::span<const opcua::Assignment> write(base::Instant now);
  void written(base::Instant at);

  /// The cells, and while a hold is not confirmed the axes, have to be read at once.
  [[nodiscard]] bool mustRead(base::Instant now) const;
  /// The same, where the stream has time for it.
  [[nodiscard]] bool mayRead(base::Instant now) const;
  [[nodiscard]] std::span<const opcua::Variable> read(base::Instant now);
  /// The answer, in the order of `read`. What could not be read is not known.
  void seen(std::span<const opcua::Reading> readings, base::Instant at);

  /// Due whether the program has a feed cell or not. It is not waited for.
  [[nodiscard]] Heartbeat& beat() { return m_beat; }
  /// A sign of life has been confirmed. @param sent  when it was sent
  void beaten(base::Instant sent, base::Instant at);

  /// No answer: nothing is known of the last access, and it is made again.
  void lost(base::Instant now);

  [[nodiscard]] const FeedSeen& state() const { return m_seen; }
  [[nodiscard]] bool holds() const { return m_exists && m_seen.holds; }
  /// How much later the path is by now than at 100 %: all that is expected of the motion is.
  [[nodiscard]] base::Duration lostTime(base::Instant now) const;

  /// What has happened since the last call, for recording and display.
  [[nodiscard]] std::vector<trace::Note> takeNotes();
  /// All orders so far, with the holds of the source. @param now  the last one lasts until then
  [[nodiscard]] std::vector<FeedEvent> events(base::Instant now) const;
  /// What was made of a source of factors, without `count`. Nothing: the program has no cell for
  /// them.
  [[nodiscard]] std::optional<FactorReport> factors() const;

 private:
  void note(base::Instant at, std::string text);
  void wantFactor(const FeedOrder& order, base::Instant now);
  /// The value in the cell has changed. @param ordered  when it was wanted
  void begin(base::Instant ordered, double percent, bool isForeign);
  void beginFactor(base::Instant now);
  /// What is known of the axes is of before.
  void forgetPlace();
  [[nodiscard]] double product() const;
  void takePlace(std::span<const opcua::Reading> readings, base::Instant at);
  void account(base::Instant now);

  bool m_exists;
  Heartbeat m_beat;
  base::Duration m_silenceLimit;            ///< 0: signs of life are not watched
  std::optional<base::Instant> m_beatenAt;  ///< the last one was there at the latest
  templates::CellMap m_map;
  std::vector<opcua::Assignment> m_assignments;
  std::vector<opcua::Variable> m_cells;  ///< wanted, acting; factor
  std::vector<opcua::Variable> m_all;    ///< the same, then the axes
  FeedOrder m_asked;                     ///< last, whether it can be obeyed or not
  FeedOrder m_order;                     ///< that is obeyed
  base::Instant m_orderedAt{};
  bool m_mustWrite = false;
  bool m_isSent = false;  ///< the override, and is not confirmed yet
  /// Of the factor.
  struct Factor {
    double wanted = 1.0;
    base::Instant readAt{};  ///< from the source
    bool mustWrite = false;
    bool isSent = false;  ///< and not confirmed yet
    base::Instant sentAt{};
    std::optional<base::Instant> timedFrom;  ///< of what is sent, if its delay counts
    base::Instant next{};                    ///< it is not written before
    base::Instant noteNext{};
    std::optional<live::FactorSeen> told;  ///< noted last
    base::Instant tellNext{};
    FactorReport report;
    trace::DurationCounter delays;
  };
  Factor m_factor;
  bool m_mustConfirm = false;  ///< the control has not been seen to obey yet
  bool m_readsAxes = false;    ///< of the read in progress
  base::Instant m_nextWrite{};
  base::Instant m_nextRead{};
  std::vector<double> m_place;  ///< of the axes, at the last look; empty: not known
  base::Instant m_placeAt{};
  double m_standsAtZMm = 0.0;  ///< where Z stood when the axes were seen to
  FeedSeen m_seen;
  std::vector<FeedEvent> m_events;
  std::vector<trace::Note> m_notes;
  base::Duration m_lost{};
  base::Instant m_accountedTo{};
};

/// Takes the standstills that orders have made out of the pauses: they are none of the stream. The
/// clocks of control and client differ, so they are known by how long they lasted.
/// @param pauses  in time order  @return the standstills, one for a hold at most
[[nodiscard]] std::vector<trace::Pause> takeHolds(std::vector<trace::Pause>& pauses,
                                                  std::span<const FeedEvent> events);

}  // namespace rivulet::streaming
