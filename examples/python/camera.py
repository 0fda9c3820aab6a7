#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A camera guides the tool along a seam that no program knows. It sees the seam 2 mm ahead of the place of
the last executed point; its pictures come from a model here: put those of your camera in its place.

examples/python/camera.py
examples/python/camera.py opc.tcp://127.0.0.1:4840
"""
import math
import random
import sys

import rivulet

MACHINE = sys.argv[1] if len(sys.argv) > 1 else "simulate"
AHEAD_MM, STEP_MM, LENGTH_MM = 2.0, 0.1, 30.0
WIDTH, MM_PER_PIXEL = 64, 0.1  # of a row of the picture
noise = random.Random(1)


def seam(x):
    """Where it really is: only the model of the camera knows, and what is printed at the end."""
    return 1.5 * math.sin(x / 5.0)


def picture(x, y):
    """A row of grey values across the path, its middle at x, y: the seam is dark, 0.4 mm wide."""
    offsets = ((i - WIDTH / 2) * MM_PER_PIXEL for i in range(WIDTH))
    return [200 - 150 * math.exp(-(((y + o - seam(x)) / 0.2) ** 2)) + noise.gauss(0, 5) for o in offsets]


def offset_of_seam(row):
    """The middle of what is dark, mm from the middle of the picture; None: no seam is seen."""
    dark = [max(0.0, 150.0 - value) for value in row]
    if sum(dark) < 100.0:
        return None
    return MM_PER_PIXEL * (sum(i * value for i, value in enumerate(dark)) / sum(dark) - WIDTH / 2)


def height(seen, x):
    """Of the seam at x: straight between the two points that were seen beside it."""
    (xa, ya), (xb, yb) = next((a, b) for a, b in zip(seen, seen[1:]) if b[0] >= x)
    return ya + (yb - ya) * (x - xa) / (xb - xa)


seen = [(0.0, 0.0)]  # points of the seam, from where the tool began; it comes to the seam within 2 mm
errors = []
with rivulet.live(
    box=((-5, -10, 40), (60, 10, 60)), feed=600, machine=MACHINE, points=2, ahead=4, full_within=20
) as machine:
    x0, y0, _ = machine.position
    for step in range(1, round(LENGTH_MM / STEP_MM) + 1):
        x, y = machine.position[0] - x0, machine.position[1] - y0
        if x > AHEAD_MM:
            errors.append(abs(y - seam(x)))
        offset = offset_of_seam(picture(x + AHEAD_MM, y))
        if offset is None:
            raise SystemExit("The seam is out of sight: the axes are held.")
        if x + AHEAD_MM > seen[-1][0]:
            seen.append((x + AHEAD_MM, y + offset))
        machine.move(x0 + step * STEP_MM, y0 + height(seen, step * STEP_MM))
report = machine.report
print("%s, %s: %d points" % (report.outcome, report.finding, report.executed))
print("never more than %.3f mm beside the seam; delay %.0f ms (median)" % (max(errors), report.live.delay_ms.p50))
