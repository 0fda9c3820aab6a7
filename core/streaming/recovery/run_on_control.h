// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds a run on a control, whoever started it: what its program reports in its cells, whether its
/// client is still there, and who started it. The latter is in a small program next to the flexible
/// program, because R-parameters hold no text.
/// Methods window, credit and file. @threadsafety runs on the calling thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "opcua/link.h"
#include "streaming/run/run.h"
#include "templates/window_protocol.h"

namespace rivulet::streaming {

/// A flexible program that is active on the control.
struct RunOnControl {
  std::string programName;  ///< e.g. "RIVULET_WINDOW_7X2.MPF"
  int baseCell = 0;         ///< R number of its first cell
  int number = 0;           ///< number of the run it obeys; 0: it waits for the first client
  int job = 0;      ///< number of the whole job that it is, see `job::JobName`; 0: a single run
  int stretch = 0;  ///< of a job: in progress, or the last; 0: none yet
  bool isNative = false;      ///< of a job: the control executes blocks of its own
  std::size_t delivered = 0;  ///< windows
  std::size_t latched = 0;
  std::size_t executed = 0;
  templates::WindowState state = templates::WindowState::Runs;
  double heartbeat = 0.0;           ///< as it was read last
  bool hasClient = false;           ///< its heartbeat changed while it was watched
  std::optional<RunOrigin> origin;  ///< nothing: not named, or not readable

  /// A job has another number in each stretch.
  [[nodiscard]] bool isSameAs(const RunOnControl& other) const {
    return baseCell == other.baseCell && job == other.job && (job != 0 || number == other.number);
  }
};

/// How long a heartbeat has to be watched to be sure that the client is gone, if the network is
/// not very slow.
inline constexpr base::Duration kHeartbeatWatch = std::chrono::milliseconds{2500};

/// Follows the run on a control by looking again and again: only several looks show whether its
/// client is still there.
class RunWatch {
 public:
  /// Looks once; nothing is changed on the control. @param baseCell  as for `findRun`
  /// @return as `findRun`
  [[nodiscard]] base::Result<std::optional<RunOnControl>> look(opcua::Link& link,
                                                               opcua::Control& control,
                                                               int baseCell);
  /// `hasClient` of the last look is certain: its heartbeat has changed, or has not changed for
  /// `kHeartbeatWatch`.
  [[nodiscard]] bool isClientKnown() const { return m_isClientKnown; }

 private:
  /// Compares with the look before.
  void takeHeartbeat(RunOnControl& run, base::Instant now);

  std::optional<RunOnControl> m_last;
  base::Instant m_since{};  ///< the heartbeat has the present value
  bool m_hasBeaten = false;
  bool m_isClientKnown = false;
};

/// Looks for a run. Nothing is changed on the control.
/// @param baseCell  first cell of the program if its name does not say it
/// @param watchFor  how long the heartbeat is watched; clients change it once a second. 0: not at
///                  all, `hasClient` is then false
/// @return nothing if the channel is in reset or executes a program of somebody else; otherwise a
///         link error
[[nodiscard]] base::Result<std::optional<RunOnControl>> findRun(opcua::Link& link,
                                                                opcua::Control& control,
                                                                int baseCell,
                                                                base::Duration watchFor);

/// How a program that waits on the control is told to end.
struct EndCommand {
  opcua::Assignment end;
  std::vector<opcua::Variable> identity;  ///< cells that tell the program from others
  /// The heartbeat: axes that stand because their client is gone come to the end only with another
  /// one. Nothing: the program watches none.
  std::optional<opcua::Variable> beat;
  std::function<bool(std::span<const double>)> isMeant;  ///< by the numbers in these cells
  std::string_view isAnother;                            ///< sentence if it is not
  std::string_view doesNotEnd;                           ///< sentence if it goes on
  std::function<bool()> goesOn = {};  ///< asked while waiting; false: give up. Empty: always true
  /// The feed cell: axes that are held go on at 100 %, as soon as it is certain by the heartbeat
  /// that nobody else is there who holds them. Nothing: the program has none.
  std::optional<opcua::Variable> feed = {};
};

/// Commands the program to end, unless the channel is in reset, and waits for that, with a
/// heartbeat of its own: as long as `goesOn` wants, or without it for the deadline of the settings.
/// The command is given again whenever it is found overwritten.
/// @return ChannelBusy if it is another program; StopNotConfirmed; Cancelled if `goesOn` gives up;
///         or a link error
[[nodiscard]] base::Result<void> endProgram(opcua::Link& link, const EndCommand& command,
                                            const RunSettings& settings);

/// What has become of a run that was stopped.
struct StoppedRun {
  bool hasEnded = false;                     ///< its program had nothing left to execute
  std::optional<base::Duration> stoodAfter;  ///< else: its axes are held, so long after the order
};

/// An override of 0 is seen to act within this time, also over a slow network.
inline constexpr base::Duration kStandsMax = std::chrono::seconds{5};

/// Stops a run, whoever started it: holds its axes at once, on the path, and commands its program
/// to end before its next window or block. It goes on to there only with `endRun`, or ends where it
/// is with a reset at the control.
/// @param goesOn  asked while the axes move although they are held, because what moves does not
///                obey; false: give up
/// @return StopNotConfirmed if it gives up, ChannelBusy if it is another program by now, or a link
///         error
[[nodiscard]] base::Result<StoppedRun> stopRun(opcua::Link& link, const RunOnControl& run,
                                               const RunSettings& settings,
                                               const std::function<bool()>& goesOn);

/// Commands the program of this run to end, and waits for it. It executes only the windows it has
/// copied, a job the block of the control that it is in. Axes that are held go on to there, but not
/// while the run has a client, who may hold them. @param goesOn  see `EndCommand`
/// @return StopNotConfirmed, ChannelBusy if it obeys another run by now, Cancelled, or a link error
[[nodiscard]] base::Result<void> endRun(opcua::Link& link, const RunOnControl& run,
                                        const RunSettings& settings,
                                        std::function<bool()> goesOn = {});

/// Stops what Rivulet has no cells for, somebody else's program too, by the reset of the control:
/// the axes brake, and the program ends where it is. Waits until the channel is in reset.
/// @param goesOn  asked once the control has had `kStandsMax` for it; false: give up
/// @return StopNotConfirmed if it gives up, MethodMissing if only the keys of the machine reset the
///         control, or a link error
[[nodiscard]] base::Result<void> stopByReset(opcua::Link& link, opcua::Control& control,
                                             const std::function<bool()>& goesOn);

/// Name on the control of the program that says who started the run with this first cell.
[[nodiscard]] std::string runLabelName(int baseCell);
/// Its text: comments, and an end.
[[nodiscard]] std::string runLabelText(int number, const RunOrigin& origin);
/// Inverse of `runLabelText`; nothing for another run or another text.
[[nodiscard]] std::optional<RunOrigin> runLabelOf(std::string_view text, int number);

/// "anna, cell-pc-3, 2026-11-22T05:00:00Z (run 123456)", as far as it is known: few words, because
/// it is not translated.
[[nodiscard]] std::string describeOrigin(int number, const std::optional<RunOrigin>& origin);

/// Number of a run in a cell; 0: none.
[[nodiscard]] int runNumberOf(double cell);

/// Stores the label; to be called while the channel is in reset.
[[nodiscard]] base::Result<void> storeRunLabel(opcua::Control& control, int baseCell, int number,
                                               const RunOrigin& origin);

}  // namespace rivulet::streaming
