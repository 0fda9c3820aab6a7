#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A spiral that is computed while the machine moves, until the *executed* position is 6 mm from its
centre; on the virtual machine, or on the one whose address is given:

examples/python/spiral.py
examples/python/spiral.py opc.tcp://127.0.0.1:4840
"""
import math
import sys

import rivulet

MACHINE = sys.argv[1] if len(sys.argv) > 1 else "simulate"
STEP_MM = 0.1

with rivulet.live(box=((-20, -20, 0), (20, 20, 100)), feed=1200, machine=MACHINE) as machine:
    x, y, _ = machine.position
    radius = angle = 0.0
    while math.dist(machine.position[:2], (x, y)) < 6.0:
        radius += 0.02
        angle += STEP_MM / max(radius, STEP_MM)
        machine.move(x + radius * math.cos(angle), y + radius * math.sin(angle))
report = machine.report
print(
    "%s, %s: %d points, %d late windows, delay %.0f ms (median)"
    % (report.outcome, report.finding, report.executed, machine.late, report.live.delay_ms.p50)
)
