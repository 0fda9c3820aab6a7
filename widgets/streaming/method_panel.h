// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method, N, δ and feed, with the verdict on them: feasible or not, which equation limits, where
/// in the program, and the smallest change that helps.
/// @threadsafety GUI thread.
#pragma once

#include <optional>

#include "feasibility/verdict.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/start/stream_settings.h"
#include "widgets/common/page.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class WholeNumberField;

/// Largest feed to be suggested: just below the limit, rounded down to a value that an operator
/// would type.
/// @return mm/s; nothing if no such feed is left
[[nodiscard]] std::optional<double> offeredFeedMmPerS(double feedMmPerSMax);

/// "62 % (line 214: F 2,000 mm/min, 0.300 mm)"
[[nodiscard]] QString overrideLimitText(const streaming::OverrideLimit& limit);

/// The pauses of a run, as known before its start.
struct PauseSummary {
  std::size_t count = 0;
  std::size_t inCut = 0;
  std::optional<double> costS;   ///< nothing: not known yet
  std::optional<double> totalS;  ///< of the run, with them
};

/// The simulation of the program with the present settings.
struct RehearsalView {
  bool isDone = false;  ///< false: in progress
  std::size_t runs = 0;
  std::size_t faulty = 0;                ///< of these: executed wrong points
  std::size_t points = 0;                ///< that were simulated
  bool isWhole = false;                  ///< all of the program
  std::optional<double> safeFeedMmPerS;  ///< if runs failed: a feed at which none did

  [[nodiscard]] bool hasFailed() const { return faulty > 0; }
};

/// One sentence on it.
[[nodiscard]] QString rehearsalText(const RehearsalView& rehearsal);

class MethodPanel final : public Page {
  Q_OBJECT

 public:
  explicit MethodPanel(QWidget* parent = nullptr);

  /// Shows the settings; does not signal.
  void setSettings(const streaming::StreamSettings& settings);
  [[nodiscard]] streaming::StreamSettings settings() const { return m_settings; }
  /// @param verdict  nothing: not judged  @param problem  why it could not be judged
  void setVerdict(const std::optional<feasibility::Verdict>& verdict,
                  const std::optional<QString>& problem);
  /// The choice between the whole job and its motion alone. @param hasBlocks  the program has
  /// blocks that the machine needs beside the motion  @param isJob  the stretches of a job are
  /// streamed
  /// @param obstacle  why the program can only be streamed without them; empty: it can be a job
  void setJob(bool hasBlocks, bool isJob, const QString& obstacle);
  /// The points are those of a live source: its F are their feeds.
  void setLive(bool isLive);
  /// With the feeds of the program, before `setVerdict`. @param limit  nothing: one feed for all
  /// @param fastestMmPerS  largest feed of the program at 100 %
  void setOverrideLimit(const std::optional<streaming::OverrideLimit>& limit, double fastestMmPerS);
  /// Largest feed that may be typed: that of the machine.
  void setFeedMax(double feedMmPerS);
  /// The verdict is the stricter of both. @param rehearsal  nothing: there is none
  void setRehearsal(const std::optional<RehearsalView>& rehearsal);
  /// @param pauses  nothing: not known
  void setPauses(const std::optional<PauseSummary>& pauses);
  /// During a run nothing can be changed.
  void setEditable(bool editable);

 Q_SIGNALS:
  void settingsChanged(const rivulet::streaming::StreamSettings& settings);
  /// @param isWhole  false: the motion alone
  void jobChosen(bool isWhole);

 private:
  void buildSettings();
  void buildVerdict();
  void showSettings();
  void showVerdict();
  void showHeadline();
  /// The feed that is offered, by the stricter of equation and simulation.
  [[nodiscard]] std::optional<double> offeredFeed() const;
  /// The same as an override on the feeds of the program; whole percent.
  [[nodiscard]] std::optional<double> offeredOverride() const;
  void takeOffer();
  void takeOfferedDelta();
  void showOffer(const QString& reason);
  void showFeedFields();
  void showJob();
  void takeJob();
  void showLimit();
  [[nodiscard]] bool hasFailedRehearsal() const {
    return m_judged.rehearsal && m_judged.rehearsal->hasFailed();
  }
  void showPauses();
  void takeSettings();
  [[nodiscard]] QString equationText(feasibility::Equation equation) const;
  [[nodiscard]] bool usesDelta() const;
  [[nodiscard]] bool isWindow() const;

  streaming::StreamSettings m_settings;
  struct Judgement {
    std::optional<feasibility::Verdict> verdict;
    std::optional<QString> problem;
    std::optional<streaming::OverrideLimit> overrideLimit;
    double fastestMmPerS = 0.0;
    std::optional<PauseSummary> pauses;
    std::optional<RehearsalView> rehearsal;
  };
  Judgement m_judged;
  /// The choice between the whole job and its motion alone.
  struct Job {
    bool hasBlocks = false;
    bool isChosen = false;
    QString obstacle;
  };
  Job m_jobChoice;
  bool m_isLive = false;
  bool m_editable = true;
  bool m_isShowing = false;  ///< fields are being filled, not edited

  QGroupBox* m_settingsGroup = group({.text = QT_TR_NOOP("Method")});
  QComboBox* m_job =
      list({.items = {QT_TR_NOOP("Whole job"), QT_TR_NOOP("Motion only"), QT_TR_NOOP("Dry run")}});
  QComboBox* m_method = list(
      {.tip = QT_TR_NOOP(
           "Window: the machine waits if the client is late; it never executes a point twice. "
           "Position: the client watches the tool and replaces points it has passed. Signal: "
           "the client watches an R-parameter in which the program says which half of the loop may "
           "be replaced. Credit: like window, without a stop between windows; it starts only on "
           "a control that has passed the test on the page Credit test."),
       .items = {QT_TR_NOOP("Window"), QT_TR_NOOP("Position"), QT_TR_NOOP("Signal"),
                 QT_TR_NOOP("Credit (experimental)")},
       .id = "method"});
  struct Fields {
    WholeNumberField* points = nullptr;
    NumberField* delta = nullptr;
    NumberField* feed = nullptr;
    NumberField* overridePercent = nullptr;
    NumberField* correction = nullptr;
    NumberField* lift = nullptr;
    NumberField* height = nullptr;  ///< of a dry run
    QCheckBox* packed = nullptr;
    NumberField* tolerance = nullptr;
  };
  Fields m_fields;
  QComboBox* m_feedSource =
      list({.items = {QT_TR_NOOP("Of the program"), QT_TR_NOOP("One for all moves")}});
  QStackedWidget* m_rate;  ///< one of the two
  Form* m_form;
  QComboBox* m_layout =
      list({.items = {QT_TR_NOOP("With gaps (R11, R21 …)"), QT_TR_NOOP("In a row (R10 …)")}});
  QComboBox* m_access = list({.items = {QT_TR_NOOP("Automatic"), QT_TR_NOOP("Arrays, or no start"),
                                        QT_TR_NOOP("Lists"), QT_TR_NOOP("One by one")}});
  QCheckBox* m_byHand =
      checkBox({.text = QT_TR_NOOP("copied by hand"),
                .tip = QT_TR_NOOP(
                    "For a control that gives no right to its part programs: store the template "
                    "there, select it and press cycle start. The run waits until this is done."),
                .id = "by-hand"});

  QGroupBox* m_pausesGroup = group({.text = QT_TR_NOOP("Pauses")});
  QLabel* m_planned = value({.wraps = true});
  QLabel* m_cost = value({.wraps = true});

  QGroupBox* m_verdictGroup = group({.text = QT_TR_NOOP("Verdict")});
  StatusLabel* m_headline = status();
  QLabel* m_reason = label({.wraps = true});
  StatusLabel* m_rehearsalText = status({.wraps = true});
  Form* m_figures;
  QLabel* m_margin = value({.wraps = true});
  QLabel* m_limit = value({.wraps = true});
  QLabel* m_place = value({.wraps = true});
  QPushButton* m_useFeed = button({.icon = "apply"}, &MethodPanel::takeOffer);
  QPushButton* m_useDelta = button({.icon = "apply"}, &MethodPanel::takeOfferedDelta);
};

}  // namespace rivulet::widgets
