// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A link between a client and a virtual machine on which everything goes wrong that can: requests
/// and answers are late or lost, the client stands still, the connection breaks, and what was on
/// its way when it broke arrives later, between the requests of the next connection. Within one
/// connection requests keep their order, as on TCP. What goes wrong when is drawn from a seed.
/// @threadsafety one object, one thread.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::streaming {

/// How often what goes wrong, per request unless it says otherwise.
struct LinkFaults {
  double delayProbability = 0.0;
  base::Duration delayMax{};  ///< of a request on its way
  double lostRequestProbability = 0.0;
  double lostAnswerProbability = 0.0;
  double stallProbability = 0.0;  ///< the client stands still behind an answer
  base::Duration stallMax{};
  double disconnectProbability = 0.0;
  /// Requests that were on their way when the connection broke arrive within this time, in any
  /// order; zero: they are gone.
  base::Duration strayMax{};
};

class FaultyLink final : public opcua::Link, public opcua::Control {
 public:
  /// @param machine  must outlive the link
  FaultyLink(machine::Machine& machine, const LinkFaults& faults, std::uint64_t seed);

  /// The next connection. Requests of the one before that are still on their way become strays.
  void reconnect();
  /// What goes wrong from now on.
  void setFaults(const LinkFaults& faults) { m_faults = faults; }
  [[nodiscard]] bool isConnected() const { return m_connected; }

  /// Called in front of each cell that is written. `stray`: by a request of an earlier connection.
  std::function<void(int cell, double value, bool stray)> onWrite;
  /// Called between events; the machine may be acted upon.
  std::function<void()> onTime;
  /// Called in front of each start of a program: what the machine has recorded is about to go.
  std::function<void()> onCycleStart;
  /// Stands for a program on the control that is not the one transferred; empty: that one.
  std::string programInstead;

  [[nodiscard]] base::Instant now() const override { return m_machine.now(); }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override;
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override;
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override;
  std::optional<opcua::Event> wait(base::Instant until) override;

  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool overwrite) override;
  base::Result<std::string> downloadProgram(const std::string& name) override;
  base::Result<void> selectProgram(const std::string& name) override;
  [[nodiscard]] bool isVirtualMachine() const override { return true; }
  [[nodiscard]] opcua::Abilities abilities() const override { return {true, true}; }
  base::Result<void> cycleStart() override;
  base::Result<void> reset() override;
  base::Result<trace::ControlTrace> fetchTrace() override;

 private:
  enum class Fate { Answered, RequestLost, AnswerLost };
  struct Sent {
    base::RequestId id;
    bool isRead = false;
    std::vector<opcua::Variable> variables;
    std::vector<opcua::Assignment> assignments;
    std::string program;  ///< name of the program to be stored; empty: variables
    std::string text;
    opcua::Grouping grouping = opcua::Grouping::List;
    base::Instant sent{};
    base::Instant arrives{};  ///< at the machine
    base::Instant deadline{};
    Fate fate = Fate::Answered;
    std::optional<base::RequestId> inner;  ///< once it has arrived
    bool givenUp = false;
  };

  base::RequestId submit(Sent request, base::Duration deadline);
  void breakConnection();
  void deliver(Sent& request);
  [[nodiscard]] base::Error lost() const;
  [[nodiscard]] base::Duration drawn(base::Duration max);

  machine::Machine& m_machine;
  SimulatedLink m_inner;
  LinkFaults m_faults;
  base::Random m_random;
  base::RequestId m_lastId;
  std::deque<Sent> m_requests;  ///< of this connection, in order
  std::deque<Sent> m_strays;    ///< of earlier ones
  base::Instant m_lastArrival{};
  bool m_connected = true;
  bool m_lossReported = false;
};

}  // namespace rivulet::streaming
