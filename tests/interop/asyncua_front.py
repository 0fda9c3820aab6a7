# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A control as asyncua would serve it: a server of that library whose variables and methods are
those of a rivulet-machine behind it, which it reaches with the client of that library. So every
value and every call passes both of its halves. Namespaces have other indices than on the machine,
and there are no array nodes.

usage: python3 asyncua_front.py PLAN.json
PLAN: {"upstream": "opc.tcp://…", "folder": "…", "variables": ["/Channel/…", …],
       "user": "…", "password": "…"}
prints one line of JSON when it listens: {"endpoint": "…", "fingerprint": "…"}
"""

import asyncio
import hashlib
import json
import logging
import socket
import sys
from pathlib import Path

from asyncua import Client, Server, ua
from asyncua.common.callback import CallbackType
from asyncua.crypto.cert_gen import setup_self_signed_certificate
from asyncua.crypto.permission_rules import User, UserRole
from asyncua.server.address_space import AttributeService
from cryptography.x509.oid import ExtendedKeyUsageOID

CONTROL = "SinumerikVarProvider"
VIRTUAL = "urn:rivulet:virtual-machine"
APPLICATION = "urn:rivulet:test:asyncua-front"
ITEMS_MAX = 500  # in a request to the machine


async def read_upstream(client, nodes, attribute):
    """One data value for each node, in requests as large as a control takes."""
    values = []
    for first in range(0, len(nodes), ITEMS_MAX):
        parameters = ua.ReadParameters()
        for node in nodes[first : first + ITEMS_MAX]:
            item = ua.ReadValueId()
            item.NodeId = node
            item.AttributeId = attribute
            parameters.NodesToRead.append(item)
        values.extend(await client.uaclient.read(parameters))
    return values


class ForwardedWrites(AttributeService):
    """Writes of clients go to the machine, in one request, and its answers come back."""

    def __init__(self, aspace, client, upstream_of):
        super().__init__(aspace)
        self._client = client
        self._upstream_of = upstream_of

    async def write(self, params, user=User(role=UserRole.Admin)):
        items = params.NodesToWrite
        if not any(item.NodeId in self._upstream_of for item in items):
            return await super().write(params, user)
        forwarded = ua.WriteParameters()
        for item in items:
            if item.NodeId not in self._upstream_of:
                return [ua.StatusCode(ua.StatusCodes.BadNotSupported) for _ in items]
            copy = ua.WriteValue()
            copy.NodeId = self._upstream_of[item.NodeId]
            copy.AttributeId = item.AttributeId
            copy.Value = ua.DataValue(item.Value.Value)
            forwarded.NodesToWrite.append(copy)
        return await self._client.uaclient.write(forwarded)


class OneUser:
    """Nobody, or the user of the plan with their password."""

    def __init__(self, plan):
        self._plan = plan

    def get_user(self, iserver, username=None, password=None, certificate=None):
        if username is not None and (
            username != self._plan["user"] or password != self._plan["password"]
        ):
            return None
        return User(role=UserRole.User)


async def add_variables(client, server, parent, index, upstream_index, names):
    """@return the machine's node of each node added"""
    nodes = [ua.NodeId(name, upstream_index) for name in names]
    types = await read_upstream(client, nodes, ua.AttributeIds.DataType)
    levels = await read_upstream(client, nodes, ua.AttributeIds.AccessLevel)
    values = await read_upstream(client, nodes, ua.AttributeIds.Value)
    upstream_of = {}
    for name, node, data_type, level, value in zip(names, nodes, types, levels, values):
        if not data_type.StatusCode.is_good():
            continue  # this machine does not have it
        own = ua.NodeId(name, index)
        variable = await parent.add_variable(
            own,
            ua.QualifiedName(name, index),
            value.Value.Value,
            value.Value.VariantType,
            data_type.Value.Value,
        )
        if level.Value.Value & ua.AccessLevel.CurrentWrite.mask:
            await variable.set_writable()
        upstream_of[own] = node
    return upstream_of


async def add_methods(client, parent, index, upstream_index, identifier):
    """The object of the machine with all its methods, as they are."""
    object_id = ua.NodeId(identifier, upstream_index)
    own = await parent.add_object(
        ua.NodeId(identifier, index), ua.QualifiedName(identifier, index)
    )

    def forward(method_id):
        async def call(_, *arguments):
            request = ua.CallMethodRequest()
            request.ObjectId = object_id
            request.MethodId = method_id
            request.InputArguments = list(arguments)
            result = (await client.uaclient.call([request]))[0]
            result.InputArgumentResults = result.InputArgumentResults or []  # None is no list
            return result

        return call

    for method in await client.get_node(object_id).get_methods():
        arguments = {"InputArguments": [], "OutputArguments": []}
        for property_node in await method.get_properties():
            name = (await property_node.read_browse_name()).Name
            arguments[name] = await property_node.read_value() or []
        name = (await method.read_browse_name()).Name
        await own.add_method(
            ua.NodeId(method.nodeid.Identifier, index),
            ua.QualifiedName(name, index),
            forward(method.nodeid),
            arguments["InputArguments"],
            arguments["OutputArguments"],
        )


async def main(plan):
    folder = Path(plan["folder"])
    key, certificate = folder / "front.key.pem", folder / "front.der"
    await setup_self_signed_certificate(
        key,
        certificate,
        APPLICATION,
        "127.0.0.1",
        [ExtendedKeyUsageOID.CLIENT_AUTH, ExtendedKeyUsageOID.SERVER_AUTH],
        {"commonName": "asyncua front"},
    )
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    endpoint = f"opc.tcp://127.0.0.1:{port}"

    server = Server(user_manager=OneUser(plan))
    await server.init()
    await server.set_application_uri(APPLICATION)
    server.set_endpoint(endpoint)
    server.set_security_policy(
        [
            ua.SecurityPolicyType.NoSecurity,
            ua.SecurityPolicyType.Basic256Sha256_Sign,
            ua.SecurityPolicyType.Basic256Sha256_SignAndEncrypt,
        ]
    )
    await server.load_certificate(certificate)
    await server.load_private_key(key)
    # The other way round than on the machine, behind one that is nobody's.
    await server.register_namespace("urn:nobody")
    virtual = await server.register_namespace(VIRTUAL)
    control = await server.register_namespace(CONTROL)

    async with Client(plan["upstream"]) as client:
        upstream_control = await client.get_namespace_index(CONTROL)
        upstream_virtual = await client.get_namespace_index(VIRTUAL)
        objects = server.nodes.objects
        sinumerik = await objects.add_object(
            ua.NodeId("Sinumerik", control), ua.QualifiedName("Sinumerik", control)
        )
        upstream_of = await add_variables(
            client, server, sinumerik, control, upstream_control, plan["variables"]
        )
        await add_methods(client, sinumerik, control, upstream_control, "/Methods")
        await add_methods(client, objects, virtual, upstream_virtual, "VirtualMachine")

        async def refresh(event, _):
            asked = [
                item.NodeId
                for item in event.request_params.NodesToRead
                if item.AttributeId == ua.AttributeIds.Value and item.NodeId in upstream_of
            ]
            values = await read_upstream(
                client, [upstream_of[node] for node in asked], ua.AttributeIds.Value
            )
            for node, value in zip(asked, values):
                await server.write_attribute_value(node, value)

        server.subscribe_server_callback(CallbackType.PreRead, refresh)
        server.iserver.attribute_service = ForwardedWrites(
            server.iserver.aspace, client, upstream_of
        )
        async with server:
            fingerprint = hashlib.sha256(certificate.read_bytes()).hexdigest()
            print(json.dumps({"endpoint": endpoint, "fingerprint": fingerprint}), flush=True)
            while True:
                await client.check_connection()
                await asyncio.sleep(1)


logging.basicConfig(level=logging.ERROR)
asyncio.run(main(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))))
