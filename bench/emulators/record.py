#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the recordings of the open set: record.py FOLDER. The virtual machine of machine.toml executes the
programs, in virtual time; what is learned from has a noise of 1 µm. The same version of Rivulet makes
the same bytes."""
import pathlib
import random
import sys
import tempfile

import rivulet

HERE = pathlib.Path(__file__).resolve().parent
NOISE_MM = 0.001


def record(program, folder):
    with tempfile.TemporaryDirectory() as work:
        recording = pathlib.Path(work) / "run.rivulet"
        rivulet.stream(
            program, motion_only=True, method="credit", preset=HERE / "machine.toml", seed=1, accept_infeasible=True,
            record=recording,
        )
        trace = rivulet.analyse(recording)
        columns = [trace.times["x_act"], *(trace[name] for name in ("x_set", "y_set", "x_act", "y_act"))]
    noise = random.Random(program.stem)
    scale = NOISE_MM if program.stem.startswith("learn") else 0.0
    with open(folder / (program.stem + ".csv"), "w", encoding="utf-8", newline="\n") as file:
        file.write("t_s,x_cmd,y_cmd,x_fb,y_fb\n")
        for t, xs, ys, xa, ya in zip(*columns):
            xa, ya = xa + noise.gauss(0, scale), ya + noise.gauss(0, scale)
            file.write("%.3f,%.6f,%.6f,%.6f,%.6f\n" % (t, xs, ys, xa, ya))


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    for each in sorted((HERE / "programs").glob("*.mpf")):
        record(each, target)
        print(target / (each.stem + ".csv"))
