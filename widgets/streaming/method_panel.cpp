// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/method_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "job/dry_plan.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

using streaming::AccessPreference;

namespace {

constexpr double kFeedMmPerMinMin = 0.1;
constexpr double kPercent = 100.0;
/// Places in the choice of feeds.
constexpr int kFeedOfProgram = 0;
constexpr int kOneFeed = 1;
/// Places in the choice of what is run.
constexpr int kWholeJob = 0;
constexpr int kMotionOnly = 1;
constexpr int kDryRun = 2;
constexpr double kDryRunMm = 50.0;  ///< as it is offered first
constexpr double kDryRunMmMin = 1.0;

/// Smallest δ to be suggested: just above the limit, rounded up to 0.001 mm.
double offeredDeltaMm(double deltaMmMin) {
  return std::ceil(deltaMmMin * 1.001 * 1000.0) / 1000.0;
}

}  // namespace

std::optional<double> offeredFeedMmPerS(double feedMmPerSMax) {
  if (!std::isfinite(feedMmPerSMax)) {
    return std::nullopt;
  }
  const double limit = base::mmPerMinFromMmPerS(feedMmPerSMax) * 0.999;
  const double step = limit >= 1000.0 ? 10.0 : (limit >= 10.0 ? 1.0 : kFeedMmPerMinMin);
  const double offered = std::floor(limit / step) * step;
  if (offered < kFeedMmPerMinMin) {
    return std::nullopt;
  }
  return base::mmPerSFromMmPerMin(offered);
}

namespace {

struct LimitTexts {
  Q_DECLARE_TR_FUNCTIONS(LimitTexts)

 public:
  static QString percent(const streaming::OverrideLimit& limit) {
    return QStringLiteral("%1\u00A0%").arg(numberText(kPercent * limit.overrideFactor, 0));
  }
  static QString block(const streaming::OverrideLimit& limit) {
    const QString feed =
        limit.isRapid ? tr("rapid") : QStringLiteral("F\u00A0%1").arg(feedText(limit.feedMmPerS));
    return tr("line %1: %2, %3").arg(countText(limit.line.value), feed, lengthText(limit.stepMm));
  }
};

struct RehearsalTexts {
  Q_DECLARE_TR_FUNCTIONS(RehearsalTexts)

 public:
  static QString text(const RehearsalView& rehearsal) {
    if (!rehearsal.isDone) {
      return tr("The program is being simulated with these settings.");
    }
    const QString points =
        rehearsal.isWhole ? tr("all %1 points").arg(countText(rehearsal.points))
                          : tr("the %1 most difficult points").arg(countText(rehearsal.points));
    if (!rehearsal.hasFailed()) {
      return tr("Simulation of %1: no wrong point in %n runs.", nullptr,
                static_cast<int>(rehearsal.runs))
          .arg(points);
    }
    return tr("Simulation of %1: wrong points in %2 of %3 runs.")
        .arg(points, countText(rehearsal.faulty), countText(rehearsal.runs));
  }
};

}  // namespace

QString rehearsalText(const RehearsalView& rehearsal) {
  return RehearsalTexts::text(rehearsal);
}

QString overrideLimitText(const streaming::OverrideLimit& limit) {
  return QStringLiteral("%1 (%2)").arg(LimitTexts::percent(limit), LimitTexts::block(limit));
}

MethodPanel::MethodPanel(QWidget* parent)
    : Page(parent),
      m_fields{
          .points = whole(1, 9999),
          .delta =
              number({.min = 0.001, .max = 100.0, .step = 0.05, .unit = "mm"}, {.id = "delta"}),
          .feed = number({.min = kFeedMmPerMinMin,
                          .max = 40'000.0,
                          .decimals = 1,
                          .step = 50.0,
                          .unit = "mm/min"},
                         {.id = "feed"}),
          .overridePercent = number({.min = kPercent * gcode::kOverrideMin,
                                     .max = kPercent * gcode::kOverrideMax,
                                     .decimals = 0,
                                     .step = 5.0,
                                     .unit = "%"},
                                    {.id = "program-override"}),
          .correction = number(
              {.min = 0.0, .max = templates::kCorrectionLimitMmMax, .step = 0.01, .unit = "mm"},
              {.special = QT_TR_NOOP("none")}),
          .lift = number({.min = 0.0, .max = templates::kLiftMmMax, .step = 0.5, .unit = "mm"},
                         {.special = QT_TR_NOOP("none")}),
          .height = number({.min = kDryRunMmMin,
                            .max = job::kRaiseMmMax,
                            .decimals = 1,
                            .step = 10.0,
                            .unit = "mm"}),
          .packed = checkBox(
              {.text = QT_TR_NOOP("packed: one R-parameter each"),
               .tip = QT_TR_NOOP(
                   "All axes of a point share one R-parameter, in steps of 0.001 mm from the first "
                   "point of its window: a third of the accesses, so faster where the points are "
                   "dense. A control that calculates otherwise refuses the first window; nothing "
                   "moves then."),
               .id = "packed"}),
          .tolerance = number({.min = 0.0,
                               .max = gcode::kStreamToleranceMax,
                               .decimals = 4,
                               .step = 0.001,
                               .unit = "mm"},
                              {.special = QT_TR_NOOP("none"), .id = "tolerance"})},
      m_rate(new QStackedWidget),
      m_form(new Form(this, m_settingsGroup, Form::Height::Touch)),
      m_figures(new Form(this, nullptr)) {
  setMinimumWidth(330);
  buildSettings();
  buildVerdict();
  inColumn({m_settingsGroup, m_verdictGroup, m_pausesGroup, spring()}, this);
  onEdit({m_job, m_fields.height}, &MethodPanel::takeJob);
  onEdit({m_method, m_layout, m_access, m_byHand, m_fields.points, m_feedSource,
          m_fields.overridePercent, m_fields.delta, m_fields.correction, m_fields.lift,
          m_fields.feed, m_fields.packed, m_fields.tolerance},
         &MethodPanel::takeSettings);
  onLanguage(&MethodPanel::showSettings, &MethodPanel::showVerdict, &MethodPanel::showPauses);
}

void MethodPanel::buildSettings() {
  int item = 0;
  for (const base::MethodTraits& method : base::kMethods) {
    if (!method.sendsBlocks) {  // for comparison, on the command line
      m_method->setItemData(item++, static_cast<int>(method.kind));
    }
  }
  item = 0;
  for (const templates::Layout layout : {templates::Layout::Paper, templates::Layout::Contiguous}) {
    m_layout->setItemData(item++, static_cast<int>(layout));
  }
  item = 0;
  for (const AccessPreference access : {AccessPreference::Automatic, AccessPreference::Array,
                                        AccessPreference::List, AccessPreference::Single}) {
    m_access->setItemData(item++, static_cast<int>(access));
  }
  m_fields.height->setValue(kDryRunMm);
  m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_form->row({.text = QT_TR_NOOP("Run")}, m_job);
  m_form->row({.text = QT_TR_NOOP("Method")}, m_method);
  m_form->row({}, m_fields.points);
  m_form->row({.text = QT_TR_NOOP("Points")}, m_fields.packed);
  m_form->row({.text = QT_TR_NOOP("Tolerance"),
               .tip = QT_TR_NOOP(
                   "Straight moves that stay so near to the path take the place of many short "
                   "ones (rotary axes: degrees). Corners, feeds and the order of the path "
                   "stay. Not in whole jobs and live runs.")},
              m_fields.tolerance);
  m_form->row({.text = QT_TR_NOOP("δ (point reached)")}, m_fields.delta);
  m_form->row({.text = QT_TR_NOOP("Feed")}, m_feedSource);
  // One of the two is shown. A row of a form that was hidden gets no height back (Qt 6.4).
  m_rate->addWidget(m_fields.feed);
  m_rate->addWidget(m_fields.overridePercent);
  m_form->row({}, m_rate);
  m_form->row({.text = QT_TR_NOOP("R-parameters")}, m_layout);
  m_form->row({.text = QT_TR_NOOP("Correction up to"),
               .tip = QT_TR_NOOP("Largest correction of each axis during the run. The control must "
                                 "not add corrections up (MD36750 bit 0), and its own limit "
                                 "(SD43350) should not be larger.")},
              m_fields.correction);
  m_form->row(
      {.text = QT_TR_NOOP("Lift while paused"),
       .tip = QT_TR_NOOP("While the axes are held, the tool can be lifted by so much. The "
                         "control must not add overlays up (MD36750 bit 0), and its limit "
                         "(SD43350) must not be smaller. Not with a correction or in a whole "
                         "job; on a real control only after its stop test with a lift.")},
      m_fields.lift);
  m_form->row({.text = QT_TR_NOOP("Access")}, m_access);
  m_form->row({.text = QT_TR_NOOP("Template")}, m_byHand);
  m_form->insertRow(
      1, label({.text = QT_TR_NOOP("Above the workpiece"), .isTouch = true}, m_fields.height),
      m_fields.height);
  setTabOrder(m_job, m_fields.height);
  setTabOrder(m_fields.height, m_method);
}

void MethodPanel::buildVerdict() {
  auto* pauses = new Form(this, m_pausesGroup);
  pauses->row({.text = QT_TR_NOOP("Planned"),
               .tip = QT_TR_NOOP("Places where the axes will stop for a moment. Off the cut means "
                                 "after a rapid or a retract, or at a sharp corner; the path shows "
                                 "the places."),
               .isMuted = true},
              m_planned);
  pauses->row({.text = QT_TR_NOOP("Cost"),
               .tip = QT_TR_NOOP("Standstill, braking and acceleration, computed with the axes of "
                                 "the virtual machine"),
               .isMuted = true},
              m_cost);
  m_headline->setEmphasis(16.0, true);
  m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_figures->row({.text = QT_TR_NOOP("Margin"), .isMuted = true}, m_margin);
  m_figures->row({.text = QT_TR_NOOP("Largest feed"), .isMuted = true}, m_limit);
  m_figures->row({.text = QT_TR_NOOP("Limiting place"), .isMuted = true}, m_place);
  inColumn({m_headline, m_reason, m_rehearsalText, m_figures, m_useFeed, m_useDelta},
           m_verdictGroup);
}

void MethodPanel::takeOfferedDelta() {
  if (m_judged.verdict) {
    m_settings.deltaMm = offeredDeltaMm(m_judged.verdict->deltaMmMin);
    showSettings();
    Q_EMIT settingsChanged(m_settings);
  }
}

void MethodPanel::setSettings(const streaming::StreamSettings& settings) {
  m_settings = settings;
  showSettings();
}

void MethodPanel::setVerdict(const std::optional<feasibility::Verdict>& verdict,
                             const std::optional<QString>& problem) {
  m_judged.verdict = verdict;
  m_judged.problem = problem;
  showVerdict();
}

void MethodPanel::setOverrideLimit(const std::optional<streaming::OverrideLimit>& limit,
                                   double fastestMmPerS) {
  m_judged.overrideLimit = limit;
  m_judged.fastestMmPerS = fastestMmPerS;
}

void MethodPanel::setFeedMax(double feedMmPerS) {
  const bool wasShowing = std::exchange(m_isShowing, true);
  m_fields.feed->setMaximum(base::mmPerMinFromMmPerS(feedMmPerS));
  m_isShowing = wasShowing;
}

void MethodPanel::setRehearsal(const std::optional<RehearsalView>& rehearsal) {
  m_judged.rehearsal = rehearsal;
  showVerdict();
}

std::optional<double> MethodPanel::offeredFeed() const {
  if (!m_judged.verdict) {
    return std::nullopt;
  }
  const auto byEquation = offeredFeedMmPerS(m_judged.verdict->feedMmPerSMax);
  if (!hasFailedRehearsal()) {
    return byEquation;
  }
  const auto bySimulation = m_judged.rehearsal->safeFeedMmPerS
                                ? offeredFeedMmPerS(*m_judged.rehearsal->safeFeedMmPerS)
                                : std::nullopt;
  return byEquation && bySimulation ? std::optional(std::min(*byEquation, *bySimulation))
                                    : std::nullopt;
}

std::optional<double> MethodPanel::offeredOverride() const {
  if (!m_judged.overrideLimit || !(m_judged.fastestMmPerS > 0.0)) {
    return std::nullopt;
  }
  double factor = m_judged.overrideLimit->overrideFactor;
  if (hasFailedRehearsal()) {
    factor =
        std::min(factor, m_judged.rehearsal->safeFeedMmPerS.value_or(0.0) / m_judged.fastestMmPerS);
  }
  const double offered = std::floor(kPercent * factor * 0.999) / kPercent;
  return offered >= gcode::kOverrideMin ? std::optional(std::min(offered, gcode::kOverrideMax))
                                        : std::nullopt;
}

void MethodPanel::takeOffer() {
  if (m_settings.usesProgramFeeds()) {
    m_settings.overrideFactor = offeredOverride().value_or(m_settings.overrideFactor);
  } else {
    m_settings.feedMmPerS = offeredFeed().value_or(m_settings.feedMmPerS);
  }
  showSettings();
  Q_EMIT settingsChanged(m_settings);
}

void MethodPanel::setPauses(const std::optional<PauseSummary>& pauses) {
  m_judged.pauses = pauses;
  showPauses();
}

void MethodPanel::setEditable(bool editable) {
  m_editable = editable;
  showSettings();
  showVerdict();
}

bool MethodPanel::usesDelta() const {
  return base::usesDelta(m_settings.parameters.method);
}

bool MethodPanel::isWindow() const {
  return base::hasWindows(m_settings.parameters.method);
}

void MethodPanel::showSettings() {
  const bool wasShowing = std::exchange(m_isShowing, true);
  m_method->setCurrentIndex(m_method->findData(static_cast<int>(m_settings.parameters.method)));
  m_layout->setCurrentIndex(m_layout->findData(static_cast<int>(m_settings.parameters.layout)));
  m_access->setCurrentIndex(m_access->findData(static_cast<int>(m_settings.access)));
  m_byHand->setChecked(m_settings.transferByHand);
  m_fields.points->setValue(m_settings.parameters.pointsPerLoop);
  m_fields.delta->setValue(m_settings.deltaMm);
  m_fields.feed->setValue(base::mmPerMinFromMmPerS(m_settings.feedMmPerS));
  showFeedFields();
  showJob();
  for (QWidget* field : {static_cast<QWidget*>(m_method), static_cast<QWidget*>(m_fields.points),
                         static_cast<QWidget*>(m_fields.feed), static_cast<QWidget*>(m_access),
                         static_cast<QWidget*>(m_byHand)}) {
    field->setEnabled(m_editable);
  }
  const bool window = isWindow();
  m_form->label(m_fields.points)
      ->setText(window ? tr("N (points per window)") : tr("N (points per loop)"));
  m_layout->setEnabled(m_editable && !window);
  m_layout->setToolTip(window ? tr("Windows have a layout of their own") : QString());
  m_access->setToolTip(
      window ? tr("Automatic: before anything moves, the forms of access are tested on the control "
                  "and the best one is used. The report names it.")
             : tr("Automatic: lists, as this method was published. Arrays need the contiguous "
                  "layout."));
  m_fields.correction->setValue(m_settings.parameters.correctionLimitMm);
  m_fields.correction->setEnabled(m_editable && window);
  m_fields.lift->setValue(m_settings.parameters.liftMm);
  m_fields.lift->setEnabled(m_editable && window);
  m_fields.packed->setChecked(m_settings.parameters.packed);
  m_fields.packed->setEnabled(m_editable && window);
  m_fields.tolerance->setValue(m_settings.tolerance);
  m_fields.tolerance->setEnabled(m_editable && !m_isLive);
  m_fields.delta->setEnabled(m_editable && usesDelta());
  m_form->setTip(m_fields.delta,
                 usesDelta()
                     ? tr("Distance from the tool at which a point counts as reached")
                     : tr("This method does not use δ: it watches an R-parameter, not the tool"));
  m_isShowing = wasShowing;
}

void MethodPanel::showFeedFields() {
  const bool isPublished = base::isPublished(m_settings.parameters.method);
  const bool ofProgram = m_settings.usesProgramFeeds();
  m_feedSource->setCurrentIndex(ofProgram ? kFeedOfProgram : kOneFeed);
  m_feedSource->setEnabled(m_editable && !isPublished && !m_isLive);
  m_form->setTip(
      m_feedSource,
      m_isLive ? tr("The points of a live source have feeds of their own.")
      : isPublished
          ? tr("This method has one feed for all moves, as it was published")
          : tr("Of the program: each move has the feed of its own block, rapids are rapids. "
               "One for all moves: rapids have it, too."));
  m_fields.overridePercent->setValue(kPercent * m_settings.overrideFactor);
  m_fields.overridePercent->setEnabled(m_editable && !m_isLive);
  m_fields.feed->setEnabled(m_editable && !m_isLive);
  const QString name = ofProgram ? tr("Override") : tr("F (path feed)");
  QWidget* const shown =
      ofProgram ? static_cast<QWidget*>(m_fields.overridePercent) : m_fields.feed;
  m_rate->setCurrentWidget(shown);
  shown->setAccessibleName(name);
  m_form->label(m_rate)->setText(name);
  m_form->label(m_rate)->setBuddy(shown);
  m_form->setTip(m_rate, ofProgram ? tr("Scales the feeds of the program, and its rapids up to the "
                                        "rapid feed of the machine")
                                   : QString());
}

void MethodPanel::setLive(bool isLive) {
  if (isLive != m_isLive) {
    m_isLive = isLive;
    showSettings();
  }
}

void MethodPanel::setJob(bool hasBlocks, bool isJob, const QString& obstacle) {
  m_jobChoice.hasBlocks = hasBlocks;
  m_jobChoice.isChosen = isJob;
  m_jobChoice.obstacle = obstacle;
  showSettings();
}

void MethodPanel::takeJob() {
  if (m_isShowing) {
    return;
  }
  if (m_job->currentIndex() == kDryRun) {
    m_settings.wholeJob = true;
    m_settings.dryRunMm = m_fields.height->value();
    showSettings();
    Q_EMIT settingsChanged(m_settings);
    return;
  }
  m_settings.dryRunMm = 0.0;
  m_jobChoice.isChosen = m_job->currentIndex() == kWholeJob;  // the program is read so
  Q_EMIT jobChosen(m_jobChoice.isChosen);
}

void MethodPanel::showJob() {
  const bool isDry = m_settings.dryRunMm > 0.0;
  m_form->setRowVisible(m_job, m_jobChoice.hasBlocks || isDry);
  m_form->setRowVisible(m_fields.height, isDry);
  m_fields.height->setEnabled(m_editable);
  if (isDry) {
    m_fields.height->setValue(m_settings.dryRunMm);
  }
  m_job->setCurrentIndex(isDry ? kDryRun : m_jobChoice.isChosen ? kWholeJob : kMotionOnly);
  m_job->setEnabled(m_editable && (m_jobChoice.obstacle.isEmpty() || isDry));
  m_form->setTip(
      m_job,
      !m_jobChoice.obstacle.isEmpty()
          ? m_jobChoice.obstacle
          : tr("Whole job: the control executes tools, spindle, coolant, cycles and retracts at "
               "their place, and Rivulet streams the motion between them. Motion only: these "
               "blocks are left out. Dry run: the whole job above the workpiece, without spindle "
               "and coolant."));
}

void MethodPanel::takeSettings() {
  if (m_isShowing) {
    return;
  }
  m_settings.parameters.method = static_cast<base::MethodKind>(m_method->currentData().toInt());
  m_settings.parameters.layout = static_cast<templates::Layout>(m_layout->currentData().toInt());
  m_settings.access = static_cast<AccessPreference>(m_access->currentData().toInt());
  m_settings.transferByHand = m_byHand->isChecked();
  m_settings.parameters.pointsPerLoop = m_fields.points->value();
  m_settings.parameters.correctionLimitMm = isWindow() ? m_fields.correction->value() : 0.0;
  m_settings.parameters.liftMm = isWindow() ? m_fields.lift->value() : 0.0;
  m_settings.parameters.packed = isWindow() && m_fields.packed->isChecked();
  // The fields round; a value the operator did not touch keeps its digits.
  if (std::abs(m_fields.tolerance->value() - m_settings.tolerance) > 5e-5) {
    m_settings.tolerance = m_fields.tolerance->value();
  }
  if (std::abs(m_fields.delta->value() - m_settings.deltaMm) > 5e-4) {
    m_settings.deltaMm = m_fields.delta->value();
  }
  if (!base::isPublished(m_settings.parameters.method) && m_feedSource->isEnabled()) {
    m_settings.programFeeds = m_feedSource->currentIndex() == kFeedOfProgram;
  }
  if (std::abs(m_fields.overridePercent->value() - kPercent * m_settings.overrideFactor) > 0.5) {
    m_settings.overrideFactor = m_fields.overridePercent->value() / kPercent;
  }
  const double feedMmPerS = base::mmPerSFromMmPerMin(m_fields.feed->value());
  if (std::abs(feedMmPerS - m_settings.feedMmPerS) > base::mmPerSFromMmPerMin(0.05)) {
    m_settings.feedMmPerS = feedMmPerS;
  }
  showSettings();
  Q_EMIT settingsChanged(m_settings);
}

QString MethodPanel::equationText(feasibility::Equation equation) const {
  switch (equation) {
    case feasibility::Equation::PointDistance:
      return tr("Equation (1): the tool must not pass a point between two polls.");
    case feasibility::Equation::Delta:
      return tr("Equation (2): the tool must be seen within δ of each point.");
    case feasibility::Equation::Window:
      return tr("Equation (3): half a loop must be written before the tool has used it up.");
    case feasibility::Equation::RealWindow:
      return tr(
          "Equation (3) with the real path: half a loop must be written before the tool has "
          "used it up.");
    case feasibility::Equation::Reach:
      return tr("Reach: the next window must be written while the tool executes the current one.");
    case feasibility::Equation::Machine:
      return tr("Machine: requests and motion of this machine, followed through the program.");
  }
  return {};
}

void MethodPanel::showPauses() {
  m_planned->setText(m_judged.pauses ? tr("%1, of them %2 in the cut")
                                           .arg(countText(m_judged.pauses->count),
                                                countText(m_judged.pauses->inCut))
                                     : noValue());
  if (m_judged.pauses && m_judged.pauses->costS && m_judged.pauses->totalS) {
    m_cost->setText(
        tr("%1 of %2")
            .arg(secondsText(*m_judged.pauses->costS), durationText(*m_judged.pauses->totalS)));
  } else {
    m_cost->setText(m_judged.pauses ? tr("computing …") : noValue());
  }
}

void MethodPanel::showHeadline() {
  if (m_judged.rehearsal) {
    m_rehearsalText->setStatus(hasFailedRehearsal()         ? Status::Fault
                               : m_judged.rehearsal->isDone ? Status::Good
                                                            : Status::Busy,
                               rehearsalText(*m_judged.rehearsal));
  }
  if (hasFailedRehearsal()) {
    m_headline->setStatus(Status::Fault, tr("Not feasible"));
  } else if (m_judged.rehearsal && !m_judged.rehearsal->isDone) {
    m_headline->setStatus(Status::Busy, tr("Checking …"));
  } else if (m_judged.verdict->waits) {
    m_headline->setStatus(Status::Attention, tr("Safe, with waiting"));
  } else {
    m_headline->setStatus(m_judged.verdict->feasible ? Status::Good : Status::Fault,
                          m_judged.verdict->feasible ? tr("Feasible") : tr("Not feasible"));
  }
}

void MethodPanel::showLimit() {
  const auto& place = m_judged.verdict->limiting.place;
  if (m_judged.overrideLimit) {
    m_figures->label(m_limit)->setText(tr("Largest override"));
    m_limit->setText(LimitTexts::percent(*m_judged.overrideLimit));
    m_place->setText(LimitTexts::block(*m_judged.overrideLimit));
    return;
  }
  m_figures->label(m_limit)->setText(isWindow() ? tr("Largest feed without waiting")
                                                : tr("Largest feed"));
  m_limit->setText(feedText(m_judged.verdict->feedMmPerSMax));
  if (!place || place->lastLine.value == 0) {
    m_place->setText(noValue());
  } else if (place->firstLine == place->lastLine) {
    m_place->setText(tr("line %1").arg(countText(place->lastLine.value)));
  } else {
    m_place->setText(
        tr("lines %1–%2").arg(countText(place->firstLine.value), countText(place->lastLine.value)));
  }
}

void MethodPanel::showOffer(const QString& reason) {
  const bool ofProgram = m_settings.usesProgramFeeds();
  const auto factor = ofProgram ? offeredOverride() : std::nullopt;
  const auto feed = ofProgram ? std::nullopt : offeredFeed();
  if (factor || feed) {
    m_useFeed->setText(factor
                           ? tr("Use override = %1\u00A0%").arg(numberText(kPercent * *factor, 0))
                           : tr("Use F = %1").arg(feedText(*feed)));
    m_useFeed->setVisible(true);
    m_useFeed->setEnabled(m_editable);
  } else if (!hasFailedRehearsal()) {
    m_reason->setText(reason + QLatin1Char('\n') +
                      tr("No feed is slow enough: two points of the program nearly coincide."));
  }
}

void MethodPanel::showVerdict() {
  const bool judged = m_judged.verdict.has_value();
  for (QLabel* figure : {m_margin, m_limit, m_place}) {
    m_figures->setRowVisible(figure, judged);
  }
  m_useFeed->hide();
  m_useDelta->hide();
  m_rehearsalText->setVisible(judged && m_judged.rehearsal);
  if (!judged) {
    const bool isProblem = m_judged.problem && !m_judged.problem->isEmpty();
    m_headline->setStatus(isProblem && !m_isLive ? Status::Attention : Status::Unknown,
                          tr("Not judged"));
    m_reason->setText(isProblem ? *m_judged.problem : tr("Load a program to get a verdict."));
    return;
  }

  showHeadline();
  const bool waits = m_judged.verdict->waits;
  showLimit();
  const feasibility::Condition& limiting = m_judged.verdict->limiting;
  QString reason = (waits                        ? tr("The machine will wait for points: %1")
                    : m_judged.verdict->feasible ? tr("Closest limit: %1")
                                                 : tr("Violated: %1"))
                       .arg(equationText(limiting.equation));
  if (m_judged.problem && !m_judged.problem->isEmpty()) {
    reason += QLatin1Char('\n') + *m_judged.problem;
  }
  m_reason->setText(reason);
  m_margin->setText((isWindow() ? tr("%1 × (waits below 1)") : tr("%1 × (must exceed 1)"))
                        .arg(factorText(limiting.margin)));
  if (m_judged.verdict->feasible && !waits && !hasFailedRehearsal()) {
    return;
  }
  // A larger δ costs no time, so it is suggested first if it is enough alone.
  const bool onlyDelta =
      std::none_of(m_judged.verdict->conditions.begin(), m_judged.verdict->conditions.end(),
                   [](const feasibility::Condition& condition) {
                     return condition.decides && condition.margin <= 1.0 &&
                            condition.equation != feasibility::Equation::Delta;
                   });
  if (usesDelta() && onlyDelta && !m_judged.verdict->feasible &&
      m_judged.verdict->deltaMmMin > 0.0) {
    m_useDelta->setText(
        tr("Use δ = %1").arg(lengthText(offeredDeltaMm(m_judged.verdict->deltaMmMin))));
    m_useDelta->setVisible(true);
    m_useDelta->setEnabled(m_editable);
  }
  showOffer(reason);
}

}  // namespace rivulet::widgets
