// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/services.h"

#include <QElapsedTimer>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <utility>

#include "opcua/node_map.h"
#include "opcua/open62541/discovery.h"
#include "service/node_table.h"
#include "service/service_watch.h"
#include "session/background.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

namespace {

/// A preflight that is not ready is asked for again, and for how long.
constexpr int kRepeatMs = 500;
constexpr qint64 kRepeatMsMax = 20'000;
/// Of a discovery server.
constexpr std::chrono::seconds kSearchMax{5};

QString text(const std::string& from) {
  return QString::fromStdString(from);
}

widgets::ServiceLink linkOf(service::ServiceSeen::State state) {
  using State = service::ServiceSeen::State;
  switch (state) {
    case State::Connecting:
      break;
    case State::Connected:
      return widgets::ServiceLink::Connected;
    case State::Silent:
      return widgets::ServiceLink::Silent;
    case State::Gone:
      return widgets::ServiceLink::Gone;
    case State::Asked:
      return widgets::ServiceLink::Asked;
  }
  return widgets::ServiceLink::Connecting;
}

/// @param port  of an address without one
QString addressOf(const QString& typed, int port) {
  const QString scheme = QStringLiteral("opc.tcp://");
  QString address = typed.trimmed();
  if (!address.startsWith(scheme)) {
    address.prepend(scheme);
  }
  while (address.endsWith(QLatin1Char('/'))) {
    address.chop(1);
  }
  const QString host = address.mid(scheme.size());
  const qsizetype afterName = host.lastIndexOf(QLatin1Char(']')) + 1;  // of an address of IPv6
  return host.indexOf(QLatin1Char(':'), afterName) < 0
             ? address + QLatin1Char(':') + QString::number(port)
             : address;
}

}  // namespace

/// A service, and what is asked of it.
class Services::Watched final : public QObject {
 public:
  Watched(Services& services, const QString& address)
      : endpoint(address), watch(address.toStdString(), [this, &services] {
          // Told once, however often it changes before the GUI thread looks.
          if (!m_isTold.exchange(true)) {
            QMetaObject::invokeMethod(
                this,
                [this, &services] {
                  m_isTold = false;
                  services.take(*this);
                },
                Qt::QueuedConnection);
          }
        }) {}

  void call(const QString& method, const QStringList& inputs) {
    std::vector<std::string> texts;
    for (const QString& input : inputs) {
      texts.push_back(input.toStdString());
    }
    watch.call(method.toStdString(), std::move(texts));
  }

 private:
  std::atomic<bool> m_isTold{false};

 public:
  QString endpoint;
  QElapsedTimer asked;          ///< since a preflight was asked for
  service::ServiceWatch watch;  ///< the last member: its thread uses the others
};

Services::Services(const QStringList& endpoints, report::MachineStore store)
    : m_store(std::move(store)) {
  for (const QString& endpoint : endpoints) {
    if (!m_endpoints.contains(endpoint)) {
      watch(endpoint);
    }
  }
}

Services::~Services() {
  for (const auto& [endpoint, watched] : m_watched) {
    watched->watch.endSoon();  // all at once
  }
}

void Services::watch(const QString& endpoint) {
  m_endpoints.append(endpoint);
  for (const report::KnownMachine& machine : m_store.machines()) {
    m_names[text(machine.endpoint)] = text(machine.name);
  }
  m_watched[endpoint] = std::make_unique<Watched>(*this, endpoint);
}

Services::Watched* Services::find(const QString& endpoint) const {
  const auto found = m_watched.find(endpoint);
  return found == m_watched.end() ? nullptr : found->second.get();
}

std::vector<widgets::ServiceView> Services::views() const {
  std::vector<widgets::ServiceView> views;
  for (const QString& endpoint : m_endpoints) {
    const service::ServiceSeen seen = m_watched.at(endpoint)->watch.seen();
    widgets::ServiceView& view = views.emplace_back();
    view.endpoint = endpoint;
    view.link = linkOf(seen.state);
    view.problem = seen.error.code ? widgets::errorText(seen.error) : QString();
    view.user = text(seen.user);
    view.question = seen.question;
    if (!view.isKnown()) {
      continue;
    }
    const service::Snapshot& now = seen.snapshot;
    view.machine = text(now.machine);
    const auto name = m_names.find(view.machine);
    view.name = name == m_names.end() ? QString() : name->second;
    view.model = text(now.model);
    view.state = text(now.state);
    view.waitingFor = text(now.waitingFor);
    view.programs = text(now.files).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    view.program = text(now.program);
    view.alarm = text(now.alarm);
    view.message = text(now.message);
    view.leftRun = text(now.leftRun);
    view.isRunning = now.itemState == "Executing";
    view.pointsDone = now.pointsDone;
    view.points = now.points;
    view.progress = now.progressPercent / 100.0;
    view.timeLeftS = now.timeLeftS;
    view.lateWindows = now.lateWindows;
    view.positionMm = now.positionMm;
  }
  return views;
}

bool Services::add(const QString& endpoint) {
  const QString address = addressOf(endpoint, service::kPort);
  if (m_endpoints.contains(address)) {
    return false;
  }
  watch(address);
  Q_EMIT listChanged();
  Q_EMIT changed();
  return true;
}

void Services::remove(const QString& endpoint) {
  if (m_endpoints.removeAll(endpoint) > 0) {
    m_watched.erase(endpoint);
    Q_EMIT listChanged();
    Q_EMIT changed();
  }
}

void Services::search(const QString& address) {
  const std::string asked = address.trimmed().isEmpty()
                                ? std::string(opcua::kLocalEndpoint)
                                : addressOf(address, opcua::kPort).toStdString();
  session::inBackground(
      this, [asked] { return opcua::findServers(asked, kSearchMax); },
      [](Services& self, const base::Result<std::vector<opcua::FoundServer>>& found) {
        QStringList endpoints;
        if (found) {
          for (const opcua::FoundServer& server : *found) {
            if (server.productUri == service::kNamespaceUri && !server.addresses.empty()) {
              const QString endpoint = text(server.addresses.front());
              if (!self.m_endpoints.contains(endpoint) && !endpoints.contains(endpoint)) {
                endpoints.append(endpoint);
              }
            }
          }
        }
        Q_EMIT self.searched(endpoints, found ? base::Error() : found.error());
      });
}

void Services::call(const QString& endpoint, const QString& method, const QStringList& inputs) {
  if (Watched* watched = find(endpoint)) {
    watched->asked.start();
    watched->call(method, inputs);
  }
}

void Services::take(Watched& watched) {
  while (auto answer = watched.watch.takeAnswer()) {
    const QString method = text(answer->method);
    const bool isPreflight = method.startsWith(QLatin1String("Preflight"));
    if (isPreflight && service::isNotYet(answer->answer) &&
        watched.asked.elapsed() < kRepeatMsMax) {
      QTimer::singleShot(kRepeatMs, &watched, [&watched, method] { watched.call(method, {}); });
      continue;
    }
    Q_EMIT answered(watched.endpoint, method, answer->answer.accepted, text(answer->answer.message),
                    text(answer->answer.confirmation));
  }
  Q_EMIT changed();
}

void Services::logIn(const QString& endpoint, const QString& user, const QString& pin) {
  if (Watched* watched = find(endpoint)) {
    service::ServiceAccess access;
    access.user = user.toStdString();
    access.password = pin.toStdString();
    watched->watch.connectWith(std::move(access));
  }
}

void Services::accept(const QString& endpoint) {
  Watched* watched = find(endpoint);
  const auto question = watched != nullptr ? watched->watch.seen().question : nullptr;
  if (question) {
    service::ServiceAccess access;
    access.fingerprint = question->shown.fingerprint;
    access.keepsLogin = true;
    watched->watch.connectWith(std::move(access));
  }
}

void Services::allow(const QString& endpoint, const opcua::SecurityChoice& choice) {
  if (Watched* watched = find(endpoint)) {
    service::ServiceAccess access;
    access.security = choice;
    access.keepsLogin = true;
    watched->watch.connectWith(std::move(access));
  }
}

void Services::decline(const QString& endpoint) {
  Watched* watched = find(endpoint);
  if (watched != nullptr && !watched->watch.seen().user.empty()) {
    watched->watch.connectWith({});
  }
}

}  // namespace rivulet::hmi
