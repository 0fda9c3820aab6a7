// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What comes of each combination of rights a control may have given.

#include <QtTest>
#include <map>

#include "streaming/run/run.h"
#include "streaming/start/program_transfer.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::LinkError;
using streaming::ProgramTransfer;
using streaming::StreamError;
using streaming::TransferWay;

namespace {

const std::string kName = "A.MPF";
const std::string kText = "G1 X=R11\nM30\n";

/// A control that lets do what the test wants.
class ScriptedControl final : public opcua::Control {
 public:
  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool /*overwrite*/) override {
    if (writeError) {
      return base::fail(*writeError, "no");
    }
    if (isFalsified()) {
      files[name] = "G1 X=R1";
      return {};
    }
    files[name] = text + changedBehind;
    return {};
  }
  base::Result<std::string> downloadProgram(const std::string& name) override {
    if (isFalsified()) {
      return base::fail(LinkError::Rejected, "no");
    }
    if (readError) {
      return base::fail(*readError, "no");
    }
    if (files.count(name) == 0) {
      return base::fail(LinkError::ProgramMissing, "none");
    }
    return files[name];
  }
  base::Result<void> selectProgram(const std::string& name) override {
    if (isFalsified()) {
      return base::fail(LinkError::ProgramMissing, "none");
    }
    if (selectError) {
      return base::fail(*selectError, "no");
    }
    selected = name;
    return {};
  }
  [[nodiscard]] bool isVirtualMachine() const override { return false; }
  [[nodiscard]] opcua::Abilities abilities() const override { return {}; }
  base::Result<void> cycleStart() override { return base::fail(LinkError::MethodMissing, "no"); }
  base::Result<void> reset() override { return base::fail(LinkError::MethodMissing, "no"); }
  base::Result<trace::ControlTrace> fetchTrace() override {
    return base::fail(LinkError::MethodMissing, "no");
  }

  /// Whether this call is the one that is falsified on its way.
  bool isFalsified() { return calls++ == falsifiedCall; }

  int calls = 0;
  int falsifiedCall = -1;
  std::map<std::string, std::string> files;
  std::string changedBehind;
  std::string selected;
  std::optional<LinkError> writeError;
  std::optional<LinkError> readError;
  std::optional<LinkError> selectError;
};

}  // namespace

class TestProgramTransfer : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// One bit on the way takes no rights away.
  void aFalsifiedCallIsMadeAgain() {
    for (const int call : {0, 1, 2}) {
      ScriptedControl control;
      control.falsifiedCall = call;
      const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
      QVERIFY2(transfer && *transfer == (ProgramTransfer{true, true, true}),
               transfer ? "" : transfer.error().text().c_str());
      QCOMPARE(control.files[kName], kText);
      QVERIFY(control.calls > 3);
    }
  }

  void withAllRights() {
    ScriptedControl control;
    control.files[kName] = "an older one";
    const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(transfer && *transfer == (ProgramTransfer{true, true, true}));
    QCOMPARE(control.files[kName], kText);
    QCOMPARE(control.selected, kName);
  }

  /// A control that stores line ends of its own has the same program.
  void lineEndsOfTheControlAreItsOwn() {
    ScriptedControl control;
    control.files[kName] = "G1 X=R11\r\nM30\r\n";
    control.writeError = LinkError::Rejected;
    const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(transfer && transfer->compared);
    control.files[kName] = "G1 X=R12\r\nM30\r\n";
    QVERIFY(!transferProgram(control, kName, kText, TransferWay::Link));
  }

  void aPersonSelectsWhereWeMayNot() {
    ScriptedControl control;
    control.selectError = LinkError::MethodMissing;
    const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(transfer && *transfer == (ProgramTransfer{true, true, false}));
  }

  void whatIsThereAlreadyNeedsNoRightToWrite() {
    ScriptedControl control;
    control.files[kName] = kText;
    control.writeError = LinkError::Rejected;
    const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(transfer && *transfer == (ProgramTransfer{false, true, true}));
  }

  void withoutRightsItIsRefused_data() {
    QTest::addColumn<int>("write");
    QTest::addColumn<int>("read");
    const auto add = [](const char* name, std::optional<LinkError> write,
                        std::optional<LinkError> read) {
      QTest::newRow(name) << (write ? static_cast<int>(*write) : 0)
                          << (read ? static_cast<int>(*read) : 0);
    };
    add("no write, nothing there", LinkError::Rejected, LinkError::ProgramMissing);
    add("no write, no read", LinkError::Rejected, LinkError::Rejected);
    add("no methods", LinkError::MethodMissing, LinkError::MethodMissing);
    add("written, not to be read", std::nullopt, LinkError::NotWritable);
  }

  void withoutRightsItIsRefused() {
    QFETCH(int, write);
    QFETCH(int, read);
    ScriptedControl control;
    const auto error = [](int code) {
      return code == 0 ? std::nullopt : std::optional(static_cast<LinkError>(code));
    };
    control.writeError = error(write);
    control.readError = error(read);
    const auto transfer = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(!transfer);
    QVERIFY(transfer.error().code == StreamError::TransferRefused);
    QVERIFY(control.selected.empty());
  }

  void anotherProgramIsNeverStarted() {
    ScriptedControl changing;
    changing.changedBehind = "\n";
    const auto changed = transferProgram(changing, kName, kText, TransferWay::Link);
    QVERIFY(!changed && changed.error().code == StreamError::WrongProgram);
    QVERIFY(changing.selected.empty());

    ScriptedControl other;
    other.files[kName] = "G0 X0\nM30\n";
    const auto byHand = transferProgram(other, kName, kText, TransferWay::ByHand);
    QVERIFY(!byHand && byHand.error().code == StreamError::WrongProgram);
  }

  void whatIsNoMatterOfRightsIsToldAsItIs() {
    ScriptedControl control;
    control.writeError = LinkError::ConnectionLost;
    control.files[kName] = kText;
    const auto lost = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(!lost && lost.error().code == LinkError::ConnectionLost);
    control.writeError.reset();
    control.selectError = LinkError::ChannelNotInReset;
    const auto busy = transferProgram(control, kName, kText, TransferWay::Link);
    QVERIFY(!busy && busy.error().code == LinkError::ChannelNotInReset);
  }

  void byHandNothingIsWritten() {
    ScriptedControl control;
    control.readError = LinkError::Rejected;
    const auto unread = transferProgram(control, kName, kText, TransferWay::ByHand);
    QVERIFY(unread && *unread == (ProgramTransfer{false, false, false}));
    control.readError.reset();
    // The person has not come so far yet: that is no fault.
    const auto missing = transferProgram(control, kName, kText, TransferWay::ByHand);
    QVERIFY(missing && *missing == (ProgramTransfer{false, false, false}));
    control.files[kName] = kText;
    const auto there = transferProgram(control, kName, kText, TransferWay::ByHand);
    QVERIFY(there && *there == (ProgramTransfer{false, true, false}));
    QVERIFY(control.selected.empty());
  }
};

RIVULET_TEST(TestProgramTransfer)
#include "tst_program_transfer.moc"
