// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/machines_page.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/connection/board_card.h"
#include "widgets/connection/connection_state.h"
#include "widgets/connection/service_card.h"
#include "widgets/connection/service_panel.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::widgets {

namespace {

constexpr int kCardPx = 340;
constexpr int kCardGapPx = 12;

}  // namespace

/// One machine. Its button connects or opens it.
class MachineCard final : public BoardCard {
  Q_DECLARE_TR_FUNCTIONS(MachineCard)

 public:
  explicit MachineCard(QWidget* parent)
      : BoardCard(QString(), parent),
        m_endpoint(new ElidedLabel(1, this)),
        m_link(new StatusLabel(this)),
        m_state(new StatusLabel(this)),
        m_program(new ElidedLabel(1, this)),
        m_progress(new QProgressBar(this)),
        m_alarms(new StatusLabel(this)),
        m_lastRun(new QLabel(this)) {
    m_lastRun->setWordWrap(true);
    addRows({m_endpoint, m_link, m_state, m_program, m_progress, m_alarms, m_lastRun});
  }

  [[nodiscard]] const MachineCardView& view() const { return m_view; }

  void show(const MachineCardView& view, const QString& blocked) {
    const bool isSame = view.endpoint == m_view.endpoint;
    m_view = view;
    name()->setText(view.name.isEmpty() ? view.endpoint : view.name);
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
    showProgress(*m_progress, view.progress);
    m_alarms->setVisible(view.isPresent && view.alarms > 0);
    m_alarms->setStatus(Status::Fault, tr("%n alarms", nullptr, static_cast<int>(view.alarms)));
    m_lastRun->setText(lastRunText());
    open()->setText(isConnected ? tr("Open") : tr("Connect"));
    open()->setAccessibleName(open()->text() + QLatin1Char(' ') + name()->text());
    open()->setEnabled(blocked.isEmpty() || view.isPresent);
    open()->setToolTip(open()->isEnabled() ? QString() : blocked);
    setRemoval(isSame, view.canRemove, questionText());
  }

 private:
  [[nodiscard]] QString questionText() const {
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
    if (m_view.hasFeedTest) {
      kept.append(tr("stop test"));
    }
    if (m_view.hasJobTest) {
      kept.append(tr("job test"));
    }
    const QString question =
        tr("Remove this machine from the list? Its runs and recordings stay on the page Runs.");
    return kept.isEmpty() ? question
                          : question + QLatin1Char(' ') +
                                tr("Put aside as files, and not used any more: %1.")
                                    .arg(kept.join(QStringLiteral(", ")));
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
  ElidedLabel* m_endpoint;
  StatusLabel* m_link;
  StatusLabel* m_state;
  ElidedLabel* m_program;
  QProgressBar* m_progress;
  StatusLabel* m_alarms;
  QLabel* m_lastRun;
};

MachinesPage::MachinesPage(QWidget* parent)
    : Page(parent),
      m_board(new QWidget(this)),
      m_panel(new ServicePanel(this)),
      m_grid(new QGridLayout),
      m_serviceGrid(new QGridLayout),
      m_foundList(new QVBoxLayout) {
  m_showLeftOver->setCheckable(true);
  connect(m_showLeftOver, &QPushButton::toggled, this, [this] { showCards(); });
  m_grid->setSpacing(kCardGapPx);
  auto* board = inColumn({m_note, m_grid, inRow({{m_leftOverNote, 1}, m_showLeftOver})}, m_board,
                         QMargins(0, 0, 0, 0));
  buildServices(*board);
  board->addStretch(1);
  inColumn({{m_board, 1}, {m_panel, 1}}, this);
  m_panel->hide();
  connect(m_panel, &ServicePanel::closeRequested, this, [this] { openService(QString()); });
  retranslate();
}

void MachinesPage::buildServices(QVBoxLayout& layout) {
  m_serviceGrid->setSpacing(kCardGapPx);
  m_address->setPlaceholderText(QStringLiteral("opc.tcp://192.168.214.7:4841"));
  m_addLabel->setBuddy(m_address);
  layout.addWidget(heading({.text = QT_TR_NOOP("Services: machines without a window")}));
  layout.addLayout(m_serviceGrid);
  layout.addLayout(inRow({m_addLabel, {m_address, 1}, m_add, m_search}));
  layout.addWidget(m_foundNote);
  layout.addLayout(m_foundList);
  const auto add = [this] {
    if (!m_address->text().trimmed().isEmpty() && m_add->isEnabled()) {
      Q_EMIT addServiceRequested(m_address->text().trimmed());
    }
  };
  connect(m_add, &QPushButton::clicked, this, add);
  connect(m_address, &QLineEdit::returnPressed, this, add);
  connect(m_address, &QLineEdit::textChanged, this, &MachinesPage::showServices);
  connect(m_search, &QPushButton::clicked, this,
          [this] { Q_EMIT searchRequested(m_address->text().trimmed()); });
}

void MachinesPage::setServices(const std::vector<ServiceView>& services) {
  m_services = services;
  showServices();
}

void MachinesPage::clearAddress() {
  m_address->clear();
  m_address->setFocus();
}

void MachinesPage::setServicesBlocked(const QString& why) {
  m_servicesBlocked = why;
  showServices();
}

void MachinesPage::openService(const QString& endpoint) {
  const auto found =
      std::find_if(m_services.begin(), m_services.end(),
                   [&](const ServiceView& service) { return service.endpoint == endpoint; });
  const bool isThere = found != m_services.end();
  if (isThere) {
    m_panel->setService(*found);
  }
  m_board->setVisible(!isThere);
  m_panel->setVisible(isThere);
}

void MachinesPage::showServices() {
  while (m_serviceCards.size() > m_services.size()) {
    delete m_serviceCards.back();
    m_serviceCards.pop_back();
  }
  while (m_serviceCards.size() < m_services.size()) {
    auto* card = new ServiceCard(m_board);
    connect(card, &ServiceCard::openRequested, this, &MachinesPage::openService);
    connect(card, &ServiceCard::removeRequested, this, &MachinesPage::removeServiceRequested);
    m_serviceCards.push_back(card);
  }
  for (std::size_t i = 0; i < m_services.size(); ++i) {
    m_services[i].canRemove = m_servicesBlocked.isEmpty();
    m_serviceCards[i]->show(m_services[i]);
    if (m_panel->isVisible() && m_services[i].endpoint == m_panel->endpoint()) {
      m_panel->setService(m_services[i]);
    }
  }
  if (m_placed != m_services.size()) {
    m_columns = 0;
    place();
  }
  m_add->setEnabled(m_servicesBlocked.isEmpty() && !m_address->text().trimmed().isEmpty());
  m_search->setEnabled(m_servicesBlocked.isEmpty());
  m_address->setEnabled(m_servicesBlocked.isEmpty());
  m_add->setToolTip(m_servicesBlocked.isEmpty()
                        ? tr("Puts the service with this address on the board.")
                        : m_servicesBlocked);
  m_search->setToolTip(
      m_servicesBlocked.isEmpty()
          ? tr("Asks a discovery server of OPC UA for services: that of the address, or of this "
               "computer.")
          : m_servicesBlocked);
}

void MachinesPage::setFound(const QStringList& endpoints, const QString& note) {
  m_found = endpoints;
  m_foundText = note;
  while (m_foundButtons.size() > static_cast<std::size_t>(endpoints.size())) {
    delete m_foundButtons.back();
    m_foundButtons.pop_back();
  }
  while (m_foundButtons.size() < static_cast<std::size_t>(endpoints.size())) {
    QPushButton* button = makeTouchButton(m_board);
    const auto index = static_cast<qsizetype>(m_foundButtons.size());
    button->setObjectName(QStringLiteral("service-found-%1").arg(index));
    // Queued: the list loses the button that is clicked.
    connect(
        button, &QPushButton::clicked, this,
        [this, index] { Q_EMIT addServiceRequested(m_found.value(index)); }, Qt::QueuedConnection);
    m_foundList->addWidget(button, 0, Qt::AlignLeft);
    m_foundButtons.push_back(button);
  }
  for (qsizetype i = 0; i < endpoints.size(); ++i) {
    m_foundButtons[static_cast<std::size_t>(i)]->setText(tr("Add %1").arg(endpoints[i]));
    m_foundButtons[static_cast<std::size_t>(i)]->setToolTip(
        tr("Puts the service with this address on the board."));
  }
  m_foundNote->setText(note);
  m_foundNote->setVisible(!note.isEmpty());
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
    auto* card = new MachineCard(m_board);
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

namespace {

template <class Card>
void placeIn(QGridLayout& grid, const std::vector<Card*>& cards, int columns) {
  for (std::size_t i = 0; i < cards.size(); ++i) {
    grid.addWidget(cards[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
  }
  for (int column = 0; column < std::max(columns, grid.columnCount()); ++column) {
    grid.setColumnStretch(column, column < columns ? 1 : 0);
  }
}

}  // namespace

void MachinesPage::place() {
  const int columns = std::max(1, width() / (kCardPx + kCardGapPx));
  if (columns == m_columns) {
    return;
  }
  m_columns = columns;
  m_placed = m_serviceCards.size();
  placeIn(*m_grid, m_cards, columns);
  placeIn(*m_serviceGrid, m_serviceCards, columns);
}

void MachinesPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  place();
}

void MachinesPage::retranslate() {
  for (MachineCard* card : m_cards) {
    card->show(MachineCardView(card->view()), m_blocked);
  }
  setFound(QStringList(m_found), QString(m_foundText));
  showServices();
  showLeftOver();
}

}  // namespace rivulet::widgets
