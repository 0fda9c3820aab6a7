// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What is open: a program, the settings it is to be streamed with, and what follows from both
/// (flexible program, distances, verdict, times, pauses). Knows no page and no connection; who has
/// one tells it where the tool stands and what access costs. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "feasibility/verdict.h"
#include "machine/config.h"
#include "preparation/judged.h"
#include "session/file_watch.h"
#include "session/hazards.h"
#include "session/job_check.h"
#include "session/live_path.h"
#include "session/program_loader.h"
#include "session/program_timer.h"
#include "session/rehearsal.h"
#include "session/session_event.h"
#include "streaming/control/machine_facts.h"
#include "streaming/control/machine_profile.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/run/run.h"
#include "streaming/start/start_policy.h"
#include "streaming/start/stream_settings.h"
#include "widgets/calibration/access_source.h"
#include "widgets/streaming/method_panel.h"
#include "widgets/streaming/run_progress.h"

namespace rivulet::hmi {

/// What follows from program and settings.
struct Findings : preparation::Judged {
  feasibility::OperatingPoint operatingPoint;
  feasibility::AccessModel access;
  widgets::AccessSource source;  ///< of `access`
  /// The distances of the path are being found: there is no verdict yet.
  bool isBeingMeasured = false;
  /// The simulation of the program with these settings; nothing: there is no verdict to check.
  std::optional<streaming::Rehearsed> rehearsed;
  std::shared_ptr<const session::RehearsalOutcome> rehearsal;  ///< null: not done (yet)
  /// The machine that is to run the job is known: the job is compared with it.
  bool isJobChecked = false;
  std::shared_ptr<const session::Hazards> hazards;  ///< null: not known (yet)
};

/// Stands in where the machine is not known: it has a spindle and tools.
[[nodiscard]] const machine::MachineConfig& usualMachine();

class Document final : public QObject {
  Q_OBJECT

 public:
  explicit Document(const streaming::StreamSettings& settings);

  /// Reads a program in the background; the present one stays until the new one is there.
  void open(const QString& path, const session::Reading& reading = {});
  /// The same for the motion alone, whatever the settings say: the program of an earlier run.
  /// @param limit  by which its long moves are divided
  void openMotion(const QString& path, const session::Reading& reading,
                  const gcode::MoveRules& limit);
  /// Points that arrive during the run take the place of a program. @param name  of their source,
  /// which is open
  void openLive(const live::Setup& setup, const std::string& name);
  /// What takes the place of a program.
  struct LiveInput {
    live::Setup setup;
    std::string name;                     ///< of the source
    std::optional<base::Error> obstacle;  ///< why it is not open; nothing: it is
  };
  /// Nothing: there is a program, or there is nothing.
  [[nodiscard]] const std::optional<LiveInput>& live() const { return m_live; }
  /// The source is open again, or cannot be opened. @param obstacle  nothing: it is open
  void setLiveObstacle(std::optional<base::Error> obstacle);
  /// A run begins: its path has no points yet.
  void beginLivePath();
  void appendLive(const session::LivePoints& more) { m_livePath.append(more); }
  /// Reads the file of the present program again. Nothing without a program.
  void readAgain(const session::Reading& reading);
  void cancelReading() { m_loader.cancel(); }

  /// Null: no program is loaded.
  [[nodiscard]] const std::shared_ptr<const overview::ProgramView>& view() const { return m_view; }
  [[nodiscard]] std::shared_ptr<const gcode::Program> program() const;
  /// The file has another content on disk by now. A file that is gone has not changed.
  [[nodiscard]] bool hasFileChanged() const {
    return m_watch.state() == session::FileWatch::State::Changed;
  }
  [[nodiscard]] const std::vector<gcode::StreamPoint>& points() const;
  /// The stretches of a whole job are streamed, and the control gets its blocks; else the motion
  /// alone.
  [[nodiscard]] bool isJob() const { return m_view && m_view->isJob(); }
  /// > 0: the job runs dry, so much higher.
  [[nodiscard]] double dryRunMm() const { return isJob() ? m_reading.dryRunMm : 0.0; }
  /// Null: there are no blocks that the machine needs beside the motion.
  [[nodiscard]] const overview::JobOutline* outline() const;
  /// M functions of another machine that the program calls, and what this one gets for them.
  [[nodiscard]] const std::vector<job::FunctionUse>& foreignFunctions() const;
  /// Why the program cannot be run as a whole job with the present settings; nothing: it can, or it
  /// has no blocks for the control.
  enum class JobObstacle : unsigned char { Machine, Method, Correction, NotWhole };
  [[nodiscard]] std::optional<JobObstacle> jobObstacle() const;
  [[nodiscard]] const QString& path() const { return m_path; }
  /// The file that was asked for last.
  [[nodiscard]] const QString& requestedPath() const { return m_requestedPath; }
  [[nodiscard]] const session::Reading& reading() const { return m_reading; }
  /// By which long moves of the program have been divided.
  [[nodiscard]] const gcode::MoveRules& moveRules() const { return m_moves.limit; }
  /// Where the program came from.
  [[nodiscard]] session::ProgramSource source() const;

  [[nodiscard]] const streaming::StreamSettings& settings() const { return m_settings; }
  void setSettings(const streaming::StreamSettings& settings);
  /// As `setSettings`, without `settingsChanged`: for the page on which they were changed.
  void editSettings(const streaming::StreamSettings& settings);
  /// The whole job is to be run, or its motion alone.
  void chooseJob(bool isWhole);
  /// The settings with the rotary axes the program turns.
  [[nodiscard]] templates::TemplateParameters parameters() const;
  [[nodiscard]] streaming::RunSettings runSettings() const;
  /// The limits that feeds keep, and the machine of times and simulations.
  /// @param machine  null: nobody has entered them, so those of the paper's machine
  void setMachine(std::shared_ptr<const machine::MachineConfig> machine);
  [[nodiscard]] const std::shared_ptr<const machine::MachineConfig>& machine() const {
    return m_machine;
  }
  /// The control that the flexible program is written for.
  void setTarget(templates::TargetControl target);
  /// Part of the programs for the machine: see `streaming::silenceLimitS`.
  void setSilenceLimit(double seconds);
  /// Where it is not proved, windows take no longer than this: see `streaming::stopLimitS`.
  void setStopLimit(double seconds);
  /// @param liftMmMax  how far the tool may be lifted there, mm
  void setFeedProof(streaming::FeedProof proof, double liftMmMax);
  [[nodiscard]] streaming::FeedProof feedProof() const { return m_stop.proof; }
  /// The machine that whole jobs are compared with before they start. @param machine  null: it is
  /// not known
  void setJobMachine(std::shared_ptr<const machine::MachineConfig> machine);
  /// What the machine that jobs are for does for words of other machines.
  void setLoadMachine(const report::LoadMachine& machine);
  [[nodiscard]] const std::shared_ptr<const machine::MachineConfig>& jobMachine() const {
    return m_jobMachine;
  }
  /// No feed can be larger, mm/s.
  [[nodiscard]] double feedMmPerSMax() const { return m_machineFeeds.feedMmPerSMax; }
  /// Commanded feed of the move to a point, mm/s. @param point  index into `points`
  [[nodiscard]] double commandedMmPerS(std::size_t point) const;
  [[nodiscard]] const Findings& findings() const { return m_findings; }
  /// Of a whole job, machine coordinates; null: not known (yet), or the machine is not.
  [[nodiscard]] const streaming::CutBox* jobCut() const {
    return m_findings.hazards ? &m_checked.job->cut : nullptr;
  }

  /// Null: not known for the present settings (yet).
  [[nodiscard]] std::shared_ptr<const overview::PauseMap> pauses() const;
  [[nodiscard]] std::optional<widgets::PauseSummary> pauseSummary() const;
  /// What is left of the run with the present settings; nothing: not known. @param executed  points
  /// so far  @param nativeLine  of the block of the control in progress; 0: none is
  [[nodiscard]] std::optional<widgets::TimeLeft> timeLeft(std::size_t executed,
                                                          std::size_t nativeLine = 0) const;

  /// What access costs on the connected machine. @param record  null: not measured
  void setCalibration(std::shared_ptr<const streaming::CalibrationRecord> record, bool isOutdated);
  /// Which whole jobs may run on the connected machine; all while none is connected.
  void setJobRelease(const streaming::JobRelease& release);
  [[nodiscard]] const streaming::JobRelease& jobRelease() const { return m_jobRelease; }
  /// Where a run would begin. Points that depend on it are made again, but not those of a run.
  void setToolPosition(const base::Vec3& positionMm);
  /// Makes points again that depend on the tool's position, if it has moved, or on how long a move
  /// may take.
  void placePoints();
  /// A run is in progress: program and points stay as they are, and the processors are its own.
  void setRunning(bool isRunning);
  /// A run was left that can be resumed: its points must stay as they are.
  void setHeld(bool isHeld) { m_motion.isHeld = isHeld; }
  /// Judges and announces again: texts of the findings depend on the language.
  void judge();

 Q_SIGNALS:
  /// @param share  0 to 1; nothing: no program is being read
  void readingProgressed(const std::optional<double>& share);
  void readingCancelled();
  void readingFailed(const rivulet::base::Error& error, const QString& path);
  /// Another program or live source, or the same file read again.
  void programLoaded();
  /// The same program with points for another position of the tool, or more live points.
  void programPlaced();
  void fileStateChanged(rivulet::session::FileWatch::State state);
  void settingsChanged();
  /// `findings` are new.
  void judged();
  void timesEstimated(const std::shared_ptr<const rivulet::overview::ProgramTimes>& times);
  /// `pauses` or `pauseSummary` is new.
  void pausesChanged();

 private:
  void read(const QString& path, const session::Reading& reading);
  /// The view of a live run without points.
  void showNoPoints();
  void take(const session::LoadedProgram& loaded);
  [[nodiscard]] bool wantsJob() const;
  /// Adds what the control does before the stretches that are to come, and after the last one.
  /// @return false: how long that takes is not known
  [[nodiscard]] bool addNativeTimes(widgets::TimeLeft& left, std::size_t executed,
                                    std::size_t nativeLine) const;
  /// Why a dry run that is wanted would not be one; nothing: it is, or none is wanted.
  [[nodiscard]] std::optional<base::Error> dryRunProblem() const;
  /// Reads the program again if it is to be a job and is not, or the other way round.
  void followJob();
  void takePlaced(const std::shared_ptr<const overview::ProgramView>& view,
                  const session::PlaceRequest& request);
  /// What the points of the program are to be made for; as they are while a run has them.
  [[nodiscard]] gcode::MoveRules wantedMoveRules() const;
  /// What access costs with the present settings. @param source  its form is set
  [[nodiscard]] feasibility::AccessModel accessModel(widgets::AccessSource& source) const;
  void chooseFeedCells(const feasibility::AccessModel& access);
  /// Finds the distances of the program, those of a long one in the background: they are judged
  /// when they are there. @return whether they are
  bool measure(int pointsPerLoop, bool isTimed);
  void estimateTimes();
  /// Everything that the simulation depends on.
  [[nodiscard]] std::string rehearsalKey() const;
  void rehearse();
  void takeRehearsal(const std::shared_ptr<const session::RehearsalOutcome>& outcome,
                     const std::string& key);
  /// Compares a whole job with the machine.
  void checkJob();
  void showHazards();
  void forgetTimes();
  [[nodiscard]] session::TimeSettings timeSettings() const;
  /// Null: not known for the present settings (yet).
  [[nodiscard]] const overview::RunTime* runTime() const;

  std::optional<LiveInput> m_live;
  session::LivePath m_livePath;
  session::ProgramLoader m_loader;
  session::ProgramTimer m_timer;
  session::Rehearsal m_rehearsal;
  session::JobCheck m_jobCheck;
  session::FileWatch m_watch;
  QTimer m_estimateTimer;  ///< settings change while an operator turns them: wait for a rest

  std::shared_ptr<const machine::MachineConfig> m_machine;     ///< null: that of the paper
  std::shared_ptr<const machine::MachineConfig> m_jobMachine;  ///< null: not known
  report::LoadMachine m_loadMachine;
  /// The comparison of a whole job with the machine.
  struct Checked {
    std::shared_ptr<const job::Plan> plan;            ///< of `job`, or in progress
    std::shared_ptr<const forecast::CheckedJob> job;  ///< null: not known (yet)
  };
  Checked m_checked;
  gcode::ProgramFeeds m_machineFeeds;  ///< limits, at 100 %
  /// How a run stands, as far as its machine decides it.
  struct MachineStop {
    templates::TargetControl target = templates::TargetControl::Sinumerik;
    double silenceLimitS = templates::kSilenceLimitS;
    streaming::FeedProof proof = streaming::FeedProof::Proved;
    double liftMmMax = templates::kLiftMmMax;
    double limitS = streaming::stopLimitS(nullptr);
  };
  MachineStop m_stop;
  streaming::StreamSettings m_settings;
  /// What `parameters` was last completed for, and the result: it takes a pass over the program.
  struct FeedCells {
    std::shared_ptr<const overview::ProgramView> view;
    templates::TemplateParameters parameters;
    base::Duration accessTime{};
    bool feedPerPoint = false;
  };
  /// The distances that the verdict takes.
  struct Measured {
    std::shared_ptr<const overview::ProgramView> view;
    int pointsPerLoop = 0;
    bool isTimed = false;
    std::optional<feasibility::ProgramDistances> distances;
    bool isDone = false;
    [[nodiscard]] bool isFor(const Measured& other) const {
      return view == other.view && pointsPerLoop == other.pointsPerLoop && isTimed == other.isTimed;
    }
  };
  /// What takes a pass over the program.
  struct Passes {
    FeedCells feedCells;
    Measured measured;
  };
  Passes m_passes;
  std::shared_ptr<const overview::ProgramView> m_view;
  QString m_path;
  QString m_requestedPath;
  session::Reading m_reading;
  std::optional<base::Error> m_dryRunError;  ///< of the program as it was read
  Findings m_findings;
  widgets::AccessSource m_source;
  /// Of the program, a stop may have to wait for its moves.
  struct Moves {
    std::shared_ptr<const gcode::Program> whole;  ///< as it was read
    gcode::MoveRules limit;                       ///< by which the shown points are divided
    std::optional<gcode::MoveRules> ofRun;        ///< see `openMotion`
  };
  Moves m_moves;
  base::Vec3 m_toolMm;  ///< the origin while no machine has been seen
  streaming::JobRelease m_jobRelease;
  bool m_isMotionAlone = false;  ///< see `openMotion`
  /// Of the machine.
  struct Motion {
    bool isRunning = false;
    bool isHeld = false;
  };
  Motion m_motion;

  /// Of times and pauses.
  struct Estimate {
    std::optional<session::TimeSettings> timesFor;
    std::shared_ptr<const overview::ProgramTimes> times;  ///< null: not known
    std::shared_ptr<const overview::PauseMap> pauses;     ///< null: not known
    std::optional<session::TimeSettings> pausesFor;
  };
  Estimate m_estimate;
  /// The simulation that was made last or is in progress.
  struct Rehearsed {
    std::shared_ptr<const session::RehearsalOutcome> outcome;  ///< null: not done
    std::string key;                                           ///< see `rehearsalKey`
  };
  Rehearsed m_rehearsed;
};

}  // namespace rivulet::hmi
