// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A control as node-opcua would serve it: a server of that library whose variables and methods are
// those of a rivulet-machine behind it, which it reaches with the client of that library. So every
// value and every call passes both of its halves. Namespaces have other indices than on the
// machine, and there are no array nodes.
//
// usage: node node_opcua_front.js PLAN.json
// PLAN: {"upstream": "opc.tcp://…", "folder": "…", "variables": ["/Channel/…", …],
//        "user": "…", "password": "…"}
// With "namespace" it is no SINUMERIK: that is the namespace of its variables, and these are objects:
//        {"of": "/Channel/…", "id": "i=5001", "name": "Cell_1", "folder": "Cells"}; "scale": by what
//        a number is multiplied, "texts": what the numbers from 0 are shown as. "methods" has such
//        rows, too, and "methods_object" the object they belong to.
// prints one line of JSON when it listens, among what the library says: {"endpoint": "…", "fingerprint": "…"}

"use strict";

const crypto = require("crypto");
const fs = require("fs");
const net = require("net");
const opcua = require("node-opcua");

const plan = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
const { AttributeIds } = opcua;
const ITEMS_MAX = 500;

/// Items that arrive in the same turn go upstream in one request, in their order.
class Batch {
  constructor(send) {
    this.send = send;
    this.waiting = [];
  }
  add(item) {
    return new Promise((done, failed) => {
      if (this.waiting.length === 0) {
        setImmediate(() => this.flush());
      }
      this.waiting.push({ item, done, failed });
    });
  }
  async flush() {
    const sent = this.waiting;
    this.waiting = [];
    try {
      const answers = await this.send(sent.map((one) => one.item));
      sent.forEach((one, i) => one.done(answers[i]));
    } catch (error) {
      sent.forEach((one) => one.failed(error));
    }
  }
}

function freePort() {
  return new Promise((done) => {
    const probe = net.createServer().listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

async function connectUpstream() {
  const client = opcua.OPCUAClient.create({
    endpointMustExist: false,
    connectionStrategy: { maxRetry: 0 },
    clientCertificateManager: new opcua.OPCUACertificateManager({
      rootFolder: `${plan.folder}/client`,
    }),
  });
  await client.connect(plan.upstream);
  const session = await client.createSession();
  session.on("session_closed", () => process.exit(1));
  client.on("close", () => process.exit(1));
  return session;
}

/// In requests as large as a control takes.
async function readAll(session, nodes, attributeId) {
  const values = [];
  for (let first = 0; first < nodes.length; first += ITEMS_MAX) {
    const some = nodes.slice(first, first + ITEMS_MAX);
    values.push(...(await session.read(some.map((nodeId) => ({ nodeId, attributeId })))));
  }
  return values;
}

/// A row of the plan; the names of a SINUMERIK stand for themselves.
function rowOf(entry) {
  return typeof entry === "string" ? { of: entry, id: `s=${entry}`, name: entry } : entry;
}

/// A value as this server shows it.
function shown(row, value) {
  if (!value.statusCode.isGood() || (!row.scale && !row.texts)) {
    return value;
  }
  const number = Number(value.value.value);
  return new opcua.DataValue({
    sourceTimestamp: value.sourceTimestamp,
    value: row.texts
      ? { dataType: opcua.DataType.String, value: row.texts[number] ?? `state ${number}` }
      : { dataType: opcua.DataType.Double, value: number * row.scale },
  });
}

async function addVariables(session, space, upstreamIndex, parent, entries) {
  const rows = entries.map(rowOf);
  const nodes = rows.map((row) => `ns=${upstreamIndex};s=${row.of}`);
  const folders = new Map();
  const folderOf = (name) => {
    if (!name) {
      return parent;
    }
    if (!folders.has(name)) {
      folders.set(name, space.addObject({ organizedBy: parent, browseName: name }));
    }
    return folders.get(name);
  };
  const reads = new Batch((ids) =>
    session.read(ids.map((nodeId) => ({ nodeId, attributeId: AttributeIds.Value })))
  );
  const writes = new Batch((items) => session.write(items));
  const types = await readAll(session, nodes, AttributeIds.DataType);
  const levels = await readAll(session, nodes, AttributeIds.AccessLevel);
  rows.forEach((row, i) => {
    if (!types[i].statusCode.isGood()) {
      return; // this machine does not have it
    }
    const isWritable = (levels[i].value.value & opcua.AccessLevelFlag.CurrentWrite) !== 0;
    space.addVariable({
      componentOf: folderOf(row.folder),
      nodeId: row.id,
      browseName: row.name,
      dataType: row.texts ? "String" : row.scale ? "Double" : types[i].value.value,
      minimumSamplingInterval: 100,
      accessLevel: isWritable ? "CurrentRead | CurrentWrite" : "CurrentRead",
      userAccessLevel: isWritable ? "CurrentRead | CurrentWrite" : "CurrentRead",
      value: {
        timestamped_get: () => reads.add(nodes[i]).then((value) => shown(row, value)),
        timestamped_set: isWritable
          ? (value) =>
              writes.add({
                nodeId: nodes[i],
                attributeId: AttributeIds.Value,
                value: { value: value.value },
              })
          : undefined,
      },
    });
  });
}

/// @param names  rows of the methods that are shown, and of the object; without them all, as they are
async function addMethods(session, space, upstreamIndex, identifier, parent, names) {
  const objectId = `ns=${upstreamIndex};s=${identifier}`;
  const own = names ? names.object : rowOf(identifier);
  const object = space.addObject({
    organizedBy: parent,
    nodeId: own.id,
    browseName: own.name,
  });
  const found = await session.browse({
    nodeId: objectId,
    referenceTypeId: "HierarchicalReferences",
    browseDirection: opcua.BrowseDirection.Forward,
    includeSubtypes: true,
    nodeClassMask: opcua.NodeClass.Method,
    resultMask: 63,
  });
  for (const { nodeId, browseName } of found.references) {
    const row = names
      ? names.methods.find((one) => one.of === browseName.name)
      : { id: `s=${nodeId.value}`, name: browseName.name };
    if (!row) {
      continue;
    }
    const signature = await session.getArgumentDefinition(nodeId);
    const bare = (list) =>
      list.map((one) => ({ name: one.name, dataType: one.dataType, valueRank: one.valueRank }));
    const method = space.addMethod(object, {
      nodeId: row.id,
      browseName: row.name,
      inputArguments: bare(signature.inputArguments),
      outputArguments: bare(signature.outputArguments),
    });
    method.bindMethod((inputArguments, context, callback) => {
      session.call({ objectId, methodId: nodeId, inputArguments }).then(
        ({ statusCode, outputArguments }) => callback(null, { statusCode, outputArguments }),
        callback
      );
    });
  }
  return object;
}

async function main() {
  const session = await connectUpstream();
  const uris = await session.readNamespaceArray();
  const control = "SinumerikVarProvider";
  const virtual = "urn:rivulet:virtual-machine";
  const port = await freePort();
  const server = new opcua.OPCUAServer({
    host: "127.0.0.1",
    hostname: "127.0.0.1",
    port,
    resourcePath: "",
    securityPolicies: [opcua.SecurityPolicy.None, opcua.SecurityPolicy.Basic256Sha256],
    securityModes: [
      opcua.MessageSecurityMode.None,
      opcua.MessageSecurityMode.Sign,
      opcua.MessageSecurityMode.SignAndEncrypt,
    ],
    allowAnonymous: true,
    userManager: {
      isValidUser: (user, password) => user === plan.user && password === plan.password,
    },
    serverCertificateManager: new opcua.OPCUACertificateManager({
      automaticallyAcceptUnknownCertificate: true,
      rootFolder: `${plan.folder}/server`,
    }),
    buildInfo: { productName: "node-opcua front", softwareVersion: "1", buildNumber: "1" },
  });
  await server.initialize();
  const { addressSpace } = server.engine;
  // The other way round than on the machine, behind one that is nobody's.
  addressSpace.registerNamespace("urn:nobody");
  const virtualSpace = addressSpace.registerNamespace(virtual);
  const controlSpace = addressSpace.registerNamespace(plan.namespace ?? control);
  const root = addressSpace.rootFolder.objects;
  const sinumerik = controlSpace.addObject({
    organizedBy: root,
    nodeId: "s=Sinumerik",
    browseName: plan.namespace ? "Machine" : "Sinumerik",
  });
  const controlIndex = uris.indexOf(control);
  await addVariables(session, controlSpace, controlIndex, sinumerik, plan.variables);
  const names = plan.methods && { object: plan.methods_object, methods: plan.methods };
  await addMethods(session, controlSpace, controlIndex, "/Methods", sinumerik, names);
  await addMethods(session, virtualSpace, uris.indexOf(virtual), "VirtualMachine", root);
  await server.start();
  const der = server.getCertificate();
  const fingerprint = crypto.createHash("sha256").update(der).digest("hex");
  console.log(JSON.stringify({ endpoint: `opc.tcp://127.0.0.1:${port}`, fingerprint }));
  process.on("SIGTERM", () => process.exit(0));
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
