// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs that this window does not stream: one that is on the control, whoever started it, or one
/// that was left and is kept on this computer. They can be watched, stopped and, if they are kept
/// here, resumed. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <optional>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/messages.h"
#include "hmi/run_controller.h"
#include "session/stream_session.h"
#include "widgets/streaming/found_run_bar.h"

namespace rivulet::hmi {

class FoundRuns final : public QObject {
  Q_OBJECT

 public:
  FoundRuns(session::StreamSession& session, Document& document, MachineModel& machine,
            RunController& runs, Messages& messages);

  /// Nothing: there is none, it is streamed by this window, or the operator does not want to see
  /// it.
  [[nodiscard]] std::optional<widgets::FoundRunView> view() const;
  [[nodiscard]] bool isOnControl() const { return m_seen.onControl.has_value(); }
  /// Shows program and progress. Nothing is written to the control.
  void watch(bool watch);
  /// Holds the axes of the run on the control, at once, and commands it to end.
  void stop();
  /// Lets a run that is held go on to the end of its window or block, where it ends.
  void end();
  /// Loads the program of the run with its settings, and asks the control where it was left.
  void resume();
  /// A run that was left is not offered again until the window is opened again.
  void dismiss();

 Q_SIGNALS:
  void changed();
  /// The run that is being watched. @param executed  points
  void watched(std::size_t executed);

 private:
  void takeSeen(const session::RunsSeen& seen);
  void takeEnded(const session::RunEnded& ended);
  void forget();
  void command(bool holds);
  /// To the operator, and in the log.
  void tell(Messages::Severity severity, const Messages::Text& text);
  [[nodiscard]] const report::SavedRun* saved() const;
  [[nodiscard]] std::size_t executedPoints() const;
  /// Loads the program of the run, unless it is loaded already. @return false and says why if its
  /// file is not known
  bool load(const report::SavedRun& run);
  [[nodiscard]] bool isLoaded(const report::SavedRun& run) const;
  void takeLoaded();
  /// Asks the control as soon as nothing is in the way any more.
  void askWhenPossible();

  session::StreamSession& m_session;
  Document& m_document;
  MachineModel& m_machine;
  RunController& m_runs;
  Messages& m_messages;
  session::RunsSeen m_seen;
  bool m_isWatched = false;
  std::optional<base::Duration> m_stopConfirmedAfter;
  bool m_isHeld = false;                       ///< stopped by this window, and not ended
  int m_dismissed = 0;                         ///< number of a run that is not to be shown
  std::optional<report::SavedRun> m_resuming;  ///< its program is being loaded
  bool m_asksSoon = false;                     ///< the program is there, the simulation is not yet
};

}  // namespace rivulet::hmi
