// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz/memory_network.h"

#include <open62541/plugin/eventloop.h>
#include <sys/epoll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <deque>
#include <map>
#include <string>
#include <utility>

#include "fuzz/require.h"
#include "opcua/open62541/handle.h"

namespace rivulet::tests {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::int64_t kNanosecondsPerMs = 1'000'000;
constexpr std::int64_t kNanosecondsPerTick = 100;  ///< of the library's UA_DateTime

/// What the simulated clock shows; not 0, which some take for "never".
std::int64_t presentNs = 1000 * kNanosecondsPerSecond;

struct Connection {
  UA_ConnectionManager_connectionCallback callback = nullptr;
  void* application = nullptr;
  void* context = nullptr;
};

struct Event {
  std::uintptr_t connection = 0;
  UA_ConnectionState state = UA_CONNECTIONSTATE_ESTABLISHED;
  std::string message;
};

/// One side: what the library knows of the network, with what has arrived for it.
struct Manager : UA_ConnectionManager {
  std::map<std::uintptr_t, Connection> connections;
  std::deque<Event> events;
  UA_StatusCode (*run)(UA_EventLoop*, UA_UInt32) = nullptr;  ///< the loop's own
};

struct Network {
  std::map<std::uintptr_t, Manager*> managers;  ///< by connection
  std::map<UA_UInt16, std::uintptr_t> listeners;
  std::map<const UA_EventLoop*, Manager*> loops;
  // No number of a socket: Rivulet sets options of the socket that a connection is.
  std::uintptr_t nextConnection = 1U << 30U;
  UA_UInt16 nextPort = 50'000;
  std::function<void()> partner;
  std::function<void(std::string&)> damage;
  bool isPartnerActing = false;
};

Network& network() {
  static Network one;
  return one;
}

/// The two ends of a connection differ in the last bit.
std::uintptr_t peerOf(std::uintptr_t connection) {
  return connection ^ 1U;
}
bool isServers(std::uintptr_t connection) {
  return (connection & 1U) != 0;
}

UA_QualifiedName key(std::string_view name) {
  return {0, opcua::borrow(name)};
}

template <class T>
T parameter(const UA_KeyValueMap& parameters, std::string_view name, std::size_t type) {
  const void* value = UA_KeyValueMap_getScalar(&parameters, key(name), &UA_TYPES[type]);
  return value == nullptr ? T{} : *static_cast<const T*>(value);
}

Manager& managerOf(UA_ConnectionManager* manager) {
  return *static_cast<Manager*>(manager);
}
Manager& managerOf(UA_EventSource* source) {
  return managerOf(reinterpret_cast<UA_ConnectionManager*>(source));
}

void addEvent(std::uintptr_t connection, UA_ConnectionState state, std::string message = {}) {
  if (const auto found = network().managers.find(connection); found != network().managers.end()) {
    found->second->events.push_back({connection, state, std::move(message)});
  }
}

void tell(Manager& manager, const Event& event, const UA_KeyValueMap& parameters) {
  const auto found = manager.connections.find(event.connection);
  if (found == manager.connections.end()) {
    return;
  }
  Connection& connection = found->second;
  if (event.state != UA_CONNECTIONSTATE_CLOSING) {
    connection.callback(&manager, event.connection, connection.application, &connection.context,
                        event.state, &parameters, opcua::borrow(event.message));
    return;
  }
  Connection closed = connection;
  manager.connections.erase(found);
  network().managers.erase(event.connection);
  std::erase_if(network().listeners,
                [&](const auto& listener) { return listener.second == event.connection; });
  closed.callback(&manager, event.connection, closed.application, &closed.context, event.state,
                  &parameters, UA_BYTESTRING_NULL);
}

void noteStopped(Manager& manager) {
  if (manager.connections.empty() && manager.eventSource.state == UA_EVENTSOURCESTATE_STOPPING) {
    manager.eventSource.state = UA_EVENTSOURCESTATE_STOPPED;
  }
}

/// @return whether anything had arrived
bool deliver(Manager& manager) {
  const bool hadAny = !manager.events.empty();
  for (std::size_t left = manager.events.size(); left > 0 && !manager.events.empty(); --left) {
    const Event event = std::move(manager.events.front());
    manager.events.pop_front();
    tell(manager, event, UA_KEYVALUEMAP_NULL);
  }
  noteStopped(manager);
  return hadAny;
}

UA_StatusCode run(UA_EventLoop* loop, UA_UInt32 timeoutMs) noexcept {
  Network& net = network();
  Manager& manager = *net.loops.at(loop);
  const bool hadAny = deliver(manager);
  const UA_StatusCode status = manager.run(loop, 0);
  if (hadAny || loop->state != UA_EVENTLOOPSTATE_STARTED) {
    return status;
  }
  if (net.partner && !std::exchange(net.isPartnerActing, true)) {
    net.partner();
    net.isPartnerActing = false;
  }
  if (!deliver(manager) && timeoutMs > 0) {
    const std::int64_t untilNs = std::min(presentNs + timeoutMs * kNanosecondsPerMs,
                                          loop->nextCyclicTime(loop) < INT64_MAX / 100
                                              ? loop->nextCyclicTime(loop) * kNanosecondsPerTick
                                              : INT64_MAX);
    presentNs = std::max(presentNs, untilNs);
  }
  return manager.run(loop, 0);
}

UA_StatusCode start(UA_EventSource* source) noexcept {
  Manager& manager = managerOf(source);
  UA_EventLoop* const loop = source->eventLoop;
  network().loops[loop] = &manager;
  if (loop->run != &tests::run) {
    manager.run = std::exchange(loop->run, &tests::run);
  }
  source->state = UA_EVENTSOURCESTATE_STARTED;
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode closeConnection(UA_ConnectionManager* manager, std::uintptr_t connection) noexcept {
  if (!managerOf(manager).connections.contains(connection)) {
    return UA_STATUSCODE_BADNOTFOUND;
  }
  addEvent(connection, UA_CONNECTIONSTATE_CLOSING);
  addEvent(peerOf(connection), UA_CONNECTIONSTATE_CLOSING);
  return UA_STATUSCODE_GOOD;
}

void stop(UA_EventSource* source) noexcept {
  Manager& manager = managerOf(source);
  source->state = UA_EVENTSOURCESTATE_STOPPING;
  for (const auto& [connection, state] : manager.connections) {
    closeConnection(&manager, connection);
  }
  noteStopped(manager);
}

UA_StatusCode release(UA_EventSource* source) noexcept {
  Manager* const manager = &managerOf(source);
  std::erase_if(network().loops, [&](const auto& loop) { return loop.second == manager; });
  UA_KeyValueMap_clear(&source->params);
  UA_String_clear(&source->name);
  delete manager;
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode openConnection(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                             void* application, void* context,
                             UA_ConnectionManager_connectionCallback callback) noexcept {
  Network& net = network();
  if (parameter<UA_Boolean>(*parameters, "validate", UA_TYPES_BOOLEAN)) {
    return UA_STATUSCODE_GOOD;
  }
  auto port = parameter<UA_UInt16>(*parameters, "port", UA_TYPES_UINT16);
  const bool listens = parameter<UA_Boolean>(*parameters, "listen", UA_TYPES_BOOLEAN);
  const auto listener = net.listeners.find(port);
  if (!listens && listener == net.listeners.end()) {
    return UA_STATUSCODE_BADDISCONNECT;
  }
  const std::uintptr_t connection = std::exchange(net.nextConnection, net.nextConnection + 2);
  net.managers[connection] = &managerOf(manager);
  managerOf(manager).connections[connection] = {callback, application, context};
  if (!listens) {
    const std::uintptr_t peer = peerOf(connection);
    Manager& server = *net.managers.at(listener->second);
    net.managers[peer] = &server;
    server.connections[peer] = server.connections.at(listener->second);
    addEvent(peer, UA_CONNECTIONSTATE_ESTABLISHED);
    addEvent(connection, UA_CONNECTIONSTATE_ESTABLISHED);
    tell(managerOf(manager), {connection, UA_CONNECTIONSTATE_OPENING, {}}, UA_KEYVALUEMAP_NULL);
    return UA_STATUSCODE_GOOD;
  }
  if (port == 0) {
    port = net.nextPort++;
  }
  net.listeners[port] = connection;
  UA_String address = opcua::borrow("127.0.0.1");
  UA_KeyValuePair facts[]{{key("listen-address"), opcua::borrowScalar(address, UA_TYPES_STRING)},
                          {key("listen-port"), opcua::borrowScalar(port, UA_TYPES_UINT16)}};
  tell(managerOf(manager), {connection, UA_CONNECTIONSTATE_ESTABLISHED, {}}, {2, facts});
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode send(UA_ConnectionManager* manager, std::uintptr_t connection,
                   const UA_KeyValueMap* /*parameters*/, UA_ByteString* message) noexcept {
  const bool isOpen = managerOf(manager).connections.contains(connection);
  if (isOpen) {
    std::string bytes(opcua::view(*message));
    if (isServers(connection) && network().damage) {
      std::exchange(network().damage, {})(bytes);
    }
    addEvent(peerOf(connection), UA_CONNECTIONSTATE_ESTABLISHED, std::move(bytes));
  }
  UA_ByteString_clear(message);
  return isOpen ? UA_STATUSCODE_GOOD : UA_STATUSCODE_BADCONNECTIONCLOSED;
}

UA_StatusCode allocate(UA_ConnectionManager* /*manager*/, std::uintptr_t /*connection*/,
                       UA_ByteString* buffer, std::size_t size) noexcept {
  return UA_ByteString_allocBuffer(buffer, size);
}

void release(UA_ConnectionManager* /*manager*/, std::uintptr_t /*connection*/,
             UA_ByteString* buffer) noexcept {
  UA_ByteString_clear(buffer);
}

}  // namespace

void setPartner(std::function<void()> partner) {
  network().partner = std::move(partner);
}

void setDamage(std::function<void(std::string&)> damage) {
  network().damage = std::move(damage);
}

}  // namespace rivulet::tests

// Who defines a function of a library in the program itself takes its place.
extern "C" {

// NOLINTBEGIN(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
UA_ConnectionManager* UA_ConnectionManager_new_POSIX_TCP(const UA_String name) {
  using namespace rivulet;
  auto* const manager = new tests::Manager{};
  manager->eventSource.eventSourceType = UA_EVENTSOURCETYPE_CONNECTIONMANAGER;
  UA_String_copy(&name, &manager->eventSource.name);
  manager->eventSource.start = &tests::start;
  manager->eventSource.stop = &tests::stop;
  manager->eventSource.free = &tests::release;
  manager->protocol = opcua::borrow("tcp");
  manager->openConnection = &tests::openConnection;
  manager->sendWithConnection = &tests::send;
  manager->closeConnection = &tests::closeConnection;
  manager->allocNetworkBuffer = &tests::allocate;
  manager->freeNetworkBuffer = &tests::release;
  return manager;
}

/// There are no sockets that could become ready, and to ask for them took a third of the time.
int epoll_wait(int /*epfd*/, epoll_event* /*events*/, int /*maxevents*/, int timeout) {
  rivulet::tests::require(timeout == 0);
  return 0;
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  using namespace rivulet::tests;
  if (clock != CLOCK_MONOTONIC && clock != CLOCK_MONOTONIC_RAW) {
    return static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  }
  time->tv_sec = presentNs / kNanosecondsPerSecond;
  time->tv_nsec = presentNs % kNanosecondsPerSecond;
  return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* /*remaining*/) {
  using namespace rivulet::tests;
  require(clock == CLOCK_MONOTONIC && flags == TIMER_ABSTIME);
  presentNs = std::max(presentNs, time->tv_sec * kNanosecondsPerSecond + time->tv_nsec);
  return 0;
}
// NOLINTEND(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
}
