// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/service_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "opcua/control_map.h"
#include "opcua/error.h"
#include "opcua/open62541/ua_link.h"
#include "service/node_table.h"
#include "trust/connect.h"

namespace rivulet::service {

namespace {

using State = ServiceSeen::State;

/// How often the server looks at its variables.
constexpr base::Duration kInterval = std::chrono::milliseconds{250};
/// How long a call waits at most until it is sent.
constexpr base::Duration kStep = std::chrono::milliseconds{100};
/// A service is heard once a second; after this time what it said is not shown any more.
constexpr base::Duration kSilentAfter = std::chrono::seconds{3};
/// The service answers after it has read a large program, and is silent until then.
constexpr base::Duration kAnswerMax = std::chrono::seconds{60};
constexpr base::Duration kConnectDeadline = std::chrono::seconds{2};
constexpr base::Duration kRetry = std::chrono::seconds{2};

/// Certificates and the list of servers are files that all watches share.
std::mutex& trustFiles() {
  static std::mutex mutex;
  return mutex;
}

/// Makes the connection that was allowed, and keeps the link for its subscription.
trust::Opener openerInto(std::unique_ptr<opcua::UaLink>& link) {
  return [&link](const opcua::ConnectOptions& allowed) -> base::Result<opcua::Connection> {
    opcua::ConnectOptions options = allowed;
    options.connectDeadline = kConnectDeadline;
    options.commandDeadline = kAnswerMax;
    options.silenceMax = kAnswerMax;
    options.own = [&allowed] {
      const std::lock_guard lock(trustFiles());
      return allowed.own();
    };
    options.trust = [&allowed](const opcua::CertificateFacts& facts, std::string_view der) {
      const std::lock_guard lock(trustFiles());
      return allowed.trust(facts, der);
    };
    auto opened = opcua::UaLink::connect(options);
    if (!opened) {
      return base::fail(opened.error());
    }
    link = *std::move(opened);
    opcua::Connection connection;
    connection.link = link.get();
    connection.control = link.get();
    connection.name = options.endpoint;
    return connection;
  };
}

Answer answerOf(const base::Result<std::vector<opcua::NodeValue>>& outputs) {
  constexpr std::size_t kOutputs = 3;
  if (!outputs) {
    return {false, outputs.error().text(), {}};
  }
  const auto text = [&](std::size_t index) {
    const auto* found = std::get_if<std::string>(&(*outputs)[index]);
    return found != nullptr ? *found : std::string();
  };
  if (outputs->size() != kOutputs) {
    return {false, "The service has another version: it answers in a form that is not known.", {}};
  }
  const bool* accepted = std::get_if<bool>(outputs->data());
  return {accepted != nullptr && *accepted, text(1), text(2)};
}

}  // namespace

ServiceWatch::ServiceWatch(std::string endpoint, Changed changed)
    : m_endpoint(std::move(endpoint)), m_changed(std::move(changed)), m_thread([this] { work(); }) {
}

ServiceWatch::~ServiceWatch() {
  endSoon();
  m_thread.join();
}

void ServiceWatch::endSoon() {
  const std::lock_guard lock(m_mutex);
  m_ends = true;
  m_wake.notify_all();
}

ServiceSeen ServiceWatch::seen() const {
  const std::lock_guard lock(m_mutex);
  return m_seen;
}

void ServiceWatch::connectWith(ServiceAccess access) {
  const std::lock_guard lock(m_mutex);
  m_asked = std::move(access);
  m_wake.notify_all();
}

void ServiceWatch::call(std::string method, std::vector<std::string> inputs) {
  const std::lock_guard lock(m_mutex);
  const bool isUrgent = method == "Stop";
  Call made{std::move(method), std::move(inputs)};
  m_calls.insert(isUrgent ? m_calls.begin() : m_calls.end(), std::move(made));
  m_wake.notify_all();
}

std::optional<ServiceAnswer> ServiceWatch::takeAnswer() {
  const std::lock_guard lock(m_mutex);
  if (m_answers.empty()) {
    return std::nullopt;
  }
  ServiceAnswer answer = std::move(m_answers.front());
  m_answers.pop_front();
  return answer;
}

bool ServiceWatch::isInterrupted() const {
  const std::lock_guard lock(m_mutex);
  return m_ends || m_asked;
}

void ServiceWatch::publish(ServiceSeen seen) {
  if (!seen.error.code) {
    seen.error = m_refused;
  }
  {
    const std::lock_guard lock(m_mutex);
    m_seen = std::move(seen);
  }
  m_changed();
}

void ServiceWatch::publishAnswer(ServiceAnswer answer) {
  {
    const std::lock_guard lock(m_mutex);
    m_answers.push_back(std::move(answer));
  }
  m_changed();
}

void ServiceWatch::refuseCalls(const std::string& why) {
  std::deque<Call> calls;
  {
    const std::lock_guard lock(m_mutex);
    calls.swap(m_calls);
  }
  for (Call& call : calls) {
    publishAnswer({std::move(call.method), {false, why, {}}});
  }
}

/// Until something is asked, or the time is over. Calls are answered meanwhile.
void ServiceWatch::pause(base::Duration duration) {
  const auto end =
      std::chrono::steady_clock::now() + std::min<base::Duration>(duration, std::chrono::hours{24});
  for (;;) {
    refuseCalls("The service is not connected.");
    std::unique_lock lock(m_mutex);
    const bool isAwake =
        m_wake.wait_until(lock, end, [this] { return m_ends || m_asked || !m_calls.empty(); });
    if (!isAwake || m_ends || m_asked) {
      return;
    }
  }
}

void ServiceWatch::work() {
  for (;;) {
    {
      const std::lock_guard lock(m_mutex);
      if (m_ends) {
        return;
      }
      if (m_asked) {
        ServiceAccess before = std::exchange(m_access, *std::exchange(m_asked, std::nullopt));
        if (m_access.keepsLogin) {
          m_access.user = std::move(before.user);
          m_access.password = std::move(before.password);
        }
        m_refused = {};
      }
    }
    connect();
  }
}

/// One attempt, and the connection if it succeeds.
void ServiceWatch::connect() {
  opcua::ConnectRequest request;
  request.endpoint = m_endpoint;
  request.sessionName = "Rivulet, board of machines";
  request.map = std::make_shared<const opcua::ControlMap>();  // no control
  request.user = m_access.user;
  request.password = m_access.password;
  request.fingerprint = m_access.fingerprint;
  request.security = m_access.security;
  const opcua::Attempt attempt = trust::connect(request, trust::trustFolder(), openerInto(m_link));
  const bool isLogin = !m_access.user.empty();
  if (attempt.connection) {
    serve(std::exchange(m_access, {}).user);
    m_link.reset();
    return;
  }
  m_link.reset();
  ServiceSeen seen;
  seen.error = attempt.connection.error();
  if (attempt.question && attempt.question->kind == opcua::TrustQuestion::Kind::Login && isLogin) {
    // Who has mistyped a PIN still sees the machine.
    m_refused = seen.error;
    m_access = {};
    return;
  }
  seen.state = attempt.question ? State::Asked : State::Gone;
  seen.question = attempt.question;
  seen.user = m_access.user;
  publish(std::move(seen));
  if (!attempt.question) {
    m_access.fingerprint.clear();
  }
  pause(attempt.question ? base::Duration::max() : kRetry);
}

/// Until the connection is lost or something else is asked for.
void ServiceWatch::serve(const std::string& user) {
  std::vector<std::string> addresses;
  for (const VariableRow& row : variableRows()) {
    addresses.push_back(nodeAddress(row.identifier));
  }
  ServiceSeen seen;
  seen.user = user;
  const auto lose = [&](const base::Error& error) {
    seen = {};
    seen.state = State::Gone;
    seen.error = error;
    publish(seen);
    m_link.reset();
    pause(kRetry);
  };
  if (const auto watched = m_link->watch(addresses, kInterval); !watched) {
    base::Error error = watched.error();
    if (error.code == opcua::LinkError::VariableMissing) {
      error.message = "This server is no service of Rivulet, or one of another version.";
      error.context = m_endpoint;
    }
    lose(error);
    return;
  }
  bool isKnown = false;
  while (!isInterrupted()) {
    const auto event = m_link->wait(m_link->now() + kStep);
    if (event && event->kind == opcua::EventKind::ConnectionLost) {
      lose(event->error);
      return;
    }
    const auto changes = m_link->takeChanges();
    for (const opcua::NodeChange& change : changes) {
      take(variableRows()[change.index], change.value, seen.snapshot);
    }
    isKnown = isKnown || !changes.empty();
    const State before = seen.state;
    seen.state = !isKnown                           ? State::Connecting
                 : m_link->silence() > kSilentAfter ? State::Silent
                                                    : State::Connected;
    if (!changes.empty() || seen.state != before) {
      publish(seen);
    }
    makeCalls();
  }
}

void ServiceWatch::makeCalls() {
  for (;;) {
    Call call;
    {
      const std::lock_guard lock(m_mutex);
      if (m_calls.empty()) {
        return;
      }
      call = std::move(m_calls.front());
      m_calls.pop_front();
    }
    const std::string method = methodIdentifier(call.method);
    const auto outputs =
        m_link->callMethod(nodeAddress(kMethodsObject), nodeAddress(method), call.inputs);
    publishAnswer({std::move(call.method), answerOf(outputs)});
  }
}

}  // namespace rivulet::service
