// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/commissioning/commissioning_page.h"

#include <QCheckBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/calibration/access_source.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

using streaming::CommissioningStep;

namespace {

constexpr int kCells = 10;
constexpr int kCellMost = 100'000;

}  // namespace

CommissioningPage::CommissioningPage(QWidget* parent)
    : Page(parent),
      m_cell(whole(0, kCellMost, {.name = QT_TR_NOOP("First R-parameter of the test")})),
      m_program(say(new QPlainTextEdit(this), {.name = QT_TR_NOOP("Test program")})),
      m_blockedLabel(new StatusLabel(this, StatusLabel::Elided{2})),
      m_checks(new QVBoxLayout) {
  m_verdict->setEmphasis(14.0, true);
  m_program->setReadOnly(true);
  m_program->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_program->setMinimumHeight(120);
  auto* cells = inRow({label({.text = QT_TR_NOOP("First R-parameter"), .isMuted = true}),
                       m_cell,
                       {m_confirmed, 1}});
  auto* layout = inColumn(
      {m_verdict, m_machine,
       label(
           {.text = QT_TR_NOOP(
                "Method credit lets the axes move on while the next window is on its way. That is "
                "safe only on a control that answers while its axes are busy. This test finds out: "
                "a program that moves no axis, for a few seconds. The channel must be in reset."),
            .wraps = true}),
       cells, m_byHand},
      this);
  for (StatusLabel*& step : m_steps) {
    step = new StatusLabel(this);
    step->setWordWrap(true);
    layout->addWidget(step);
  }
  layout->addLayout(inRow({m_start, m_cancel, {m_blockedLabel, 1}}));
  layout->addLayout(m_checks);
  layout->addWidget(m_program, 1);
  connect(m_cell, &WholeNumberField::valueChanged, this, [this] {
    // Other cells must be confirmed again.
    m_confirmed->setChecked(false);
    retranslate();
  });
  connect(m_confirmed, &QCheckBox::toggled, this, &CommissioningPage::showButtons);
  connect(m_byHand, &QCheckBox::toggled, this, &CommissioningPage::showSteps);
  connect(m_start, &QPushButton::clicked, this, [this] {
    m_problem.clear();
    m_confirmed->setChecked(false);
    Q_EMIT testRequested(m_cell->value(), m_byHand->isChecked());
  });
  retranslate();
}

void CommissioningPage::setTest(const std::optional<streaming::CreditTest>& test, bool isOutdated) {
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
  m_confirmed->setText(
      tr("Nobody else uses R%1 to R%2").arg(m_cell->value()).arg(m_cell->value() + kCells - 1));
  m_program->setPlainText(QString::fromStdString(streaming::commissioningProgram(m_cell->value())));
  showSteps();
  showResult();
  showButtons();
}

void CommissioningPage::showSteps() {
  const QString name = QString::fromStdString(streaming::commissioningFileName());
  const std::array<QString, 4> texts{
      tr("1. Bring the channel to reset, in AUTO."),
      m_byHand->isChecked()
          ? tr("2. Store the text below as part program %1 and select it.").arg(name)
          : tr("2. The program %1 is transferred, read back and selected.").arg(name),
      tr("3. Press cycle start at the control (a virtual machine starts by itself)."),
      tr("4. Numbers are sent and must come back while the control is busy.")};
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
}

void CommissioningPage::showResult() {
  while (QLayoutItem* item = m_checks->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (m_step) {
    m_verdict->setStatus(Status::Busy, *m_step == CommissioningStep::CycleStart
                                           ? tr("Waiting for cycle start")
                                           : tr("The test is in progress"));
  } else if (!m_problem.isEmpty()) {
    m_verdict->setStatus(Status::Attention, m_problem);
  } else if (!m_test) {
    m_verdict->setStatus(Status::Unknown,
                         tr("Not tested: method credit does not start on this control"));
  } else if (m_isOutdated) {
    m_verdict->setStatus(Status::Attention,
                         tr("Tested with another version of the server: test it again"));
  } else if (m_test->result.passed()) {
    m_verdict->setStatus(Status::Good, tr("Passed: method credit may run on this control"));
  } else {
    m_verdict->setStatus(Status::Fault,
                         tr("Not passed: method credit does not start. Use method window."));
  }
  m_machine->setVisible(m_test.has_value() && !m_step);
  if (!m_test || m_step) {
    return;
  }
  m_machine->setText(tr("%1, %2, tested %3; %4 of %5 answers while busy, the slowest after %6")
                         .arg(QString::fromStdString(m_test->endpoint),
                              QString::fromStdString(streaming::versionText(m_test->server)),
                              dateText(m_test->testedAtUtc),
                              QString::number(m_test->result.answered),
                              QString::number(m_test->result.asked),
                              millisecondsText(m_test->result.slowestAnswer)));
  for (const streaming::CommissioningCheck& check : m_test->result.checks) {
    auto* label = new StatusLabel(this);
    label->setWordWrap(true);
    label->setStatus(check.passed ? Status::Good : Status::Fault, checkText(check));
    m_checks->addWidget(label);
    label->show();
  }
}

QString CommissioningPage::checkText(const streaming::CommissioningCheck& check) {
  const QString name = QString::fromStdString(check.name);
  if (name == QLatin1String("answers-while-busy")) {
    return tr("The control answers the client while blocks wait to be executed.");
  }
  if (name == QLatin1String("main-run-seen-by-client")) {
    return tr("What a synchronized action writes reaches the client.");
  }
  if (name == QLatin1String("main-run-seen-by-program")) {
    return tr("What a synchronized action writes reaches the program without a stop.");
  }
  if (name == QLatin1String("action-with-its-block")) {
    return tr("A synchronized action before a block is executed with that block.");
  }
  if (name == QLatin1String("buffer-level")) {
    return tr("The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).");
  }
  return QString::fromStdString(check.message);
}

void CommissioningPage::showButtons() {
  m_start->setEnabled(!m_step && m_blocked.isEmpty() && m_confirmed->isChecked());
  m_cancel->setVisible(m_step.has_value());
  m_confirmed->setEnabled(!m_step);
  const QString why = !m_blocked.isEmpty()        ? m_blocked
                      : !m_confirmed->isChecked() ? tr("Confirm the R-parameters first.")
                                                  : QString();
  m_blockedLabel->setVisible(!m_step && !why.isEmpty());
  m_blockedLabel->setStatus(Status::Unknown, why);
}

}  // namespace rivulet::widgets
