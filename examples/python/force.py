#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Force control: the tool follows a surface that it does not know by the force on it. The force comes
from a model here; put that of your sensor in its place."""
import math
import sys

import rivulet

MACHINE = sys.argv[1] if len(sys.argv) > 1 else "simulate"
WANTED_N, STIFFNESS_N_PER_MM = 20.0, 100.0


def force(position):
    x, _, z = position
    surface = 50.0 + 0.2 * math.sin(x / 4.0)
    return max(0.0, WANTED_N + STIFFNESS_N_PER_MM * (surface - z))


forces = []
with rivulet.live(
    box=((-5, -5, 40), (60, 5, 60)), feed=600, machine=MACHINE, points=2, ahead=4, full_within=20
) as machine:
    x, y, z = machine.position
    for step in range(1, 401):
        forces.append(force(machine.position))
        z += 0.25 * (forces[-1] - WANTED_N) / STIFFNESS_N_PER_MM
        machine.move(x + 0.05 * step, y, z)
worst = max(abs(each - WANTED_N) for each in forces)
delay = machine.report.live.delay_ms
print("force within %.1f %% of %.0f N; delay %.0f ms (median)" % (100 * worst / WANTED_N, WANTED_N, delay.p50))
