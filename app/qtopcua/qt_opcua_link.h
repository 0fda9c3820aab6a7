// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The connection to a control with Qt OPC UA, in place of `opcua::UaLink`. Wall time. It behaves
/// alike, with four differences: it connects without encryption and without a user only; it knows
/// the names of a SINUMERIK, but no map of another control, and does not browse; one service call
/// is under way at a time, because Qt OPC UA does not say to which of several an answer belongs;
/// and of a server that answers fewer items than were asked, it takes the missing writes for done,
/// because Qt OPC UA fills them in.
/// @threadsafety one object, one thread at a time. Has a thread of its own for the network.
#pragma once

#include <memory>

#include "opcua/link.h"
#include "opcua/open62541/ua_link.h"

namespace rivulet::qtopcua {

class QtOpcUaLink final : public opcua::Link, public opcua::Control {
 public:
  /// Connects, opens a session and resolves the namespaces.
  /// @return `LinkKindError::NotAble`, NotReachable, Rejected, NamespaceMissing
  [[nodiscard]] static base::Result<std::unique_ptr<QtOpcUaLink>> connect(
      const opcua::ConnectOptions& options);

  /// Closes the session; blocks a second at most, whatever the other side does.
  ~QtOpcUaLink() override;
  QtOpcUaLink(const QtOpcUaLink&) = delete;
  QtOpcUaLink& operator=(const QtOpcUaLink&) = delete;

  /// Time since `connect`.
  [[nodiscard]] base::Instant now() const override;
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override;
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override;
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override;
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override;
  /// Never returns before `until` without an event, also after the connection is lost.
  /// An answer that came in time is reported even if this call came after the request's deadline.
  std::optional<opcua::Event> wait(base::Instant until) override;
  [[nodiscard]] base::Duration silence() const override;

  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool overwrite) override;
  base::Result<std::string> downloadProgram(const std::string& name) override;
  base::Result<void> selectProgram(const std::string& name) override;
  base::Result<opcua::ServerIdentity> identity() override;
  base::Result<std::string> accessRights() override;
  base::Result<bool> mayWrite(const opcua::Variable& variable) override;
  [[nodiscard]] bool isVirtualMachine() const override;
  [[nodiscard]] opcua::Abilities abilities() const override;
  base::Result<void> cycleStart() override;
  base::Result<void> reset() override;
  base::Result<trace::ControlTrace> fetchTrace() override;
  base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from) override;

 private:
  class Impl;
  explicit QtOpcUaLink(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

/// `QtOpcUaLink::connect`, as a connection that hides which kind of link it has.
[[nodiscard]] base::Result<opcua::Connection> openQtConnection(
    const opcua::ConnectOptions& options);

}  // namespace rivulet::qtopcua
