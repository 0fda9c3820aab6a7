// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/machines.h"

#include <algorithm>
#include <map>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::hmi {

Machines::Machines(Document& document, MachineModel& machine, RunController& runs,
                   PastRuns& pastRuns, report::MachineStore store)
    : m_document(document), m_machine(machine), m_runs(runs), m_store(std::move(store)) {
  connect(&pastRuns, &PastRuns::listed, this,
          [this](const std::shared_ptr<const report::HistoryList>& list) {
            const bool isFirst = m_history == nullptr;
            m_history = list;
            refresh();
            if (isFirst) {
              Q_EMIT found();
            }
          });
  connect(&m_machine, &MachineModel::linkChanged, this, &Machines::refresh);
  connect(&m_machine, &MachineModel::calibrationChanged, this, &Machines::refresh);
  connect(&m_runs, &RunController::permissionsChanged, this, &Machines::changed);
}

void Machines::refresh() {
  m_known = m_store.machines();
  Q_EMIT changed();
}

std::vector<widgets::MachineCardView> Machines::cards() const {
  std::map<std::string, widgets::MachineCardView> cards;
  for (const report::KnownMachine& known : m_known) {
    widgets::MachineCardView& card = cards[known.endpoint];
    card.name = card.name.isEmpty() ? QString::fromStdString(known.name) : card.name;
  }
  if (m_history) {
    for (const streaming::RunSummary& run : m_history->runs) {  // the newest first
      if (run.endpoint.empty()) {
        continue;
      }
      widgets::MachineCardView& card = cards[run.endpoint];
      if (card.lastRun.isEmpty()) {
        card.lastRun = tr("Last run %1: %2, %3 of %4 points")
                           .arg(widgets::startText(run), QString::fromStdString(run.programName),
                                widgets::countText(run.executed), widgets::countText(run.total));
      }
    }
  }
  const std::string present = m_machine.endpoint().trimmed().toStdString();
  if (m_machine.isConnected()) {
    cards[present];
  }
  std::vector<widgets::MachineCardView> list;
  for (auto& [endpoint, card] : cards) {
    card.endpoint = QString::fromStdString(endpoint);
    if (endpoint == present) {
      card.isPresent = true;
      card.connection = m_machine.connectionState();
      card.machine = m_machine.view();
      if (m_runs.isRunning() && m_document.program()) {
        const streaming::Counters& counters = m_runs.update().counters;
        card.program = QString::fromStdString(m_document.program()->name);
        card.progress = counters.total > 0 ? static_cast<double>(counters.executed) /
                                                 static_cast<double>(counters.total)
                                           : 0.0;
      }
    }
    list.push_back(std::move(card));
  }
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.name.isEmpty() == b.name.isEmpty() ? a.name.localeAwareCompare(b.name) < 0
                                                : !a.name.isEmpty();
  });
  return list;
}

void Machines::open(const QString& endpoint) {
  const bool isPresent = endpoint == m_machine.endpoint().trimmed() && m_machine.isConnected();
  if (!isPresent && canChange()) {
    m_machine.connectTo(endpoint);
  }
}

}  // namespace rivulet::hmi
