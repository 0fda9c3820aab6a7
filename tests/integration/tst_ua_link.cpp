// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The link against the real server: what is asked arrives, and every failure has its name.

#include <QtTest>
#include <cmath>
#include <limits>
#include <vector>

#include "machine/front/variable_service.h"
#include "opcua/request.h"
#include "support/chosen_link.h"
#include "support/loopback_machine.h"
#include "support/plain_server.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using opcua::Assignment;
using opcua::Event;
using opcua::EventKind;
using opcua::Grouping;
using opcua::LinkError;
using opcua::rParameter;
using opcua::Variable;
using opcua::VariableKind;
using tests::LoopbackMachine;

namespace {

/// Far beyond anything a loaded computer needs: only a hang runs into it.
constexpr base::Duration kPatience = 60s;

std::vector<Variable> parameters(int first, int count) {
  std::vector<Variable> variables;
  for (int i = 0; i < count; ++i) {
    variables.push_back(rParameter(first + i));
  }
  return variables;
}

std::vector<Assignment> assignments(int first, const std::vector<double>& values) {
  std::vector<Assignment> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.push_back({rParameter(first + static_cast<int>(i)), values[i]});
  }
  return result;
}

/// The next event, which must come.
Event next(opcua::Link& link) {
  auto event = link.wait(link.now() + kPatience);
  RIVULET_ASSERT(event.has_value());
  return std::move(*event);
}

std::vector<double> numbers(const Event& event) {
  std::vector<double> result;
  for (const opcua::Reading& reading : event.readings) {
    result.push_back(reading.status ? std::nan("") : reading.number);
  }
  return result;
}

/// What the variable service of a fresh machine takes for these requests, in virtual time. The
/// random numbers are the server's, so no real access can be faster.
base::Duration serviceTime(const std::string& preset, std::uint64_t seed,
                           const std::vector<std::pair<machine::AccessKind, int>>& requests) {
  machine::Machine twin(*machine::loadPreset(preset), seed);
  base::Instant served{};
  for (const auto& [kind, count] : requests) {
    twin.beginRequest(kind, base::Instant{});
    for (int i = 0; i < count; ++i) {
      served = twin.serveNode();
    }
  }
  return served.time_since_epoch();
}

}  // namespace

class TestUaLink : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { RIVULET_SKIP_WITHOUT_LINK(); }

  void writesAndReadsBack_data() {
    QTest::addColumn<int>("grouping");
    QTest::newRow("list") << static_cast<int>(Grouping::List);
    QTest::newRow("single") << static_cast<int>(Grouping::Single);
    QTest::newRow("array, count") << static_cast<int>(Grouping::ArrayCount);
    QTest::newRow("array, range") << static_cast<int>(Grouping::ArrayRange);
  }

  void writesAndReadsBack() {
    QFETCH(int, grouping);
    const auto how = static_cast<Grouping>(grouping);
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const std::vector<double> values{1.5, -2.25, 0.0, 1e-300, 1e300, 0.1};

    const auto write = link->write(assignments(10, values), kPatience, how);
    const Event written = next(*link);
    QCOMPARE(written.kind, EventKind::WriteDone);
    QVERIFY(written.request == write);
    QVERIFY(written.statuses == std::vector<std::error_code>(values.size()));
    QVERIFY(written.sent <= written.at);

    // Visible at the next interpolation boundary.
    std::vector<double> seen;
    const base::Instant limit = link->now() + kPatience;
    while (seen != values && link->now() < limit) {
      const auto id = link->read(parameters(10, 6), kPatience, how);
      const Event read = next(*link);
      QCOMPARE(read.kind, EventKind::ReadDone);
      QVERIFY(read.request == id);
      seen = numbers(read);
    }
    QVERIFY(seen == values);
    QVERIFY(!link->wait(link->now()));
  }

  /// What does not ascend by one has a node of its own, and every value keeps its place.
  void arraysAndScalarsShareARequest() {
    for (const Grouping form : {Grouping::ArrayCount, Grouping::ArrayRange}) {
      LoopbackMachine cell;
      const auto link = tests::connectChosen(cell);
      const std::vector<Assignment> items{{rParameter(20), 1.0}, {rParameter(21), 2.0},
                                          {rParameter(22), 3.0}, {rParameter(40), 4.0},
                                          {rParameter(30), 5.0}, {rParameter(31), 6.0},
                                          {rParameter(0), 7.0}};
      std::vector<Variable> variables{{VariableKind::PathFeed, 0}};
      std::vector<double> expected{0.0};
      for (const Assignment& item : items) {
        variables.push_back(item.variable);
        expected.push_back(item.value);
      }
      link->write(items, kPatience, form);
      const Event written = next(*link);
      QVERIFY(written.statuses == std::vector<std::error_code>(items.size()));
      QCOMPARE(cell.server().nodesServed(), 4U);
      QCOMPARE(cell.server().requestsServed(), 1U);
      link->read(variables, kPatience, Grouping::List);
      QVERIFY(numbers(next(*link)) == expected);
      QCOMPARE(cell.server().nodesServed(), 4U + 8U);
      link->read(variables, kPatience, form);
      QVERIFY(numbers(next(*link)) == expected);
      QCOMPARE(cell.server().nodesServed(), 4U + 8U + 5U);
    }
  }

  void arraysCostWhatTheControlCharges() {
    LoopbackMachine::Options options;
    options.arrays =
        machine::ArrayAccess{true, true, machine::ArrayWrite::All, machine::ArrayCharge::Element};
    LoopbackMachine cell(options);
    const auto link = tests::connectChosen(cell);
    link->write(assignments(10, std::vector<double>(20, 1.0)), kPatience, Grouping::ArrayCount);
    QVERIFY(next(*link).statuses == std::vector<std::error_code>(20));
    link->read(parameters(10, 20), kPatience, Grouping::ArrayRange);
    QVERIFY(numbers(next(*link)) == std::vector<double>(20, 1.0));
    QCOMPARE(cell.server().nodesServed(), 40U);
    QCOMPARE(cell.server().requestsServed(), 2U);
  }

  /// What the control does not offer fails by its name, and nothing is written.
  void arraysThatAreNotOffered() {
    using machine::ArrayWrite;
    LoopbackMachine::Options options;
    options.arrays =
        machine::ArrayAccess{true, false, ArrayWrite::Refused, machine::ArrayCharge::Node};
    LoopbackMachine cell(options);
    const auto link = tests::connectChosen(cell);
    const auto statuses = [&](int first, Grouping form) {
      link->write(assignments(first, {1.0, 2.0, 3.0}), kPatience, form);
      return next(*link).statuses;
    };
    const auto all = [](LinkError error) { return std::vector<std::error_code>(3, error); };
    QVERIFY(statuses(10, Grouping::ArrayCount) == all(LinkError::NotWritable));
    QVERIFY(statuses(10, Grouping::ArrayRange) == all(LinkError::VariableMissing));
    QVERIFY(statuses(98, Grouping::ArrayCount) == all(LinkError::VariableMissing));  // up to R100
    link->read(parameters(10, 3), kPatience, Grouping::ArrayRange);
    for (const opcua::Reading& reading : next(*link).readings) {
      QVERIFY(reading.status == LinkError::VariableMissing);
    }
    link->read(parameters(10, 3), kPatience, Grouping::ArrayCount);
    QVERIFY(numbers(next(*link)) == std::vector<double>(3, 0.0));
  }

  void aListIsOneServiceCallAndSinglesAreMany() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    QCOMPARE(cell.server().nodesServed(), 0U);  // connecting costs no variable
    link->read(parameters(0, 20), kPatience, Grouping::List);
    QCOMPARE(next(*link).kind, EventKind::ReadDone);
    QCOMPARE(cell.server().nodesServed(), 20U);
    QCOMPARE(cell.server().requestsServed(), 1U);
    link->read(parameters(0, 20), kPatience, Grouping::Single);
    QCOMPARE(next(*link).readings.size(), std::size_t{20});
    QCOMPARE(cell.server().nodesServed(), 40U);
    QCOMPARE(cell.server().requestsServed(), 21U);
    link->write(assignments(0, {1, 2, 3}), kPatience, Grouping::List);
    QCOMPARE(next(*link).kind, EventKind::WriteDone);
    QCOMPARE(cell.server().nodesServed(), 43U);
    QCOMPARE(cell.server().requestsServed(), 22U);
  }

  /// Several requests in progress at once are answered in the order they were made, and each is a
  /// request of its own to the control, also when they reach it together.
  void requestsAreServedInOrder() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const std::vector<base::RequestId> ids{
        link->write(assignments(1, {1, 2, 3}), kPatience, Grouping::List),
        link->read(parameters(1, 3), kPatience, Grouping::Single),
        link->read(parameters(4, 2), kPatience, Grouping::List),
        link->write(assignments(1, {4}), kPatience, Grouping::Single)};
    for (const base::RequestId id : ids) {
      QVERIFY(next(*link).request == id);
    }
    QCOMPARE(cell.server().requestsServed(), 6U);
    QCOMPARE(cell.server().nodesServed(), 9U);
  }

  void itemsOfAWriteAreExecutedInOrder() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    std::vector<Assignment> items;
    for (int i = 1; i <= 50; ++i) {
      items.push_back({rParameter(20), static_cast<double>(i)});
    }
    link->write(items, kPatience, Grouping::List);
    QCOMPARE(next(*link).kind, EventKind::WriteDone);
    double value = 0.0;
    do {
      link->read(parameters(20, 1), kPatience, Grouping::List);
      value = numbers(next(*link))[0];
      QVERIFY(value == 0.0 || value == 50.0);
    } while (value == 0.0);
  }

  void allKindsOfVariablesAreThere() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const std::vector<Variable> variables{
        {VariableKind::ActualPosition, 0}, {VariableKind::ActualPosition, 2},
        {VariableKind::DistanceToGo, 1},   {VariableKind::PathFeed, 0},
        {VariableKind::ProgramStatus, 0},  {VariableKind::ChannelStatus, 0},
        {VariableKind::LineNumber, 0},     {VariableKind::ProgramName, 0},
        {VariableKind::Message, 0},        {VariableKind::Alarm, 0}};
    link->read(variables, kPatience, Grouping::List);
    const Event event = next(*link);
    QCOMPARE(event.readings.size(), variables.size());
    for (const opcua::Reading& reading : event.readings) {
      QVERIFY2(!reading.status, reading.status.message().c_str());
    }
    cell.stop();
    const machine::MachineConfig& config = cell.machineAfterStop().config();
    QCOMPARE(event.readings[0].number, config.axes[0].startMm);
    QCOMPARE(event.readings[1].number, config.axes[2].startMm);
    QCOMPARE(event.readings[4].number, 5.0);  // in reset
    QCOMPARE(event.readings[5].number, 0.0);
    QCOMPARE(event.readings[7].text, std::string());
    QCOMPARE(event.readings[9].number, 0.0);
  }

  void everyItemHasItsOwnStatus() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const Variable missing = rParameter(99999);
    const Variable position{VariableKind::ActualPosition, 0};
    link->read(std::vector{rParameter(1), missing, rParameter(2), Variable{position.kind, 3}},
               kPatience, Grouping::List);
    const Event read = next(*link);
    QCOMPARE(read.kind, EventKind::ReadDone);
    QVERIFY(!read.readings[0].status);
    QVERIFY(read.readings[1].status == LinkError::VariableMissing);
    QVERIFY(!read.readings[2].status);
    QVERIFY(read.readings[3].status == LinkError::VariableMissing);

    for (const Grouping how : {Grouping::List, Grouping::Single}) {
      link->write(
          std::vector<Assignment>{
              {rParameter(1), 1.0}, {position, 1.0}, {missing, 1.0}, {rParameter(2), 2.0}},
          kPatience, how);
      const Event written = next(*link);
      QCOMPARE(written.kind, EventKind::WriteDone);
      QVERIFY(!written.statuses[0]);
      QVERIFY(written.statuses[1] == LinkError::NotWritable);
      QVERIFY(written.statuses[2] == LinkError::VariableMissing);
      QVERIFY(!written.statuses[3]);
    }
  }

  void valuesThatAreNoNumbersAreNeverSent() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
      const auto id = link->write(assignments(1, {1.0, bad}), kPatience, Grouping::List);
      const Event event = next(*link);
      QCOMPARE(event.kind, EventKind::RequestFailed);
      QVERIFY(event.request == id);
      QVERIFY(event.error.code == LinkError::BadValue);
    }
    link->read(parameters(1, 1), kPatience, Grouping::List);
    QVERIFY(numbers(next(*link)) == std::vector<double>{0.0});
    QCOMPARE(cell.server().nodesServed(), 1U);  // the read; nothing of the writes got there
  }

  void requestsBeyondTheLimitAreRefused() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const std::vector<Variable> many(opcua::kItemsMax + 1, rParameter(1));
    link->read(many, kPatience, Grouping::List);
    const Event refused = next(*link);
    QCOMPARE(refused.kind, EventKind::RequestFailed);
    QVERIFY(refused.error.code == LinkError::TooManyItems);
    link->read(std::span(many).first(opcua::kItemsMax), kPatience, Grouping::List);
    QCOMPARE(next(*link).readings.size(), opcua::kItemsMax);
    link->read({}, kPatience, Grouping::List);
    QCOMPARE(next(*link).kind, EventKind::ReadDone);
  }

  /// 100 nodes take the service about 430 ms: no answer can be there after 50.
  void deadlinesAreKeptAndLateAnswersDropped() {
    QVERIFY(serviceTime("dmu75", 1, {{machine::AccessKind::Read, 100}}) > 200ms);
    LoopbackMachine cell({"dmu75"});
    const auto link = tests::connectChosen(cell);
    const auto late = link->read(parameters(0, 100), 50ms, Grouping::List);
    const Event expired = next(*link);
    QCOMPARE(expired.kind, EventKind::RequestFailed);
    QVERIFY(expired.request == late);
    QVERIFY(expired.error.code == LinkError::DeadlineExceeded);
    QVERIFY(expired.at - expired.sent >= 50ms);

    // The connection goes on. The server works through the late request first; its answer
    // belongs to nobody any more.
    const auto id = link->read(parameters(1, 2), kPatience, Grouping::List);
    const Event event = next(*link);
    QCOMPARE(event.kind, EventKind::ReadDone);
    QVERIFY(event.request == id);
    QCOMPARE(event.readings.size(), std::size_t{2});
    QCOMPARE(cell.server().nodesServed(), 102U);
    QVERIFY(!link->wait(link->now() + 5ms));
  }

  void anAnswerThatCameInTimeCountsWheneverItIsAskedFor() {
    const LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const auto other = tests::connectChosen(cell);
    const base::Duration deadline = 200ms;
    const auto id = link->read(parameters(1, 1), deadline, Grouping::List);
    const base::Instant until = other->now() + deadline;
    // The server answers one after another: when the other one has its answer, ours is sent.
    other->read(parameters(1, 1), kPatience, Grouping::List);
    QCOMPARE(next(*other).kind, EventKind::ReadDone);
    QVERIFY(!other->wait(until));
    const Event event = next(*link);
    QVERIFY(event.request == id);
    QCOMPARE(event.kind, EventKind::ReadDone);
  }

  void aChainThatExpiresIsNotGoneOnWith() {
    LoopbackMachine cell({"dmu75"});
    const auto link = tests::connectChosen(cell);
    const auto chain = link->read(parameters(0, 100), 60ms, Grouping::Single);
    const auto behind = link->read(parameters(1, 1), kPatience, Grouping::List);
    const Event expired = next(*link);
    QVERIFY(expired.request == chain);
    QVERIFY(expired.error.code == LinkError::DeadlineExceeded);
    QVERIFY(next(*link).request == behind);
    // 60 ms are over long before the hundredth call.
    QVERIFY(cell.server().nodesServed() < 100U);
  }

  void waitingEndsWhenTheTimeHasCome() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    for (const base::Duration rest : {0ns, 300'000ns, 2'700'000ns, 12'000'000ns}) {
      const base::Instant until = link->now() + rest;
      QVERIFY(!link->wait(until));
      QVERIFY(link->now() >= until);
    }
  }

  void aLostConnectionIsReportedOnce() {
    LoopbackMachine cell({"dmu75"});
    const auto link = tests::connectChosen(cell);
    link->read(parameters(0, 100), kPatience, Grouping::Single);
    link->read(parameters(0, 100), kPatience, Grouping::List);
    while (cell.server().nodesServed() < 3) {
      QVERIFY(!link->wait(link->now() + 1ms));
    }
    cell.stop();  // in the middle of the chain

    const Event lost = next(*link);
    QCOMPARE(lost.kind, EventKind::ConnectionLost);
    QVERIFY(lost.error.code == LinkError::ConnectionLost);
    QVERIFY(!lost.error.message.empty());
    QVERIFY(!link->wait(link->now() + 20ms));

    const auto id = link->read(parameters(0, 1), kPatience, Grouping::List);
    const Event refused = next(*link);
    QCOMPARE(refused.kind, EventKind::RequestFailed);
    QVERIFY(refused.request == id);
    QVERIFY(refused.error.code == LinkError::ConnectionLost);
    QVERIFY(link->downloadProgram("A.MPF").error().code == LinkError::ConnectionLost);
    QVERIFY(!link->wait(link->now() + 20ms));
  }

  /// A server that goes and comes back is another one: the link stays lost.
  void aLostConnectionStaysLost() {
    auto cell = std::make_unique<LoopbackMachine>();
    const std::string endpoint = cell->endpoint();
    const auto link = tests::connectChosen(*cell);
    cell->stop();
    QCOMPARE(next(*link).kind, EventKind::ConnectionLost);
    LoopbackMachine::Options again;
    again.port = static_cast<std::uint16_t>(std::stoi(endpoint.substr(endpoint.rfind(':') + 1)));
    const LoopbackMachine second(again);
    QVERIFY(!link->wait(link->now() + 50ms));
    link->read(parameters(0, 1), kPatience, Grouping::List);
    QVERIFY(next(*link).error.code == LinkError::ConnectionLost);
    QCOMPARE(second.server().nodesServed(), 0U);
  }

  /// Reading with a second client costs the first one its slots: the service does one node
  /// after another, whoever asks.
  void twoClientsShareOneService() {
    const base::Duration together =
        serviceTime("dmu75", 7, {{machine::AccessKind::Read, 30}, {machine::AccessKind::Read, 30}});
    LoopbackMachine cell({"dmu75", 7});
    const auto first = tests::connectChosen(cell);
    const auto second = tests::connectChosen(cell);
    const base::Instant begin = first->now();
    first->read(parameters(0, 30), kPatience, Grouping::List);
    second->read(parameters(30, 30), kPatience, Grouping::List);
    QCOMPARE(next(*second).readings.size(), std::size_t{30});
    QCOMPARE(next(*first).readings.size(), std::size_t{30});
    QVERIFY(first->now() - begin >= together - machine::VariableService::kOnTheWay);
    QCOMPARE(cell.server().requestsServed(), 2U);
    QCOMPARE(cell.server().nodesServed(), 60U);
  }

  void accessTakesWhatTheServiceTakes() {
    const base::Duration list = serviceTime("dmu75", 3, {{machine::AccessKind::Write, 20}});
    LoopbackMachine cell({"dmu75", 3});
    const auto link = tests::connectChosen(cell);
    link->write(assignments(0, std::vector<double>(20, 1.0)), kPatience, Grouping::List);
    const Event event = next(*link);
    QVERIFY(event.at - event.sent >= list - machine::VariableService::kOnTheWay);
  }

  void theHostIsUsedAsTyped() {
    const LoopbackMachine cell;  // announces itself as 127.0.0.1
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = "opc.tcp://localhost" + cell.endpoint().substr(cell.endpoint().rfind(':'));
    options.connectDeadline = kPatience;
    const auto link = tests::openChosen(options);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    (*link)->read(parameters(0, 1), kPatience, Grouping::List);
    QCOMPARE(next(**link).kind, EventKind::ReadDone);
  }

  void whoDoesNotAnswerIsNotReachable() {
    std::string endpoint;
    {
      const LoopbackMachine gone;
      endpoint = gone.endpoint();
    }
    const std::string unknown = "opc.tcp://host.invalid:4840";
    for (const std::string& address :
         {endpoint, std::string("control.example:4840"), unknown, std::string()}) {
      opcua::ConnectOptions options;
      options.security = opcua::unencrypted();
      options.endpoint = address;
      options.connectDeadline = 10s;
      const auto link = tests::openChosen(options);
      QVERIFY(!link);
      QVERIFY(link.error().code ==
              (address == unknown ? LinkError::HostUnknown : LinkError::NotReachable));
      QVERIFY(link.error().text().find(address) != std::string::npos);
    }
  }

  void anotherServerIsNoControl() {
    const tests::PlainServer plain;
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = plain.endpoint();
    options.connectDeadline = kPatience;
    const auto link = tests::openChosen(options);
    QVERIFY(!link);
    QVERIFY2(link.error().code == LinkError::NamespaceMissing, link.error().text().c_str());
  }
};

RIVULET_TEST(TestUaLink)
#include "tst_ua_link.moc"
