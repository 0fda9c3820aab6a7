#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A spiral that grows until the executed position is 6 mm from its centre, then returns.

rivulet-cli stream --live tcp:4001 --box -20 20 -20 20 0 100 --simulate --preset dmu75-arrays &
examples/spiral.py 4001
"""
import json
import math
import socket
import sys

STEP_MM = 0.1
LEAD = 42  # points sent that have not been executed: three windows of 14

connection = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
replies = connection.makefile("r")
centre = json.loads(replies.readline())
sent, radius, angle, grows = 0, 0.0, 0.0, True


def listen():
    """The next reply of the run; it ends this program if the run has ended."""
    global grows
    reply = json.loads(replies.readline())
    if "end" in reply:
        print(reply.get("error", reply["end"]), "after", reply["executed"], "points")
        sys.exit(0 if reply["end"] == "completed" else 1)
    reached = math.hypot(reply["x"] - centre["x"], reply["y"] - centre["y"])
    if grows and reached > 6.0:
        grows = False
        print(f"turned back: the tool is at {reached:.2f} mm, after {sent} points were sent")
    return reply["executed"]


executed = 0
while grows or radius > 0.0:
    radius = max(0.0, radius + (0.01 if grows else -0.02))
    angle += STEP_MM / max(radius, STEP_MM)
    connection.sendall(b"X%.4f Y%.4f\n" % (centre["x"] + radius * math.cos(angle),
                                         centre["y"] + radius * math.sin(angle)))
    sent += 1
    while sent - executed >= LEAD:
        executed = listen()
connection.sendall(b"end\n")
while True:
    listen()
