// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/live/live_panel.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "base/units.h"
#include "widgets/common/error_text.h"
#include "widgets/common/folding_columns.h"
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
      m_buffer(say(new QProgressBar(this),
                   {.tip = QT_TR_NOOP("Points that have arrived and are not executed. When it is "
                                      "full, the source is made to wait."),
                    .name = QT_TR_NOOP("Buffer"),
                    .id = "live-buffer"})) {
  setMinimumWidth(kMinWidthPx);
  m_hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_buffer->setMinimumHeight(kTouchHeightPx / 2);

  auto* run = new QGridLayout(m_run);
  run->setHorizontalSpacing(5);
  run->setContentsMargins(5, 8, 5, 8);
  run->addWidget(label({.text = QT_TR_NOOP("Buffer")}, m_buffer), 0, 0);
  run->addWidget(m_buffer, 0, 1, 1, 3);
  // Two columns: what goes in and comes out, and how long it takes.
  constexpr std::array<Figure, FigureCount> kOrder{In,     Out,        Accepted, Executed,
                                                   Median, Percentile, Theory,   Merged};
  constexpr std::array<const char*, FigureCount> kNames{
      QT_TR_NOOP("In"),          QT_TR_NOOP("Out"),      QT_TR_NOOP("Accepted"),
      QT_TR_NOOP("Executed"),    QT_TR_NOOP("Merged"),   QT_TR_NOOP("Delay, median"),
      QT_TR_NOOP("Delay, 99 %"), QT_TR_NOOP("In theory")};
  constexpr std::array<const char*, FigureCount> kHints{
      QT_TR_NOOP("Points from the source, mean of the last two seconds"),
      QT_TR_NOOP("Points executed, mean of the last two seconds"),
      QT_TR_NOOP("Points of the source within the agreed limits"),
      QT_TR_NOOP("Points that are known to be executed"),
      QT_TR_NOOP("Points too close to the one before, which are left out"),
      QT_TR_NOOP("From the arrival of a point to the beginning of its move; during a run, of the "
                 "last 500 points"),
      QT_TR_NOOP("Of a hundred points, one was later than this."),
      QT_TR_NOOP("Least delay, and the delay when all buffers are full")};
  for (std::size_t place = 0; place < kOrder.size(); ++place) {
    const Figure figure = kOrder[place];
    m_values[figure] = value({.tip = kHints[figure], .name = kNames[figure]});
    QLabel* name =
        label({.text = kNames[figure], .tip = kHints[figure], .isMuted = true, .wraps = true});
    // The last two are too wide for that.
    const bool isWide = figure == Theory || figure == Merged;
    const int row = figure == Merged ? 5 : static_cast<int>(place / 2) + 1;
    const int column = isWide ? 0 : 2 * static_cast<int>(place % 2);
    run->addWidget(name, row, column);
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
  int row = 0;
  for (const char* fact :
       {"X", "Y", "Z", QT_TR_NOOP("First point within"), QT_TR_NOOP("Largest step"),
        QT_TR_NOOP("Largest F"), QT_TR_NOOP("Merge below"), QT_TR_NOOP("When it is silent")}) {
    const auto at = static_cast<std::size_t>(row);
    m_facts[at] = value({.wraps = true});
    agreed->addWidget(label({.text = fact, .isMuted = true}), row, 0, Qt::AlignTop);
    agreed->addWidget(m_facts[at], row++, 1);
  }
  agreed->setColumnStretch(1, 1);

  auto* inner = new QWidget;
  inColumn({m_run, m_agreed, spring()}, inner, QMargins(0, 0, 0, 0));
  inColumn({inRow({{m_open, 1}, {m_change, 1}}),
            m_title,
            m_state,
            m_hint,
            {makeScrolling(inner, this), 1}},
           this);
  onLanguage(&LivePanel::showAll);
}

void LivePanel::setSource(const live::Setup& setup, const QString& name, const QString& obstacle) {
  if (setup != m_setup || name != m_name) {
    m_level.reset();
    m_summary.reset();
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
  showAll();
}

void LivePanel::setUpdate(const streaming::LiveUpdate& update) {
  if (!m_isRunning) {
    return;
  }
  if (update.source) {
    m_level = update.source;
  }
  showState();
  showBuffer();
  showFigures();
}

void LivePanel::setReport(const streaming::RunReport& report) {
  m_isRunning = false;
  m_summary = report.live;
  if (m_level && report.live) {
    m_level->accepted = report.live->accepted;
    m_level->executed = report.live->executed;
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
  showFigure(Executed, m_level ? countText(m_level->executed) : noValue());
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

}  // namespace rivulet::widgets
