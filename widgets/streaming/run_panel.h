// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The strip at the bottom of the window: Stop, Hold, the state of the run, Resume and Start. It
/// has the same height whatever it shows, and it fits a window of 480 px. Stop is available in
/// every state in which something may move, and needs no confirmation. A run whose program has a
/// feed cell stands on its path at once, as with Hold; it then goes on (Continue) or ends (End
/// here). Other runs end before their next window, and it is shown when the control has confirmed
/// it. Stop is no safety function. Start first asks for the preflight, and moves the machine only
/// after it has been held; while a run has an override, that has the place of Start.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "streaming/run/run.h"
#include "widgets/common/page.h"
#include "widgets/streaming/found_run_bar.h"
#include "widgets/streaming/run_progress.h"

class QBoxLayout;
class QGridLayout;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class ElidedLabel;
class HoldButton;
class OverrideControl;
class StatusLabel;
class StopButton;

/// "Running", "Holding", … in the language of the operator.
[[nodiscard]] QString runStateText(streaming::RunState state);
/// What a run waits for. @param key  `LiveUpdate::waitingFor`; one without a sentence is shown as
/// it is
[[nodiscard]] QString waitingText(const QString& key);

class RunPanel final : public Page {
  Q_OBJECT

 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// State, counters, margin and reason to wait, as the stream reports them.
  void setUpdate(const streaming::LiveUpdate& update);
  /// How the run has ended.
  void setReport(const streaming::RunReport& report);
  /// Another program: nothing of an earlier run is shown. @param points  of this program
  void setProgram(std::size_t points);
  /// Number of points of the loaded program, before a run reports it.
  void setTotal(std::size_t points);
  /// The run begins at a chosen point: the points before it do not count. @param point  an index
  void setRunBegin(std::size_t point);
  /// Where the run is in its program, and the time that is left of it; before a start, of the run
  /// to come.
  void setProgress(const RunProgress& progress);
  /// Where the whole job in progress is; nothing: none is in progress.
  void setJob(const std::optional<JobProgress>& job);
  /// One line: which program in which version.
  void setTitle(const QString& title);
  /// Why Start is not possible; empty: it is.
  void setStartBlocked(const QString& reason);
  /// The preflight is shown and nothing in it stands in the way: holding Start starts.
  void setPreflightPassed(bool passed);
  /// The present run, or the next one, can be held before a window.
  void setCanHold(bool canHold);
  /// A run was left. Resuming it is then what is offered first. @param isThere  it can be resumed
  /// by its method  @param reason  why it cannot be resumed now; empty: it can
  void setResume(bool isThere, const QString& reason);
  /// A run that this window does not stream: Stop is for it, and while it is watched, its state and
  /// progress are shown. Nothing: there is none.
  void setFound(const std::optional<FoundRunView>& found);
  /// The control may move something, whoever has started it: Stop can be pressed.
  void setMayMove(bool mayMove);
  /// Who is there may set the path override. @param maxPercent  the highest
  void setOverrideAllowed(bool isAllowed, double maxPercent);
  /// How soon the axes stand after Stop at worst, s; nothing: not known.
  void setStopWithin(const std::optional<double>& seconds);
  /// By how much the tool can be lifted while the run is held, mm; 0: not at all.
  void setLift(double mm);
  /// The run in progress or the last one has executed wrong points, which nobody has acknowledged.
  void setWrongMotion(bool hasWrongMotion);

  [[nodiscard]] bool isActive() const;
  /// In a narrow window it arranges itself anew, so the present arrangement does not count.
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void preflightRequested();
  void startRequested();
  void stopRequested();
  /// @param hold  false: continue
  void holdRequested(bool hold);
  /// A run that is held is to end: the axes execute what the control has of it.
  void endRequested();
  void overrideRequested(double percent);
  /// The tool is to be lifted by so much, mm; 0: lowered.
  void liftRequested(double mm);
  /// Nothing moves yet: the control is to be asked for the place.
  void resumeRequested();

 protected:
  void restyle() override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  enum class StopState { None, Requested, Confirmed, Unconfirmed };
  enum Figure { Line, Left, Stream, Executed, FigureCount };

  [[nodiscard]] std::array<QPushButton*, 6> buttons() const;
  void buildButtons();
  void buildFigures();
  void arrange();
  void requestStop();

  void showAll();
  void showButtons();
  void showStopNote();
  void showState();
  void showReason();
  void showFigures();
  void showCounters();
  void showPlace();
  /// Whether the points come in time, and how many moves the control has.
  void showStream();
  /// How much of the run is done, 0 to 1.
  [[nodiscard]] double doneShare() const;
  /// What has been executed, sent and accepted, of the points of this run.
  [[nodiscard]] streaming::Counters shownCounters() const;
  /// @param value  empty: not known  @param hint  what it is, or why it is not known
  void showFigure(Figure figure, const QString& value, const QString& hint,
                  Status status = Status::Plain);
  /// Hides the less important figures until the others fit.
  void fitFigures();
  [[nodiscard]] QString stopText() const;
  [[nodiscard]] static QString timeLeftText(const TimeLeft& left);
  /// Why a figure of a run that another computer streams is not known.
  [[nodiscard]] static QString elsewhereText();
  [[nodiscard]] QString waitingSentence() const;
  /// What there is to say of the feed cell; empty: nothing.
  [[nodiscard]] QString feedSentence() const;
  /// Hold and override act at once.
  [[nodiscard]] bool hasFeedCell() const;
  /// The axes stand, held, and the tool is not on the path.
  [[nodiscard]] bool isLifted() const;
  /// The run holds because of its live source, not of the operator.
  [[nodiscard]] bool isHeldBySource() const;
  /// "Running: stretch 3 of 12".
  [[nodiscard]] QString activeText() const;
  /// What the control does by itself, and when it obeys; empty: it does not.
  [[nodiscard]] QString nativeText() const;
  /// Shows the run on the control instead of one of this window.
  void showFoundState();
  /// The run that is shown is not of this window.
  [[nodiscard]] bool isWatching() const { return hasFound() && m_found->isWatched; }
  /// The control runs what another client streams, and this window streams nothing.
  [[nodiscard]] bool hasFound() const { return !isActive() && m_found && m_found->isOnControl(); }
  /// "Wrong motion", and how the run ended if it has.
  [[nodiscard]] QString wrongMotionText(const QString& end) const;

  streaming::LiveUpdate m_update;
  RunProgress m_where;
  std::optional<JobProgress> m_job;
  bool m_hasWrongMotion = false;
  StopState m_stopState = StopState::None;
  bool m_mayMove = false;
  std::size_t m_runBegin{0};
  /// Of the run in progress.
  struct Feed {
    std::optional<double> askedPercent;  ///< as override, last
    double liftMm = 0.0;                 ///< see `setLift`
    std::optional<double> stopWithinS;   ///< see `setStopWithin`
  };
  Feed m_feed;
  bool m_canHold = false;
  struct Starting {
    QString blocked;  ///< why it cannot start; empty: it can
    bool hasPassed = false;
  };
  Starting m_starting;
  struct Resuming {
    bool isOffered = false;
    QString blocked;
  };
  Resuming m_resuming;
  std::optional<FoundRunView> m_found;

  QGridLayout* m_rows;
  QWidget* m_state;  ///< state and reason
  StatusLabel* m_stateLabel;
  StatusLabel* m_reason;
  QWidget* m_left;
  QWidget* m_right;
  QBoxLayout* m_rightLayout;
  HoldButton* m_start;
  HoldButton* m_end;
  OverrideControl* m_override;
  QPushButton* m_lift = button({.id = "lift"});
  StopButton* m_stop;
  QPushButton* m_hold = button({.id = "hold"});
  QPushButton* m_resume = button({.text = QT_TR_NOOP("Resume …"), .icon = "resume", .id = "resume"},
                                 &RunPanel::resumeRequested);
  QWidget* m_figures;
  QProgressBar* m_progress;
  ElidedLabel* m_title;
  struct ShownFigure {
    QWidget* area = nullptr;
    QLabel* name = nullptr;
    StatusLabel* value = nullptr;
  };
  std::array<ShownFigure, FigureCount> m_shown{};
};

}  // namespace rivulet::widgets
