// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A link between a client and a virtual machine with all kinds of faults: requests and answers are
/// late or lost, the client stalls, the connection breaks, and requests that were in transit arrive
/// later, between the requests of the next connection. Within one connection requests keep their
/// order, as with TCP. The faults are drawn from a seed.
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

/// Probability of each fault, per request unless stated otherwise.
struct LinkFaults {
  double delayProbability = 0.0;
  base::Duration delayMax{};  ///< of a request in transit
  double lostRequestProbability = 0.0;
  double lostAnswerProbability = 0.0;
  double stallProbability = 0.0;  ///< the client stalls after an answer
  base::Duration stallMax{};
  double disconnectProbability = 0.0;
  /// Requests that were in transit when the connection broke arrive within this time, in any order;
  /// zero: they are lost.
  base::Duration strayMax{};
};

class FaultyLink final : public opcua::Link, public opcua::Control {
 public:
  /// @param machine  must outlive the link
  FaultyLink(machine::Machine& machine, const LinkFaults& faults, std::uint64_t seed);

  /// The next connection. Requests of the previous one that are still in transit become strays.
  void reconnect();
  /// The faults from now on.
  void setFaults(const LinkFaults& faults) { m_faults = faults; }
  [[nodiscard]] bool isConnected() const { return m_connected; }

  /// Called before each cell that is written. `stray`: by a request of an earlier connection.
  std::function<void(int cell, double value, bool stray)> onWrite;
  /// Called between events; the machine may be acted upon.
  std::function<void()> onTime;
  /// Called before each start of a program, when the machine's trace is about to be cleared.
  std::function<void()> onCycleStart;
  /// A program on the control that replaces the transferred one; empty: none.
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
  /// Hands over what has arrived at the machine. @param next  moved to the next arrival
  void deliverArrived(std::deque<Sent>& requests, base::Instant& next);
  /// A request whose deadline has passed, as a failure. @param next  moved to the next deadline
  [[nodiscard]] std::optional<opcua::Event> giveUp(base::Instant& next);
  /// What the client hears of an answer; nothing: the answer is lost, or too late.
  [[nodiscard]] std::optional<opcua::Event> hear(opcua::Event event);
  /// The client does nothing for a while.
  void stallClient();
  /// Of the link below; first what came while the client did nothing.
  std::optional<opcua::Event> nextEvent(base::Instant until);
  [[nodiscard]] base::Error lost() const;
  [[nodiscard]] base::Duration drawn(base::Duration max);

  machine::Machine& m_machine;
  SimulatedLink m_inner;
  LinkFaults m_faults;
  base::Random m_random;
  base::RequestId m_lastId;
  std::deque<opcua::Event> m_unheard;
  std::deque<Sent> m_requests;  ///< of this connection, in order
  std::deque<Sent> m_strays;    ///< of earlier ones
  base::Instant m_lastArrival{};
  bool m_connected = true;
  bool m_lossReported = false;
};

}  // namespace rivulet::streaming
