// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Connections with the library that RIVULET_TEST_LINK names, open62541 without it: one set of
/// tests for all of them. @threadsafety as the link.
#pragma once

#include <QtTest>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/contract.h"
#include "opcua/open62541/ua_link.h"
#include "qtopcua/open_link.h"
#include "support/loopback_machine.h"

namespace rivulet::tests {

[[nodiscard]] inline opcua::LinkKind chosenLinkKind() {
  const std::string name = qEnvironmentVariable("RIVULET_TEST_LINK").toStdString();
  if (name.empty()) {
    return opcua::LinkKind::Open62541;
  }
  const auto kind = qtopcua::linkFromName(name);
  RIVULET_ASSERT(kind.has_value());
  return *kind;
}

/// A connection as one object, whatever made it.
class ChosenLink final : public opcua::Link, public opcua::Control {
 public:
  explicit ChosenLink(opcua::Connection connection) : m_connection(std::move(connection)) {}

  [[nodiscard]] base::Instant now() const override { return link().now(); }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override {
    return link().read(variables, deadline, grouping);
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override {
    return link().write(assignments, deadline, grouping);
  }
  base::RequestId store(const std::string& name, const std::string& text,
                        base::Duration deadline) override {
    return link().store(name, text, deadline);
  }
  base::RequestId readTrace(const trace::TracePosition& from, base::Duration deadline) override {
    return link().readTrace(from, deadline);
  }
  std::optional<opcua::Event> wait(base::Instant until) override { return link().wait(until); }
  [[nodiscard]] base::Duration silence() const override { return link().silence(); }

  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool overwrite) override {
    return control().uploadProgram(name, text, overwrite);
  }
  base::Result<std::string> downloadProgram(const std::string& name) override {
    return control().downloadProgram(name);
  }
  base::Result<void> selectProgram(const std::string& name) override {
    return control().selectProgram(name);
  }
  base::Result<opcua::ServerIdentity> identity() override { return control().identity(); }
  base::Result<std::string> accessRights() override { return control().accessRights(); }
  base::Result<bool> mayWrite(const opcua::Variable& variable) override {
    return control().mayWrite(variable);
  }
  [[nodiscard]] bool isVirtualMachine() const override { return control().isVirtualMachine(); }
  [[nodiscard]] opcua::Abilities abilities() const override { return control().abilities(); }
  base::Result<void> cycleStart() override { return control().cycleStart(); }
  base::Result<void> reset() override { return control().reset(); }
  base::Result<trace::ControlTrace> fetchTrace() override { return control().fetchTrace(); }
  base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from) override {
    return control().fetchTracePiece(from);
  }

 private:
  [[nodiscard]] opcua::Link& link() const { return *m_connection.link; }
  [[nodiscard]] opcua::Control& control() const { return *m_connection.control; }

  opcua::Connection m_connection;
};

/// A new connection. @return as `qtopcua::openLink`
[[nodiscard]] inline base::Result<std::unique_ptr<ChosenLink>> openChosen(
    const opcua::ConnectOptions& options) {
  auto connection = qtopcua::openLink(chosenLinkKind(), options);
  if (!connection) {
    return base::fail(connection.error());
  }
  return std::make_unique<ChosenLink>(std::move(*connection));
}

/// A new connection to a machine. It answers, so failure is a bug.
[[nodiscard]] inline std::unique_ptr<ChosenLink> connectChosen(const LoopbackMachine& machine) {
  opcua::ConnectOptions options;
  options.security = opcua::unencrypted();
  options.endpoint = machine.endpoint();
  options.connectDeadline = std::chrono::seconds(20);
  options.commandDeadline = std::chrono::seconds(20);
  auto link = openChosen(options);
  RIVULET_ASSERT(link.has_value());
  return std::move(*link);
}

}  // namespace rivulet::tests

/// In `initTestCase`: leaves the whole test out, visibly, where the build lacks the library.
#define RIVULET_SKIP_WITHOUT_LINK()                                                          \
  if (!rivulet::qtopcua::isAvailable(rivulet::tests::chosenLinkKind())) {                     \
    QSKIP("Qt OPC UA was not there when this was built.");                                    \
  }
