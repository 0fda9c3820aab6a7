#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The experiment of [P1] on the virtual machine: how long an access takes, and from which distance of
points on the methods execute each point once. A machine takes the place of the virtual one by its
address:

examples/python/p1_experiment.py
examples/python/p1_experiment.py opc.tcp://127.0.0.1:4840
"""
import math
import pathlib
import sys
import tempfile

import rivulet

FEEDS = [300, 500, 1000, 2000]  # mm/min
DISTANCES = [0.5, 0.4, 0.3, 0.2, 0.15, 0.1, 0.05, 0.02, 0.01]  # mm, from large to small as in [P1]
POINTS, RADIUS_MM = 60, 20.0


def program(folder, distance):
    """Points at this distance, on a circle."""
    file = folder / "steps.mpf"
    angles = (i * distance / RADIUS_MM for i in range(1, POINTS + 1))
    steps = ("X%.4f Y%.4f" % (RADIUS_MM * math.sin(a), RADIUS_MM * (1 - math.cos(a))) for a in angles)
    file.write_text("G71 G90 G94 F500\n" + "".join("G1 %s\n" % step for step in steps) + "M30\n")
    return file


def is_right(machine, file, feed, **method):
    """Whether each point was executed once, by the trace of the control."""
    try:
        report = rivulet.stream(file, machine, feed=feed, motion_only=True, accept_infeasible=True, **method)
    except rivulet.RunFailed as failed:
        report = failed.report
    return report.get("finding") == "faultless"


def limit(machine, folder, feed, **method):
    """The smallest distance that was right before the first that was not; None: not even the largest."""
    smallest = None
    for distance in DISTANCES:
        delta = {"delta": distance} if method["method"] == "position" else {}
        if not is_right(machine, program(folder, distance), feed, **method, **delta):
            break
        smallest = distance
    return smallest


def main(machine="simulate"):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        first = rivulet.stream(program(folder, 0.5), machine, feed=300, motion_only=True, method="window")
        print("access per variable: mean %.2f ms, 99 %% %.2f ms" % (first.access_ms.mean, first.access_ms.p99))
        print("\nsmallest distance, mm, at which each point was executed once\n")
        print("F mm/min | equation | position | signal, N 7 | window, N 7")
        for feed in FEEDS:
            verdict = rivulet.judge(d_min=0.5, delta=0.5, feed=feed, method="position")
            equation = 0.5 * feed / verdict.feed_mm_per_min_max
            measured = [limit(machine, folder, feed, method="position")]
            measured += [limit(machine, folder, feed, method=method, points=7) for method in ("signal", "window")]
            print("%8d | %8.3f | %8s | %11s | %s" % (feed, equation, *measured))


if __name__ == "__main__":
    main(*sys.argv[1:])
