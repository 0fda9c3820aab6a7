// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Programs, selection and the virtual machine's own keys, over OPC UA.

#include <QtTest>
#include <string>
#include <vector>

#include "support/chosen_link.h"
#include "support/loopback_machine.h"
#include "support/test_program.h"
#include "trace/control_trace.h"

using namespace rivulet;
using namespace std::chrono_literals;
using opcua::LinkError;
using opcua::VariableKind;
using tests::LoopbackMachine;

namespace {

constexpr base::Duration kPatience = 60s;

const std::string kSquare =
    "; a square\n"
    "G0 X0 Y0 Z50\n"
    "G1 X10 F6000\n"
    "G1 Y10\n"
    "G1 X0\n"
    "G1 Y0\n"
    "M30\n";

/// Loops until R1 is set.
const std::string kWaiting =
    "WAIT1: STOPRE\n"
    "G4 F0.02\n"
    "IF R1==0 GOTOB WAIT1\n"
    "M30\n";

opcua::Reading readOne(opcua::Link& link, opcua::Variable variable) {
  link.read(std::vector{variable}, kPatience, opcua::Grouping::List);
  const auto event = link.wait(link.now() + kPatience);
  RIVULET_ASSERT(event && event->kind == opcua::EventKind::ReadDone);
  return event->readings[0];
}

/// Reads the channel's status until it is this one.
void awaitChannel(opcua::Link& link, machine::ChannelStatus status) {
  const base::Instant limit = link.now() + kPatience;
  while (readOne(link, {VariableKind::ChannelStatus, 0}).number != static_cast<double>(status)) {
    RIVULET_ASSERT(link.now() < limit);
  }
}

std::error_code codeOf(const base::Result<void>& result) {
  return result ? std::error_code() : result.error().code;
}

}  // namespace

class TestUaControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { RIVULET_SKIP_WITHOUT_LINK(); }

  /// What is measured on one server is not taken for another, or another version.
  void theServerSaysWhoItIs() {
    for (const char* preset : {"ideal", "dmu75-arrays"}) {
      LoopbackMachine::Options options;
      options.preset = preset;
      const LoopbackMachine cell(options);
      const auto link = tests::connectChosen(cell);
      const auto identity = link->identity();
      QVERIFY(identity);
      QCOMPARE(identity->applicationUri, std::string("urn:rivulet:machine"));
      QCOMPARE(identity->productName, std::string("Rivulet virtual machine"));
      QVERIFY(!identity->softwareVersion.empty());
      QCOMPARE(identity->buildNumber, std::string(preset));
      QVERIFY(*identity == *link->identity());
    }
  }

  void programsGoThereAndBack() {
    const LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    std::string bytes = "G1 X1 ; \xC3\xA4 \r\n\tM30\n";
    QVERIFY(link->uploadProgram("BACK.MPF", bytes, false));
    const auto back = link->downloadProgram("BACK.MPF");
    QVERIFY(back.has_value());
    QCOMPARE(*back, bytes);

    QVERIFY(codeOf(link->uploadProgram("BACK.MPF", kSquare, false)) == LinkError::FileExists);
    QCOMPARE(*link->downloadProgram("BACK.MPF"), bytes);
    QVERIFY(link->uploadProgram("BACK.MPF", kSquare, true));
    QCOMPARE(*link->downloadProgram("BACK.MPF"), kSquare);
  }

  /// Many network packets in both directions.
  void aLargeProgramArrivesWhole() {
    const LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    std::string text;
    for (int i = 0; text.size() < (std::size_t{2} << 20U); ++i) {
      text += "N" + std::to_string(i) + " G1 X" + std::to_string(i % 100) + " F6000\n";
    }
    text += "M30\n";
    QVERIFY(link->uploadProgram("LARGE.MPF", text, false));
    const auto back = link->downloadProgram("LARGE.MPF");
    QVERIFY(back.has_value());
    QVERIFY(*back == text);
  }

  void whatIsMissingIsSaid() {
    const LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    const auto missing = link->downloadProgram("NIX.MPF");
    QVERIFY(!missing);
    QVERIFY(missing.error().code == LinkError::ProgramMissing);
    QVERIFY(codeOf(link->selectProgram("NIX.MPF")) == LinkError::ProgramMissing);
    QVERIFY(codeOf(link->cycleStart()) == LinkError::ProgramMissing);
    QVERIFY(codeOf(link->uploadProgram("a/b.MPF", kSquare, false)) == LinkError::Rejected);
  }

  void aProgramRunsAndLeavesItsTrace() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->isVirtualMachine());
    QVERIFY(link->uploadProgram("SQUARE.MPF", kSquare, false));
    QVERIFY(link->selectProgram("SQUARE.MPF"));
    QCOMPARE(readOne(*link, {VariableKind::ProgramName, 0}).text, std::string("SQUARE.MPF"));
    QVERIFY(link->cycleStart());
    awaitChannel(*link, machine::ChannelStatus::Reset);
    QCOMPARE(readOne(*link, {VariableKind::Alarm, 0}).number, 0.0);

    const auto trace = link->fetchTrace();
    QVERIFY(trace.has_value());
    std::vector<base::Vec3> corners;
    for (const trace::ExecutedBlock& block : trace->blocks) {
      if (block.lengthMm > 0.0) {
        corners.push_back(block.targetMm);
      }
    }
    QVERIFY(
        (corners == std::vector<base::Vec3>{{10, 0, 50}, {10, 10, 50}, {0, 10, 50}, {0, 0, 50}}));
    cell.stop();
    QVERIFY(trace::printControlTrace(*trace) ==
            trace::printControlTrace(cell.machineAfterStop().trace()));
  }

  /// M0 waits for the next cycle start, and what the machine did arrives with the trace.
  void aStopOfTheProgramIsContinued() {
    LoopbackMachine cell({.preset = "dmu75-mill"});
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->uploadProgram("STOP.MPF", "S1000 M3\nM0\nG1 X1 F6000\nM30\n", false));
    QVERIFY(link->selectProgram("STOP.MPF") && link->cycleStart());
    awaitChannel(*link, machine::ChannelStatus::Interrupted);
    QCOMPARE(readOne(*link, {VariableKind::Alarm, 0}).number, 0.0);
    QVERIFY(link->cycleStart());
    awaitChannel(*link, machine::ChannelStatus::Reset);
    const auto trace = link->fetchTrace();
    QVERIFY(trace.has_value());
    QCOMPARE(trace->blocks.size(), std::size_t{1});
    using Kind = trace::ControlEvent::Kind;
    std::vector<Kind> kinds;
    for (const trace::ControlEvent& event : trace->events) {
      kinds.push_back(event.kind);
    }
    QVERIFY((kinds == std::vector<Kind>{Kind::Spindle, Kind::Stop, Kind::Spindle}));
    QCOMPARE(trace->events.front().value, 1000.0);
  }

  /// While the program runs, piece by piece, without waiting for an answer.
  void theTraceIsReadWhileTheProgramRuns() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->uploadProgram("SQUARE.MPF", kSquare, false));
    QVERIFY(link->selectProgram("SQUARE.MPF"));
    QVERIFY(link->cycleStart());
    trace::ControlTrace all;
    trace::TracePosition position;
    std::size_t pieces = 0;
    const auto take = [&](const trace::TracePiece& piece) {
      all.cycle = piece.records.cycle;
      all.truncated = all.truncated || piece.records.truncated;
      all.samples.insert(all.samples.end(), piece.records.samples.begin(),
                         piece.records.samples.end());
      all.blocks.insert(all.blocks.end(), piece.records.blocks.begin(), piece.records.blocks.end());
      all.events.insert(all.events.end(), piece.records.events.begin(), piece.records.events.end());
      pieces += piece.records.samples.empty() ? 0 : 1;
      position = piece.next;
    };
    while (readOne(*link, {VariableKind::ChannelStatus, 0}).number != 0.0) {
      const base::RequestId id = link->readTrace(position, kPatience);
      QVERIFY(id != base::RequestId{});
      const auto event = link->wait(link->now() + kPatience);
      QVERIFY(event && event->kind == opcua::EventKind::TraceDone && event->request == id);
      take(*event->trace);
    }
    QVERIFY(pieces > 2);
    for (bool isLast = false; !isLast;) {
      const auto piece = link->fetchTracePiece(position);
      QVERIFY(piece.has_value());
      take(*piece);
      isLast = piece->isLast;
    }
    const auto whole = link->fetchTrace();
    QVERIFY(whole.has_value());
    QVERIFY(trace::printControlTrace(all) == trace::printControlTrace(*whole));
  }

  /// Longer than one answer of the server.
  void aLongTraceIsFetchedInParts() {
    LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->uploadProgram("LONG.MPF", "G1 X1 F6000\nG4 F1000\nM30\n", false));
    QVERIFY(link->selectProgram("LONG.MPF"));
    cell.stop();
    machine::Machine& machine = cell.machineAfterStop();
    QVERIFY(machine.cycleStart());
    machine.advance(machine.now() + 210s);  // in no time; recorded from the first motion on

    auto server = machine::Server::start(machine, {});
    QVERIFY(server.has_value());
    std::atomic<bool> stop{false};
    std::thread thread([&] { (*server)->run(stop); });
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = (*server)->endpoint();
    options.commandDeadline = kPatience;
    const auto again = tests::openChosen(options);
    QVERIFY(again.has_value());
    const auto trace = (*again)->fetchTrace();
    stop.store(true);
    thread.join();
    QVERIFY(trace.has_value());
    QVERIFY(trace::printControlTrace(*trace).size() > (std::size_t{1} << 20U));
    QVERIFY(trace->samples.size() >= 50'000);  // 200 s in cycles of 4 ms
  }

  void onlyAChannelInResetTakesAProgram() {
    const LoopbackMachine cell;
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->uploadProgram("WAIT.MPF", kWaiting, false));
    QVERIFY(link->uploadProgram("SQUARE.MPF", kSquare, false));
    QVERIFY(link->selectProgram("WAIT.MPF"));
    QVERIFY(link->cycleStart());
    awaitChannel(*link, machine::ChannelStatus::Active);
    QVERIFY(codeOf(link->selectProgram("SQUARE.MPF")) == LinkError::ChannelNotInReset);
    QVERIFY(codeOf(link->cycleStart()) == LinkError::ChannelNotInReset);
    QVERIFY(link->reset());
    awaitChannel(*link, machine::ChannelStatus::Reset);
    QVERIFY(link->selectProgram("SQUARE.MPF"));
  }

  /// The handshake of every streaming method in small: the program waits for a cell.
  void aWrittenCellLetsTheProgramGoOn() {
    const LoopbackMachine cell({"dmu75"});
    const auto link = tests::connectChosen(cell);
    QVERIFY(link->uploadProgram("WAIT.MPF", kWaiting, false));
    QVERIFY(link->selectProgram("WAIT.MPF"));
    QVERIFY(link->cycleStart());
    awaitChannel(*link, machine::ChannelStatus::Active);
    link->write(std::vector<opcua::Assignment>{{opcua::rParameter(1), 1.0}}, kPatience,
                opcua::Grouping::List);
    const auto written = link->wait(link->now() + kPatience);
    QVERIFY(written && written->kind == opcua::EventKind::WriteDone);
    awaitChannel(*link, machine::ChannelStatus::Reset);
  }

  /// Reset must work while a stream's requests are in progress, and must not lose their answers.
  void aCommandKeepsTheEventsOfTheStream() {
    const LoopbackMachine cell({"dmu75"});
    const auto link = tests::connectChosen(cell);
    const auto first =
        link->read(std::vector{opcua::rParameter(1)}, kPatience, opcua::Grouping::List);
    const auto second =
        link->read(std::vector(3, opcua::rParameter(1)), kPatience, opcua::Grouping::Single);
    QVERIFY(link->reset());
    for (const base::RequestId id : {first, second}) {
      const auto event = link->wait(link->now() + kPatience);
      QVERIFY(event && event->kind == opcua::EventKind::ReadDone);
      QVERIFY(event->request == id);
    }
  }
};

RIVULET_TEST(TestUaControl)
#include "tst_ua_control.moc"
