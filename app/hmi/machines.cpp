// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/machines.h"

#include <QDateTime>
#include <QHostAddress>
#include <QUrl>
#include <algorithm>
#include <utility>

namespace rivulet::hmi {

namespace {

/// A port is not looked at more often.
constexpr qint64 kLookEveryMs = 30'000;
/// "2026-11-22T08:30:05", which all forms of a time begin with.
constexpr std::size_t kSecondsLength = 19;

bool isThisComputer(const std::string& endpoint) {
  const QString host = QUrl(QString::fromStdString(endpoint)).host();
  return host == QLatin1String("localhost") || QHostAddress(host).isLoopback();
}

}  // namespace

Machines::Machines(Document& document, MachineModel& machine, RunController& runs,
                   PastRuns& pastRuns, report::MachineStore store)
    : m_document(document), m_machine(machine), m_runs(runs), m_store(std::move(store)) {
  m_clock.start();
  connect(&m_portCheck, &session::PortCheck::looked, this,
          [this](const QString& endpoint, bool isThere) {
            m_looks[endpoint.toStdString()] = {isThere, m_clock.elapsed()};
            Q_EMIT changed();
          });
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
  m_removed = m_store.removed();
  Q_EMIT changed();
}

std::vector<widgets::MachineCardView> Machines::cards() const {
  std::map<std::string, widgets::MachineCardView> cards;
  for (const report::KnownMachine& known : m_known) {
    widgets::MachineCardView& card = cards[known.endpoint];
    card.name = card.name.isEmpty() ? QString::fromStdString(known.name) : card.name;
    card.hasLimits = card.hasLimits || known.hasLimits;
    card.hasCalibration = card.hasCalibration || known.hasCalibration;
    card.hasCreditTest = card.hasCreditTest || known.hasCreditTest;
    card.hasFeedTest = card.hasFeedTest || known.hasFeedTest;
    card.hasJobTest = card.hasJobTest || known.hasJobTest;
  }
  if (m_history) {
    for (const streaming::RunSummary& run : m_history->runs) {  // the newest first
      const auto removed = m_removed.find(run.endpoint);
      const bool isRemoved = removed != m_removed.end() && !cards.contains(run.endpoint) &&
                             run.origin.startedAtUtc.substr(0, kSecondsLength) <=
                                 base::utcText(removed->second).substr(0, kSecondsLength);
      if (!run.endpoint.empty() && !isRemoved && !cards[run.endpoint].lastRun) {
        cards[run.endpoint].lastRun = run;
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
    const auto look = m_looks.find(endpoint);
    if (look != m_looks.end()) {
      constexpr double kMsPerS = 1000.0;
      card.answers = look->second.isThere;
      card.lookedS = static_cast<double>(m_clock.elapsed() - look->second.atMs) / kMsPerS;
    }
    card.canRemove = m_runs.canChangeSettings() && canChange() && !isConnectedWith(endpoint);
    card.isLeftOver =
        isThisComputer(endpoint) && !card.hasFacts() && !card.answers && !isConnectedWith(endpoint);
    list.push_back(std::move(card));
  }
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.name.isEmpty() == b.name.isEmpty() ? a.name.localeAwareCompare(b.name) < 0
                                                : !a.name.isEmpty();
  });
  return list;
}

bool Machines::isConnectedWith(const std::string& endpoint) const {
  return m_machine.isConnected() && m_machine.endpoint().trimmed().toStdString() == endpoint;
}

void Machines::open(const QString& endpoint) {
  if (!isConnectedWith(endpoint.toStdString()) && canChange()) {
    m_machine.connectTo(endpoint);
  }
}

void Machines::look() {
  if (m_lookedAtMs && m_clock.elapsed() - *m_lookedAtMs < kLookEveryMs) {
    return;
  }
  m_lookedAtMs = m_clock.elapsed();
  for (const widgets::MachineCardView& card : cards()) {
    if (!isConnectedWith(card.endpoint.toStdString())) {
      m_portCheck.look(card.endpoint);
    }
  }
}

void Machines::remove(const QString& endpoint) {
  if (!canChange() || !m_runs.canChangeSettings() || isConnectedWith(endpoint.toStdString())) {
    return;
  }
  const base::Result<void> done =
      m_store.remove(endpoint.toStdString(), QDateTime::currentMSecsSinceEpoch());
  if (done) {
    Q_EMIT removed(endpoint);
  } else {
    Q_EMIT removeFailed(done.error());
  }
  refresh();
}

}  // namespace rivulet::hmi
