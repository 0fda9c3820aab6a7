// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/method_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "job/dry_plan.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

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
      m_settingsGroup(new QGroupBox(this)),
      m_jobLabel(new QLabel(this)),
      m_job(new QComboBox(this)),
      m_methodLabel(new QLabel(this)),
      m_method(new QComboBox(this)),
      m_pointsLabel(new QLabel(this)),
      m_points(new WholeNumberField(this)),
      m_deltaLabel(new QLabel(this)),
      m_delta(new NumberField(this)),
      m_feedSourceLabel(new QLabel(this)),
      m_feedSource(new QComboBox(this)),
      m_feedLabel(new QLabel(this)),
      m_feed(new NumberField(this)),
      m_overrideLabel(new QLabel(this)),
      m_override(new NumberField(this)),
      m_layoutLabel(new QLabel(this)),
      m_layout(new QComboBox(this)),
      m_correctionLabel(new QLabel(this)),
      m_correction(new NumberField(this)),
      m_heightLabel(new QLabel(this)),
      m_height(new NumberField(this)),
      m_accessLabel(new QLabel(this)),
      m_access(new QComboBox(this)),
      m_transferLabel(new QLabel(this)),
      m_byHand(new QCheckBox(this)),
      m_pausesGroup(new QGroupBox(this)),
      m_plannedLabel(new QLabel(this)),
      m_planned(makeValueLabel(this)),
      m_costLabel(new QLabel(this)),
      m_cost(makeValueLabel(this)),
      m_verdictGroup(new QGroupBox(this)),
      m_headline(new StatusLabel(this)),
      m_reason(new QLabel(this)),
      m_rehearsalText(new StatusLabel(this)),
      m_marginLabel(new QLabel(this)),
      m_margin(makeValueLabel(this)),
      m_limitLabel(new QLabel(this)),
      m_limit(makeValueLabel(this)),
      m_placeLabel(new QLabel(this)),
      m_place(makeValueLabel(this)),
      m_useFeed(makeTouchButton(this)),
      m_useDelta(makeTouchButton(this)) {
  setMinimumWidth(330);
  buildSettings();
  buildVerdict();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_settingsGroup);
  layout->addWidget(m_verdictGroup);
  layout->addWidget(m_pausesGroup);
  layout->addStretch();

  connectFields();
  retranslate();
  restyle();
}

void MethodPanel::buildSettings() {
  for (const base::MethodTraits& method : base::kMethods) {
    if (!method.sendsBlocks) {  // for comparison, on the command line
      m_method->addItem(QString(), static_cast<int>(method.kind));
    }
  }
  for (const templates::Layout layout : {templates::Layout::Paper, templates::Layout::Contiguous}) {
    m_layout->addItem(QString(), static_cast<int>(layout));
  }
  for (const AccessPreference access : {AccessPreference::Automatic, AccessPreference::Array,
                                        AccessPreference::List, AccessPreference::Single}) {
    m_access->addItem(QString(), static_cast<int>(access));
  }
  m_method->setObjectName(QStringLiteral("method"));
  m_points->setRange(1, 9999);
  m_delta->setDecimals(3);
  m_delta->setRange(0.001, 100.0);
  m_delta->setSingleStep(0.05);
  m_delta->setSuffix(QStringLiteral("\u00A0mm"));
  m_feed->setDecimals(1);
  m_feed->setMinimum(kFeedMmPerMinMin);
  setFeedMax(base::mmPerSFromMmPerMin(40'000.0));
  m_feed->setSingleStep(50.0);
  m_feed->setSuffix(QStringLiteral("\u00A0mm/min"));
  m_feedSource->addItems({QString(), QString()});
  m_job->addItems({QString(), QString(), QString()});
  m_height->setDecimals(1);
  m_height->setRange(kDryRunMmMin, job::kRaiseMmMax);
  m_height->setSingleStep(10.0);
  m_height->setSuffix(QStringLiteral("\u00A0mm"));
  m_height->setValue(kDryRunMm);
  m_override->setDecimals(0);
  m_override->setRange(kPercent * gcode::kOverrideMin, kPercent * gcode::kOverrideMax);
  m_override->setSingleStep(5.0);
  m_override->setSuffix(QStringLiteral("\u00A0%"));
  m_correction->setDecimals(3);
  m_correction->setRange(0.0, templates::kCorrectionLimitMmMax);
  m_correction->setSingleStep(0.01);
  m_correction->setSuffix(QStringLiteral("\u00A0mm"));
  auto* form = m_form = new QFormLayout(m_settingsGroup);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setHorizontalSpacing(16);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  const auto addRow = [form](QLabel* label, QWidget* field) {
    label->setMinimumHeight(kTouchHeightPx);
    label->setBuddy(field);
    form->addRow(label, field);
  };
  addRow(m_jobLabel, m_job);
  addRow(m_methodLabel, m_method);
  addRow(m_pointsLabel, m_points);
  addRow(m_deltaLabel, m_delta);
  addRow(m_feedSourceLabel, m_feedSource);
  addRow(m_feedLabel, m_feed);
  addRow(m_overrideLabel, m_override);  // one of these two is shown
  addRow(m_layoutLabel, m_layout);
  addRow(m_correctionLabel, m_correction);
  addRow(m_accessLabel, m_access);
  addRow(m_transferLabel, m_byHand);
  m_heightLabel->setMinimumHeight(kTouchHeightPx);
  m_heightLabel->setBuddy(m_height);
  form->insertRow(1, m_heightLabel, m_height);
  setTabOrder(m_job, m_height);
  setTabOrder(m_height, m_method);
}

void MethodPanel::buildVerdict() {
  m_planned->setWordWrap(true);
  m_cost->setWordWrap(true);
  auto* pauses = new QFormLayout(m_pausesGroup);
  pauses->setLabelAlignment(Qt::AlignLeft);
  pauses->setHorizontalSpacing(16);
  pauses->setRowWrapPolicy(QFormLayout::WrapLongRows);
  pauses->addRow(m_plannedLabel, m_planned);
  pauses->addRow(m_costLabel, m_cost);

  m_headline->setEmphasis(16.0, true);
  m_reason->setWordWrap(true);
  m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_place->setWordWrap(true);
  m_limit->setWordWrap(true);
  m_margin->setWordWrap(true);
  auto* figures = new QFormLayout;
  figures->setLabelAlignment(Qt::AlignLeft);
  figures->setHorizontalSpacing(16);
  figures->setRowWrapPolicy(QFormLayout::WrapLongRows);
  figures->addRow(m_marginLabel, m_margin);
  figures->addRow(m_limitLabel, m_limit);
  figures->addRow(m_placeLabel, m_place);
  auto* verdict = new QVBoxLayout(m_verdictGroup);
  verdict->addWidget(m_headline);
  verdict->addWidget(m_reason);
  verdict->addWidget(m_rehearsalText);
  m_rehearsalText->setWordWrap(true);
  verdict->addLayout(figures);
  verdict->addWidget(m_useFeed);
  verdict->addWidget(m_useDelta);
}

void MethodPanel::connectFields() {
  connect(m_job, &QComboBox::currentIndexChanged, this, &MethodPanel::takeJob);
  connect(m_height, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeJob);
  connect(m_method, &QComboBox::currentIndexChanged, this, &MethodPanel::takeSettings);
  connect(m_layout, &QComboBox::currentIndexChanged, this, &MethodPanel::takeSettings);
  connect(m_access, &QComboBox::currentIndexChanged, this, &MethodPanel::takeSettings);
  connect(m_byHand, &QCheckBox::toggled, this, &MethodPanel::takeSettings);
  connect(m_points, &QSpinBox::valueChanged, this, &MethodPanel::takeSettings);
  connect(m_feedSource, &QComboBox::currentIndexChanged, this, &MethodPanel::takeSettings);
  connect(m_override, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeSettings);
  connect(m_delta, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeSettings);
  connect(m_correction, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeSettings);
  connect(m_feed, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeSettings);
  connect(m_useFeed, &QPushButton::clicked, this, &MethodPanel::takeOffer);
  connect(m_useDelta, &QPushButton::clicked, this, [this] {
    if (m_verdict) {
      m_settings.deltaMm = offeredDeltaMm(m_verdict->deltaMmMin);
      showSettings();
      Q_EMIT settingsChanged(m_settings);
    }
  });
}

void MethodPanel::setSettings(const streaming::StreamSettings& settings) {
  m_settings = settings;
  showSettings();
}

void MethodPanel::setVerdict(const std::optional<feasibility::Verdict>& verdict,
                             const std::optional<QString>& problem) {
  m_verdict = verdict;
  m_problem = problem;
  showVerdict();
}

void MethodPanel::setOverrideLimit(const std::optional<streaming::OverrideLimit>& limit,
                                   double fastestMmPerS) {
  m_overrideLimit = limit;
  m_fastestMmPerS = fastestMmPerS;
}

void MethodPanel::setFeedMax(double feedMmPerS) {
  const bool wasShowing = std::exchange(m_isShowing, true);
  m_feed->setMaximum(base::mmPerMinFromMmPerS(feedMmPerS));
  m_isShowing = wasShowing;
}

void MethodPanel::setRehearsal(const std::optional<RehearsalView>& rehearsal) {
  m_rehearsal = rehearsal;
  showVerdict();
}

std::optional<double> MethodPanel::offeredFeed() const {
  if (!m_verdict) {
    return std::nullopt;
  }
  const auto byEquation = offeredFeedMmPerS(m_verdict->feedMmPerSMax);
  if (!hasFailedRehearsal()) {
    return byEquation;
  }
  const auto bySimulation =
      m_rehearsal->safeFeedMmPerS ? offeredFeedMmPerS(*m_rehearsal->safeFeedMmPerS) : std::nullopt;
  return byEquation && bySimulation ? std::optional(std::min(*byEquation, *bySimulation))
                                    : std::nullopt;
}

std::optional<double> MethodPanel::offeredOverride() const {
  if (!m_overrideLimit || !(m_fastestMmPerS > 0.0)) {
    return std::nullopt;
  }
  double factor = m_overrideLimit->overrideFactor;
  if (hasFailedRehearsal()) {
    factor = std::min(factor, m_rehearsal->safeFeedMmPerS.value_or(0.0) / m_fastestMmPerS);
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
  m_pauses = pauses;
  showPauses();
}

void MethodPanel::setEditable(bool editable) {
  m_editable = editable;
  showSettings();
  showVerdict();
}

void MethodPanel::retranslate() {
  const bool wasShowing = std::exchange(m_isShowing, true);
  m_settingsGroup->setTitle(tr("Method"));
  m_jobLabel->setText(tr("Run"));
  m_job->setItemText(kWholeJob, tr("Whole job"));
  m_job->setItemText(kMotionOnly, tr("Motion only"));
  m_job->setItemText(kDryRun, tr("Dry run"));
  m_heightLabel->setText(tr("Above the workpiece"));
  m_methodLabel->setText(tr("Method"));
  m_method->setItemText(0, tr("Window"));
  m_method->setItemText(1, tr("Position"));
  m_method->setItemText(2, tr("Signal"));
  m_method->setItemText(3, tr("Credit (experimental)"));
  m_method->setToolTip(
      tr("Window: the machine waits if the client is late; it never executes a point twice. "
         "Position: the client watches the tool and replaces points it has passed. Signal: the "
         "client watches a cell in which the program says which half of the loop may be replaced. "
         "Credit: like window, without a stop between windows; it starts only on a control that "
         "has passed the test on the page Credit test."));
  m_deltaLabel->setText(tr("δ (point reached)"));
  m_feedSourceLabel->setText(tr("Feed"));
  m_feedSource->setItemText(kFeedOfProgram, tr("Of the program"));
  m_feedSource->setItemText(kOneFeed, tr("One for all moves"));
  m_overrideLabel->setText(tr("Override"));
  m_override->setToolTip(
      tr("Scales the feeds of the program, and its rapids up to the rapid feed of the machine"));
  m_overrideLabel->setToolTip(m_override->toolTip());
  m_feedLabel->setText(tr("F (path feed)"));
  m_layoutLabel->setText(tr("Cells"));
  m_correctionLabel->setText(tr("Correction up to"));
  m_correction->setSpecialValueText(tr("none"));
  m_correction->setToolTip(
      tr("Largest correction of each axis during the run. The control must not add corrections up "
         "(MD36750 bit 0), and its own limit (SD43350) should not be larger."));
  m_correctionLabel->setToolTip(m_correction->toolTip());
  m_layout->setItemText(0, tr("Paper (R11, R21 …)"));
  m_layout->setItemText(1, tr("Contiguous (R10 …)"));
  m_accessLabel->setText(tr("Access"));
  m_access->setItemText(0, tr("Automatic"));
  m_access->setItemText(1, tr("Arrays, or no start"));
  m_access->setItemText(2, tr("Lists"));
  m_access->setItemText(3, tr("One by one"));
  m_transferLabel->setText(tr("Template"));
  m_byHand->setText(tr("copied by hand"));
  m_byHand->setToolTip(
      tr("For a control that gives no right to its part programs: store the template there, select "
         "it and press cycle start. The run waits until this is done."));
  m_isShowing = wasShowing;
  m_pausesGroup->setTitle(tr("Pauses"));
  m_plannedLabel->setText(tr("Planned"));
  m_plannedLabel->setToolTip(
      tr("Places where the axes will stop for a moment. Off the cut means after a rapid or a "
         "retract, or at a sharp corner; the path shows the places."));
  m_costLabel->setText(tr("Cost"));
  m_costLabel->setToolTip(
      tr("Standstill, braking and acceleration, computed with the axes of the virtual machine"));
  m_verdictGroup->setTitle(tr("Verdict"));
  m_marginLabel->setText(tr("Margin"));
  m_limitLabel->setText(tr("Largest feed"));
  m_placeLabel->setText(tr("Limiting place"));
  showSettings();
  showVerdict();
  showPauses();
}

void MethodPanel::restyle() {
  const QColor color = themeColors(palette()).text;
  m_useFeed->setIcon(themedIcon(QStringLiteral("apply"), color));
  m_useDelta->setIcon(themedIcon(QStringLiteral("apply"), color));
  for (QLabel* label : {m_marginLabel, m_limitLabel, m_placeLabel, m_plannedLabel, m_costLabel}) {
    setMuted(label, palette());
  }
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
  m_points->setValue(m_settings.parameters.pointsPerLoop);
  m_delta->setValue(m_settings.deltaMm);
  m_feed->setValue(base::mmPerMinFromMmPerS(m_settings.feedMmPerS));
  showFeedFields();
  showJob();
  for (QWidget* field : {static_cast<QWidget*>(m_method), static_cast<QWidget*>(m_points),
                         static_cast<QWidget*>(m_feed), static_cast<QWidget*>(m_access),
                         static_cast<QWidget*>(m_byHand)}) {
    field->setEnabled(m_editable);
  }
  const bool window = isWindow();
  m_pointsLabel->setText(window ? tr("N (points per window)") : tr("N (points per loop)"));
  m_layout->setEnabled(m_editable && !window);
  m_layout->setToolTip(window ? tr("Windows have a layout of their own") : QString());
  m_access->setToolTip(
      window ? tr("Automatic: before anything moves, the forms of access are tested on the control "
                  "and the best one is used. The report names it.")
             : tr("Automatic: lists, as this method was published. Arrays need the contiguous "
                  "layout."));
  m_correction->setValue(m_settings.parameters.correctionLimitMm);
  m_correction->setEnabled(m_editable && window);
  m_delta->setEnabled(m_editable && usesDelta());
  m_delta->setToolTip(usesDelta()
                          ? tr("Distance from the tool at which a point counts as reached")
                          : tr("This method does not use δ: it watches a cell, not the tool"));
  m_deltaLabel->setToolTip(m_delta->toolTip());
  m_isShowing = wasShowing;
}

void MethodPanel::showFeedFields() {
  const bool isPublished = base::isPublished(m_settings.parameters.method);
  const bool ofProgram = m_settings.usesProgramFeeds();
  m_feedSource->setCurrentIndex(ofProgram ? kFeedOfProgram : kOneFeed);
  m_feedSource->setEnabled(m_editable && !isPublished && !m_isLive);
  m_feedSource->setToolTip(
      m_isLive ? tr("The points of a live source have feeds of their own.")
      : isPublished
          ? tr("This method has one feed for all moves, as it was published")
          : tr("Of the program: each move has the feed of its own block, rapids are rapids. "
               "One for all moves: rapids have it, too."));
  m_feedSourceLabel->setToolTip(m_feedSource->toolTip());
  m_override->setValue(kPercent * m_settings.overrideFactor);
  m_override->setEnabled(m_editable && !m_isLive);
  m_feed->setEnabled(m_editable && !m_isLive);
  m_form->setRowVisible(m_override, ofProgram);
  m_form->setRowVisible(m_feed, !ofProgram);
}

void MethodPanel::setLive(bool isLive) {
  if (isLive != m_isLive) {
    m_isLive = isLive;
    showSettings();
  }
}

void MethodPanel::setJob(bool hasBlocks, bool isJob, const QString& obstacle) {
  m_hasBlocks = hasBlocks;
  m_isJob = isJob;
  m_jobObstacle = obstacle;
  showSettings();
}

void MethodPanel::takeJob() {
  if (m_isShowing) {
    return;
  }
  if (m_job->currentIndex() == kDryRun) {
    m_settings.wholeJob = true;
    m_settings.dryRunMm = m_height->value();
    showSettings();
    Q_EMIT settingsChanged(m_settings);
    return;
  }
  m_settings.dryRunMm = 0.0;
  m_isJob = m_job->currentIndex() == kWholeJob;  // the program is read so
  Q_EMIT jobChosen(m_isJob);
}

void MethodPanel::showJob() {
  const bool isDry = m_settings.dryRunMm > 0.0;
  m_form->setRowVisible(m_job, m_hasBlocks || isDry);
  m_form->setRowVisible(m_height, isDry);
  m_height->setEnabled(m_editable);
  if (isDry) {
    m_height->setValue(m_settings.dryRunMm);
  }
  m_job->setCurrentIndex(isDry ? kDryRun : m_isJob ? kWholeJob : kMotionOnly);
  m_job->setEnabled(m_editable && (m_jobObstacle.isEmpty() || isDry));
  m_job->setToolTip(
      !m_jobObstacle.isEmpty()
          ? m_jobObstacle
          : tr("Whole job: the control executes tools, spindle, coolant, cycles and retracts at "
               "their place, and Rivulet streams the motion between them. Motion only: these "
               "blocks are left out. Dry run: the whole job above the workpiece, without spindle "
               "and coolant."));
  m_jobLabel->setToolTip(m_job->toolTip());
}

void MethodPanel::takeSettings() {
  if (m_isShowing) {
    return;
  }
  m_settings.parameters.method = static_cast<base::MethodKind>(m_method->currentData().toInt());
  m_settings.parameters.layout = static_cast<templates::Layout>(m_layout->currentData().toInt());
  m_settings.access = static_cast<AccessPreference>(m_access->currentData().toInt());
  m_settings.transferByHand = m_byHand->isChecked();
  m_settings.parameters.pointsPerLoop = m_points->value();
  m_settings.parameters.correctionLimitMm = isWindow() ? m_correction->value() : 0.0;
  // The fields round; a value the operator did not touch keeps its digits.
  if (std::abs(m_delta->value() - m_settings.deltaMm) > 5e-4) {
    m_settings.deltaMm = m_delta->value();
  }
  if (!base::isPublished(m_settings.parameters.method) && m_feedSource->isEnabled()) {
    m_settings.programFeeds = m_feedSource->currentIndex() == kFeedOfProgram;
  }
  if (std::abs(m_override->value() - kPercent * m_settings.overrideFactor) > 0.5) {
    m_settings.overrideFactor = m_override->value() / kPercent;
  }
  const double feedMmPerS = base::mmPerSFromMmPerMin(m_feed->value());
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
  }
  return {};
}

void MethodPanel::showPauses() {
  m_planned->setText(m_pauses ? tr("%1, of them %2 in the cut")
                                    .arg(countText(m_pauses->count), countText(m_pauses->inCut))
                              : noValue());
  if (m_pauses && m_pauses->costS && m_pauses->totalS) {
    m_cost->setText(
        tr("%1 of %2").arg(secondsText(*m_pauses->costS), durationText(*m_pauses->totalS)));
  } else {
    m_cost->setText(m_pauses ? tr("computing …") : noValue());
  }
}

void MethodPanel::showHeadline() {
  if (m_rehearsal) {
    m_rehearsalText->setStatus(hasFailedRehearsal()  ? Status::Fault
                               : m_rehearsal->isDone ? Status::Good
                                                     : Status::Busy,
                               rehearsalText(*m_rehearsal));
  }
  if (hasFailedRehearsal()) {
    m_headline->setStatus(Status::Fault, tr("Not feasible"));
  } else if (m_rehearsal && !m_rehearsal->isDone) {
    m_headline->setStatus(Status::Busy, tr("Checking …"));
  } else if (m_verdict->waits) {
    m_headline->setStatus(Status::Attention, tr("Safe, with waiting"));
  } else {
    m_headline->setStatus(m_verdict->feasible ? Status::Good : Status::Fault,
                          m_verdict->feasible ? tr("Feasible") : tr("Not feasible"));
  }
}

void MethodPanel::showLimit() {
  const auto& place = m_verdict->limiting.place;
  if (m_overrideLimit) {
    m_limitLabel->setText(tr("Largest override"));
    m_limit->setText(LimitTexts::percent(*m_overrideLimit));
    m_place->setText(LimitTexts::block(*m_overrideLimit));
    return;
  }
  m_limitLabel->setText(isWindow() ? tr("Largest feed without waiting") : tr("Largest feed"));
  m_limit->setText(feedText(m_verdict->feedMmPerSMax));
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
  const bool judged = m_verdict.has_value();
  for (QWidget* widget : {m_marginLabel, m_margin, m_limitLabel, m_limit, m_placeLabel, m_place}) {
    widget->setVisible(judged);
  }
  m_useFeed->hide();
  m_useDelta->hide();
  m_rehearsalText->setVisible(judged && m_rehearsal);
  if (!judged) {
    const bool isProblem = m_problem && !m_problem->isEmpty();
    m_headline->setStatus(isProblem && !m_isLive ? Status::Attention : Status::Unknown,
                          tr("Not judged"));
    m_reason->setText(isProblem ? *m_problem : tr("Load a program to get a verdict."));
    return;
  }

  showHeadline();
  const bool waits = m_verdict->waits;
  showLimit();
  const feasibility::Condition& limiting = m_verdict->limiting;
  QString reason = (waits                 ? tr("The machine will wait for points: %1")
                    : m_verdict->feasible ? tr("Closest limit: %1")
                                          : tr("Violated: %1"))
                       .arg(equationText(limiting.equation));
  if (m_problem && !m_problem->isEmpty()) {
    reason += QLatin1Char('\n') + *m_problem;
  }
  m_reason->setText(reason);
  m_margin->setText((isWindow() ? tr("%1 × (waits below 1)") : tr("%1 × (must exceed 1)"))
                        .arg(factorText(limiting.margin)));
  if (m_verdict->feasible && !waits && !hasFailedRehearsal()) {
    return;
  }
  // A larger δ costs no time, so it is suggested first if it is enough alone.
  const bool onlyDelta = std::none_of(m_verdict->conditions.begin(), m_verdict->conditions.end(),
                                      [](const feasibility::Condition& condition) {
                                        return condition.decides && condition.margin <= 1.0 &&
                                               condition.equation != feasibility::Equation::Delta;
                                      });
  if (usesDelta() && onlyDelta && !m_verdict->feasible && m_verdict->deltaMmMin > 0.0) {
    m_useDelta->setText(tr("Use δ = %1").arg(lengthText(offeredDeltaMm(m_verdict->deltaMmMin))));
    m_useDelta->setVisible(true);
    m_useDelta->setEnabled(m_editable);
  }
  showOffer(reason);
}

}  // namespace rivulet::widgets
