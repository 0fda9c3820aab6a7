// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A virtual machine in virtual time that is reached as a control is: by connections that may be
/// closed, opened again and lost. Its time advances only while a client waits for it, so what a run
/// does never depends on the load of the computer. The pace limits how fast it advances: a test
/// that presses a button in the middle of a run needs the run to be still there.
/// @threadsafety the test's thread; connections belong to the client's thread.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/contract.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "opcua/connection.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::tests {

class SimulatedControl {
 public:
  /// Seconds of the machine that pass in one second at most.
  static constexpr double kUnlimited = 1e9;

  explicit SimulatedControl(const std::string& preset, double pace = kUnlimited)
      : m_shared(std::make_shared<Shared>(preset, load(preset), pace)) {}
  /// @param config  of a machine that differs from its preset
  SimulatedControl(machine::MachineConfig config, double pace)
      : m_shared(std::make_shared<Shared>("dmu75", std::move(config), pace)) {}
  ~SimulatedControl() { kill(); }
  SimulatedControl(const SimulatedControl&) = delete;
  SimulatedControl& operator=(const SimulatedControl&) = delete;

  /// Where every such control is reached.
  [[nodiscard]] static std::string endpoint() { return "opc.tcp://simulated:4840"; }

  /// Opens a connection. @return NotReachable for another endpoint, or when it has been killed
  [[nodiscard]] base::Result<opcua::Connection> connect(const std::string& endpoint) const {
    if (endpoint != SimulatedControl::endpoint() || m_shared->isDown()) {
      return base::fail(opcua::LinkError::NotReachable, "Nothing answers there.");
    }
    auto paced = std::make_shared<PacedLink>(m_shared);
    opcua::Connection connection;
    connection.link = paced.get();
    connection.control = paced.get();
    connection.name = endpoint;
    connection.owner = std::move(paced);
    return connection;
  }

  void setPace(double pace) { m_shared->setPace(pace); }
  /// Says to clients that connect from now on that real axes move.
  void passForReal() { m_shared->isReal = true; }
  /// The machine's time at the last answer.
  [[nodiscard]] base::Instant now() const { return m_shared->lastNow.load(); }
  /// As if its power failed.
  void kill() { m_shared->setDown(); }
  /// All connections are lost; the machine goes on, and can be connected to again.
  void cut() { m_shared->cut(); }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] static machine::MachineConfig load(const std::string& preset) {
    auto config = machine::loadPreset(preset);
    RIVULET_ASSERT(config.has_value());
    return std::move(*config);
  }

  /// What the connections of one machine have in common.
  struct Shared {
    Shared(std::string presetName, machine::MachineConfig config, double firstPace)
        : preset(std::move(presetName)), machine(std::move(config), 1), pace(firstPace) {}

    [[nodiscard]] bool isDown() {
      const std::lock_guard lock(mutex);
      return down;
    }
    void setDown() {
      const std::lock_guard lock(mutex);
      down = true;
      changed.notify_all();
    }
    void cut() {
      const std::lock_guard lock(mutex);
      ++cuts;
      changed.notify_all();
    }
    /// @param since  `cuts` when the connection was made
    [[nodiscard]] bool isLost(int since) {
      const std::lock_guard lock(mutex);
      return down || cuts != since;
    }
    [[nodiscard]] int cutsNow() {
      const std::lock_guard lock(mutex);
      return cuts;
    }
    void setPace(double newPace) {
      const std::lock_guard lock(mutex);
      pace = newPace;
      changed.notify_all();
    }
    /// Waits until the pace allows `passed` of the machine's time; less than a few milliseconds is
    /// added to the next one.
    void keepPace(base::Duration passed) {
      std::unique_lock lock(mutex);
      owed += std::chrono::duration<double>(passed) / pace;
      if (owed > std::chrono::milliseconds(5)) {
        const auto due = Clock::now() + std::chrono::duration_cast<Clock::duration>(owed);
        changed.wait_until(lock, due, [&] { return down || pace == kUnlimited; });
        owed = {};
      }
    }

    const std::string preset;
    machine::Machine machine;  ///< the client's thread
    std::atomic<base::Instant> lastNow{};
    std::atomic<bool> isReal = false;
    std::mutex mutex;
    std::condition_variable changed;
    double pace;
    std::chrono::duration<double> owed{};  ///< what the client has not waited yet
    bool down = false;
    int cuts = 0;  ///< how often all connections were lost
  };

  class PacedLink final : public opcua::Link, public opcua::Control {
   public:
    explicit PacedLink(std::shared_ptr<Shared> shared)
        : m_shared(std::move(shared)), m_link(m_shared->machine), m_cuts(m_shared->cutsNow()) {}

    [[nodiscard]] base::Instant now() const override { return m_link.now(); }
    base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                         opcua::Grouping grouping) override {
      return m_link.read(variables, deadline, grouping);
    }
    base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                          opcua::Grouping grouping) override {
      return m_link.write(assignments, deadline, grouping);
    }
    base::RequestId store(const std::string& name, const std::string& text,
                          base::Duration deadline) override {
      return m_link.store(name, text, deadline);
    }
    std::optional<opcua::Event> wait(base::Instant until) override {
      const base::Instant before = now();
      std::optional<opcua::Event> event = m_link.wait(until);
      m_shared->keepPace(now() - before);
      m_shared->lastNow.store(now());
      if (isLost()) {
        event = opcua::Event{};
        event->kind = opcua::EventKind::ConnectionLost;
        event->at = now();
        event->error = lost();
      }
      return event;
    }

    base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                     bool overwrite) override {
      return isLost() ? base::fail(lost()) : m_link.uploadProgram(name, text, overwrite);
    }
    base::Result<std::string> downloadProgram(const std::string& name) override {
      return isLost() ? base::fail(lost()) : m_link.downloadProgram(name);
    }
    base::Result<void> selectProgram(const std::string& name) override {
      return isLost() ? base::fail(lost()) : m_link.selectProgram(name);
    }
    base::Result<opcua::ServerIdentity> identity() override {
      return opcua::ServerIdentity{"urn:rivulet:simulated", "Rivulet", "1", m_shared->preset};
    }
    [[nodiscard]] bool isVirtualMachine() const override { return !m_shared->isReal; }
    [[nodiscard]] opcua::Abilities abilities() const override { return m_link.abilities(); }
    base::Result<void> cycleStart() override {
      return isLost() ? base::fail(lost()) : m_link.cycleStart();
    }
    base::Result<void> reset() override {
      return isLost() ? base::fail(lost()) : m_link.reset();
    }
    base::Result<trace::ControlTrace> fetchTrace() override {
      return isLost() ? base::fail(lost()) : m_link.fetchTrace();
    }

   private:
    [[nodiscard]] bool isLost() const { return m_shared->isLost(m_cuts); }
    [[nodiscard]] static base::Error lost() {
      return base::makeError(opcua::LinkError::ConnectionLost, "The connection was lost.");
    }

    std::shared_ptr<Shared> m_shared;
    streaming::SimulatedLink m_link;
    int m_cuts;
  };

  std::shared_ptr<Shared> m_shared;
};

}  // namespace rivulet::tests
