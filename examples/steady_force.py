#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the cutting force while the depth doubles, by the override alone; force and sensor are
simulated. Exit code 0: it stayed within 10 %. docs/live.md says how to start it.

The model: from 60 mm on the cut is 2 mm deep instead of 1 mm. What is engaged grows over the radius
of the tool, 10 mm. The force is in proportion to depth and feed: 200 N at 1 mm and F400.
"""
import json
import socket
import sys

WANTED_N, PROGRAMMED, STEP_AT_MM, RADIUS_MM = 200.0, 400.0, 60.0, 10.0

connection = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
connection.settimeout(0.2)
text, begin, worst, least, count = b"", None, 0.0, 1.0, 0
factor = 1.0


def depth_mm(x):
    return 1.0 + min(max((x - begin - STEP_AT_MM) / RADIUS_MM, 0.0), 1.0)


while True:
    connection.sendall(b"feed %.4f\n" % factor)  # also without news: it shows that the sensor lives
    try:
        heard = connection.recv(4096)
    except socket.timeout:
        continue
    if not heard:
        break
    text += heard
    *lines, text = text.split(b"\n")
    if not lines:
        continue
    reply = json.loads(lines[-1])
    if "end" in reply or not reply:
        break
    begin = reply["x"] if begin is None else begin
    feed = reply.get("feed_mm_per_min", 0.0)
    if feed <= 0.0:
        continue
    force = WANTED_N * depth_mm(reply["x"]) * feed / PROGRAMMED  # all that the sensor knows
    factor = min(max(WANTED_N / (force / feed * PROGRAMMED), 0.2), 1.2)
    if 10.0 < reply["x"] - begin < 115.0:
        worst, least, count = max(worst, abs(force / WANTED_N - 1.0)), min(least, factor), count + 1
print(f"{count} looks, least factor {least:.2f}, the force deviates by at most {100 * worst:.1f} %")
sys.exit(0 if count > 0 and least < 0.6 and worst <= 0.1 else 1)
