// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <map>
#include <string>
#include <vector>

#include "opcua/error.h"
#include "opcua/machinery.h"
#include "opcua/node_browser.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::opcua;

namespace {

const std::string kCore = "http://opcfoundation.org/UA/";
const std::string kDi = "http://opcfoundation.org/UA/DI/";
const std::string kMachinery = "http://opcfoundation.org/UA/Machinery/";
const std::string kTool = "http://opcfoundation.org/UA/MachineTool/";
const std::string kMachines = "nsu=http://opcfoundation.org/UA/Machinery/;i=1001";

/// A server in memory. A node's address is its path below the folder of machines.
class Scene final : public NodeBrowser {
 public:
  Scene& object(const std::string& parent, const std::string& uri, const std::string& name) {
    return add(parent, uri, name, NodeKind::Object, {});
  }
  Scene& text(const std::string& parent, const std::string& uri, const std::string& name,
              const std::string& value) {
    NodeFacts facts;
    facts.isText = true;
    facts.value = value;
    return add(parent, uri, name, NodeKind::Variable, facts);
  }
  Scene& number(const std::string& parent, const std::string& uri, const std::string& name,
                const std::string& value) {
    NodeFacts facts;
    facts.isNumber = true;
    facts.value = value;
    return add(parent, uri, name, NodeKind::Variable, facts);
  }
  Scene& flag(const std::string& parent, const std::string& uri, const std::string& name,
              bool value) {
    NodeFacts facts;
    facts.isBoolean = true;
    facts.value = value ? "1" : "0";
    return add(parent, uri, name, NodeKind::Variable, facts);
  }
  void refuse(const std::string& address, LinkError error) { m_refused[address] = error; }

  base::Result<std::vector<BrowsedNode>> children(const std::string& address) override {
    ++requests;
    if (const auto refused = m_refused.find(address); refused != m_refused.end()) {
      return base::fail(refused->second, "No.");
    }
    if (address == kMachines && m_children.count(kMachines) == 0) {
      return base::fail(LinkError::VariableMissing, "The server has no such node.");
    }
    return m_children[address];
  }
  base::Result<std::vector<NodeFacts>> examine(std::span<const std::string> ids) override {
    ++requests;
    std::vector<NodeFacts> facts;
    for (const std::string& id : ids) {
      facts.push_back(m_facts[id]);
    }
    return facts;
  }

  int requests = 0;

 private:
  Scene& add(const std::string& parent, const std::string& uri, const std::string& name,
             NodeKind kind, const NodeFacts& facts) {
    const std::string folder = parent.empty() ? kMachines : parent;
    const std::string address = parent.empty() ? name : parent + "/" + name;
    m_children[folder].push_back({address, 1, name, kind, uri});
    m_facts[address] = facts;
    return *this;
  }

  std::map<std::string, std::vector<BrowsedNode>> m_children;
  std::map<std::string, NodeFacts> m_facts;
  std::map<std::string, LinkError> m_refused;
};

void addIdentification(Scene& scene, const std::string& machine) {
  const std::string at = machine + "/Identification";
  scene.object("", kTool, machine)
      .object(machine, kDi, "Identification")
      .text(at, kDi, "Manufacturer", "Somebody")
      .text(at, kDi, "Model", "M 1")
      .text(at, kDi, "SerialNumber", "0815")
      .number(at, kMachinery, "YearOfConstruction", "2021");
}

void addJob(Scene& scene, const std::string& name, const std::string& identifier,
            const char* done) {
  const std::string plan = "Mill/Production/ProductionPlan";
  const std::string job = plan + "/" + name;
  scene.object(plan, kTool, name)
      .text(job, kTool, "Identifier", identifier)
      .number(job, kTool, "RunsCompleted", done)
      .number(job, kTool, "RunsPlanned", "40")
      .object(job, kTool, "State")
      .text(job + "/State", kCore, "CurrentState", "Running");
}

void addProduction(Scene& scene) {
  scene.object("Mill", kTool, "Production")
      .object("Mill/Production", kTool, "ActiveProgram")
      .text("Mill/Production/ActiveProgram", kTool, "Name", "PART.MPF")
      .text("Mill/Production/ActiveProgram", kTool, "JobIdentifier", "J 2")
      .object("Mill/Production/ActiveProgram", kTool, "State")
      .text("Mill/Production/ActiveProgram/State", kCore, "CurrentState", "Interrupted")
      .object("Mill/Production", kTool, "ProductionPlan");
  addJob(scene, "First", "J 1", "40");
  addJob(scene, "Second", "J 2", "12");
}

DescribedMachine only(Scene& scene) {
  const auto machines = readMachines(scene);
  return machines && machines->size() == 1 ? machines->front() : DescribedMachine();
}

}  // namespace

class TestMachinery : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aServerWithoutMachinesIsAskedOnce() {
    Scene scene;
    const auto machines = readMachines(scene);
    QVERIFY(machines && machines->empty());
    QCOMPARE(scene.requests, 1);
  }

  void identification() {
    Scene scene;
    addIdentification(scene, "Mill");
    DescribedMachine expected;
    expected.name = "Mill";
    expected.manufacturer = "Somebody";
    expected.model = "M 1";
    expected.serialNumber = "0815";
    expected.yearOfConstruction = "2021";
    QVERIFY(only(scene) == expected);
  }

  /// A browse name counts with its namespace only.
  void namesOfOthersAreNotMistaken() {
    Scene scene;
    scene.object("", kTool, "Mill").object("Mill", "urn:other", "Identification");
    const auto machines = readMachines(scene);
    QVERIFY(machines && machines->empty());
    Scene second;
    addIdentification(second, "Mill");
    second.object("Mill", "urn:other", "MachineryBuildingBlocks")
        .object("Mill/MachineryBuildingBlocks", kMachinery, "MachineryItemState")
        .text("Mill/MachineryBuildingBlocks/MachineryItemState", kCore, "CurrentState", "Wrong");
    QVERIFY(only(second).state.empty());
  }

  void statesOfTheBuildingBlocks() {
    Scene scene;
    addIdentification(scene, "Mill");
    const std::string blocks = "Mill/MachineryBuildingBlocks";
    scene.object("Mill", kMachinery, "MachineryBuildingBlocks")
        .object(blocks, kMachinery, "MachineryItemState")
        .text(blocks + "/MachineryItemState", kCore, "CurrentState", "Executing")
        .object(blocks, kMachinery, "MachineryOperationMode")
        .text(blocks + "/MachineryOperationMode", kCore, "CurrentState", "Processing");
    QCOMPARE(only(scene).state, std::string("Executing"));
    QCOMPARE(only(scene).operationMode, std::string("Processing"));
  }

  void statesOfAMachineTool() {
    Scene scene;
    addIdentification(scene, "Mill");
    const std::string at = "Mill/Monitoring/MachineTool";
    scene.object("Mill", kTool, "Monitoring")
        .object("Mill/Monitoring", kTool, "MachineTool")
        .number(at, kTool, "OperationMode", "1");
    QCOMPARE(only(scene).operationMode, std::string("Automatic"));
    // The state machine of newer versions comes first.
    scene.object(at, kMachinery, "MachineryOperationMode")
        .text(at + "/MachineryOperationMode", kCore, "CurrentState", "Setup")
        .object(at, kMachinery, "MachineryItemState")
        .text(at + "/MachineryItemState", kCore, "CurrentState", "NotExecuting");
    QCOMPARE(only(scene).operationMode, std::string("Setup"));
    QCOMPARE(only(scene).state, std::string("NotExecuting"));
  }

  void theJobOfTheActiveProgram() {
    Scene scene;
    addIdentification(scene, "Mill");
    addProduction(scene);
    const DescribedMachine machine = only(scene);
    QCOMPARE(machine.program, std::string("PART.MPF"));
    QCOMPARE(machine.programState, std::string("Interrupted"));
    QCOMPARE(machine.job, std::string("J 2"));
    QCOMPARE(machine.jobState, std::string("Running"));
    QVERIFY(machine.runsCompleted == 12 && machine.runsPlanned == 40);
    QVERIFY2(scene.requests <= 25, qPrintable(QString::number(scene.requests)));
  }

  /// Runs are planned for good if the number says that it is not valid.
  void runsWithoutAnEnd() {
    Scene scene;
    addIdentification(scene, "Mill");
    addProduction(scene);
    const std::string planned = "Mill/Production/ProductionPlan/Second/RunsPlanned";
    scene.flag(planned, kTool, "IsValid", false);
    QVERIFY(only(scene).runsCompleted == 12 && !only(scene).runsPlanned);
  }

  void whatMayNotBeReadIsLeftOut() {
    Scene scene;
    addIdentification(scene, "Mill");
    addProduction(scene);
    scene.refuse("Mill/Production", LinkError::Rejected);
    const DescribedMachine machine = only(scene);
    QCOMPARE(machine.model, std::string("M 1"));
    QVERIFY(machine.program.empty() && machine.job.empty());
  }

  void aLostConnectionIsToldSo() {
    Scene scene;
    addIdentification(scene, "Mill");
    scene.refuse("Mill/Identification", LinkError::ConnectionLost);
    const auto machines = readMachines(scene);
    QVERIFY(!machines && machines.error().code == LinkError::ConnectionLost);
  }
};

RIVULET_TEST(TestMachinery)
#include "tst_machinery.moc"
