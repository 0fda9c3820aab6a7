// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "qtopcua/backend_gate.h"

#include <QCoreApplication>
#include <QEvent>
#include <QOpcUaMonitoringParameters>
#include <QOpcUaNode>
#include <QSemaphore>
#include <QThread>
#include <QVariant>
#include <mutex>
#include <utility>

namespace rivulet::qtopcua {

namespace {

constexpr int kWaitMs = 1000;

/// Where the plugin works.
struct Whereabouts {
  QThread* from = QThread::currentThread();
  QThread* found = nullptr;
  QSemaphore isFound;
};

/// A value that tells where it is copied or ends. Qt OPC UA shows its thread to nobody, but takes
/// values along to it.
class Scout {
 public:
  Scout() = default;
  explicit Scout(std::shared_ptr<Whereabouts> report) : m_report(std::move(report)) {}
  Scout(const Scout& other) : m_report(other.m_report) { look(); }
  Scout& operator=(const Scout&) = delete;
  ~Scout() { look(); }

 private:
  void look() const {
    if (m_report != nullptr && QThread::currentThread() != m_report->from &&
        m_report->found == nullptr) {
      m_report->found = QThread::currentThread();
      m_report->isFound.release();
    }
  }

  std::shared_ptr<Whereabouts> m_report;
};

}  // namespace

/// The client's side, as the other thread sees it: it may end at any time.
class BackendGate::Door {
 public:
  explicit Door(QObject* client) : m_client(client) {}
  template <class Function>
  void post(Function function) {
    const std::lock_guard lock(m_mutex);
    if (m_client != nullptr) {
      QMetaObject::invokeMethod(m_client, std::move(function), Qt::QueuedConnection);
    }
  }
  void close() {
    const std::lock_guard lock(m_mutex);
    m_client = nullptr;
  }

 private:
  std::mutex m_mutex;
  QObject* m_client;
};

}  // namespace rivulet::qtopcua

Q_DECLARE_METATYPE(rivulet::qtopcua::Scout)
// Else a `QVariant` would share it, and not copy it.
Q_DECLARE_TYPEINFO(rivulet::qtopcua::Scout, Q_RELOCATABLE_TYPE);

namespace rivulet::qtopcua {

namespace {

/// One wait of the backend's thread.
struct Visit {
  QSemaphore hasCome;
  QSemaphore mayGo;
};

/// Lets it go when the last copy ends, be it because what holds it is never run.
[[nodiscard]] std::shared_ptr<void> leaveOf(const std::shared_ptr<Visit>& visit) {
  return {nullptr, [visit](void*) { visit->mayGo.release(); }};
}

/// In the backend's thread.
void wait(Visit& visit) {
  visit.mayGo.acquire();
  // What was handed over now, before any timer.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
}

}  // namespace

BackendGate::BackendGate(QObject* client) : m_door(std::make_shared<Door>(client)) {
}

BackendGate::~BackendGate() {
  m_door->close();
}

void BackendGate::find(QOpcUaClient& client) {
  const std::unique_ptr<QOpcUaNode> node(client.node(QStringLiteral("i=2253")));
  const auto report = std::make_shared<Whereabouts>();
  // Nothing is monitored: the plugin refuses this by itself, without a request to the server.
  if (node == nullptr ||
      !node->modifyMonitoring(QOpcUa::NodeAttribute::Value,
                              QOpcUaMonitoringParameters::Parameter::SamplingInterval,
                              QVariant::fromValue(Scout(report))) ||
      !report->isFound.tryAcquire(1, kWaitMs)) {
    return;
  }
  // Ends with the thread, which ends soon after the client.
  auto gate = std::make_unique<QObject>();
  gate->moveToThread(report->found);
  QObject::connect(report->found, &QThread::finished, gate.get(), &QObject::deleteLater);
  m_gate = gate.release();
}

void BackendGate::pass(std::function<void()> action) {
  if (m_gate == nullptr) {
    action();
    return;
  }
  const auto visit = std::make_shared<Visit>();
  QMetaObject::invokeMethod(
      m_gate,
      [door = m_door, visit, leave = leaveOf(visit), action = std::move(action)]() mutable {
        door->post([leave, action = std::move(action)] { action(); });
        leave.reset();
        wait(*visit);
      },
      Qt::QueuedConnection);
}

std::shared_ptr<void> BackendGate::hold() {
  if (m_gate == nullptr) {
    return nullptr;
  }
  const auto visit = std::make_shared<Visit>();
  auto leave = leaveOf(visit);
  QMetaObject::invokeMethod(
      m_gate,
      [visit] {
        visit->hasCome.release();
        wait(*visit);
      },
      Qt::QueuedConnection);
  return visit->hasCome.tryAcquire(1, kWaitMs) ? leave : nullptr;
}

}  // namespace rivulet::qtopcua
