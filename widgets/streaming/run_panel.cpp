// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/run_panel.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "widgets/common/elided_label.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/live/live_text.h"
#include "widgets/streaming/override_control.h"
#include "widgets/streaming/stop_button.h"

namespace rivulet::widgets {

using streaming::RunState;

namespace {

constexpr int kRunButtonHeightPx = 60;
constexpr int kWidthPxMin = 480;
constexpr int kFiguresHeightPx = 28;
constexpr int kFigureGapPx = 16;
constexpr int kPairGapPx = 6;
constexpr int kProgressHeightPx = 4;
constexpr int kTitleWidthPx = 160;  ///< with less, the program is not named
constexpr int kProgressSteps = 1000;
/// Below this width the state has a row of its own.
constexpr int kOneRowWidthPx = 860;

struct RunStateTexts {
  Q_DECLARE_TR_FUNCTIONS(RunStateTexts)

 public:
  static QString text(RunState state) {
    switch (state) {
      case RunState::Idle:
        return tr("Idle");
      case RunState::Armed:
        return tr("Preparing");
      case RunState::Running:
        return tr("Running");
      case RunState::Holding:
        return tr("Holding");
      case RunState::Stopping:
        return tr("Stopping");
      case RunState::Done:
        return tr("Done");
      case RunState::Stopped:
        return tr("Stopped");
      case RunState::Aborted:
        return tr("Failed");
    }
    return {};
  }
};

}  // namespace

QString runStateText(RunState state) {
  return RunStateTexts::text(state);
}

QString waitingText(const QString& key) {
  if (key == QStringLiteral("source")) {
    return RunPanel::tr("Waiting for points of the live source");
  }
  if (key == QStringLiteral("proof")) {
    return RunPanel::tr("Waiting for the test of the template on the virtual machine");
  }
  if (key == QStringLiteral("transfer")) {
    return RunPanel::tr("Waiting for the transfer of the template to the control");
  }
  if (key == QStringLiteral("cycle-start")) {
    return RunPanel::tr("Waiting for cycle start at the control");
  }
  if (key == QStringLiteral("select-and-start")) {
    return RunPanel::tr("Waiting for selection of the template and cycle start at the control");
  }
  if (key == QStringLiteral("network")) {
    return RunPanel::tr("Nothing comes from the control. Check cable, switch and server.");
  }
  if (key == QStringLiteral("claim")) {
    return RunPanel::tr(
        "Waiting until the claim of another client lapses, because it may be dead (10 s)");
  }
  if (key == QStringLiteral("trace")) {
    return RunPanel::tr("Waiting for the control's own trace");
  }
  return key.isEmpty() ? QString() : RunPanel::tr("Waiting for %1").arg(key);
}

RunPanel::RunPanel(QWidget* parent)
    : Page(parent),
      m_rows(new QGridLayout(this)),
      m_state(say(new QWidget(this), {.id = "state"})),
      m_stateLabel(new StatusLabel(m_state, StatusLabel::Elided{1})),
      m_reason(new StatusLabel(m_state, StatusLabel::Elided{2})),
      m_left(new QWidget(this)),
      m_right(new QWidget(this)),
      m_rightLayout(new QHBoxLayout(m_right)),
      m_start(say(new HoldButton(m_right), {.icon = "play", .id = "start"})),
      m_end(say(new HoldButton(m_right),
                {.text = QT_TR_NOOP("End here"),
                 .tip = QT_TR_NOOP("Hold for one second: the run ends. First the axes execute what "
                                   "the control still has of the window, with this override."),
                 .icon = "stop",
                 .id = "end-here"})),
      m_override(new OverrideControl(m_right)),
      m_stop(say(new StopButton(m_left),
                 {.text = QT_TR_NOOP("Stop"),
                  .tip = QT_TR_NOOP(
                      "The axes stand at once if the program obeys this computer's override, "
                      "else at the end of its window. Escape does the same, from anywhere in the "
                      "window. It does not replace the machine's emergency stop."),
                  .icon = "stop",
                  .id = "stop"})),
      m_figures(new QWidget(this)),
      m_progress(new QProgressBar(this)),
      m_title(say(new ElidedLabel(1, m_figures), {.isMuted = true})) {
  m_stateLabel->setEmphasis(14.0, true);
  auto* state = inColumn({m_stateLabel, m_reason}, m_state, QMargins(0, 0, 0, 0));
  state->setSpacing(0);
  buildButtons();
  buildFigures();
  m_rows->setContentsMargins(8, 4 + kProgressHeightPx, 8, 4);
  m_rows->setHorizontalSpacing(16);
  m_rows->setVerticalSpacing(4);
  m_rows->setColumnStretch(1, 1);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

  connect(m_stop, &QPushButton::clicked, this, &RunPanel::requestStop);
  connect(m_start, &HoldButton::clicked, this, [this] {
    if (!m_starting.hasPassed && !isActive()) {
      Q_EMIT preflightRequested();
    }
  });
  connect(m_start, &HoldButton::held, this, &RunPanel::startRequested);
  connect(m_end, &HoldButton::held, this, &RunPanel::endRequested);
  connect(m_override, &OverrideControl::percentRequested, this, [this](double percent) {
    m_feed.askedPercent = percent;
    Q_EMIT overrideRequested(percent);
  });
  connect(m_lift, &QPushButton::clicked, this,
          [this] { Q_EMIT liftRequested(isLifted() ? 0.0 : m_feed.liftMm); });
  connect(m_hold, &QPushButton::clicked, this,
          [this] { Q_EMIT holdRequested(m_update.state != RunState::Holding); });
  arrange();
  onLanguage(&RunPanel::showAll);
  restyle();
}

std::array<QPushButton*, 6> RunPanel::buttons() const {
  return {m_start, m_end, m_stop, m_hold, m_resume, m_lift};
}

void RunPanel::buildButtons() {
  for (QPushButton* button : buttons()) {
    button->setFixedHeight(kRunButtonHeightPx);
    button->setIconSize(QSize(24, 24));
  }
  auto* left = new QHBoxLayout(m_left);
  for (QBoxLayout* layout : {static_cast<QBoxLayout*>(left), m_rightLayout}) {
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);  // wide enough apart that one is not hit for the other
  }
  left->addWidget(m_stop);
  left->addWidget(m_hold);
  m_rightLayout->addWidget(m_resume);
  m_rightLayout->addWidget(m_start);
  m_rightLayout->addWidget(m_override);
  m_rightLayout->addWidget(m_lift);
  m_rightLayout->addWidget(m_end);
}

void RunPanel::buildFigures() {
  constexpr std::array<const char*, FigureCount> kNames{
      QT_TR_NOOP("Line"), QT_TR_NOOP("Time left"), QT_TR_NOOP("Stream"), QT_TR_NOOP("Executed")};
  m_progress->setRange(0, kProgressSteps);
  m_progress->setTextVisible(false);  // the state says it
  auto* row = new QHBoxLayout(m_figures);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kFigureGapPx);
  row->setSizeConstraint(QLayout::SetNoConstraint);
  for (std::size_t figure = 0; figure < FigureCount; ++figure) {
    m_shown[figure].area = new QWidget(m_figures);
    m_shown[figure].name = label({.text = kNames[figure], .isMuted = true});
    m_shown[figure].value = status();
    m_shown[figure].value->setStatus(Status::Plain, noValue());
    m_shown[figure].value->setFigure();
    auto* pair = inRow({m_shown[figure].name, m_shown[figure].value}, m_shown[figure].area,
                       QMargins(0, 0, 0, 0));
    pair->setSpacing(kPairGapPx);
    row->addWidget(m_shown[figure].area);
  }
  m_title->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(m_title, 1);
  row->addStretch();
  m_figures->setFixedHeight(kFiguresHeightPx);
  m_figures->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void RunPanel::arrange() {
  const bool isNarrow = width() < kOneRowWidthPx;
  QFont buttonFont = font();
  buttonFont.setPointSizeF(isNarrow ? 11.0 : 14.0);
  buttonFont.setBold(true);
  m_override->setNarrow(isNarrow);
  for (QPushButton* button : buttons()) {
    button->setFont(buttonFont);
    button->setIconSize(isNarrow ? QSize(16, 16) : QSize(24, 24));
    button->setMinimumWidth(isNarrow ? 0 : 130);
  }
  m_state->setFixedHeight(kRunButtonHeightPx);
  for (QWidget* part : {m_state, m_left, m_right, m_figures}) {
    m_rows->removeWidget(part);
  }
  const int buttons = isNarrow ? 1 : 0;
  m_rows->addWidget(m_state, 0, isNarrow ? 0 : 1, 1, isNarrow ? 3 : 1);
  m_rows->addWidget(m_left, buttons, 0);
  m_rows->addWidget(m_right, buttons, 2);
  m_rows->addWidget(m_figures, buttons + 1, 0, 1, 3);
}

QSize RunPanel::minimumSizeHint() const {
  return {kWidthPxMin, Page::minimumSizeHint().height()};
}

void RunPanel::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  const bool isNarrow = width() < kOneRowWidthPx;
  const bool wasNarrow = event->oldSize().width() < kOneRowWidthPx;
  if (isNarrow != wasNarrow) {
    arrange();
  }
  fitFigures();
  m_progress->setGeometry(0, 0, width(), kProgressHeightPx);
}

void RunPanel::requestStop() {
  if (isActive() && !hasFeedCell() && m_stopState == StopState::None) {
    m_stopState = StopState::Requested;
    showAll();
  }
  Q_EMIT stopRequested();  // again and again if the operator wants: it does no harm
}

void RunPanel::setUpdate(const streaming::LiveUpdate& update) {
  const bool starts = update.state == RunState::Armed || update.state == RunState::Running;
  const bool wasActive = isActive();
  const std::size_t total = m_update.counters.total;
  m_update = update;
  if (m_update.counters.total == 0) {
    m_update.counters.total = total;
  }
  if (starts && !wasActive) {
    m_feed.askedPercent.reset();
    m_stopState = StopState::None;
  }
  if (update.state == RunState::Stopping && m_stopState == StopState::None) {
    m_stopState = StopState::Requested;
  }
  if (update.stopConfirmedAfter) {
    m_stopState = StopState::Confirmed;
  }
  showAll();
}

void RunPanel::setReport(const streaming::RunReport& report) {
  if (report.error.code == streaming::StreamError::StopNotConfirmed) {
    m_stopState = StopState::Unconfirmed;
  }
  showAll();
}

void RunPanel::setRunBegin(std::size_t point) {
  m_runBegin = point;
  showAll();
}

void RunPanel::setProgram(std::size_t points) {
  m_update = {};
  m_runBegin = 0;
  m_stopState = StopState::None;
  m_feed.stopWithinS.reset();
  setTotal(points);
}

void RunPanel::setTotal(std::size_t points) {
  m_update.counters.total = points;
  showAll();
}

void RunPanel::setProgress(const RunProgress& progress) {
  m_where = progress;
  showState();
  showReason();
  showFigures();
}

void RunPanel::setJob(const std::optional<JobProgress>& job) {
  m_job = job;
  showAll();
}

void RunPanel::setMayMove(bool mayMove) {
  if (mayMove != m_mayMove) {
    m_mayMove = mayMove;
    showButtons();
  }
}

void RunPanel::setTitle(const QString& title) {
  m_title->setText(title);
}

void RunPanel::setStartBlocked(const QString& reason) {
  m_starting.blocked = reason;
  showAll();
}

void RunPanel::setPreflightPassed(bool passed) {
  m_starting.hasPassed = passed;
  showAll();
}

void RunPanel::setCanHold(bool canHold) {
  m_canHold = canHold;
  showAll();
}

void RunPanel::setResume(bool isThere, const QString& reason) {
  m_resuming.isOffered = isThere;
  m_resuming.blocked = reason;
  showAll();
}

void RunPanel::setFound(const std::optional<FoundRunView>& found) {
  m_found = found;
  showAll();
}

void RunPanel::setOverrideAllowed(bool isAllowed, double maxPercent) {
  m_override->setEnabled(isAllowed);
  m_override->setMax(maxPercent);
}

void RunPanel::setStopWithin(const std::optional<double>& seconds) {
  m_feed.stopWithinS = seconds;
  showStopNote();
}

void RunPanel::showStopNote() {
  m_stop->setNote(m_feed.stopWithinS ? tr("stands in %1").arg(secondsText(*m_feed.stopWithinS, 1))
                                     : QString());
}

bool RunPanel::hasFeedCell() const {
  return m_update.feed && isActive() && m_update.state != RunState::Armed;
}

void RunPanel::setWrongMotion(bool hasWrongMotion) {
  m_hasWrongMotion = hasWrongMotion;
  showAll();
}

void RunPanel::restyle() {
  const ThemeColors& colors = themeColors(palette());
  for (const auto& [button, fill] : {std::pair<QPushButton*, QColor>(m_stop, colors.stop),
                                     std::pair<QPushButton*, QColor>(m_start, colors.start)}) {
    fillButton(*button, fill);
  }
  m_stop->setIcon(themedIcon(QStringLiteral("stop"), colors.onFill));
  m_start->setIcon(themedIcon(QStringLiteral("play"), colors.onFill));
  showButtons();
  update();
}

bool RunPanel::isActive() const {
  return m_update.state == RunState::Armed || m_update.state == RunState::Running ||
         m_update.state == RunState::Holding || m_update.state == RunState::Stopping;
}

QString RunPanel::wrongMotionText(const QString& end) const {
  return end.isEmpty() ? tr("Wrong motion") : tr("Wrong motion. %1").arg(end);
}

bool RunPanel::isHeldBySource() const {
  return m_update.state == RunState::Holding && m_update.source && m_update.source->holdsRun;
}

QString RunPanel::feedSentence() const {
  if (!hasFeedCell()) {
    return {};
  }
  const streaming::FeedSeen& feed = *m_update.feed;
  if (feed.isIgnored) {
    return tr("What moves now does not obey the override. Press NC STOP at the machine.");
  }
  if (feed.isForeign) {
    return tr("Another client has set the override to %1 %").arg(numberText(feed.wantedPercent, 0));
  }
  if (isLifted()) {
    return tr("The tool is lifted by %1. Lower it, then the run can go on")
        .arg(lengthText(*feed.liftedMm, 3));
  }
  if (feed.isHeldBySource() && feed.source) {
    return feedSourceText(*feed.source) + QStringLiteral(". ") + tr("Continue goes on without it");
  }
  if (feed.holds) {
    return feed.stoodAfter
               ? tr("The axes stand (%1 after the order). Continue goes on, End here ends the "
                    "run")
                     .arg(secondsText(base::toSeconds(*feed.stoodAfter), 2))
               : tr("The axes are braking");
  }
  return feed.wantedPercent == 0.0 ? tr("Override 0 %: the axes stand")
         : feed.source             ? feedSourceText(*feed.source)
                                   : QString();
}

QString RunPanel::waitingSentence() const {
  if (const QString feed = feedSentence(); !feed.isEmpty()) {
    return feed;
  }
  const QString key = QString::fromStdString(m_update.waitingFor);
  if (isHeldBySource()) {
    return tr("The live source is silent or wants a hold. The run goes on with its next point.");
  }
  if (key.isEmpty()) {
    return m_update.state == RunState::Holding
               ? tr("The machine waits before the next window until you press Continue.")
               : QString();
  }
  return waitingText(key);
}

QString RunPanel::activeText() const {
  const QString name = runStateText(m_update.state);
  const QString state = m_job && m_job->isDry ? tr("%1, dry run").arg(name) : name;
  if (!m_job || !isActive() || m_update.state == RunState::Armed) {
    return state;
  }
  const QString stretches = countText(m_job->stretches);
  if (!m_job->isNative) {
    return tr("%1: part %2 of %3").arg(state, countText(m_job->stretch), stretches);
  }
  return m_job->line > 0 ? tr("%1: the control, line %2").arg(state, countText(m_job->line))
                         : tr("%1: the control").arg(state);
}

QString RunPanel::nativeText() const {
  if (!m_job || !m_job->isNative || !isActive() || m_update.state == RunState::Armed) {
    return {};
  }
  if (m_job->waitsForCycleStart) {
    return tr("The program waits for cycle start at the control");
  }
  if (m_update.state == RunState::Holding && !hasFeedCell()) {
    return tr("The job waits before the next block until you press Continue.");
  }
  const QString what =
      m_job->stretch <= m_job->stretches
          ? tr("Before part %1 of %2").arg(countText(m_job->stretch), countText(m_job->stretches))
          : tr("After the last part");
  const QString block = m_job->block.isEmpty() ? what : what + QStringLiteral(": ") + m_job->block;
  return hasFeedCell()
             ? block
             : block + QStringLiteral(". ") + tr("Stop and Pause act at the end of the block");
}

QString RunPanel::stopText() const {
  switch (m_stopState) {
    case StopState::None:
      break;
    case StopState::Requested:
      return stopRequestedText(m_job && m_job->isNative ? std::nullopt : m_where.delivered);
    case StopState::Confirmed:
      return m_update.stopConfirmedAfter
                 ? tr("Stop confirmed after %1")
                       .arg(secondsText(base::toSeconds(*m_update.stopConfirmedAfter), 2))
                 : tr("Stop confirmed");
    case StopState::Unconfirmed:
      return tr("Stop NOT confirmed: check the machine");
  }
  return {};
}

void RunPanel::showAll() {
  showButtons();
  showStopNote();
  showState();
  showReason();
  showFigures();
}

void RunPanel::setLift(double mm) {
  m_feed.liftMm = mm;
  showButtons();
}

bool RunPanel::isLifted() const {
  return hasFeedCell() && m_update.feed->isLifted();
}

void RunPanel::showButtons() {
  const bool active = isActive();
  const bool offersResume = m_resuming.isOffered && !active;
  // What is offered first is far right: after an interrupted run that is Resume.
  m_rightLayout->setDirection(offersResume ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight);
  m_resume->setVisible(offersResume);
  m_resume->setEnabled(m_resuming.blocked.isEmpty());
  m_resume->setToolTip(m_resuming.blocked.isEmpty()
                           ? tr("Asks the control where the run was left. Nothing moves yet.")
                           : m_resuming.blocked);
  const bool mayLift = hasFeedCell() && m_update.feed->liftedMm && m_feed.liftMm > 0.0;
  m_lift->setVisible(mayLift);
  m_lift->setText(isLifted() ? tr("Lower") : tr("Lift by %1").arg(lengthText(m_feed.liftMm, 1)));
  m_lift->setToolTip(isLifted() ? tr("The tool goes back to where it stood.")
                                : tr("The tool goes straight up; the path waits."));
  m_override->setVisible(hasFeedCell() && !mayLift);
  m_end->setVisible(hasFeedCell() && m_update.feed->holds && !isHeldBySource());
  m_end->setEnabled(!isLifted());
  m_start->setVisible(!hasFeedCell());
  // What was asked for last is shown until the control has it.
  if (const auto& feed = m_update.feed;
      hasFeedCell() && !feed->holds &&
      (feed->isForeign ||
       m_feed.askedPercent.value_or(feed->wantedPercent) == feed->wantedPercent)) {
    m_override->setPercent(feed->wantedPercent);
  }
  m_start->setNeedsHold(m_starting.hasPassed);
  m_stop->setEnabled(active || hasFound() || m_mayMove);
  const bool canStart = !active && m_starting.blocked.isEmpty();
  if (!canStart && m_start->hasFocus()) {
    setFocus(Qt::OtherFocusReason);  // else it would go to any other button of the window
  }
  if (active && hasFocus()) {
    m_stop->setFocus(Qt::OtherFocusReason);
  }
  m_start->setEnabled(canStart);
  if (canStart && hasFocus()) {
    m_start->setFocus(Qt::OtherFocusReason);
  }
  m_start->setText(m_starting.hasPassed ? tr("Hold to start")
                   : offersResume       ? tr("Start over …")
                                        : tr("Start …"));
  m_start->setToolTip(m_starting.hasPassed
                          ? tr("Hold for one second. Then the machine moves.")
                          : tr("Shows what will happen first. Nothing moves yet."));
  // One place for both, so that a hand finds it: Hold during a run, Continue during a hold.
  const bool canGoOn = m_update.state == RunState::Holding;
  const bool isHolding = canGoOn && !isHeldBySource();
  m_hold->setText(isHolding ? tr("Continue") : tr("Pause"));
  setThemedIcon(*m_hold, isHolding ? QStringLiteral("play") : QStringLiteral("hold"),
                themeColors(palette()).text);
  m_hold->setEnabled(m_canHold && !isLifted() && (canGoOn || m_update.state == RunState::Running));
  m_hold->setToolTip(m_canHold ? hasFeedCell()
                                     ? tr("The axes stand at once, until you press Continue.")
                                     : tr("The machine waits before the next window until you "
                                          "press Continue.")
                               : tr("Only method window can hold."));
}

void RunPanel::showFoundState() {
  const QString number = QString::number(m_found->number);
  if (m_found->isStopping) {
    m_stateLabel->setStatus(Status::Busy, runStateText(RunState::Stopping));
  } else if (m_found->isWatched) {
    m_stateLabel->setStatus(Status::Busy, m_found->kind == FoundRunView::Kind::Waiting
                                              ? tr("Watching run %1: it waits").arg(number)
                                              : tr("Watching run %1").arg(number));
  } else {
    m_stateLabel->setStatus(Status::Attention, m_found->number == 0
                                                   ? tr("A program waits on the control")
                                                   : tr("Run %1 is on the control").arg(number));
  }
}

void RunPanel::showState() {
  if (hasFound()) {
    showFoundState();
    m_state->setAccessibleName(m_stateLabel->text());
    return;
  }
  const QString place =
      tr("%1 of %2").arg(countText(m_update.counters.executed), countText(m_update.counters.total));
  const auto show = [this](Status status, const QString& text) {
    m_stateLabel->setStatus(m_hasWrongMotion ? Status::Fault : status,
                            m_hasWrongMotion ? wrongMotionText(text) : text);
  };
  switch (m_update.state) {
    case RunState::Idle:
      m_stateLabel->setStatus(m_starting.blocked.isEmpty() ? Status::Good : Status::Unknown,
                              m_starting.blocked.isEmpty() ? tr("Ready") : tr("Not ready"));
      break;
    case RunState::Stopped:
      show(Status::Attention, tr("Stopped at %1").arg(place));
      break;
    case RunState::Aborted:
      show(Status::Fault, tr("Failed at %1").arg(place));
      break;
    case RunState::Done:
      show(Status::Good, m_hasWrongMotion ? QString() : runStateText(RunState::Done));
      break;
    default:
      show(Status::Busy, activeText());
  }
  // Read aloud when it changes: without the figure, which always does.
  m_state->setAccessibleName(m_stateLabel->text());
  if (isActive() && m_update.state != RunState::Armed && !m_where.isLive) {
    m_stateLabel->setStatus(m_stateLabel->status(),
                            QStringLiteral("%1 \u00B7 %2 %")
                                .arg(m_stateLabel->text(), numberText(100.0 * doneShare(), 0)));
  }
}

void RunPanel::showReason() {
  const bool active = isActive();
  QStringList sentences;
  if (const QString stop = stopText(); !stop.isEmpty()) {
    sentences.append(stop);
  }
  if (const QString native = nativeText(); !native.isEmpty()) {
    sentences.append(native);
    sentences.append(feedSentence());
  } else if (active) {
    sentences.append(waitingSentence());
  } else if (hasFound()) {
    sentences = {m_found->isStopping  ? stopRequestedText(m_found->ahead)
                 : m_found->isHeld    ? tr("Its axes are held until the run is ended or resumed.")
                 : m_found->isWatched ? tr("This window only shows it. Stop holds its axes.")
                                      : tr("This window did not start it. Stop holds its axes.")};
  } else if (m_hasWrongMotion) {
    sentences.append(tr("The run has executed wrong points: see the report."));
  } else if (!m_starting.blocked.isEmpty()) {
    sentences.append(tr("Start is not possible: %1").arg(m_starting.blocked));
  } else if (m_update.state == RunState::Aborted || m_update.state == RunState::Stopped) {
    sentences.append(m_resuming.isOffered ? tr("Resume goes on where the run was left.")
                                          : tr("A new start begins at the first point."));
  } else {
    sentences.append(tr("Ready to start"));
  }
  sentences.removeAll(QString());
  const bool isFault = m_stopState == StopState::Unconfirmed || (!active && m_hasWrongMotion) ||
                       (hasFeedCell() && m_update.feed->isIgnored);
  m_reason->setStatus(isFault                                                   ? Status::Fault
                      : !active && !hasFound() && !m_starting.blocked.isEmpty() ? Status::Attention
                                                                                : Status::Plain,
                      sentences.join(QStringLiteral(". ")));
}

void RunPanel::showFigures() {
  showCounters();
  showPlace();
  showStream();
  fitFigures();
}

void RunPanel::showFigure(Figure figure, const QString& value, const QString& hint, Status status) {
  m_shown[figure].value->setStatus(status, value.isEmpty() ? noValue() : value);
  m_shown[figure].area->setToolTip(hint);
}

streaming::Counters RunPanel::shownCounters() const {
  streaming::Counters counters = m_update.counters;
  if (isWatching()) {
    counters.executed = m_found->executed;
    counters.total = m_found->total;
    return counters;
  }
  for (std::size_t* count :
       {&counters.executed, &counters.sent, &counters.accepted, &counters.total}) {
    *count -= std::min(*count, m_runBegin);
  }
  return counters;
}

double RunPanel::doneShare() const {
  if (m_where.isLive && !isWatching()) {
    return 0.0;  // nobody knows how many points will come
  }
  const streaming::Counters counters = shownCounters();
  const std::size_t passed =
      isWatching()
          ? counters.executed
          : std::max(counters.executed, m_where.passed - std::min(m_where.passed, m_runBegin));
  return counters.total == 0 ? 0.0
                             : static_cast<double>(passed) / static_cast<double>(counters.total);
}

void RunPanel::showCounters() {
  const streaming::Counters counters = shownCounters();
  const QString total = countText(counters.total);
  QString hint = m_runBegin == 0 || isWatching()
                     ? tr("Points that are known to be executed")
                     : tr("Points that are known to be executed, from point %1 on")
                           .arg(countText(m_runBegin + 1));
  if (!isWatching()) {
    hint += QLatin1Char('\n') + tr("Sent to the control: %1, confirmed by it: %2")
                                    .arg(countText(counters.sent), countText(counters.accepted));
  }
  showFigure(Executed,
             isWatching() && counters.total == 0
                 ? tr("%Ln windows", nullptr, static_cast<int>(counters.executed))
                 : tr("%1 of %2").arg(countText(counters.executed), total),
             hint);
  m_progress->setValue(static_cast<int>(doneShare() * kProgressSteps));
}

QString RunPanel::elsewhereText() {
  return tr("Only the computer that streams this run knows it.");
}

void RunPanel::showPlace() {
  if (isWatching()) {
    showFigure(Line, {}, elsewhereText());
    showFigure(Left, {}, elsewhereText());
    return;
  }
  const bool hasLine = m_where.line > 0;
  showFigure(Line,
             !hasLine ? QString()
             : m_where.lines == 0
                 ? countText(m_where.line)
                 : tr("%1 of %2").arg(countText(m_where.line), countText(m_where.lines)),
             m_where.isLive       ? tr("Line of the live source of the move that the tool is on")
             : m_where.lines == 0 ? tr("No program is loaded.")
             : hasLine            ? tr("Line of the program of the move that the tool is on")
                                  : tr("No point has been executed yet."));
  const bool isOver = m_update.state == RunState::Done;
  if (isOver || !m_where.left) {
    showFigure(Left, {},
               isOver               ? tr("The run has ended.")
               : m_where.isLive     ? tr("A live source does not say when it ends.")
               : m_where.lines == 0 ? tr("No program is loaded.")
                                    : tr("The time of the run is not estimated yet. During a run "
                                         "nothing is estimated."));
    return;
  }
  const TimeLeft& left = *m_where.left;
  QString hint =
      tr("Estimate of the time that is left, with the feeds and the planned pauses of this run. "
         "Hold and the feed override at the control are not included.");
  const double controlS = left.nativeS + left.toolChangesS;
  if (controlS > 0.0) {
    const double streamedS = left.totalS - left.pausesS - controlS;
    hint +=
        QLatin1Char('\n') + tr("Streamed %1, pauses %2, tool changes %3, other blocks of the "
                               "control %4. Cycles, measuring and stops are not included.")
                                .arg(durationText(streamedS), durationText(left.pausesS),
                                     durationText(left.toolChangesS), durationText(left.nativeS));
  }
  showFigure(Left, timeLeftText(left), hint);
}

QString RunPanel::timeLeftText(const TimeLeft& left) {
  const QString total = durationText(left.totalS);
  const double controlS = left.nativeS + left.toolChangesS;
  if (controlS > 0.0) {
    return left.pausesS > 0.0 ? tr("%1, pauses %2, control %3")
                                    .arg(total, durationText(left.pausesS), durationText(controlS))
                              : tr("%1, control %2").arg(total, durationText(controlS));
  }
  return left.pausesS > 0.0 ? tr("%1, pauses %2").arg(total, durationText(left.pausesS)) : total;
}

void RunPanel::showStream() {
  const streaming::Counters& counters = m_update.counters;
  if (!isActive() || counters.accepted < counters.executed) {
    showFigure(Stream, {},
               isWatching() ? elsewhereText() : tr("No run of this window is in progress."));
    return;
  }
  QString moves =
      tr("%Ln moves in hand", nullptr, static_cast<int>(counters.accepted - counters.executed));
  QString hint = tr("Moves in hand: what the control has and has not executed yet.");
  const bool isKnown = m_update.margin && m_update.state != RunState::Holding;
  const bool isLate = isKnown && m_update.margin->count() < 0;
  if (isKnown) {
    moves = (isLate ? tr("late, %1") : tr("on time, %1")).arg(moves);
    hint += QLatin1Char('\n') +
            tr("Margin %1: time until the control needs the next point, minus the 99th percentile "
               "of the access time")
                .arg(millisecondsText(*m_update.margin));
  }
  showFigure(Stream, moves, hint,
             !isKnown ? Status::Plain
             : isLate ? Status::Attention
                      : Status::Good);
}

void RunPanel::fitFigures() {
  int room = width() - 2 * 8;
  for (const Figure figure : {Line, Left, Stream, Executed}) {
    QWidget* area = m_shown[figure].area;
    // Not what the layout remembers: the font may have changed since.
    const int widthPx = m_shown[figure].name->sizeHint().width() + kPairGapPx +
                        m_shown[figure].value->layout()->totalSizeHint().width();
    // Of a fixed size, so that a new value does not lay out the window.
    area->setFixedSize(widthPx, area->layout()->totalSizeHint().height());
    const int needed = widthPx + kFigureGapPx;
    area->setVisible(needed <= room);
    room -= area->isVisibleTo(this) ? needed : 0;
  }
  m_title->setVisible(room >= kTitleWidthPx);
}

void RunPanel::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  fitFigures();
}

void RunPanel::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
    fitFigures();
  }
}

void RunPanel::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), themeColors(palette()).surface);
}

}  // namespace rivulet::widgets
