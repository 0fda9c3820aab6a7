// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What an operator checks before a run, from the models as they are now. It only shows: whether a
/// run may start is `RunController`'s business. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "forecast/job_restart.h"
#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/releases.h"
#include "hmi/run_controller.h"
#include "hmi/users.h"
#include "streaming/start/first_move.h"
#include "widgets/streaming/preflight_sheet.h"

namespace rivulet::hmi {

class Preflight final : public QObject {
  Q_OBJECT

 public:
  enum Remedy {
    ReloadProgram,
    UseProgramFeed,
    ReleaseJob,
    TakeBackRelease,
    RunWholeJob,
    EnterLimits,
    MeasureAccess,
    ChooseStretch,
    ChangeLive,
    ConfirmSetUp,
    ConfirmFirstMove,
    ConfirmRepeats,
    RaiseTool,
    DriveBack,
  };

  Preflight(Document& document, MachineModel& machine, RunController& runs);

  /// Shows what a start would do. Nothing moves.
  void open();
  /// The same for a start from the beginning, also if a place to resume at has been found.
  void openForStart();
  void close();
  /// The operator does not want to go on now: closes it, and forgets where a run would be resumed.
  void dismiss();
  [[nodiscard]] bool isOpen() const { return m_isOpen; }
  /// The place where a run was left has been found: it is about resuming there.
  [[nodiscard]] bool isForResume() const { return m_runs.place().has_value() && !m_back; }
  /// At a line that the operator has chosen, a kind of resuming.
  [[nodiscard]] bool isForChosenLine() const { return isForResume() && m_runs.place()->isChosen; }
  /// Of the tool, as a run of its own before anything else.
  struct Raise {
    double toMm = 0.0;  ///< Z
    double feedMmPerS = 0.0;
  };
  /// The operator has chosen to raise it: nothing else starts.
  [[nodiscard]] bool isRaising() const { return m_isRaising; }
  /// Nothing: the tool is not raised, or need not be any more.
  [[nodiscard]] std::optional<Raise> raise() const;
  /// Along the path of the run that was left, as a run of its own before it goes on.
  struct Back {
    base::Result<streaming::BackWay> way;  ///< or why there is none
    double feedMmPerS = 0.0;
  };
  /// The operator has chosen to drive the tool back; nothing: not.
  [[nodiscard]] const std::optional<Back>& back() const { return m_back; }
  void setBack(const streaming::BackWish& wish, double feedMmPerS);
  /// It is shown, and nothing stands in the way.
  [[nodiscard]] bool hasPassed() const {
    return m_isOpen && !(isForResume() ? m_runs.placeBlocked() : m_runs.startBlocked()) &&
           (m_back        ? m_back->way.has_value()
            : isRaising() ? raise().has_value()
                          : (m_isSetUpConfirmed || missingSetUp().isEmpty()) &&
                                (m_isFirstMoveConfirmed || !cutOnTheWay()) &&
                                (m_isRepeatConfirmed || !mayRepeat()));
  }
  /// In the operator's language.
  [[nodiscard]] std::vector<widgets::PreflightItem> items() const;
  [[nodiscard]] widgets::FirstMove firstMove() const;
  /// How soon the axes stand after Stop at worst, s: where the feed cell is not proved, when the
  /// control has executed what it has. Nothing: not known.
  [[nodiscard]] std::optional<double> stopSeconds() const;
  void remedy(int remedyId);
  /// The operator has looked: nothing is in the way of the first move.
  void confirmFirstMove();
  /// The operator has typed that old points may be executed again.
  void confirmRepeats();
  /// Shows who has released the job; without it nobody has to.
  void setReleases(Releases& releases, Users& users);

 Q_SIGNALS:
  /// The operator wants to confirm that nothing is in the way of the first move.
  void straightRequested();
  /// The operator wants to drive the tool back. @param feedMmPerMin  that is proposed
  /// @param feedMmPerMinMax  of the machine
  void backRequested(double feedMmPerMin, double feedMmPerMinMax);
  void repeatsRequested();
  /// Opened or closed.
  void openChanged();
  void changed();
  /// The operator wants to enter the limits of the machine.
  void limitsRequested();
  /// Somebody wants to measure how fast the control can be written to.
  void calibrationRequested();
  /// The operator wants to agree on something else with the live source.
  void liveRequested();
  /// An engineer wants to begin a job in the middle. @param stretches  that there are
  void stretchRequested(int stretches);

 private:
  [[nodiscard]] std::vector<widgets::PreflightItem> programItems() const;
  /// Of a live source.
  [[nodiscard]] std::vector<widgets::PreflightItem> liveItems() const;
  [[nodiscard]] widgets::PreflightItem liveStartItem() const;
  /// @param agreed  with the source of factors
  [[nodiscard]] widgets::PreflightItem factorItem(const live::FactorAgreement& agreed) const;
  [[nodiscard]] widgets::PreflightItem programItem() const;
  /// What the program leaves open, and how it is read; no text: nothing is open.
  [[nodiscard]] widgets::PreflightItem readingItem() const;
  [[nodiscard]] widgets::PreflightItem functionsItem() const;
  [[nodiscard]] widgets::PreflightItem machineItem() const;
  /// Of a program with blocks that the machine needs beside the motion.
  [[nodiscard]] widgets::PreflightItem jobItem() const;
  /// What the program sets up, of which only its motion is to be streamed, and is not so at the
  /// control.
  [[nodiscard]] forecast::SetUp missingSetUp() const;
  [[nodiscard]] widgets::PreflightItem firstMoveItem() const;
  /// Whether the way of the tool to the first point passes within what the program cuts.
  [[nodiscard]] const std::optional<streaming::CutOnTheWay>& cutOnTheWay() const;
  /// The same, anew: a pass over the program.
  [[nodiscard]] std::optional<streaming::CutOnTheWay> findCut() const;
  /// Before it is asked for, in the background.
  void findPath();
  void change();
  /// @param name  in the audit trail of the start
  void confirm(bool& question, std::string_view name);
  /// Says so, and what can be done.
  void warnOfCut(widgets::PreflightItem& item) const;
  [[nodiscard]] widgets::PreflightItem straightItem() const;
  [[nodiscard]] bool mayRepeat() const;
  [[nodiscard]] widgets::PreflightItem repeatItem() const;
  [[nodiscard]] widgets::PreflightItem raiseItem() const;
  [[nodiscard]] widgets::PreflightItem backItem() const;
  /// The feed of what is not cut: not faster than the program cuts, as the tool may stand in the
  /// workpiece.
  [[nodiscard]] double carefulMmPerS() const;
  [[nodiscard]] widgets::PreflightItem travelItem() const;
  /// @param sizesMm  of the path, or of the box that it stays in
  [[nodiscard]] widgets::PreflightItem travelItem(const base::Vec3& sizesMm) const;
  /// What the machine cannot do of a whole job.
  [[nodiscard]] widgets::PreflightItem hazardItem() const;
  [[nodiscard]] widgets::PreflightItem resumeItem() const;
  /// The first move of a run that begins at a chosen line. @param point  its number and place
  [[nodiscard]] widgets::PreflightItem chosenItem(const QString& point) const;
  /// What the program has set up to the chosen line, and nobody sets now.
  [[nodiscard]] widgets::PreflightItem stateItem() const;
  /// What re-establishes the state in which a job goes on.
  [[nodiscard]] widgets::PreflightItem jobResumeItem() const;
  [[nodiscard]] widgets::PreflightItem originItem() const;
  [[nodiscard]] widgets::PreflightItem feedItem() const;
  [[nodiscard]] widgets::PreflightItem programFeedItem() const;
  [[nodiscard]] widgets::PreflightItem methodItem() const;
  /// How long the machine may still move after Stop.
  [[nodiscard]] widgets::PreflightItem stopItem() const;
  [[nodiscard]] bool standsAtOnce(const streaming::RunSettings& settings) const;
  /// Nothing: how long the axes brake is not known.
  [[nodiscard]] std::optional<double> feedCellSeconds() const;
  [[nodiscard]] widgets::PreflightItem runCellItem(const streaming::RunSettings& settings) const;
  [[nodiscard]] widgets::PreflightItem accessItem() const;
  [[nodiscard]] widgets::PreflightItem releaseItem() const;

  Document& m_document;
  MachineModel& m_machine;
  RunController& m_runs;
  Releases* m_releases = nullptr;
  Users* m_users = nullptr;
  bool m_isOpen = false;
  mutable std::weak_ptr<const job::Plan> m_setUpOf;
  mutable std::shared_ptr<const machine::MachineConfig> m_setUpOn;  ///< null: not known
  mutable forecast::SetUp m_setUp;                                  ///< computed once for both
  /// Found once between two changes; nothing: not yet.
  mutable std::optional<std::optional<streaming::CutOnTheWay>> m_cut;
  /// Of the program's path: it takes a pass over it.
  struct Path {
    std::shared_ptr<const overview::ProgramView> view;
    streaming::CutBox cut;
  };
  mutable Path m_path;
  // By the operator, as long as it is shown.
  bool m_isSetUpConfirmed = false;
  bool m_isFirstMoveConfirmed = false;
  bool m_isRepeatConfirmed = false;
  bool m_isRaising = false;
  std::optional<Back> m_back;
  std::string m_confirmed;  ///< by hand, as the audit trail names it
};

}  // namespace rivulet::hmi
