// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/machines_page.h"

#include <QCoreApplication>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_state.h"

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
        m_open(makeTouchButton(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont font = m_name->font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * 1.3);
    m_name->setFont(font);
    m_lastRun->setWordWrap(true);
    m_progress->setRange(0, 1000);
    auto* layout = new QVBoxLayout(this);
    for (QWidget* row : std::initializer_list<QWidget*>{
             m_name, m_endpoint, m_link, m_state, m_program, m_progress, m_alarms, m_lastRun}) {
      layout->addWidget(row);
    }
    layout->addStretch();
    layout->addWidget(m_open);
  }

  [[nodiscard]] QPushButton* open() const { return m_open; }
  [[nodiscard]] const MachineCardView& view() const { return m_view; }

  void show(const MachineCardView& view, const QString& blocked) {
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
    m_lastRun->setText(view.lastRun.isEmpty() ? tr("No run is known.") : view.lastRun);
    m_open->setText(isConnected ? tr("Open") : tr("Connect"));
    m_open->setAccessibleName(m_open->text() + QLatin1Char(' ') + m_name->text());
    m_open->setEnabled(blocked.isEmpty() || view.isPresent);
    m_open->setToolTip(m_open->isEnabled() ? QString() : blocked);
  }

 private:
  static QString percentText(double share) {
    return QStringLiteral("%1\u00A0%").arg(numberText(100.0 * share, 1));
  }

  void showLink() {
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
  QPushButton* m_open;
};

MachinesPage::MachinesPage(QWidget* parent)
    : Page(parent), m_note(new QLabel(this)), m_grid(new QGridLayout) {
  m_note->setWordWrap(true);
  m_grid->setSpacing(kCardGapPx);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_note);
  layout->addLayout(m_grid);
  layout->addStretch(1);
  retranslate();
}

void MachinesPage::setMachines(const std::vector<MachineCardView>& machines) {
  const bool isOther = machines.size() != m_cards.size();
  while (m_cards.size() > machines.size()) {
    delete m_cards.back();
    m_cards.pop_back();
  }
  while (m_cards.size() < machines.size()) {
    auto* card = new MachineCard(this);
    connect(card->open(), &QPushButton::clicked, this,
            [this, card] { Q_EMIT openRequested(card->view().endpoint); });
    m_cards.push_back(card);
  }
  for (std::size_t i = 0; i < machines.size(); ++i) {
    m_cards[i]->show(machines[i], m_blocked);
  }
  if (isOther) {
    m_columns = 0;
    place();
  }
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
      tr("One machine at a time is connected with a window. The others are not asked, because "
         "each question would cost them time that another stream may need."));
  for (MachineCard* card : m_cards) {
    card->show(MachineCardView(card->view()), m_blocked);
  }
}

}  // namespace rivulet::widgets
