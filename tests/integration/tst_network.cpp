// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The real link over a network with faults, to the real server of a virtual machine.

#include <QtTest>

#include "support/fault_proxy.h"
#include "support/loopback_machine.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using opcua::Event;
using opcua::EventKind;
using opcua::Grouping;
using opcua::LinkError;
using opcua::rParameter;
using tests::FaultKind;
using tests::FaultProxy;
using tests::LoopbackMachine;
using tests::NetworkFault;

namespace {

constexpr base::Duration kPatience = 60s;

NetworkFault fault(FaultKind kind, base::Duration duration = {}, base::Duration delay = {}) {
  NetworkFault fault;
  fault.kind = kind;
  fault.duration = duration;
  fault.delay = delay;
  return fault;
}

base::Result<std::unique_ptr<opcua::UaLink>> connectTo(const std::string& endpoint,
                                                       base::Duration deadline = 20s) {
  opcua::ConnectOptions options;
  options.endpoint = endpoint;
  options.connectDeadline = deadline;
  return opcua::UaLink::connect(options);
}

/// One value, asked for with this deadline; the event that ends the request.
Event readOnce(opcua::Link& link, base::Duration deadline) {
  const std::vector<opcua::Variable> asked{rParameter(1)};
  const base::RequestId id = link.read(asked, deadline, Grouping::List);
  for (;;) {
    auto event = link.wait(link.now() + kPatience);
    RIVULET_ASSERT(event.has_value());
    if (event->request == id || event->kind == EventKind::ConnectionLost) {
      return std::move(*event);
    }
  }
}

}  // namespace

class TestNetwork : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatPassesTheProxyArrives() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    const auto link = connectTo(proxy.endpoint());
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    QCOMPARE(readOnce(**link, kPatience).kind, EventKind::ReadDone);
    proxy.begin(fault(FaultKind::Cut));
    while (!proxy.hasStruck()) {
    }
    QCOMPARE(readOnce(**link, kPatience).kind, EventKind::ConnectionLost);
  }

  void aFaultIsDrawnTheSameAgain() {
    std::set<FaultKind> kinds;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const NetworkFault first = tests::drawNetworkFault(seed, 4s);
      const NetworkFault again = tests::drawNetworkFault(seed, 4s);
      QVERIFY(first.kind == again.kind && first.after == again.after &&
              first.duration == again.duration && first.delay == again.delay &&
              first.place == again.place && first.seed == again.seed);
      QVERIFY(first.after < 4s && first.duration < 10s);
      kinds.insert(first.kind);
    }
    QCOMPARE(kinds.size(), static_cast<std::size_t>(FaultKind::Count) - 1);
  }
};

RIVULET_TEST(TestNetwork)
#include "tst_network.moc"
