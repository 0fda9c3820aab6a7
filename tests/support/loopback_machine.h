// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A virtual machine behind its real OPC UA server on a free loopback port, run by a thread of
/// its own inside the test process. The test talks to it as to a control.
/// @threadsafety for the test's thread; the machine belongs to the server's thread meanwhile.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/contract.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "opcua/open62541/ua_link.h"

namespace rivulet::tests {

class LoopbackMachine {
 public:
  struct Options {
    std::string preset = "ideal";  ///< access is free; "dmu75" makes it cost what it costs
    std::uint64_t seed = 1;
    std::uint16_t port = 0;
    std::optional<machine::ArrayAccess> arrays = std::nullopt;  ///< in place of the preset's
  };

  /// Answers from here on.
  explicit LoopbackMachine(const Options& options) : m_machine(load(options), options.seed) {
    machine::ServerOptions where;
    where.port = options.port;
    auto server = machine::Server::start(m_machine, where);
    RIVULET_ASSERT(server.has_value());
    m_server = std::move(*server);
    m_endpoint = m_server->endpoint();
    m_thread = std::thread([this] { serve(); });
  }
  LoopbackMachine() : LoopbackMachine(Options{}) {}
  ~LoopbackMachine() { stop(); }
  LoopbackMachine(const LoopbackMachine&) = delete;
  LoopbackMachine& operator=(const LoopbackMachine&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }
  /// Its counters may be read at any time, until `stop`.
  [[nodiscard]] const machine::Server& server() const { return *m_server; }

  /// A new connection to it. It answers, so failure is a bug.
  [[nodiscard]] std::unique_ptr<opcua::UaLink> connect() const {
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = m_endpoint;
    options.connectDeadline = std::chrono::seconds(20);
    options.commandDeadline = std::chrono::seconds(20);
    auto link = opcua::UaLink::connect(options);
    RIVULET_ASSERT(link.has_value());
    return std::move(*link);
  }

  /// As if somebody pressed the key at the machine: acts whoever has started the program.
  void pressReset() { m_isResetPressed.store(true); }

  /// The server goes away: all connections are closed, the thread ends. Twice does no harm.
  void stop() {
    m_stop.store(true);
    if (m_thread.joinable()) {
      m_thread.join();
    }
    m_server.reset();
  }

  /// The machine itself, once the server has gone.
  [[nodiscard]] machine::Machine& machineAfterStop() {
    RIVULET_ASSERT(m_server == nullptr);
    return m_machine;
  }

 private:
  void serve() {
    while (!m_stop.load()) {
      if (m_isResetPressed.exchange(false)) {
        m_machine.reset();
      }
      m_server->iterate(std::chrono::milliseconds(10));
    }
  }
  [[nodiscard]] static machine::MachineConfig load(const Options& options) {
    auto config = machine::loadPreset(options.preset);
    RIVULET_ASSERT(config.has_value());
    if (options.arrays) {
      config->access.arrays = *options.arrays;
    }
    return std::move(*config);
  }

  machine::Machine m_machine;
  std::unique_ptr<machine::Server> m_server;
  std::string m_endpoint;
  std::atomic<bool> m_stop{false};
  std::atomic<bool> m_isResetPressed{false};
  std::thread m_thread;
};

}  // namespace rivulet::tests
