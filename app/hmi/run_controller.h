// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What may be done with the control now and why not, and the run that is in progress or was the
/// last. The rules are those of `streaming/start/start_policy`, as on the command line.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/messages.h"
#include "session/stream_session.h"
#include "streaming/recovery/back_along.h"
#include "streaming/start/start_policy.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

class RunController final : public QObject {
  Q_OBJECT

 public:
  RunController(session::StreamSession& session, Document& document, MachineModel& machine,
                Messages& messages);

  [[nodiscard]] std::optional<streaming::Blocked> startBlocked() const;
  [[nodiscard]] std::optional<streaming::Blocked> resumeBlocked() const;
  [[nodiscard]] std::optional<streaming::Blocked> calibrationBlocked() const;
  /// A run that was left becomes the one that `askResume` asks for. @param run  with its program
  void adopt(session::ResumeQuestion run);
  /// Asks how the job begins with one of its stretches. Nothing moves. `placeFound` answers.
  /// @return false and says why if something stands in the way
  bool askFromStretch(int stretch);
  /// Number of the run that `askResume` asks for; 0: none.
  [[nodiscard]] int leftRunNumber() const { return m_left ? m_left->checkpoint.runNumber : 0; }
  /// A run was left, and its method can resume it: that is offered before a new start.
  [[nodiscard]] bool hasRunToResume() const;
  /// The method of the settings can be held before a window.
  [[nodiscard]] bool canHold() const;
  [[nodiscard]] bool canOverride() const { return !refusal(permission::Act::Override); }
  /// No run is in progress, and who is there may do it.
  [[nodiscard]] bool canChangeSettings() const;

  /// Who is there may do what; nothing: everything. Stop is not asked for.
  using Gate = std::function<std::optional<permission::Refusal>(permission::Act)>;
  void setGate(Gate gate) { m_gate = std::move(gate); }

  /// What somebody has confirmed for the next start, as the audit trail names it; empty: nothing.
  void setConfirmed(std::string what) { m_confirmed = std::move(what); }
  /// Starts if nothing stands in the way. @return false and says why otherwise
  bool start();
  /// Raises the tool straight up, as a run of its own. The run that was left cannot be resumed any
  /// more. @param toMm  Z  @return false as `start`
  bool raise(double toMm, double feedMmPerS);
  /// The way back along the path of the run whose place is shown. @return why there is none
  [[nodiscard]] base::Result<streaming::BackWay> wayBack(const streaming::BackWish& wish) const;
  /// Drives the tool along that way, as a run of its own. Then the place is asked for again.
  bool driveBack(const streaming::BackWay& way, double feedMmPerS);
  /// The axes stand at once, as with `hold`; without a feed cell the run ends before its next
  /// window. May be called again and again. Between runs: a test of the control is aborted, and
  /// what else the control executes is stopped by its reset, if it can be reset from here.
  void stop();
  /// The run ends before its next window. What is held goes on until there.
  void end();
  /// The axes stand at once, or without a feed cell before the next window; or they go on.
  void hold(bool hold);
  [[nodiscard]] bool isHeld() const { return m_isHeld; }
  /// The run in progress is `raise` or `driveBack`, and none of the program.
  [[nodiscard]] bool isPositioning() const { return m_positioning != Positioning::None; }
  /// The axes stand at once, and the run ends there: its program is left held, if it has not ended.
  /// Without a feed cell the run ends before its next window.
  void leave();
  /// Lifts the tool while the axes are held, mm; 0: back onto the path.
  void lift(double mm);
  /// Of the run in progress, percent.
  void setOverride(double percent);
  /// Asks the control where the run was left. Nothing moves. `placeFound` answers.
  void askResume();
  /// Resumes at the place found. @return false and says why if something stands in the way
  bool resume();
  /// Points that are known to be executed, or that the tool has visibly passed: a control may
  /// report many at once, after the last of them. For display.
  [[nodiscard]] std::size_t passed() const {
    return std::max(m_update.counters.executed, m_passedSeen);
  }
  /// The move that the tool is on: the index of the point at which it ends; nothing: not known.
  [[nodiscard]] std::optional<std::size_t> move() const { return m_move; }
  /// Line of that move, or of the block that the control executes; 0: not known.
  [[nodiscard]] std::size_t runLine() const;
  /// The place found; nothing while there is none to be confirmed.
  [[nodiscard]] const std::optional<widgets::ResumePlace>& place() const { return m_place; }
  /// Offers a start in the middle of the program, in the same way as a place to resume at: nothing
  /// moves. Without an effect during a run. @param line  the first whose motion is executed, from 1
  void offerStartAtLine(std::size_t line);
  /// Why a run may not begin at `place`.
  [[nodiscard]] std::optional<streaming::Blocked> placeBlocked() const;
  /// How the job goes on at that place; null: it is no whole job.
  [[nodiscard]] const run::JobRestart* restart() const { return m_restart.get(); }
  /// Says why the run that was left is not resumed. @param why  a sentence
  void refuseResume(const Messages::Text& why);
  /// The place found is no longer offered.
  void forgetResume();
  /// Begins on cells the operator has confirmed, if nothing stands in the way.
  void calibrate(const streaming::CalibrationPlan& plan);
  void cancelCalibration() { m_session.stop(); }
  void correct(const base::Vec3& valueMm);

  /// The run in progress, or the last one, has executed wrong points, and nobody has acknowledged
  /// it. @return a sentence; empty: it has not
  [[nodiscard]] QString wrongMotion() const;
  void acknowledgeWrongMotion();

  [[nodiscard]] bool isRunning() const { return m_session.isRunning(); }
  [[nodiscard]] bool isCalibrating() const { return m_session.isCalibrating(); }
  /// Counted in the whole program, also for a run that was resumed.
  [[nodiscard]] const streaming::LiveUpdate& update() const { return m_update; }
  /// Index of the point at which the run in progress, or the last one, has begun by the operator's
  /// choice; 0: at the first. `update` counts the points before it, though nobody executes them.
  [[nodiscard]] std::size_t runBegin() const { return m_runBegin; }
  /// Where the whole job in progress is; nothing: none is in progress.
  [[nodiscard]] const std::optional<session::JobUpdate>& job() const { return m_job; }
  /// Line of the program whose native block the control executes; 0: none of them.
  [[nodiscard]] std::size_t nativeLine() const {
    return m_job && m_job->isNative ? m_job->line.value : 0;
  }
  /// Null: no run has ended since the last start.
  [[nodiscard]] const std::shared_ptr<const streaming::RunReport>& report() const {
    return m_report;
  }

 Q_SIGNALS:
  /// The tool has been raised, or not: it has been said.
  void raised();
  /// What may be done, or why not, has changed.
  void permissionsChanged();
  void corrected(const rivulet::base::Vec3& valueMm);
  /// @param firstPoint  index of the first point that is streamed
  void started(std::size_t firstPoint);
  void updated(const rivulet::streaming::LiveUpdate& update);
  /// Times count from the first motion of the run.
  void sampled(const rivulet::widgets::TraceSample& sample);
  /// `job` is new.
  void jobChanged();
  void paused(const rivulet::trace::Pause& pause);
  void finished(const std::shared_ptr<const rivulet::streaming::RunReport>& report);

  /// `wrongMotion` has changed.
  void wrongMotionChanged();
  void resumeAsked();
  void placeFound(const rivulet::widgets::ResumePlace& place);
  void resumeRefused(const QString& reason);
  void resumeForgotten();
  void calibrationProgressed(const rivulet::streaming::CalibrationProgress& progress);

 private:
  [[nodiscard]] streaming::StartFacts facts(permission::Act act) const;
  [[nodiscard]] std::optional<permission::Refusal> refusal(permission::Act act) const {
    return m_gate ? m_gate(act) : std::nullopt;
  }
  /// @return true if something stands in the way; it has been said
  bool refuses(const std::optional<streaming::Blocked>& blocked);
  void noteEnd();
  /// Nothing of the last run is shown any more.
  void forgetLast();
  /// A run of its own that moves the tool.
  enum class Positioning : unsigned char { None, Raise, Back };
  void takePositioned(const session::RunFinished& finished);
  /// Starts a program that moves the tool, and nothing of the program that is open.
  void startPositioning(Positioning kind, gcode::Program program, double feedMmPerS,
                        session::StartCommand command, ActDetails details,
                        const Messages::Text& text);
  /// @param resume, restart  by value: the start forgets the place that was found
  bool startRun(std::optional<streaming::Resume> resume,
                std::shared_ptr<const run::JobRestart> restart = nullptr);
  void ask(session::ResumeQuestion question);
  /// Why a job does not go on. @param chosen  stretch to begin with; 0: it is resumed
  [[nodiscard]] static QString jobRefusal(bool isMachineKnown, int chosen);
  /// The place at which a job goes on, as it is shown.
  [[nodiscard]] widgets::ResumePlace placeOf(const run::JobRestart& restart) const;
  [[nodiscard]] std::optional<streaming::JobCheck> jobCheck(permission::Act act) const;
  /// The points of a run that was left are those of its list; a job's do not depend on where the
  /// tool stands.
  void holdPoints();
  /// @param restart   of a whole job that goes on; null: it is none
  /// @param isChosen  it begins at a point that the operator has chosen
  void announceStart(const streaming::RunSettings& settings, const run::JobRestart* restart,
                     bool isChosen);
  void takeUpdate(const streaming::LiveUpdate& update);
  /// Where the run is, for when the axes cannot be read.
  void showExecuted();
  void takeSample(const trace::LiveSample& sample, base::Instant origin);
  /// From the position of a sample to the end of the move that it is on; nothing: not known.
  /// Takes from a position on which move the tool is.
  void followTool(const streaming::LiveUpdate& update);
  void forgetMove();
  [[nodiscard]] std::optional<widgets::MachineView::ToGo> toGo(
      const trace::LiveSample& sample) const;
  void takeResume(const session::ResumeFound& found);
  void takeEnded(const session::RunEnded& ended);
  void sayCannotStop();
  void takeJob(const session::JobUpdate& job);
  void takeFinished(const session::RunFinished& finished);
  void takeWrong(const streaming::WrongMotion& wrong);
  void logOutcome(const session::RunFinished& finished);
  void raiseCut(const run::RecordingCut& cut);
  /// The alarms of the run that has just ended.
  void raiseOutcome();

  session::StreamSession& m_session;
  Document& m_document;
  MachineModel& m_machine;
  Messages& m_messages;
  Gate m_gate;
  streaming::LiveUpdate m_update;
  std::optional<base::Instant> m_firstMotion;
  std::optional<std::size_t> m_move;              ///< see `move`
  std::size_t m_passedSeen = 0;                   ///< points before the farthest such move
  std::optional<base::Vec3> m_startMm;            ///< of the tool before the run
  std::optional<streaming::WrongMotion> m_wrong;  ///< seen in the run in progress, or in the last
  bool m_hasWrongMotion = false;                  ///< and not acknowledged
  std::string m_confirmed;                        ///< see `setConfirmed`
  bool m_isHeld = false;                          ///< by the operator
  Positioning m_positioning = Positioning::None;
  bool m_isEnding = false;  ///< the run in progress has been told to end
  std::optional<session::JobUpdate> m_job;
  std::size_t m_firstPoint = 0;
  std::size_t m_runBegin = 0;
  std::shared_ptr<const streaming::RunReport> m_report;
  std::optional<session::ResumeQuestion> m_left;      ///< the run that could be resumed
  std::optional<session::ResumeQuestion> m_question;  ///< asked last, until something starts
  std::shared_ptr<const job::Plan> m_plan;            ///< of the job in progress; null: none
  std::optional<streaming::Resume> m_resume;          ///< the place found
  std::shared_ptr<const run::JobRestart> m_restart;   ///< the same of a whole job
  std::optional<widgets::ResumePlace> m_place;        ///< the same, as it is shown
};

}  // namespace rivulet::hmi
