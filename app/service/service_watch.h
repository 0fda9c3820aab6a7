// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A service as somebody else's client sees it: connected by the rules of `trust::connect`, told by
/// a subscription what changes, connected again when it was gone. Methods are called one after the
/// other; Stop overtakes the others. It has a thread of its own, on which alone anything waits.
/// @threadsafety all functions from any thread; `Changed` is called on the thread of the watch.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/instant.h"
#include "opcua/connection.h"
#include "service/service_session.h"

namespace rivulet::opcua {
class UaLink;
}

namespace rivulet::service {

/// What a client knows of a service.
struct ServiceSeen {
  enum class State {
    Connecting,
    Connected,
    Silent,  ///< connected, but for some time nothing has been heard
    Gone,    ///< not reachable, or the connection was lost; it is tried again
    Asked,   ///< a person has to decide before it is tried again: `question`
  };
  State state = State::Connecting;
  Snapshot snapshot;  ///< as it is now if connected; else empty, for nobody knows
  std::string user;   ///< as whom it is connected, or is asked to be; empty: anonymous
  base::Error error;  ///< why Gone or Asked; a login that was refused
  std::shared_ptr<const opcua::TrustQuestion> question;
};

/// How a method has been answered.
struct ServiceAnswer {
  std::string method;
  Answer answer;
};

/// As whom, and how, a service is connected.
struct ServiceAccess {
  std::string user;
  std::string password;
  std::string fingerprint;  ///< of a certificate that is accepted now
  std::optional<opcua::SecurityChoice> security;
  /// User and password of the attempt that led to the question are taken again.
  bool keepsLogin = false;
};

class ServiceWatch {
 public:
  using Changed = std::function<void()>;

  /// Begins to connect.
  ServiceWatch(std::string endpoint, Changed changed);
  /// Ends the connection; a connection that is being made is waited for.
  ~ServiceWatch();
  ServiceWatch(const ServiceWatch&) = delete;
  ServiceWatch& operator=(const ServiceWatch&) = delete;

  /// Tells the thread to end, without waiting for it.
  void endSoon();
  [[nodiscard]] ServiceSeen seen() const;
  /// Connects again, with this.
  void connectWith(ServiceAccess access);
  /// Answers come in `takeAnswer`. Without a connection, the answer says so.
  void call(std::string method, std::vector<std::string> inputs);
  [[nodiscard]] std::optional<ServiceAnswer> takeAnswer();

 private:
  struct Call {
    std::string method;
    std::vector<std::string> inputs;
  };

  void work();
  void connect();
  void serve(const std::string& user);
  void makeCalls();
  void refuseCalls(const std::string& why);
  void publish(ServiceSeen seen);
  void publishAnswer(ServiceAnswer answer);
  [[nodiscard]] bool isInterrupted() const;
  void pause(base::Duration duration);

  std::string m_endpoint;
  Changed m_changed;

  mutable std::mutex m_mutex;  ///< of the members up to `m_ends`
  std::condition_variable m_wake;
  ServiceSeen m_seen;
  std::deque<Call> m_calls;
  std::deque<ServiceAnswer> m_answers;
  std::optional<ServiceAccess> m_asked;  ///< by `connectWith`
  bool m_ends = false;

  // Of the thread alone.
  ServiceAccess m_access;  ///< of the next attempt
  base::Error m_refused;   ///< the login
  std::unique_ptr<opcua::UaLink> m_link;
  std::thread m_thread;
};

}  // namespace rivulet::service
