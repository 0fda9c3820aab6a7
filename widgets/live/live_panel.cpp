// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/live/live_panel.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "base/units.h"
#include "widgets/common/error_text.h"
#include "widgets/common/folding_columns.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/live/live_text.h"

namespace rivulet::widgets {

namespace {

constexpr int kMinWidthPx = 360;

}  // namespace

LivePanel::LivePanel(QWidget* parent)
    : Page(parent),
      m_title(makeHeading(this)),
      m_state(new StatusLabel(this)),
      m_hint(new QLabel(this)),
      m_bufferName(new QLabel(this)),
      m_buffer(new QProgressBar(this)),
      m_run(new QGroupBox(this)),
      m_agreed(new QGroupBox(this)),
      m_change(makeTouchButton(this)),
      m_open(makeTouchButton(this)) {
  setMinimumWidth(kMinWidthPx);
  m_state->setObjectName(QStringLiteral("live-state"));
  m_state->setWordWrap(true);
  m_hint->setWordWrap(true);
  m_hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_buffer->setObjectName(QStringLiteral("live-buffer"));
  m_buffer->setMinimumHeight(kTouchHeightPx / 2);
  m_bufferName->setBuddy(m_buffer);
  m_change->setObjectName(QStringLiteral("live-change"));
  m_open->setObjectName(QStringLiteral("live-program"));

  auto* run = new QGridLayout(m_run);
  run->setHorizontalSpacing(5);
  run->setContentsMargins(5, 8, 5, 8);
  run->addWidget(m_bufferName, 0, 0);
  run->addWidget(m_buffer, 0, 1, 1, 3);
  // Two columns: what goes in and comes out, and how long it takes.
  constexpr std::array<Figure, FigureCount> kOrder{In,     Out,        Accepted, Executed,
                                                   Median, Percentile, Theory,   Merged};
  for (std::size_t place = 0; place < kOrder.size(); ++place) {
    const Figure figure = kOrder[place];
    m_names[figure] = new QLabel(m_run);
    m_names[figure]->setWordWrap(true);
    m_values[figure] = makeValueLabel(m_run);
    // The last two are too wide for that.
    const bool isWide = figure == Theory || figure == Merged;
    const int row = figure == Merged ? 5 : static_cast<int>(place / 2) + 1;
    const int column = isWide ? 0 : 2 * static_cast<int>(place % 2);
    run->addWidget(m_names[figure], row, column);
    run->addWidget(m_values[figure], row, column + 1, 1, isWide ? 3 : 1);
  }
  m_values[In]->setObjectName(QStringLiteral("live-in"));
  m_values[Out]->setObjectName(QStringLiteral("live-out"));
  m_values[Median]->setObjectName(QStringLiteral("live-median"));
  m_values[Executed]->setObjectName(QStringLiteral("live-executed"));
  run->setColumnStretch(1, 1);
  run->setColumnStretch(3, 1);

  auto* agreed = new QGridLayout(m_agreed);
  agreed->setHorizontalSpacing(12);
  for (int fact = 0; fact < FactCount; ++fact) {
    const auto at = static_cast<std::size_t>(fact);
    m_factNames[at] = new QLabel(m_agreed);
    m_facts[at] = makeValueLabel(m_agreed);
    m_facts[at]->setWordWrap(true);
    agreed->addWidget(m_factNames[at], fact, 0, Qt::AlignTop);
    agreed->addWidget(m_facts[at], fact, 1);
  }
  agreed->setColumnStretch(1, 1);

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_open, 1);
  buttons->addWidget(m_change, 1);
  auto* inner = new QWidget;
  auto* rows = new QVBoxLayout(inner);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(m_run);
  rows->addWidget(m_agreed);
  rows->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(buttons);
  layout->addWidget(m_title);
  layout->addWidget(m_state);
  layout->addWidget(m_hint);
  layout->addWidget(makeScrolling(inner, this), 1);
  connect(m_change, &QPushButton::clicked, this, &LivePanel::changeRequested);
  connect(m_open, &QPushButton::clicked, this, &LivePanel::programRequested);
  retranslate();
  restyle();
}

void LivePanel::setSource(const live::Setup& setup, const QString& name, const QString& obstacle) {
  if (setup != m_setup || name != m_name) {
    m_level.reset();
    m_summary.reset();
    m_counters = {};
  }
  m_setup = setup;
  m_name = name;
  m_obstacle = obstacle;
  showAll();
}

void LivePanel::begin() {
  m_isRunning = true;
  m_level.reset();
  m_summary.reset();
  m_counters = {};
  showAll();
}

void LivePanel::setUpdate(const streaming::LiveUpdate& update) {
  if (!m_isRunning) {
    return;
  }
  m_counters = update.counters;
  if (update.source) {
    m_level = update.source;
  }
  showState();
  showBuffer();
  showFigures();
}

void LivePanel::setReport(const streaming::RunReport& report) {
  m_isRunning = false;
  m_counters = report.counters;
  m_summary = report.live;
  if (m_level && report.live) {
    m_level->accepted = report.live->accepted;
    m_level->merged = report.live->merged;
    m_level->refusal = report.live->refusal;
  }
  showAll();
}

void LivePanel::setEditable(bool editable) {
  m_change->setEnabled(editable);
  m_open->setEnabled(editable);
}

void LivePanel::showAll() {
  m_title->setText(m_name);
  showState();
  showBuffer();
  showFigures();
  showAgreed();
}

void LivePanel::showState() {
  // It is told once how to send; during a run the place is for what happens.
  const QString port = m_name.section(QLatin1Char(':'), 1);
  m_hint->setText(m_name.startsWith(QStringLiteral("tcp:")) ||
                          m_name.startsWith(QStringLiteral("udp:"))
                      ? tr("Send lines such as X1.5 Y2 F500 to 127.0.0.1, port %1. The line “end” "
                           "ends the run.")
                            .arg(port)
                      : tr("Send lines such as X1.5 Y2 F500 to it. The line “end” ends the run."));
  m_hint->setVisible(!m_isRunning && m_obstacle.isEmpty());
  if (m_isRunning) {
    if (m_level) {
      showStateOf(*m_level);
    } else {
      m_state->setStatus(Status::Busy, tr("It is read as soon as the control runs the program."));
    }
  } else if (!m_obstacle.isEmpty()) {
    m_state->setStatus(Status::Fault, m_obstacle);
  } else if (m_summary && m_summary->refusal.code) {
    m_state->setStatus(Status::Fault, errorText(m_summary->refusal));
  } else if (m_summary) {
    m_state->setStatus(Status::Good, tr("The run has ended. It listens for the next one."));
  } else {
    m_state->setStatus(Status::Good, tr("Listening. Nothing is read before the start."));
  }
}

void LivePanel::showStateOf(const live::Level& level) {
  using live::SourceState;
  const QString silence = ageText(base::toSeconds(level.silence));
  switch (level.state) {
    case SourceState::Waiting:
      m_state->setStatus(Status::Busy, tr("Waiting for the first line, for %1").arg(silence));
      return;
    case SourceState::Receiving:
      m_state->setStatus(Status::Good, tr("Receiving"));
      return;
    case SourceState::Silent:
      m_state->setStatus(Status::Attention,
                         tr("Silent for %1; %2").arg(silence, silenceText(m_setup.limits)));
      return;
    case SourceState::Ended:
      m_state->setStatus(Status::Good, tr("Ended by the source"));
      return;
    case SourceState::Refused:
      m_state->setStatus(Status::Fault, errorText(level.refusal));
      return;
  }
}

void LivePanel::showBuffer() {
  const std::size_t capacity = m_level ? m_level->capacity : 0;
  const std::size_t waiting = m_level && m_isRunning ? std::min(m_level->waiting, capacity) : 0;
  m_buffer->setRange(0, std::max(1, static_cast<int>(capacity)));
  m_buffer->setValue(static_cast<int>(waiting));
  const QString text = capacity == 0
                           ? noValue()
                           : tr("%1 of %2 points").arg(countText(waiting), countText(capacity));
  m_buffer->setFormat(text);
  m_buffer->setAccessibleDescription(text);
}

void LivePanel::showFigure(Figure figure, const QString& value) {
  m_values[figure]->setText(value);
}

void LivePanel::showFigures() {
  const auto rate = [this](double perS) {
    return m_level && m_isRunning ? tr("%1 /s").arg(numberText(perS, 1)) : noValue();
  };
  showFigure(In, rate(m_level ? m_level->acceptedPerS : 0.0));
  showFigure(Out, rate(m_level ? m_level->executedPerS : 0.0));
  showFigure(Accepted, m_level ? countText(m_level->accepted) : noValue());
  showFigure(Executed, m_level ? countText(m_counters.executed) : noValue());
  showFigure(Merged, m_level ? countText(m_level->merged) : noValue());
  // During a run that of the last points, after it that of all.
  const bool hasAll = !m_isRunning && m_summary && m_summary->delay.count > 0;
  const bool hasDelay = hasAll || (m_level && m_level->delays > 0);
  showFigure(Median,
             !hasDelay ? noValue()
                       : millisecondsText(hasAll ? m_summary->delay.p50 : m_level->delayMedian, 0));
  showFigure(Percentile,
             !hasDelay ? noValue()
                       : millisecondsText(hasAll ? m_summary->delay.p99 : m_level->delayP99, 0));
  const QString theory = hasAll    ? theoryText(m_summary->leastDelay, m_summary->mostDelay)
                         : m_level ? theoryText(m_level->leastDelay, m_level->mostDelay)
                                   : QString();
  showFigure(Theory, theory.isEmpty() ? noValue() : theory);
}

void LivePanel::showAgreed() {
  const live::Agreement& agreed = m_setup.agreement;
  m_facts[BoxX]->setText(boxText(agreed, 0));
  m_facts[BoxY]->setText(boxText(agreed, 1));
  m_facts[BoxZ]->setText(boxText(agreed, 2));
  m_facts[First]->setText(lengthText(agreed.startMmMax));
  m_facts[Step]->setText(
      base::any(m_setup.rotaryAxes)
          ? QStringLiteral("%1, %2 %3°")
                .arg(lengthText(agreed.stepMmMax),
                     QString::fromStdString(base::rotaryNames(m_setup.rotaryAxes)),
                     numberText(agreed.turnDegMax, 3))
          : lengthText(agreed.stepMmMax));
  m_facts[Feed]->setText(feedText(base::mmPerSFromMmPerMin(agreed.feedMmPerMinMax)));
  m_facts[Merge]->setText(lengthText(agreed.distanceMmMin));
  m_facts[Silence]->setText(silenceText(m_setup.limits));
}

void LivePanel::retranslate() {
  m_change->setText(tr("Live points …"));
  m_change->setToolTip(tr("Another source, or something else agreed with it"));
  m_open->setText(tr("Open program …"));
  m_open->setToolTip(tr("A program takes the place of the live source."));
  m_run->setTitle(tr("Points"));
  m_agreed->setTitle(tr("Agreed with the source"));
  m_bufferName->setText(tr("Buffer"));
  m_buffer->setAccessibleName(tr("Buffer"));
  m_buffer->setToolTip(
      tr("Points that have arrived and are not executed. When it is full, the source is made to "
         "wait."));
  const std::array<QString, FigureCount> names{
      tr("In"),     tr("Out"),           tr("Accepted"),    tr("Executed"),
      tr("Merged"), tr("Delay, median"), tr("Delay, 99 %"), tr("In theory")};
  const std::array<QString, FigureCount> hints{
      tr("Points from the source, mean of the last two seconds"),
      tr("Points executed, mean of the last two seconds"),
      tr("Points of the source within the agreed limits"),
      tr("Points that are known to be executed"),
      tr("Points too close to the one before, which are left out"),
      tr("From the arrival of a point to the beginning of its move; during a run, of the last 500 "
         "points"),
      tr("Of a hundred points, one was later than this."),
      tr("Least delay, and the delay when all buffers are full")};
  for (std::size_t figure = 0; figure < FigureCount; ++figure) {
    m_names[figure]->setText(names[figure]);
    m_names[figure]->setToolTip(hints[figure]);
    m_values[figure]->setToolTip(hints[figure]);
    m_values[figure]->setAccessibleName(names[figure]);
  }
  const std::array<QString, FactCount> facts{
      QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z"), tr("First point within"),
      tr("Largest step"),  tr("Largest F"),     tr("Merge below"),   tr("When it is silent")};
  for (std::size_t fact = 0; fact < FactCount; ++fact) {
    m_factNames[fact]->setText(facts[fact]);
  }
  showAll();
}

void LivePanel::restyle() {
  m_open->setIcon(themedIcon(QStringLiteral("open"), themeColors(palette()).text));
  m_change->setIcon(themedIcon(QStringLiteral("live"), themeColors(palette()).text));
  setMuted(m_hint, palette());
  for (QLabel* name : m_names) {
    setMuted(name, palette());
  }
  for (QLabel* name : m_factNames) {
    setMuted(name, palette());
  }
}

}  // namespace rivulet::widgets
