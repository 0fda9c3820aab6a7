// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A `Link` to a virtual machine in virtual time: `wait` jumps the clock to the next event
/// instead of sleeping. Requests pay the access cost of the machine's variable service, node
/// after node, exactly as through the OPC UA front.
/// @threadsafety one object, one thread.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "machine/machine.h"
#include "opcua/link.h"

namespace rivulet::streaming {

/// What the variable service of the machine has done.
struct ServiceLoad {
  std::size_t requests = 0;
  std::size_t nodes = 0;  ///< elements of an array that is charged by the element count each
};

class SimulatedLink final : public opcua::Link, public opcua::Control {
 public:
  /// @param machine  must outlive the link
  explicit SimulatedLink(machine::Machine& machine) : m_machine(machine) {}

  /// Observer: called before each R-parameter that is written, at the machine's time.
  std::function<void(base::RequestId request, int cell, double value)> onWrite;

  /// Since the last start of the program; storing a program is a request without nodes.
  [[nodiscard]] const ServiceLoad& served() const { return m_served; }

  [[nodiscard]] base::Instant now() const override { return m_machine.now(); }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override;
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override;
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override;
  /// Costs no time, so that a run is the same whether its trace is fetched or not.
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override;
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
  base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from) override;

 private:
  struct Request {
    base::RequestId id;
    machine::AccessKind kind = machine::AccessKind::Read;
    opcua::Grouping grouping = opcua::Grouping::List;
    std::vector<opcua::Variable> variables;
    std::vector<double> values;  ///< Write
    std::string program;         ///< name of the program to be stored; empty: variables
    std::string text;            ///< of the program
    base::Instant sent{};
    base::Instant deadline{};
    std::size_t next = 0;        ///< first variable of the node to be served
    base::Instant nextDoneAt{};  ///< when that node is done; valid once begun
    bool begun = false;
    bool refused = false;   ///< a value is not finite: fails without being sent
    bool reported = false;  ///< its deadline has passed and been reported
    opcua::Event event;
  };

  base::RequestId submit(Request request, base::Duration deadline);
  void beginNode(Request& request);
  [[nodiscard]] base::Instant serveNode();
  /// True if nothing is left to be served.
  [[nodiscard]] static bool isServed(const Request& request);
  /// Variables of the node to be served.
  [[nodiscard]] static std::size_t nodeLength(const Request& request);
  /// Reads or writes them.
  void access(Request& request, std::size_t length);
  [[nodiscard]] bool offers(opcua::Grouping grouping) const;
  [[nodiscard]] std::error_code writeVariable(const Request& request, std::size_t item);
  [[nodiscard]] opcua::Reading readVariable(const opcua::Variable& variable) const;
  [[nodiscard]] opcua::Reading readEquipment(const opcua::Variable& variable) const;

  machine::Machine& m_machine;
  ServiceLoad m_served;
  base::RequestId m_lastId;
  std::deque<Request> m_requests;
  std::deque<opcua::Event> m_traces;  ///< answers to `readTrace`
};

}  // namespace rivulet::streaming
