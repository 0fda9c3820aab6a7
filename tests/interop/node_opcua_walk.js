// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A client of node-opcua that looks at a rivulet-machine as a stranger does: it browses everything
// from Objects, follows the X axis through a program, asks for history, and goes one step beyond
// every limit that the server states. It judges nothing.
//
// usage: node node_opcua_walk.js ENDPOINT
// prints one line of JSON at the end: {"nodes": […], "limits": {…}, "positions": […], …}

"use strict";

const opcua = require("node-opcua");

const { AttributeIds } = opcua;
const PROGRAM = "G0 X0 Y0 Z50\nG1 X20 F1200\nM30\n";

/// What the library says goes to standard error; the last line of standard output is the result.
console.log = console.error;

/// Name of the status of a service or of one of its results; "Good" if it throws nothing.
async function statusOf(call) {
  try {
    const result = await call();
    const one = Array.isArray(result) ? result[result.length - 1] : result;
    const status = one && (one.statusCode || one);
    return status && status.name ? status.name : "Good";
  } catch (error) {
    const named = /\b(Bad[A-Za-z]+)\b/.exec(error.message);
    return named ? named[1] : error.message;
  }
}

const many = (count, one) => Array.from({ length: count }, () => one);

async function browse(session, start) {
  const found = [];
  const seen = new Set([start]);
  for (let front = [start]; front.length > 0; ) {
    const part = front.splice(0, 100);
    const results = await session.browse(
      part.map((nodeId) => ({
        nodeId,
        referenceTypeId: "HierarchicalReferences",
        includeSubtypes: true,
        browseDirection: opcua.BrowseDirection.Forward,
        resultMask: 63,
      })),
    );
    for (const [i, result] of results.entries()) {
      let { references, continuationPoint } = result;
      while (continuationPoint && continuationPoint.length > 0) {
        const more = await session.browseNext(continuationPoint, false);
        references = references.concat(more.references);
        ({ continuationPoint } = more);
      }
      for (const one of references || []) {
        const id = one.nodeId.toString();
        if (!seen.has(id)) {
          seen.add(id);
          front.push(id);
          found.push({
            id,
            parent: part[i],
            nodeClass: opcua.NodeClass[one.nodeClass],
            name: one.browseName.name,
            type: one.typeDefinition.toString(),
          });
        }
      }
    }
  }
  return found;
}

async function typeOf(session, nodeId) {
  const { references } = await session.browse({
    nodeId,
    referenceTypeId: "HasTypeDefinition",
    browseDirection: opcua.BrowseDirection.Forward,
    resultMask: 63,
  });
  return references.length > 0 ? references[0].nodeId.toString() : "";
}

/// The attributes of nodes, into them.
async function readAttributes(session, nodes) {
  const wanted = ["Description", "DataType", "ValueRank", "AccessLevel", "Historizing", "Value"];
  for (let from = 0; from < nodes.length; from += 100) {
    const part = nodes.slice(from, from + 100);
    const values = await session.read(
      part.flatMap(({ id }) =>
        wanted.map((name) => ({ nodeId: id, attributeId: AttributeIds[name] })),
      ),
    );
    for (const [i, node] of part.entries()) {
      const [description, dataType, rank, access, historizing, value] = values.slice(
        i * wanted.length,
        (i + 1) * wanted.length,
      );
      node.description = (description.value.value && description.value.value.text) || "";
      if (node.nodeClass === "Variable") {
        node.dataType = dataType.value.value.toString();
        node.rank = rank.value.value;
        node.access = access.value.value;
        node.historizing = historizing.value.value;
        node.status = value.statusCode.name;
        const content = value.value && value.value.value;
        if (content && content.constructor.name === "EUInformation") {
          const known = Object.values(opcua.standardUnits).find(
            (unit) => unit.unitId === content.unitId,
          );
          node.unit = {
            number: content.unitId,
            symbol: content.displayName.text,
            name: content.description.text,
            known: known ? [known.displayName.text, known.description.text] : [],
          };
        } else if (content && content.constructor.name === "Range") {
          node.range = [content.low, content.high];
        }
      }
    }
  }
}

async function follow(session, names, axis) {
  const subscription = await session.createSubscription2({
    requestedPublishingInterval: 1,
    requestedLifetimeCount: 1000,
    requestedMaxKeepAliveCount: 10,
    publishingEnabled: true,
  });
  const item = await subscription.monitor(
    { nodeId: axis, attributeId: AttributeIds.Value },
    { samplingInterval: 1, queueSize: 1_000_000, discardOldest: true },
    opcua.TimestampsToReturn.Both,
  );
  const seen = [];
  const arrived = new Promise((done) => {
    item.on("changed", (value) => {
      seen.push(value.value.value);
      if (value.value.value > 19.99) {
        done();
      }
    });
  });
  const call = async (objectId, method, inputArguments = []) => {
    const methodId = `${objectId}/${method}`;
    return (await session.call({ objectId, methodId, inputArguments })).statusCode.name;
  };
  const text = (value) => ({ dataType: opcua.DataType.String, value });
  const path = "Sinumerik/FileSystem/Part Program/WALK.MPF";
  const statuses = [
    await call(names.methods, "CopyFileToServer", [
      text(path),
      { dataType: opcua.DataType.ByteString, value: Buffer.from(PROGRAM) },
      { dataType: opcua.DataType.Boolean, value: true },
    ]),
    await call(names.methods, "Select", [text(path), { dataType: opcua.DataType.UInt32, value: 1 }]),
    await call(names.machine, "CycleStart"),
  ];
  await arrived;
  const revised = {
    sampling: item.result.revisedSamplingInterval,
    queue: item.result.revisedQueueSize,
    publishing: subscription.publishingInterval,
  };
  await subscription.terminate();
  return { statuses, seen, revised };
}

/// The stated value of each limit, the status at it and the status one step beyond.
async function exceed(client, session, names, stated) {
  const found = {};
  const note = async (name, at, beyond) => {
    found[name] = { stated: stated[name], at: await statusOf(at), beyond: await statusOf(beyond) };
  };
  const node = "i=2253"; // the object Server: nothing has to be simulated to answer for it
  const simple = async (name, call) =>
    note(
      name,
      () => call(stated[name]),
      () => call(stated[name] + 1),
    );
  await simple("MaxNodesPerRead", (count) =>
    session.read(many(count, { nodeId: node, attributeId: AttributeIds.NodeClass })),
  );
  // Nobody writes here: there is no such node.
  await simple("MaxNodesPerWrite", async (count) => {
    const statuses = await session.write(
      many(count, {
        nodeId: "i=1",
        attributeId: AttributeIds.Description,
        value: { value: { dataType: opcua.DataType.LocalizedText, value: { text: "x" } } },
      }),
    );
    return statuses.length === count ? "Good" : "BadCount";
  });
  await simple("MaxNodesPerBrowse", (count) =>
    session.browse(
      many(count, { nodeId: "i=11705", resultMask: 0, browseDirection: opcua.BrowseDirection.Forward }),
    ),
  );
  await simple("MaxNodesPerTranslateBrowsePathsToNodeIds", (count) =>
    session.translateBrowsePath(many(count, opcua.makeBrowsePath("RootFolder", "/Objects/Server"))),
  );
  await simple("MaxNodesPerRegisterNodes", (count) => session.registerNodes(many(count, node)));
  const rights = {
    objectId: names.methods,
    methodId: `${names.methods}/GetMyAccessRights`,
    inputArguments: [],
  };
  await simple("MaxNodesPerMethodCall", (count) => session.call(many(count, rights)));
  const array = (count) => ({ nodeId: `${names.channel}/Parameter/R[u1,0,#${count}]` });
  await simple("MaxArrayLength", (count) =>
    session.read({ ...array(count), attributeId: AttributeIds.Value }),
  );
  const program = (bytes) => ({
    objectId: names.methods,
    methodId: `${names.methods}/CopyFileToServer`,
    inputArguments: [
      { dataType: opcua.DataType.String, value: "Sinumerik/FileSystem/Part Program/LONG.MPF" },
      { dataType: opcua.DataType.ByteString, value: Buffer.alloc(bytes, 32) },
      { dataType: opcua.DataType.Boolean, value: true },
    ],
  });
  // The largest one would take the time that the control takes for it.
  await note(
    "MaxByteStringLength",
    () => session.call(program(1000)),
    () => session.call(program(stated.MaxByteStringLength + 1)),
  );

  const subscribe = () =>
    session.createSubscription({ requestedPublishingInterval: 1000, publishingEnabled: false });
  let subscriptionId;
  await note(
    "MaxSubscriptions",
    async () => {
      for (let i = 0; i < stated.MaxSubscriptions; ++i) {
        ({ subscriptionId } = await subscribe());
      }
    },
    subscribe,
  );
  const watch = (count) =>
    session.createMonitoredItems({
      subscriptionId,
      timestampsToReturn: opcua.TimestampsToReturn.Both,
      itemsToCreate: many(count, {
        itemToMonitor: { nodeId: "i=2258", attributeId: AttributeIds.Value },
        monitoringMode: opcua.MonitoringMode.Disabled,
        requestedParameters: { clientHandle: 1, samplingInterval: 1000, queueSize: 1 },
      }),
    });
  const resultsOf = async (count) => (await watch(count)).results;
  await note(
    "MaxMonitoredItemsPerCall",
    async () => "Good", // the next limit uses it
    () => resultsOf(stated.MaxMonitoredItemsPerCall + 1),
  );
  await note(
    "MaxMonitoredItems",
    () => resultsOf(stated.MaxMonitoredItems),
    () => resultsOf(1),
  );
  const others = [];
  await note(
    "MaxSessions",
    async () => {
      while (others.length + 1 < stated.MaxSessions) {
        others.push(await client.createSession());
      }
    },
    () => client.createSession(),
  );
  for (const other of others) {
    await other.close();
  }
  return found;
}

async function main() {
  const client = opcua.OPCUAClient.create({
    endpointMustExist: false,
    connectionStrategy: { maxRetry: 0 },
    transportSettings: { maxMessageSize: 1 << 26, maxChunkCount: 1 << 14 },
  });
  await client.connect(process.argv[2]);
  const session = await client.createSession();
  const namespaces = await session.readNamespaceArray();
  const control = namespaces.indexOf("SinumerikVarProvider");
  const names = {
    channel: `ns=${control};s=/Channel`,
    methods: `ns=${control};s=/Methods`,
    machine: `ns=${namespaces.indexOf("urn:rivulet:virtual-machine")};s=VirtualMachine`,
  };
  const nodes = await browse(session, "i=85");
  // Of the library are the nodes of the standard and those of its sessions.
  const own = nodes.filter(({ id }) => /^ns=[23];/.test(id));
  // As on the control, browsing lists only the first element.
  for (const name of ["MachineAxis/measPos1[u1,4]", "Parameter/R[u1,12]", "Parameter/R[u1,10,#5]"]) {
    const id = `${names.channel}/${name}`;
    own.push({ id, parent: "", nodeClass: "Variable", name, type: await typeOf(session, id) });
    own.push(...(await browse(session, id)));
  }
  await readAttributes(session, own);
  const limits = {};
  for (const { id, name, parent } of nodes) {
    if (/^(ns=0;)?i=(2268|11704)$/.test(parent)) {
      const read = await session.read({ nodeId: id, attributeId: AttributeIds.Value });
      limits[name] = read.value.value;
    }
  }
  const axis = `${names.channel}/GeometricAxis/aaAcsRel`;
  const now = new Date();
  const history = await statusOf(() => session.readHistoryValue(axis, new Date(now - 60_000), now));
  const positions = await follow(session, names, axis);
  const exceeded = await exceed(client, session, names, limits);
  process.stdout.write(
    `${JSON.stringify({ namespaces, count: nodes.length, nodes: own, stated: limits, history, positions, exceeded })}\n`,
  );
  await client.disconnect();
  process.exit(0);
}

main().catch((error) => {
  console.error(`node_opcua_walk: ${error.stack}`);
  process.exit(1);
});
