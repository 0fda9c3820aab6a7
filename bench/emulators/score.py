#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The score of an emulator, in README.md's terms: score.py open|closed RECORDINGS [ANSWERS]"""
import csv
import hashlib
import math
import pathlib
import sys


def read(file, names):
    """Columns of a table."""
    with open(file, newline="", encoding="utf-8") as text:
        rows = list(csv.DictReader(text))
    return [[float(row[name]) for row in rows] for name in names]


def speed(t, x):
    return [(x[min(i + 1, len(x) - 1)] - x[max(i - 1, 0)]) / (t[min(i + 1, len(t) - 1)] - t[max(i - 1, 0)]) for i in range(len(t))]


def main(which, recordings, answers=None):
    whole, fit, worst = hashlib.sha256(), {"x": [0.0, 0.0], "y": [0.0, 0.0]}, {}
    for line in (pathlib.Path(__file__).parent / "recordings.tsv").read_text().splitlines():  # to learn from first
        of, use, name, sha256 = line.split("\t")
        if of != which:
            continue
        file = pathlib.Path(recordings) / (name + ".csv")
        whole.update(file.read_bytes())
        if sha256 not in ("-", hashlib.sha256(file.read_bytes()).hexdigest()):
            sys.exit("%s is not the recording that is meant." % file)
        t, xs, ys, xa, ya = read(file, ("t_s", "x_cmd", "y_cmd", "x_fb", "y_fb"))
        vx, vy = speed(t, xs), speed(t, ys)
        if use == "learn":  # the lag of each axis that explains most of its following error: least squares
            for axis, speeds, set_points, places in (("x", vx, xs, xa), ("y", vy, ys, ya)):
                fit[axis][0] += sum(v * (s - a) for v, s, a in zip(speeds, set_points, places))
                fit[axis][1] += sum(v * v for v in speeds)
            continue
        lag = {axis: above / below for axis, (above, below) in fit.items()}
        late = [[s - lag["x"] * v for s, v in zip(xs, vx)], [s - lag["y"] * v for s, v in zip(ys, vy)]]
        models = {"set point": (xs, ys), "set point, late": late}
        if answers:
            models["emulator"] = read(pathlib.Path(answers) / (name + ".csv"), ("X_emulated", "Y_emulated"))
        for model, (x, y) in models.items():
            if len(x) != len(t):
                sys.exit("%s: the answer has %d rows, the recording %d." % (name, len(x), len(t)))
            off = [1e3 * math.hypot(a - b, c - d) for a, b, c, d in zip(x, xa, y, ya)]
            rms = math.sqrt(sum(e * e for e in off) / len(off))
            worst[model] = max(worst.get(model, 0.0), rms)
            print("%-26s %-16s RMS %9.3f µm, at most %9.3f µm" % (name, model, rms, max(off)))
    for model, rms in worst.items():
        print("%-26s %-16s RMS %9.3f µm" % ("worst", model, rms))
    print("set %s, recordings %s, lags %.2f and %.2f ms" % (which, whole.hexdigest()[:12], 1e3 * lag["x"], 1e3 * lag["y"]))


if __name__ == "__main__":
    main(*sys.argv[1:])
