#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The figures of docs/linuxcnc-figures.md and its pictures: see scripts/linuxcnc."""

import ctypes
import datetime
import json
import math
import os
import pathlib
import platform
import subprocess
import sys

sys.dont_write_bytecode = True
import rig  # noqa: E402  beside this file
import svg  # noqa: E402

RUNS = 3
BLOCKS = 80  # of scorpion.tap
AHEAD = [4, 8, 16]


class Figures:
    def __init__(self, source, bridge, cli, pictures):
        self.machine = rig.Machine(source, bridge, cli)
        self.preset = source / "examples" / "linuxcnc" / "sim.toml"
        self.pictures = pictures
        pictures.mkdir(exist_ok=True)
        self.text = []

    def say(self, *lines):
        self.text += lines

    def record(self, what, file, words):
        """A streamed run. @return its report and its samples"""
        since = self.machine.mark()
        report = self.machine.streamed(what, file, words)
        self.machine.mark()
        return report, rig.moving(self.machine.samples(since))

    def simulate(self, what, file, words):
        """The same on the virtual machine. @return its report and its samples"""
        recording = self.machine.folder / "simulated.rivulet"
        words = ["--simulate", "--preset", self.preset, "--axes", "XYZ", "--json", *words]
        report = json.loads(
            self.machine.answer(
                what,
                self.machine.client(
                    "stream", file, "--motion-only", "--record", recording, *words
                ),
            )
        )
        samples = []
        for line in unpacked(recording.read_bytes()).decode(errors="replace").splitlines():
            words = line.split()
            if words and words[0] == "s":
                samples.append(rig.Sample([len(samples), *words[2:9]]))
        return report, rig.moving(samples)

    def predict(self, file, words):
        words = ["--program", file, "--preset", self.preset, "--axes", "XYZ", "--json", *words]
        client = self.machine.client("feasibility", *words)
        return json.loads(self.machine.answer("feasibility", client, codes=(0, 1)))

    # --- what is measured -------------------------------------------------------------------------

    def integrity(self):
        self.say(
            "## Each point once",
            "",
            "Programs written by others, all moves at 50 mm/s. The judge follows the recorded set points along the",
            "path: each point once, in order, nothing else within %.2f mm." % rig.TOLERANCE_MM,
            "",
            "| program | method | points | time, s | stops | farthest from the path, mm |",
            "|---|---|---|---|---|---|",
        )
        for file in rig.programs(self.machine):
            points = self.machine.points(file)
            for words in (rig.WINDOW, rig.CREDIT):
                report, samples = self.record(file.name, file, [*words, *rig.FEED])
                off = rig.judge(file.name, samples, points)
                self.say(
                    "| `%s` | %s | %d | %.1f | %d | %.3f |"
                    % (
                        file.name,
                        words[1],
                        report["executed"],
                        len(samples) * rig.CYCLE_S,
                        len(rig.stops(samples)),
                        off,
                    )
                )
        self.say("")

    def credit(self):
        file = rig.write(self.machine, "even.nc", rig.wave((0.0, -100.0, 0.0), 300))
        points = self.machine.points(file)
        self.say(
            "## Credit at 50 mm/s, points 1 mm apart",
            "",
            "A path of 300 points in gentle bends, %d runs each. The least speed is that of all servo cycles from 20 mm"
            % RUNS,
            "after the start to 5 mm before the end, in % of the feed.",
            "",
            "| points ahead | windows × points | least speed of each run, % | runs with a stop |",
            "|---|---|---|---|",
        )
        curves = []
        for ahead in AHEAD:
            count = ahead // 2
            words = ["--method", "credit", "--points", 2, "--windows", min(count + 1, 8)]
            words += ["--windows-ahead", count, *rig.FEED]
            least, stopped = [], 0
            for _ in range(RUNS):
                _, samples = self.record("credit", file, words)
                rig.judge("credit", samples, points)
                even = rig.even_part(samples, points)
                least.append(100.0 * min(s.speed for s in even) / rig.FEED_MM_PER_S)
                stopped += bool(rig.stops(even))
            if ahead == 8:
                curves.append(("credit, 8 points ahead", samples))
            self.say(
                "| %d | %d × 2 | %s | %d of %d |"
                % (ahead, count, ", ".join("%.1f" % one for one in least), stopped, RUNS)
            )
        _, samples = self.record("window", file, [*rig.WINDOW, *rig.FEED])
        curves.append(("window, 8 points", samples))
        self.say("", "![Path speed of credit and window](images/linuxcnc/speed.svg)", "")
        svg.plot(
            self.pictures / "speed.svg",
            "300 points 1 mm apart at 50 mm/s",
            "time (s)",
            "path speed (mm/s)",
            [
                (
                    name,
                    [
                        (i * rig.CYCLE_S, s.speed)
                        for i, s in enumerate(rig.from_first(samples, points))
                    ],
                )
                for name, samples in curves
            ],
        )

    def pauses(self):
        file = rig.write(self.machine, "even.nc", rig.wave((0.0, -100.0, 0.0), 300))
        self.say(
            "## Pauses of method window",
            "",
            "The same path. *Predicted* is `rivulet-cli feasibility` with the axes of `examples/linuxcnc/sim.toml`; *lost* is",
            "the time that the pauses add, braking and starting included (time with pauses less time without any,",
            "both predicted, or measured with methods window and credit).",
            "",
            "| points per window | pauses predicted | measured | lost, predicted, s | measured, s | per pause, predicted, ms | measured, ms | standstill alone, measured, ms |",
            "|---|---|---|---|---|---|---|---|",
        )
        points = self.machine.points(file)

        def measure(what, words):
            return rig.from_first(self.record(what, file, words)[1], points)

        credit = min(
            len(measure("credit", [*rig.CREDIT, *rig.FEED])) * rig.CYCLE_S for _ in range(RUNS)
        )
        for count in (4, 8, 12):
            words = ["--method", "window", "--points", count, *rig.FEED]
            predicted = self.predict(file, words)
            samples = measure("window", [*words, "--windows", "2"])
            stops = rig.stops(samples)
            lost = len(samples) * rig.CYCLE_S - credit
            pauses = max(len(stops), 1)
            planned = predicted["planned_pauses"]
            standing = sorted(cycles for _, cycles in stops)
            self.say(
                "| %d | %d | %d | %.2f | %.2f | %.0f | %.0f | %d to %d, median %d |"
                % (
                    count,
                    planned,
                    len(stops),
                    predicted["pauses_cost_s"],
                    lost,
                    1000.0 * predicted["pauses_cost_s"] / max(planned, 1),
                    1000.0 * lost / pauses,
                    standing[0],
                    standing[-1],
                    standing[len(standing) // 2],
                )
            )
        self.say("")

    def side_by_side(self):
        source = rig.beginning(self.machine, BLOCKS)
        points = rig.whole(self.machine.points(source), (0.0, 0.0, 0.0))
        self.say(
            "## The same program, streamed and executed natively",
            "",
            "The first %d lines of `resources/programs/scorpion.tap` (%d points) with their own feeds. *Native*: LinuxCNC"
            % (BLOCKS, len(points)),
            "reads the file itself.",
            "It rounds corners as far as the program allows, so it is run twice: as the file stands (no limit), and with",
            "`G64 P0.01 Q0` before it, which is what the flexible program says too. Streamed rapids are G1 at the rapid",
            "feed. The virtual machine has the axes of `examples/linuxcnc/sim.toml` and streams the same program.",
            "",
            "| execution | time, s | farthest from the path, mm | stops |",
            "|---|---|---|---|",
        )
        feed = ["--feed", "program", "--rapid", "12000"]
        rows = []
        for name, head in (("native, as it stands", ""), ("native, `G64 P0.01 Q0`", "G64 P0.01 Q0\n")):
            file = self.machine.folder / "machine" / "native.ngc"
            file.write_text(head + words, encoding="ascii")
            rows.append((name, self.machine.executed(name, file)))
        for method in (rig.CREDIT, rig.WINDOW):
            name = "streamed, method %s" % method[1]
            rows.append((name, self.record(name, source, [*method, *feed])[1]))
        for method in (rig.CREDIT, rig.WINDOW):
            name = "virtual machine, method %s" % method[1]
            rows.append((name, self.simulate(name, source, [*method, *feed])[1]))
        for name, samples in rows:
            self.say(
                "| %s | %.2f | %.3f | %d |"
                % (
                    name,
                    len(samples) * rig.CYCLE_S,
                    farthest(samples, points),
                    len(rig.stops(samples)),
                )
            )
        by_name = dict(rows)
        shown = [
            "native, `G64 P0.01 Q0`",
            "streamed, method credit",
            "virtual machine, method credit",
        ]
        self.say(
            "",
            "![Speed along the path](images/linuxcnc/side-by-side.svg)",
            "",
        )
        svg.plot(
            self.pictures / "side-by-side.svg",
            "scorpion.tap, the first 200 mm in the material",
            "length of the path (mm)",
            "path speed (mm/s)",
            [(name.replace("`", ""), speeds(by_name[name], points, 200.0)) for name in shown],
        )


def unpacked(data):
    """A recording is text in frames of zstd, with text between them and an index at the end."""
    zstd = ctypes.CDLL("libzstd.so.1")
    zstd.ZSTD_findFrameCompressedSize.restype = ctypes.c_size_t
    zstd.ZSTD_decompress.restype = ctypes.c_size_t
    text, begin = b"", 0
    while (frame := data.find(b"\x28\xb5\x2f\xfd", begin)) >= 0:
        text += data[begin:frame]
        rest = data[frame:]
        size = zstd.ZSTD_findFrameCompressedSize(rest, ctypes.c_size_t(len(rest)))
        room = ctypes.create_string_buffer(1 << 24)
        count = zstd.ZSTD_decompress(room, ctypes.c_size_t(len(room)), rest, ctypes.c_size_t(size))
        text += room.raw[:count]
        begin = frame + size
    return text + data[begin:]


def legs_of(points):
    return [(a, b) for a, b in zip(points, points[1:]) if a != b]


def away(place, a, b):
    length = math.dist(a, b)
    share = sum((p - q) * (r - q) for p, q, r in zip(place, a, b)) / length**2
    share = min(max(share, 0.0), 1.0)
    return math.dist(place, [q + share * (r - q) for q, r in zip(a, b)]), share * length


def farthest(samples, points):
    """From any part of the path, whatever its order: a rounded path may be off it anywhere."""
    legs = legs_of([samples[0].set, *rig.whole(points, samples[0].set)])
    worst, near = 0.0, 0
    for sample in samples:
        around = range(max(near - 3, 0), min(near + 12, len(legs)))
        best = min((away(sample.set, *legs[i])[0], i) for i in around)
        worst, near = max(worst, best[0]), best[1]
    return worst


def speeds(samples, points, length_mm):
    """Path speed over the length that was travelled since the first point in the material."""
    first = next(i for i, p in enumerate(points) if p[2] < 0.0)
    begin = next(i for i, s in enumerate(samples) if math.dist(s.set, points[first]) < 0.02)
    found, travelled, previous = [], 0.0, samples[begin].set
    for sample in samples[begin:]:
        travelled += math.dist(sample.set, previous)
        previous = sample.set
        if travelled > length_mm:
            break
        found.append((travelled, sample.speed))
    return found


def version():
    done = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Version}", "linuxcnc-uspace"],
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout.strip() or "unknown"


def main():
    source, bridge, cli, target = sys.argv[1:5]
    source, target = pathlib.Path(source).resolve(), pathlib.Path(target)
    (target / "images").mkdir(exist_ok=True)
    figures = Figures(source, bridge, cli, target / "images" / "linuxcnc")
    try:
        access = figures.machine.calibrate()
        figures.say(
            "<!--",
            "SPDX-FileCopyrightText: 2026 The Rivulet authors",
            "SPDX-License-Identifier: GPL-3.0-or-later",
            "-->",
            "# LinuxCNC: what was measured",
            "",
            "Generated by `scripts/linuxcnc`; do not edit. Measured on %s: LinuxCNC %s,"
            % (datetime.date.today(), version()),
            "Linux %s without real time, %d processors"
            % (platform.release().split("-")[0], os.cpu_count()),
            "(load by other programs at the start: %.1f; LinuxCNC had the class SCHED_RR if started as root)."
            % os.getloadavg()[0],
            "All times and places are set points of LinuxCNC's own `halsampler`, one line per servo cycle of 1 ms. The machine",
            "is that of `examples/linuxcnc`: 200 mm/s, 1000 mm/s², no limit of the jerk, task cycle 1 ms.",
            "",
        )
        cost = {
            fit["write"]: fit for fit in access["fits"] if fit["form"] == access["best_form"]
        }
        figures.say(
            "An access through the bridge, on the same computer (`rivulet-cli calibrate`): a read takes %.2f ms,"
            % cost[False]["overhead_ms"],
            "a write %.2f ms, and each cell of an array %.3f ms more."
            % (cost[True]["overhead_ms"], cost[True]["node_ms"]),
            "",
        )
        for measure in (figures.integrity, figures.credit, figures.pauses, figures.side_by_side):
            measure()
            (target / "linuxcnc-figures.md").write_text("\n".join(figures.text), encoding="utf-8")
    finally:
        figures.machine.end()
    return 0


if __name__ == "__main__":
    sys.exit(main())
