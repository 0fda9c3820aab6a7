// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A machine tool by OPC 40501-1 and OPC 40001-1: a server of node-opcua with the types of the OPC
// Foundation, which come with that library, and one instance of MachineToolType. It has no cells.
//
// usage: node node_opcua_machine_tool.js FOLDER
// FOLDER is for the certificates
// prints one line of JSON when it listens, among what the library says: {"endpoint": "…"}

"use strict";

const net = require("net");
const opcua = require("node-opcua");

const folder = process.argv[2];
const { nodesets } = opcua;

function freePort() {
  return new Promise((done) => {
    const probe = net.createServer().listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

/// A value below a node, by browse names.
function set(node, path, dataType, value) {
  const variable = path.split("/").reduce((at, name) => at && at.getChildByName(name), node);
  if (!variable) {
    throw new Error(`${node.browseName.name} has no ${path}`);
  }
  variable.setValueFromSource({ dataType, value });
}
const { String: text, LocalizedText: shown, UInt16, UInt32, Boolean: flag } = opcua.DataType;

function addMachine(space) {
  const tools = space.getNamespaceIndex("http://opcfoundation.org/UA/MachineTool/");
  const machinery = space.getNamespaceIndex("http://opcfoundation.org/UA/Machinery/");
  const machine = space.findObjectType("MachineToolType", tools).instantiate({
    browseName: "Mill 7",
    organizedBy: space.findNode(`ns=${machinery};i=1001`),
    optionals: [
      "Identification.Model",
      "Identification.SoftwareRevision",
      "Identification.YearOfConstruction",
      "Identification.Location",
      "Monitoring.MachineTool.MachineryItemState",
      "Monitoring.MachineTool.MachineryOperationMode",
      "Production.ProductionPlan",
      "Production.ActiveProgram.JobIdentifier",
    ],
  });
  set(machine, "Identification/Manufacturer", shown, { text: "Example Machines" });
  set(machine, "Identification/Model", shown, { text: "EM 500" });
  set(machine, "Identification/SerialNumber", text, "4711");
  set(machine, "Identification/ProductInstanceUri", text, "urn:example:em500:4711");
  set(machine, "Identification/SoftwareRevision", text, "8.15");
  set(machine, "Identification/YearOfConstruction", UInt16, 2021);
  set(machine, "Identification/Location", text, "Hall 3");
  const monitored = "Monitoring/MachineTool";
  set(machine, `${monitored}/MachineryItemState/CurrentState`, shown, { text: "Executing" });
  set(machine, `${monitored}/MachineryOperationMode/CurrentState`, shown, { text: "Processing" });
  const active = "Production/ActiveProgram";
  set(machine, `${active}/Name`, text, "FLANGE.MPF");
  set(machine, `${active}/JobIdentifier`, text, "Order 12");
  set(machine, `${active}/State/CurrentState`, shown, { text: "Running" });

  const jobType = space.findObjectType("ProductionJobType", tools);
  const plan = machine.getChildByName("Production").getChildByName("ProductionPlan");
  for (const [identifier, completed, planned] of [
    ["Order 11", 20, 20],
    ["Order 12", 3, 8],
  ]) {
    const job = jobType.instantiate({ browseName: identifier, componentOf: plan });
    set(job, "Identifier", text, identifier);
    set(job, "State/CurrentState", shown, { text: completed < planned ? "Running" : "Ended" });
    set(job, "RunsCompleted", UInt32, completed);
    set(job, "RunsPlanned", UInt32, planned);
    set(job, "RunsPlanned/IsValid", flag, true);
  }
}

async function main() {
  const port = await freePort();
  const server = new opcua.OPCUAServer({
    port,
    hostname: "127.0.0.1",
    allowAnonymous: true,
    securityPolicies: [opcua.SecurityPolicy.None],
    securityModes: [opcua.MessageSecurityMode.None],
    serverCertificateManager: new opcua.OPCUACertificateManager({ rootFolder: `${folder}/server` }),
    userCertificateManager: new opcua.OPCUACertificateManager({ rootFolder: `${folder}/users` }),
    nodeset_filename: [
      nodesets.standard,
      nodesets.di,
      nodesets.ia,
      nodesets.machinery,
      nodesets.isa95JobControl,
      nodesets.machineryJobs,
      nodesets.machineTool,
    ],
  });
  await server.initialize();
  addMachine(server.engine.addressSpace);
  await server.start();
  process.stdout.write(`${JSON.stringify({ endpoint: `opc.tcp://127.0.0.1:${port}` })}\n`);
}

main().catch((error) => {
  console.error(`node_opcua_machine_tool: ${error.stack}`);
  process.exit(1);
});
