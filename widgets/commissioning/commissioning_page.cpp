// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/commissioning/commissioning_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/calibration/access_source.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

using streaming::CommissioningStep;

namespace {

constexpr int kCellMost = 100'000;
constexpr double kMoveMostMm = 500.0;
constexpr double kFeedMost = 100'000.0;
/// Three seconds: long enough to be held on its way.
constexpr streaming::AirMove kMove{0, 20.0, 400.0};

}  // namespace

CommissioningPage::CommissioningPage(std::unique_ptr<ControlTestTexts> texts, QWidget* parent)
    : Page(parent),
      m_texts(std::move(texts)),
      m_cell(whole(0, kCellMost, {.name = QT_TR_NOOP("First R-parameter of the test")})),
      m_lengthMm(say(new NumberField(this), {.name = QT_TR_NOOP("Way of the axis, mm")})),
      m_feed(say(new NumberField(this), {.name = QT_TR_NOOP("Feed of the axis, mm/min")})),
      m_liftMm(say(new NumberField(this),
                   {.tip = QT_TR_NOOP(
                        "While the axis is held, the tool is lifted along Z by so much and comes "
                        "back; 0: it is not lifted. A run may lift the tool only after that. Not "
                        "with Z as the axis."),
                    .name = QT_TR_NOOP("Lift of the tool, mm")})),
      m_program(say(new QPlainTextEdit(this), {.name = QT_TR_NOOP("Test program")})),
      m_blocks(say(new QPlainTextEdit(this),
                   {.tip = QT_TR_NOOP("One block a line, as a program has it: S500 M3, M8, T1 M6"),
                    .name = QT_TR_NOOP("Blocks to be tried")})),
      m_blockedLabel(new StatusLabel(this, StatusLabel::Elided{2})),
      m_checks(new QVBoxLayout) {
  m_verdict->setEmphasis(14.0, true);
  m_program->setReadOnly(true);
  m_program->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_program->setMinimumHeight(120);
  auto* cells = inRow({label({.text = QT_TR_NOOP("First R-parameter"), .isMuted = true}),
                       m_cell,
                       {m_confirmed, 1}});
  m_blocks->setFont(m_program->font());
  m_blocks->setMaximumHeight(90);
  m_blocks->setTabChangesFocus(true);
  m_blocks->setVisible(m_texts->isOfJobs());
  m_program->setVisible(!m_texts->isOfJobs());
  m_byHand->setVisible(!m_texts->isOfJobs());
  auto* layout =
      inColumn({m_verdict, m_machine, m_what, cells, m_byHand, m_moves, moveRow(), m_blocks}, this);
  for (StatusLabel*& step : m_steps) {
    step = new StatusLabel(this);
    step->setWordWrap(true);
    layout->addWidget(step);
  }
  layout->addLayout(inRow({m_start, m_cancel, {m_blockedLabel, 1}}));
  layout->addLayout(m_checks);
  layout->addWidget(m_program, 1);
  // Other cells, or another move, must be confirmed again.
  connect(m_cell, &WholeNumberField::valueChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_confirmed, &QCheckBox::toggled, this, &CommissioningPage::showButtons);
  connect(m_byHand, &QCheckBox::toggled, this, &CommissioningPage::showSteps);
  connect(m_start, &QPushButton::clicked, this, [this] {
    const auto move = typedMove();
    const auto blocks = typedBlocks();
    m_problem.clear();
    m_confirmed->setChecked(false);
    m_word->clear();
    Q_EMIT testRequested(m_cell->value(), m_byHand->isChecked(), move, blocks);
  });
  retranslate();
}

QWidget* CommissioningPage::moveRow() {
  m_moves->setVisible(m_texts->mayMove() && !m_texts->isOfJobs());
  for (const char axis : base::kAxisNames) {
    m_axis->addItem(QString(QLatin1Char(axis)));
  }
  m_axis->setCurrentIndex(kMove.axis);
  m_lengthMm->setRange(-kMoveMostMm, kMoveMostMm);
  m_lengthMm->setValue(kMove.mm);
  m_feed->setRange(0.0, kFeedMost);
  m_feed->setDecimals(0);
  m_feed->setValue(kMove.feedMmPerMin);
  m_liftMm->setRange(0.0, templates::kLiftMmMax);
  m_liftMm->setDecimals(1);
  auto* lift = label({.text = QT_TR_NOOP("lift, mm"), .isMuted = true});
  auto* row = new QWidget(this);
  row->setLayout(inRow({m_axis,
                        label({.text = QT_TR_NOOP("by, mm"), .isMuted = true}),
                        m_lengthMm,
                        label({.text = QT_TR_NOOP("F, mm/min"), .isMuted = true}),
                        m_feed,
                        lift,
                        m_liftMm,
                        {m_word, 1}}));
  lift->setVisible(!m_texts->isOfJobs());
  m_liftMm->setVisible(!m_texts->isOfJobs());
  m_moves->setChecked(m_texts->isOfJobs());
  row->setVisible(m_texts->isOfJobs());
  connect(m_blocks, &QPlainTextEdit::textChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_moves, &QCheckBox::toggled, row, &QWidget::setVisible);
  connect(m_moves, &QCheckBox::toggled, this, &CommissioningPage::forgetConfirmations);
  connect(m_axis, &QComboBox::currentIndexChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_lengthMm, &NumberField::valueChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_feed, &NumberField::valueChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_liftMm, &NumberField::valueChanged, this, &CommissioningPage::forgetConfirmations);
  connect(m_word, &QLineEdit::textChanged, this, &CommissioningPage::showButtons);
  return row;
}

void CommissioningPage::forgetConfirmations() {
  m_confirmed->setChecked(false);
  m_word->clear();
  retranslate();
}

std::optional<streaming::AirMove> CommissioningPage::typedMove() const {
  return m_texts->mayMove() && m_moves->isChecked()
             ? std::optional(streaming::AirMove{m_axis->currentIndex(), m_lengthMm->value(),
                                                m_feed->value(), m_liftMm->value()})
             : std::nullopt;
}

std::vector<std::string> CommissioningPage::typedBlocks() const {
  std::vector<std::string> blocks;
  for (const QString& line : m_blocks->toPlainText().split(QLatin1Char('\n'))) {
    if (m_texts->isOfJobs() && !line.trimmed().isEmpty()) {
      blocks.push_back(line.trimmed().toStdString());
    }
  }
  return blocks;
}

QString CommissioningPage::moveProblem() const {
  const auto move = typedMove();
  if (!move) {
    return {};
  }
  streaming::JobTestPlan plan;
  plan.move = *move;
  plan.blocks = typedBlocks();
  if (const auto fits = m_texts->isOfJobs() ? streaming::requireJobTestPlan(plan)
                                            : streaming::requireAirMove(*move);
      !fits) {
    return errorText(fits.error());
  }
  return m_word->text().trimmed() == QLatin1String(kMoveWord)
             ? QString()
             : tr("Clear the way of the axis, then type %1.").arg(QLatin1String(kMoveWord));
}

void CommissioningPage::setTest(const std::optional<ShownTest>& test, bool isOutdated) {
  m_test = test;
  m_isOutdated = isOutdated;
  showResult();
}

void CommissioningPage::setProgress(std::optional<CommissioningStep> step) {
  m_step = step;
  showSteps();
  showResult();
  showButtons();
}

void CommissioningPage::setProblem(const QString& reason) {
  m_problem = reason;
  showResult();
}

void CommissioningPage::setBlocked(const QString& why) {
  m_blocked = why;
  showButtons();
}

void CommissioningPage::retranslate() {
  m_what->setText(m_texts->what());
  m_confirmed->setText(tr("Nobody else uses R%1 to R%2")
                           .arg(m_cell->value())
                           .arg(m_cell->value() + m_texts->cells() - 1));
  m_blocks->setPlaceholderText(tr("Blocks to be tried, one a line: S500 M3"));
  m_word->setPlaceholderText(tr("Nothing is in its way: %1").arg(QLatin1String(kMoveWord)));
  m_program->setPlainText(m_texts->program(m_cell->value(), typedMove()));
  showSteps();
  showResult();
  showButtons();
}

void CommissioningPage::showSteps() {
  const QString name = m_texts->fileName();
  const std::array<QString, 4> texts{
      tr("1. Bring the channel to reset, in AUTO."),
      m_byHand->isChecked()
          ? tr("2. Store the text below as part program %1 and select it.").arg(name)
      : m_texts->isOfJobs()
          ? tr("2. The programs of the job are transferred, read back and selected.")
          : tr("2. The program %1 is transferred, read back and selected.").arg(name),
      tr("3. Press cycle start at the control (a virtual machine starts by itself)."),
      m_texts->lastStep(typedMove())};
  // Before the test everything is to come; then the steps are done one after another.
  const std::size_t current = !m_step ? 0 : *m_step == CommissioningStep::CycleStart ? 2 : 3;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Status status = !m_step        ? Status::Plain
                          : i < current  ? Status::Good
                          : i == current ? Status::Busy
                                         : Status::Unknown;
    m_steps[i]->setStatus(status, texts[i]);
  }
  m_byHand->setEnabled(!m_step);
  m_cell->setEnabled(!m_step);
  m_moves->setEnabled(!m_step);
  m_blocks->setReadOnly(m_step.has_value());
}

void CommissioningPage::showResult() {
  m_seen.clear();
  while (QLayoutItem* item = m_checks->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (m_step) {
    m_verdict->setStatus(Status::Busy, *m_step == CommissioningStep::CycleStart
                                           ? tr("Waiting for cycle start")
                                       : *m_step == CommissioningStep::CycleStartAgain
                                           ? tr("Waiting for cycle start, once more")
                                           : tr("The test is in progress"));
  } else if (!m_problem.isEmpty()) {
    m_verdict->setStatus(Status::Attention, m_problem);
  } else if (!m_test) {
    m_verdict->setStatus(Status::Unknown, m_texts->notTested());
  } else if (m_isOutdated) {
    m_verdict->setStatus(Status::Attention,
                         tr("Tested with another version of the server: test it again"));
  } else if (m_test->isEnough) {
    m_verdict->setStatus(Status::Good, m_texts->enough());
  } else if (m_test->result.passed()) {
    m_verdict->setStatus(Status::Attention, m_texts->notEnough());
  } else {
    m_verdict->setStatus(Status::Fault, m_texts->failed());
  }
  m_machine->setVisible(m_test.has_value() && !m_step);
  if (!m_test || m_step) {
    return;
  }
  m_machine->setText(tr("%1, %2, tested %3; %4")
                         .arg(QString::fromStdString(m_test->endpoint),
                              QString::fromStdString(streaming::versionText(m_test->server)),
                              dateText(m_test->testedAtUtc), m_test->figures()));
  for (const streaming::CommissioningCheck& check : m_test->result.checks) {
    auto* label = new StatusLabel(this);
    label->setWordWrap(true);
    label->setStatus(check.passed ? Status::Good : Status::Fault, m_texts->check(check));
    m_checks->addWidget(label);
    label->show();
  }
  showTried();
}

void CommissioningPage::showTried() {
  for (std::size_t i = 0; i < m_test->tried.size(); ++i) {
    const streaming::TriedBlock& block = m_test->tried[i];
    const bool isOpen = block.witness == streaming::Witness::Nobody;
    auto* row = new QWidget(this);
    auto* label = new StatusLabel(row);
    label->setWordWrap(true);
    label->setStatus(
        isOpen ? Status::Attention : Status::Good,
        QStringLiteral("%1: %2").arg(QString::fromStdString(block.text),
                                     isOpen ? tr("the control shows nothing of it; not released")
                                     : block.witness == streaming::Witness::Operator
                                         ? tr("seen by the operator")
                                         : QString::fromStdString(block.message)));
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins({});
    line->addWidget(label, 1);
    if (isOpen && m_test->isEnough) {
      auto* seen = new QPushButton(tr("I have seen it"), row);
      connect(seen, &QPushButton::clicked, this, [this, i] { Q_EMIT blockConfirmed(i); });
      line->addWidget(seen);
      m_seen.push_back(seen);
    }
    m_checks->addWidget(row);
    row->show();
  }
  showButtons();
}

void CommissioningPage::showButtons() {
  const QString move = moveProblem();
  m_start->setEnabled(!m_step && m_blocked.isEmpty() && m_confirmed->isChecked() && move.isEmpty());
  for (QPushButton* seen : m_seen) {
    seen->setEnabled(m_blocked.isEmpty());  // who may not test may not release either
  }
  m_cancel->setVisible(m_step.has_value());
  m_confirmed->setEnabled(!m_step);
  const QString why = !m_blocked.isEmpty()        ? m_blocked
                      : !m_confirmed->isChecked() ? tr("Confirm the R-parameters first.")
                                                  : move;
  m_blockedLabel->setVisible(!m_step && !why.isEmpty());
  m_blockedLabel->setStatus(Status::Unknown, why);
}

}  // namespace rivulet::widgets
