// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/machines_page.h"

#include <QCoreApplication>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_state.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::widgets {

namespace {

constexpr int kCardPx = 340;
constexpr int kCardGapPx = 12;

}  // namespace

/// One machine. Its button connects or opens it.
class MachineCard final : public QFrame {
  Q_DECLARE_TR_FUNCTIONS(MachineCard)

 public:
  explicit MachineCard(QWidget* parent)
      : QFrame(parent),
        m_name(new ElidedLabel(1, this)),
        m_endpoint(new ElidedLabel(1, this)),
        m_link(new StatusLabel(this)),
        m_state(new StatusLabel(this)),
        m_program(new ElidedLabel(1, this)),
        m_progress(new QProgressBar(this)),
        m_alarms(new StatusLabel(this)),
        m_lastRun(new QLabel(this)),
        m_question(new QLabel(this)),
        m_open(makeTouchButton(this)),
        m_remove(makeTouchButton(this)),
        m_confirm(makeTouchButton(this)),
        m_keep(makeTouchButton(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont font = m_name->font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * 1.3);
    m_name->setFont(font);
    m_lastRun->setWordWrap(true);
    m_question->setWordWrap(true);
    m_open->setObjectName(QStringLiteral("open"));
    m_remove->setObjectName(QStringLiteral("remove"));
    m_confirm->setObjectName(QStringLiteral("confirm-remove"));
    m_keep->setObjectName(QStringLiteral("keep"));
    m_progress->setRange(0, 1000);
    auto* layout = new QVBoxLayout(this);
    for (QWidget* row :
         std::initializer_list<QWidget*>{m_name, m_endpoint, m_link, m_state, m_program, m_progress,
                                         m_alarms, m_lastRun, m_question}) {
      layout->addWidget(row);
    }
    layout->addStretch();
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_open, 1);
    buttons->addWidget(m_remove);
    buttons->addWidget(m_keep, 1);
    buttons->addWidget(m_confirm);
    layout->addLayout(buttons);
    QObject::connect(m_remove, &QPushButton::clicked, this, [this] { ask(true); });
    QObject::connect(m_keep, &QPushButton::clicked, this, [this] { ask(false); });
  }

  [[nodiscard]] QPushButton* open() const { return m_open; }
  [[nodiscard]] QPushButton* confirm() const { return m_confirm; }
  [[nodiscard]] const MachineCardView& view() const { return m_view; }

  void show(const MachineCardView& view, const QString& blocked) {
    m_isAsking = m_isAsking && view.endpoint == m_view.endpoint && view.canRemove;
    m_view = view;
    m_name->setText(view.name.isEmpty() ? view.endpoint : view.name);
    m_endpoint->setText(view.endpoint);
    m_endpoint->setVisible(!view.name.isEmpty());
    showLink();
    const bool isConnected = view.connection == ConnectionState::Connected;
    const ProgramStatusText state = programStatusText(view.machine.programStatus);
    m_state->setVisible(isConnected);
    m_state->setStatus(state.status, state.text);
    m_program->setVisible(isConnected && !view.program.isEmpty());
    m_program->setText(view.program);
    m_progress->setVisible(isConnected && !view.program.isEmpty());
    m_progress->setValue(static_cast<int>(1000.0 * view.progress));
    m_progress->setFormat(percentText(view.progress));
    m_alarms->setVisible(view.isPresent && view.alarms > 0);
    m_alarms->setStatus(Status::Fault, tr("%n alarms", nullptr, static_cast<int>(view.alarms)));
    m_lastRun->setText(lastRunText());
    m_open->setText(isConnected ? tr("Open") : tr("Connect"));
    m_open->setAccessibleName(m_open->text() + QLatin1Char(' ') + m_name->text());
    m_open->setEnabled(blocked.isEmpty() || view.isPresent);
    m_open->setToolTip(m_open->isEnabled() ? QString() : blocked);
    m_remove->setText(tr("Remove …"));
    m_remove->setAccessibleName(m_remove->text() + QLatin1Char(' ') + m_name->text());
    m_confirm->setText(tr("Remove"));
    m_keep->setText(tr("Keep it"));
    showQuestion();
  }

 private:
  static QString percentText(double share) {
    return QStringLiteral("%1\u00A0%").arg(numberText(100.0 * share, 1));
  }

  void ask(bool isAsking) {
    m_isAsking = isAsking;
    showQuestion();
    (isAsking ? m_keep : m_remove)->setFocus();
  }

  void showQuestion() {
    QStringList kept;
    if (m_view.hasLimits) {
      kept.append(tr("limits"));
    }
    if (m_view.hasCalibration) {
      kept.append(tr("calibration"));
    }
    if (m_view.hasCreditTest) {
      kept.append(tr("credit test"));
    }
    m_question->setText(
        tr("Remove this machine from the list? Its runs and recordings stay on the page Runs.") +
        (kept.isEmpty() ? QString()
                        : QLatin1Char(' ') + tr("Put aside as files, and not used any more: %1.")
                                                 .arg(kept.join(QStringLiteral(", ")))));
    m_question->setVisible(m_isAsking);
    m_confirm->setVisible(m_isAsking);
    m_keep->setVisible(m_isAsking);
    m_open->setVisible(!m_isAsking);
    m_remove->setVisible(!m_isAsking && m_view.canRemove);
  }

  [[nodiscard]] QString lastRunText() const {
    if (!m_view.lastRun) {
      return tr("No run is known.");
    }
    const streaming::RunSummary& run = *m_view.lastRun;
    return tr("Last run %1: %2, %3 of %4 points")
        .arg(startText(run), QString::fromStdString(run.programName), countText(run.executed),
             countText(run.total));
  }

  void showLink() {
    const bool isUsed = m_view.isPresent && m_view.connection != ConnectionState::Disconnected;
    if (!isUsed && m_view.answers) {
      const QString age = secondsText(m_view.lookedS, 0);
      m_link->setStatus(Status::Unknown,
                        *m_view.answers ? tr("Not connected; its port answered %1 ago").arg(age)
                                        : tr("Not reachable: no answer %1 ago").arg(age));
      return;
    }
    if (!m_view.isPresent) {
      m_link->setStatus(Status::Unknown, tr("Not connected with this window"));
      return;
    }
    QString text = connectionText(m_view.connection);
    Status status = connectionStatus(m_view.connection);
    const std::optional<double> ageS = m_view.machine.stateAgeS;
    if (m_view.connection == ConnectionState::Connected && ageS) {
      text = tr("%1, seen %2 ago").arg(text, secondsText(*ageS, 0));
      status = m_view.machine.isVirtualMachine ? Status::Simulated : status;
      status = *ageS > 1.0 ? Status::Attention : status;
    }
    m_link->setStatus(status, text);
  }

  MachineCardView m_view;
  ElidedLabel* m_name;
  ElidedLabel* m_endpoint;
  StatusLabel* m_link;
  StatusLabel* m_state;
  ElidedLabel* m_program;
  QProgressBar* m_progress;
  StatusLabel* m_alarms;
  QLabel* m_lastRun;
  QLabel* m_question;
  QPushButton* m_open;
  QPushButton* m_remove;
  QPushButton* m_confirm;
  QPushButton* m_keep;
  bool m_isAsking = false;
};

MachinesPage::MachinesPage(QWidget* parent)
    : Page(parent),
      m_note(new QLabel(this)),
      m_grid(new QGridLayout),
      m_leftOverNote(new QLabel(this)),
      m_showLeftOver(makeTouchButton(this)) {
  m_note->setWordWrap(true);
  m_leftOverNote->setWordWrap(true);
  m_showLeftOver->setObjectName(QStringLiteral("show-left-over"));
  m_showLeftOver->setCheckable(true);
  connect(m_showLeftOver, &QPushButton::toggled, this, [this] { showCards(); });
  m_grid->setSpacing(kCardGapPx);
  auto* leftOver = new QHBoxLayout;
  leftOver->addWidget(m_leftOverNote, 1);
  leftOver->addWidget(m_showLeftOver);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_note);
  layout->addLayout(m_grid);
  layout->addLayout(leftOver);
  layout->addStretch(1);
  retranslate();
}

void MachinesPage::setMachines(const std::vector<MachineCardView>& machines) {
  m_machines = machines;
  showCards();
}

void MachinesPage::showCards() {
  std::vector<MachineCardView> shown;
  std::copy_if(m_machines.begin(), m_machines.end(), std::back_inserter(shown),
               [this](const MachineCardView& machine) {
                 return !machine.isLeftOver || m_showLeftOver->isChecked();
               });
  const bool isOther = shown.size() != m_cards.size();
  while (m_cards.size() > shown.size()) {
    delete m_cards.back();
    m_cards.pop_back();
  }
  while (m_cards.size() < shown.size()) {
    auto* card = new MachineCard(this);
    connect(card->open(), &QPushButton::clicked, this,
            [this, card] { Q_EMIT openRequested(card->view().endpoint); });
    // Queued: the list loses the card that is clicked.
    connect(
        card->confirm(), &QPushButton::clicked, this,
        [this, card] { Q_EMIT removeRequested(card->view().endpoint); }, Qt::QueuedConnection);
    m_cards.push_back(card);
  }
  for (std::size_t i = 0; i < shown.size(); ++i) {
    m_cards[i]->show(shown[i], m_blocked);
  }
  if (isOther) {
    m_columns = 0;
    place();
  }
  showLeftOver();
}

void MachinesPage::showLeftOver() {
  const auto count = std::count_if(m_machines.begin(), m_machines.end(),
                                   [](const auto& machine) { return machine.isLeftOver; });
  m_leftOverNote->setVisible(count > 0);
  m_showLeftOver->setVisible(count > 0);
  m_leftOverNote->setText(
      tr("%Ln virtual machines of this computer do not answer any more, and nothing but their runs "
         "is kept.",
         nullptr, static_cast<int>(count)));
  m_showLeftOver->setText(m_showLeftOver->isChecked() ? tr("Hide them") : tr("Show them"));
}

void MachinesPage::setBlocked(const QString& why) {
  m_blocked = why;
  for (MachineCard* card : m_cards) {
    card->show(MachineCardView(card->view()), m_blocked);
  }
}

void MachinesPage::place() {
  const int columns = std::max(1, width() / (kCardPx + kCardGapPx));
  if (columns == m_columns) {
    return;
  }
  m_columns = columns;
  for (std::size_t i = 0; i < m_cards.size(); ++i) {
    m_grid->addWidget(m_cards[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
  }
  for (int column = 0; column < std::max(columns, m_grid->columnCount()); ++column) {
    m_grid->setColumnStretch(column, column < columns ? 1 : 0);
  }
}

void MachinesPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  place();
}

void MachinesPage::retranslate() {
  m_note->setText(
      tr("One machine at a time is connected with a window. Of the others only the port is looked "
         "at, every 30 s while this page is shown: a question would cost them time that another "
         "stream may need."));
  for (MachineCard* card : m_cards) {
    card->show(MachineCardView(card->view()), m_blocked);
  }
  showLeftOver();
}

}  // namespace rivulet::widgets
