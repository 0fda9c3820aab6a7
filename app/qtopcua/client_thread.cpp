// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "qtopcua/client_thread.h"

#include <open62541/statuscodes.h>

#include <QCoreApplication>
#include <QDir>
#include <QLoggingCategory>
#include <QOpcUaAuthenticationInformation>
#include <QOpcUaEndpointDescription>
#include <QOpcUaErrorState>
#include <QOpcUaNode>
#include <QOpcUaProvider>
#include <QPluginLoader>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <clocale>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "qtopcua/backend_gate.h"

namespace rivulet::qtopcua {

namespace {

using base::Duration;
using base::Instant;

const auto kBackend = QStringLiteral("open62541");
/// How often the backend looks at the network, and for how long each time.
constexpr int kIterateMs = 1;
/// When the backend's library forgets a call: never while the connection lasts. It closes the
/// connection when an answer comes to a call that it has forgotten.
constexpr int kForgetMs = 3'600'000;
constexpr Duration kCloseDeadline = std::chrono::seconds(1);
/// Longest single wait; a condition variable does not take the end of time.
constexpr Duration kWaitMax = std::chrono::milliseconds(200);

/// An event loop needs an application; programs without a window have none.
std::shared_ptr<QCoreApplication> application() {
  if (QCoreApplication::instance() != nullptr) {
    return nullptr;
  }
  static int count = 1;
  static char name[] = "rivulet";
  static char* arguments[] = {name, nullptr};
  // Qt takes over the language of the desktop for the whole program.
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  auto made = std::make_shared<QCoreApplication>(count, arguments);
  std::setlocale(LC_ALL, locale.c_str());
  return made;
}

/// The plugin of most builds has an open62541 of its own, whose functions have the names of ours.
/// Loaded like this, each calls its own.
void bindPluginToItself() {
  const QStringList folders = QCoreApplication::libraryPaths();
  for (const QString& folder : folders) {
    const QDir plugins(folder + QStringLiteral("/opcua"));
    const QStringList files = plugins.entryList({QStringLiteral("*open62541*")}, QDir::Files);
    for (const QString& file : files) {
      QPluginLoader loader(plugins.canonicalPath() + QLatin1Char('/') + file);
      loader.setLoadHints(QLibrary::DeepBindHint | QLibrary::PreventUnloadHint);
      loader.load();
    }
  }
}

std::unique_ptr<QOpcUaClient> makeClient() {
  static const bool isBound = [] {
    bindPluginToItself();
    // Each connection would be told about on standard error.
    QLoggingCategory::setFilterRules(QStringLiteral("qt.opcua.*=false"));
    return true;
  }();
  Q_UNUSED(isBound);
  // All providers share one object of the plugin, and each deletes it when it ends.
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  QOpcUaProvider provider;
  return std::unique_ptr<QOpcUaClient>(
      provider.createClient(kBackend, {{QStringLiteral("clientIterateIntervalMs"), kIterateMs},
                                       {QStringLiteral("asyncRequestTimeoutMs"), kForgetMs}}));
}

}  // namespace

/// What both threads see.
class ClientThread::Worker {
 public:
  explicit Worker(const opcua::MonotonicClock& timeLine) : clock(timeLine) {}

  template <class Function>
  void post(Function function) {
    QMetaObject::invokeMethod(&context, std::move(function), Qt::QueuedConnection);
  }

  void push(Answer answer) {
    answer.serial = serial;
    answer.at = clock.now();
    {
      const std::lock_guard lock(mutex);
      answers.push_back(std::move(answer));
    }
    changed.notify_all();
  }

  void fail(std::uint32_t status) {
    Answer answer;
    answer.status = status;
    push(std::move(answer));
  }

  /// Of the client's thread.
  void start();
  void open(const QString& endpoint, const QString& sessionName);
  void onState(QOpcUaClient::ClientState state);
  void onConnected();
  void onError(QOpcUaClient::ClientError error);
  QOpcUaNode* object(const QString& id);
  /// @param ask  hands a request to the client; false: it is not connected
  void request(std::uint64_t number, std::function<bool()> ask);
  void end();

  template <class Condition>
  bool waitFor(Instant until, Condition condition) {
    std::unique_lock lock(mutex);
    for (;;) {
      if (condition()) {
        return true;
      }
      const Duration left = until - clock.now();
      if (left <= Duration::zero()) {
        return false;
      }
      changed.wait_for(lock, std::min(left, kWaitMax));
    }
  }

  opcua::MonotonicClock clock;
  std::shared_ptr<QCoreApplication> app = application();
  QThread thread;
  QObject context;  ///< lives in the thread

  // Of the thread.
  std::unique_ptr<QOpcUaClient> client;
  std::optional<BackendGate> gate{&context};
  bool isInSignal = false;  ///< of the client, which must not end meanwhile
  bool shallEnd = false;    ///< after it
  std::map<QString, std::unique_ptr<QOpcUaNode>> objects;
  std::uint64_t serial = 0;  ///< of the call in progress

  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<Answer> answers;
  std::uint32_t connectStatus = UA_STATUSCODE_GOOD;
  bool isConnected = false;
  bool hasFailed = false;
  bool isLost = false;
};

void ClientThread::Worker::start() {
  client = makeClient();
  if (client == nullptr) {
    return;
  }
  QObject::connect(client.get(), &QOpcUaClient::stateChanged, &context,
                   [this](QOpcUaClient::ClientState state) { onState(state); });
  // What is no address at all changes no state.
  QObject::connect(client.get(), &QOpcUaClient::errorChanged, &context,
                   [this](QOpcUaClient::ClientError error) { onError(error); });
  QObject::connect(client.get(), &QOpcUaClient::connectError, &context,
                   [this](QOpcUaErrorState* error) {
                     const std::lock_guard lock(mutex);
                     connectStatus = static_cast<std::uint32_t>(error->errorCode());
                   });
  QObject::connect(client.get(), &QOpcUaClient::readNodeAttributesFinished, &context,
                   [this](QList<QOpcUaReadResult> results, QOpcUa::UaStatusCode status) {
                     Answer answer;
                     answer.status = static_cast<std::uint32_t>(status);
                     answer.readings = std::move(results);
                     push(std::move(answer));
                   });
  QObject::connect(client.get(), &QOpcUaClient::writeNodeAttributesFinished, &context,
                   [this](QList<QOpcUaWriteResult> results, QOpcUa::UaStatusCode status) {
                     Answer answer;
                     answer.status = static_cast<std::uint32_t>(status);
                     answer.writes = std::move(results);
                     push(std::move(answer));
                   });
}

void ClientThread::Worker::open(const QString& endpoint, const QString& sessionName) {
  if (client == nullptr) {
    {
      const std::lock_guard lock(mutex);
      hasFailed = true;
      connectStatus = kNoBackend;
    }
    changed.notify_all();
    return;
  }
  QOpcUaApplicationIdentity identity;
  identity.setApplicationName(sessionName);
  client->setApplicationIdentity(identity);
  QOpcUaEndpointDescription description;
  description.setEndpointUrl(endpoint);
  description.setSecurityMode(QOpcUaEndpointDescription::None);
  description.setSecurityPolicy(QStringLiteral("http://opcfoundation.org/UA/SecurityPolicy#None"));
  client->connectToEndpoint(description);
}

/// The client reads the list of namespaces by itself, right after this.
void ClientThread::Worker::onConnected() {
  isInSignal = true;
  gate->find(*client);
  const std::shared_ptr<void> held = gate->hold();
  // A loss that the plugin has noticed meanwhile: then the client does not read.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
  isInSignal = false;
  post([held] { Q_UNUSED(held); });  // run, and forgotten, after the client has asked
  if (shallEnd) {
    post([this] { end(); });
  }
}

void ClientThread::Worker::onState(QOpcUaClient::ClientState state) {
  if (state == QOpcUaClient::Connected) {
    onConnected();
    if (client->state() != QOpcUaClient::Connected) {
      return;
    }
  }
  {
    const std::lock_guard lock(mutex);
    if (state == QOpcUaClient::Connected) {
      isConnected = true;
    } else if (state == QOpcUaClient::Disconnected) {
      isLost = isConnected;
      hasFailed = !isConnected;
    }
  }
  changed.notify_all();
}

void ClientThread::Worker::onError(QOpcUaClient::ClientError error) {
  if (error != QOpcUaClient::InvalidUrl) {
    return;
  }
  {
    const std::lock_guard lock(mutex);
    hasFailed = true;
    connectStatus = UA_STATUSCODE_BADTCPENDPOINTURLINVALID;
  }
  changed.notify_all();
}

/// Methods belong to objects; there are a few of them.
QOpcUaNode* ClientThread::Worker::object(const QString& id) {
  const auto known = objects.find(id);
  if (known != objects.end()) {
    return known->second.get();
  }
  std::unique_ptr<QOpcUaNode> node(client->node(id));
  if (node == nullptr) {
    return nullptr;
  }
  QObject::connect(
      node.get(), &QOpcUaNode::methodCallFinished, &context,
      [this](const QString& /*method*/, const QVariant& result, QOpcUa::UaStatusCode status) {
        Answer answer;
        answer.status = static_cast<std::uint32_t>(status);
        answer.outputs = result;
        push(std::move(answer));
      });
  return objects.emplace(id, std::move(node)).first->second.get();
}

void ClientThread::Worker::request(std::uint64_t number, std::function<bool()> ask) {
  gate->pass([this, number, ask = std::move(ask)] {
    serial = number;
    if (client == nullptr || !ask()) {
      fail(UA_STATUSCODE_BADNOTCONNECTED);
    }
  });
}

void ClientThread::Worker::end() {
  if (isInSignal) {
    shallEnd = true;
    return;
  }
  gate.reset();
  objects.clear();
  client.reset();
  thread.quit();
}

ClientThread::ClientThread(const opcua::MonotonicClock& clock)
    : m_worker(std::make_shared<Worker>(clock)) {
  m_worker->context.moveToThread(&m_worker->thread);
  m_worker->thread.start();
  m_worker->post([worker = m_worker.get()] { worker->start(); });
}

ClientThread::~ClientThread() {
  Worker* const worker = m_worker.get();
  const Instant deadline = worker->clock.now() + kCloseDeadline;
  worker->post([worker] {
    if (worker->client != nullptr && worker->client->state() == QOpcUaClient::Connected) {
      worker->client->disconnectFromEndpoint();
    }
  });
  worker->waitFor(deadline,
                  [worker] { return worker->isLost || worker->hasFailed || !worker->isConnected; });
  worker->post([worker] { worker->end(); });
  worker->thread.wait();  // nothing blocks in it: the network is served by the backend's thread
}

std::uint32_t ClientThread::connect(const QString& endpoint, const QString& sessionName,
                                    Instant deadline) {
  Worker* const worker = m_worker.get();
  worker->post([worker, endpoint, sessionName] { worker->open(endpoint, sessionName); });
  if (!worker->waitFor(deadline, [worker] { return worker->isConnected || worker->hasFailed; })) {
    return UA_STATUSCODE_BADTIMEOUT;
  }
  const std::lock_guard lock(worker->mutex);
  if (worker->isConnected) {
    return UA_STATUSCODE_GOOD;
  }
  return worker->connectStatus != UA_STATUSCODE_GOOD ? worker->connectStatus
                                                     : UA_STATUSCODE_BADCOMMUNICATIONERROR;
}

void ClientThread::read(std::uint64_t serial, QList<QOpcUaReadItem> items) {
  Worker* const worker = m_worker.get();
  worker->post([worker, serial, items = std::move(items)] {
    worker->request(serial, [worker, items] { return worker->client->readNodeAttributes(items); });
  });
}

void ClientThread::write(std::uint64_t serial, QList<QOpcUaWriteItem> items) {
  Worker* const worker = m_worker.get();
  worker->post([worker, serial, items = std::move(items)] {
    worker->request(serial, [worker, items] { return worker->client->writeNodeAttributes(items); });
  });
}

void ClientThread::call(std::uint64_t serial, const QString& object, const QString& method,
                        QList<QOpcUa::TypedVariant> inputs) {
  Worker* const worker = m_worker.get();
  worker->post([worker, serial, object, method, inputs = std::move(inputs)] {
    worker->request(serial, [worker, object, method, inputs] {
      QOpcUaNode* const node = worker->object(object);
      return node != nullptr && node->callMethod(method, inputs);
    });
  });
}

std::optional<Answer> ClientThread::take(Instant until) {
  Worker* const worker = m_worker.get();
  worker->waitFor(until, [worker] { return worker->isLost || !worker->answers.empty(); });
  const std::lock_guard lock(worker->mutex);
  if (worker->answers.empty()) {
    return std::nullopt;
  }
  Answer answer = std::move(worker->answers.front());
  worker->answers.pop_front();
  return answer;
}

bool ClientThread::isLost() const {
  const std::lock_guard lock(m_worker->mutex);
  return m_worker->isLost;
}

}  // namespace rivulet::qtopcua
