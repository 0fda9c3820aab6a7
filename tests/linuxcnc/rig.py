# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""LinuxCNC with a simulated machine, the bridge in front of it, rivulet-cli as its client, and a judge
who knows only the points of the program and what LinuxCNC's own halsampler has recorded in every servo
cycle. For test_linuxcnc and scripts/linuxcnc."""

import contextlib
import csv
import io
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TOLERANCE_MM = 0.05  # that of Rivulet's own judgement of traces
CYCLE_S = 0.001
WORDS = 14  # of a recorded sample
CLIENT_S = 150.0
RECORDER_S = 30.0  # more than the sampler holds
SKIPPED = 77

WINDOW = ["--method", "window", "--points", "8", "--windows", "3"]
CREDIT = ["--method", "credit", "--points", "4", "--windows", "5", "--windows-ahead", "8"]

FEED_MM_PER_S = 50.0
FEED = ["--feed", "3000"]
CORPUS = [
    "pygcode/Mach4_write.tap",
    "pygcode/Tweakie_s_CNC_Cube.nc",
    "gcode-toolpath/t2laser.nc",
]


class Failed(Exception):
    pass


class Sample:
    """One servo cycle."""

    def __init__(self, words):
        numbers = [float(word) for word in words]
        self.cycle = int(numbers[0])
        self.set = tuple(numbers[1:4])
        self.actual = tuple(numbers[4:7])
        self.speed = numbers[7]
        self.override = numbers[9]  # 1: as programmed
        self.line = int(numbers[8])
        self.equipment = tuple(numbers[10:14])  # tool, speed of the spindle, flood, mist


def has_priority():
    """Whether LinuxCNC can be started before all other programs: by root, where root may do so."""
    return os.geteuid() == 0 and subprocess.run(
        ["chrt", "--rr", "1", "true"], stderr=subprocess.DEVNULL, check=False
    ).returncode == 0


def exit_code(test):
    """Of a test program. @param test  is given the arguments SOURCE BRIDGE CLI"""
    if not has_priority() and not os.environ.get("RIVULET_TEST_LINUXCNC"):
        print(
            "skipped: LinuxCNC has no priority unless root starts it, where root may give any. Run this "
            "test as root, or set RIVULET_TEST_LINUXCNC=1 on a computer that does nothing else."
        )
        return SKIPPED
    try:
        test(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:4])
    except Failed as why:
        print("FAIL:", why)
        return 1
    return 0


def as_linuxcnc():
    """@return the words before a program that accesses LinuxCNC: user and priority that `start` gives
    to LinuxCNC. It holds the HAL's lock, for which programs with priority wait without a pause."""
    first = ["chrt", "--rr", "1"] if has_priority() else []
    user = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"]
    return [*first, *(user if os.geteuid() == 0 else [])]


class Machine:
    """@param bridge  rivulet-linuxcnc; its helper stands beside it
    @param changed  what is otherwise in its configuration: file, then text and what is in its place"""

    was_started = False

    def __init__(self, source, bridge, cli, changed=None):
        self.source = pathlib.Path(source)
        self.cli = cli
        self.process = None
        # Not in the home of root, which the user nobody cannot read.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rivulet-linuxcnc-"))
        self.folder.chmod(0o755)
        for name in (bridge, bridge + "-helper"):
            shutil.copy(name, self.folder)
        bridge = str(self.folder / pathlib.Path(bridge).name)
        setup = self.folder / "setup"
        shutil.copytree(self.source / "examples" / "linuxcnc", setup)
        for name, (right, wrong) in (changed or {}).items():
            text = (setup / name).read_text(encoding="utf-8")
            if text.count(right) != 1:
                raise Failed("%s has no line %s" % (name, right))
            (setup / name).write_text(text.replace(right, wrong), encoding="utf-8")
        self.home = self.folder / "client"
        self.home.mkdir()
        self.recorded = self.folder / "machine" / "samples.txt"
        self.process = subprocess.Popen(
            [
                # A test that takes too long is killed, and LinuxCNC must not stay behind.
                *["setpriv", "--pdeathsig", "TERM"],
                setup / "start",
                "--record",
                self.folder / "machine",
                bridge,
                "--port",
                "0",
                "--allow-start",
            ],
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        self.endpoint = self.process.stdout.readline().strip()
        if not self.endpoint:
            code = self.process.wait()
            log = self.folder / "machine" / "linuxcnc.log"
            text = log.read_text(encoding="utf-8")[-3000:] if log.exists() else ""
            self.end()
            if code == SKIPPED and not Machine.was_started:
                sys.exit(SKIPPED)
            raise Failed("LinuxCNC or the bridge did not start (exit code %d)\n%s" % (code, text))
        Machine.was_started = True

    def __enter__(self):
        return self

    def __exit__(self, _kind, why, _trace):
        try:
            self.end()
        except Failed as late:
            raise Failed("%s; and then %s" % (why, late) if why else str(late)) from why

    def end(self):
        try:
            if self.process is not None and self.process.poll() is None:
                self.process.terminate()
                self.process.wait(30)
        except subprocess.TimeoutExpired as late:
            left = subprocess.run(
                ["ps", "-g", str(self.process.pid), "-o", "pid,stat,wchan:20,args"],
                stdout=subprocess.PIPE,
                text=True,
                check=False,
            ).stdout
            os.killpg(self.process.pid, signal.SIGKILL)
            raise Failed("LinuxCNC did not end:\n" + left) from late
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)

    @contextlib.contextmanager
    def unwatched(self):
        """LinuxCNC goes on without its bridge."""
        self.process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self.process.send_signal(signal.SIGCONT)

    @contextlib.contextmanager
    def new_bridge(self):
        """In the place of one that has ended."""
        folder = self.folder / "machine"
        home = folder / "home"
        environment = dict(os.environ, HOME=str(home), XDG_RUNTIME_DIR=str(home / "runtime"))
        for name in ("config", "data"):
            environment["XDG_%s_HOME" % name.upper()] = str(home / name)
        words = [self.folder / "rivulet-linuxcnc", "--programs", folder / "programs", "--sampler"]
        process = subprocess.Popen(
            [*as_linuxcnc(), *words, "--port", "0", "--allow-start"],
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
            cwd=folder,
        )
        self.endpoint = process.stdout.readline().strip()
        try:
            yield
        finally:
            process.terminate()
            process.communicate()

    def process_named(self, name):
        """@return the id of the process below `start`, whose command begins with this name"""
        found, parents = [], [self.process.pid]
        while parents:
            parent = parents.pop()
            for task in pathlib.Path("/proc/%d/task" % parent).iterdir():
                children = map(int, (task / "children").read_text(encoding="ascii").split())
                for child in children:
                    parents.append(child)
                    words = pathlib.Path("/proc/%d/cmdline" % child).read_bytes().split(b"\0")
                    found += [child] if any(w.endswith(name.encode()) for w in words[:2]) else []
        if len(found) != 1:
            raise Failed("%d processes %s" % (len(found), name))
        return found[0]

    def client(self, *words):
        """Starts rivulet-cli with settings of its own."""
        environment = dict(os.environ, HOME=str(self.home))
        for name in ("CONFIG_HOME", "DATA_HOME", "STATE_HOME", "RUNTIME_DIR"):
            place = self.home / name.lower()
            place.mkdir(exist_ok=True, mode=0o700)
            environment["XDG_" + name] = str(place)
        return subprocess.Popen(
            [self.cli, *map(str, words)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )

    def answer(self, what, client, codes=(0,)):
        """@return what the client has printed, when it has ended"""
        try:
            output, errors = client.communicate(timeout=CLIENT_S)
        except subprocess.TimeoutExpired as late:
            client.kill()
            said = client.communicate()[1]
            raise Failed("%s: no end after %.0f s: %s" % (what, CLIENT_S, said)) from late
        if client.returncode not in codes:
            raise Failed("%s: exit code %d: %s%s" % (what, client.returncode, output, errors))
        return output

    def calibrate(self):
        """Measures what an access costs, for the verdicts."""
        words = ["calibrate", "--endpoint", self.endpoint, "--security", "none", "--json", "--yes"]
        words += ["--first-cell", 100, "--last-cell", 140, "--shots", 50, "--budget", 10]
        return json.loads(self.answer("calibrate", self.client(*words)))

    def points(self, file):
        """The points of the program, in mm, as Rivulet reads them; None where an axis has not been moved
        yet."""
        text = self.answer("points", self.client("points", file))
        return [
            tuple(float(row[axis]) if row[axis] else None for axis in ("x_mm", "y_mm", "z_mm"))
            for row in csv.DictReader(io.StringIO(text))
        ]

    def stream(self, file, words):
        return self.client(
            *["stream", file, "--motion-only", "--endpoint", self.endpoint, "--security", "none"],
            *["--control", "linuxcnc", "--axes", "XYZ", "--json", *words],
        )

    def streamed(self, what, file, words):
        """A whole run, which Rivulet itself judges from the trace that the bridge fetches."""
        report = json.loads(self.answer(what, self.stream(file, words)))
        if report["outcome"] != "completed" or report["finding"] != "faultless":
            raise Failed("%s: %s" % (what, report))
        return report

    def job(self, file, words=()):
        """A whole job in the language of LinuxCNC."""
        return self.client(
            *["job", file, "--endpoint", self.endpoint, "--security", "none"],
            *["--dialect", "linuxcnc", "--straight", "--json", *words],
        )

    def end_run(self, what):
        """Ends the program that waits for its client."""
        words = ["runs", "--endpoint", self.endpoint, "--security", "none", "--end"]
        return self.answer(what, self.client(*words))

    def executed(self, what, file):
        """The program in LinuxCNC's own hands. @return its samples"""
        since = self.mark()
        words = [self.source / "tests" / "linuxcnc" / "execute", file]
        if os.geteuid() == 0:
            copy = self.folder / "execute"
            copy.write_bytes(pathlib.Path(words[0]).read_bytes())
            copy.chmod(0o755)
            words = [*as_linuxcnc(), copy, file]
        try:
            done = subprocess.run(
                words,
                capture_output=True,
                text=True,
                cwd=self.folder / "machine",
                # Where LinuxCNC keeps what its clients share.
                env=dict(os.environ, HOME=str(self.folder / "machine" / "home")),
                timeout=CLIENT_S,
                check=False,
            )
        except subprocess.TimeoutExpired as late:
            raise Failed("%s: no end after %.0f s in LinuxCNC" % (what, CLIENT_S)) from late
        if done.returncode != 0:
            raise Failed("%s: %s" % (what, done.stderr))
        self.mark()
        return self.samples(since)

    def mark(self):
        """Everything until now has been recorded, and belongs to earlier runs."""
        question = [*as_linuxcnc(), "halcmd", "getp", "sampler.1.curr-depth"]
        behind = subprocess.run(question, stdout=subprocess.PIPE, check=True).stdout
        # One more may have been taken from the sampler and not written yet.
        last = self.last_sample().cycle + int(behind) + 1
        begun = time.monotonic()
        while self.last_sample().cycle < last:
            if time.monotonic() - begun > RECORDER_S:
                raise Failed("the recorder of samples does not follow")
            time.sleep(0.01)
        return self.recorded.stat().st_size

    def place(self):
        """Where the set points are now."""
        return self.last_sample().set

    def last_sample(self):
        with open(self.recorded, "rb") as file:
            file.seek(max(self.recorded.stat().st_size - 1000, 0))
            lines = [line.split() for line in file.read().split(b"\n")[:-1]]
        return Sample([line for line in lines if len(line) == WORDS][-1])

    def samples(self, since):
        with open(self.recorded, encoding="ascii") as file:
            file.seek(since)
            lines = [line.split() for line in file]
        samples = [Sample(line) for line in lines if len(line) == WORDS]
        gaps = any(b.cycle != a.cycle + 1 for a, b in zip(samples, samples[1:]))
        if ["overrun"] in lines or gaps:
            raise Failed("the sampler has lost samples")
        return samples


def wave(origin, count, sense=1.0):
    """Steps of 1 mm along X, in bends that the acceleration of the machine allows.
    @param sense  1: X grows, -1: it falls"""
    path = [origin]
    for i in range(count):
        angle = 0.6 * math.sin(i / 40.0)
        x, y, z = path[-1]
        path.append((x + sense * math.cos(angle), y + math.sin(angle), z))
    return path


def write(machine, name, path):
    file = machine.folder / name
    lines = ["G21 G90 G94"] + ["G1 X%.4f Y%.4f Z%.4f F3000" % point for point in path] + ["M30"]
    file.write_text("\n".join(lines) + "\n", encoding="ascii")
    return file


def beginning(machine, count):
    """The first lines of a program that is always there."""
    whole = machine.source / "resources" / "programs" / "scorpion.tap"
    lines = whole.read_text(encoding="ascii").splitlines()[:count]
    file = machine.folder / whole.name
    file.write_text("\n".join([*lines, "G0 Z10", "M30", ""]), encoding="ascii")
    return file


def programs(machine):
    """Three of the corpus, where it is; otherwise those that are always there."""
    corpus = machine.source.parent / "shared" / "corpus"
    files = [corpus / name for name in CORPUS]
    if all(file.exists() for file in files):
        return files
    print("the corpus is not here: other programs are streamed", flush=True)
    square = [(0.0, 0.0, 5.0), (0.0, 0.0, -1.0), (30.0, 0.0, -1.0), (30.0, 30.0, -1.0)]
    square += [(0.0, 30.0, -1.0), (0.0, 0.0, -1.0), (0.0, 0.0, 5.0)]
    return [
        write(machine, "square.nc", square),
        write(machine, "wave.nc", wave((0.0, 0.0, 0.0), 150)),
        beginning(machine, 40),
    ]


def moving(samples):
    """Without what is before the first motion and after the last."""
    moves = [
        i for i in range(1, len(samples)) if math.dist(samples[i].set, samples[i - 1].set) > 1e-9
    ]
    return samples[moves[0] - 1 : moves[-1] + 1] if moves else []


def whole(points, start):
    """With the place of the start for axes that have not been moved yet."""
    return [tuple(s if p is None else p for p, s in zip(point, start)) for point in points]


def judge(what, samples, points, is_whole=True):
    """Follows the set points along the path: each point once, in order, nothing else.
    @param is_whole  to its end  @return how far they are from the path at most, in mm"""
    return follow(what, samples, points, is_whole)[0]


def follow(what, samples, points, is_whole=True):
    """@return as judge, and how far along the path they have come, in mm"""
    if not samples:
        raise Failed("%s: no motion was recorded" % what)
    previous = samples[0].set
    ends = [previous] + whole(points, previous)
    legs = [(a, b, math.dist(a, b)) for a, b in zip(ends, ends[1:])]
    begins = [0.0]
    for _, _, length in legs:
        begins.append(begins[-1] + length)
    leg, along, off = 0, 0.0, 0.0
    for sample in samples[1:]:
        place = sample.set
        step = math.dist(place, previous)
        if step == 0.0:
            continue
        previous = place
        # Corners are rounded, so the path is left out a little there, and never more.
        farthest = along + 1.5 * step + 3.0 * TOLERANCE_MM
        nearest, found = math.inf, None
        for i in range(leg, len(legs)):
            if begins[i] > farthest:
                break
            a, b, length = legs[i]
            if length == 0.0:
                continue
            share = sum((p - q) * (r - q) for p, q, r in zip(place, a, b)) / length**2
            share = min(max(share, 0.0), 1.0)
            distance = math.dist(place, [q + share * (r - q) for q, r in zip(a, b)])
            at = begins[i] + share * length
            if at < along - TOLERANCE_MM or at > farthest:
                continue
            nearest = min(nearest, distance)
            if distance <= TOLERANCE_MM and found is None:
                found = (i, at)
        if found is None:
            raise Failed(
                "%s: off the path, back on it or ahead of it by more than %.2f mm before point %d "
                "(line %d of the path, %.3f of %.3f mm; %s; nearest %.3f mm)"
                % (what, TOLERANCE_MM, leg + 1, leg + 1, along, begins[-1], place, nearest)
            )
        leg, along, off = found[0], max(along, found[1]), max(off, nearest)
    if is_whole and begins[-1] - along > TOLERANCE_MM:
        done = sum(1 for end in begins[1:] if end <= along + TOLERANCE_MM)
        raise Failed("%s: %d of %d points were executed" % (what, done, len(points)))
    return off, along


def rests_of(points, place, along):
    """The path from a place on it on, for each time it comes there after `along`."""
    begin = 0.0
    for i, (a, b) in enumerate(zip(points, points[1:])):
        length = math.dist(a, b)
        begin += length
        if length == 0.0 or begin < along - TOLERANCE_MM:
            continue
        share = sum((p - q) * (r - q) for p, q, r in zip(place, a, b)) / length**2
        share = min(max(share, 0.0), 1.0)
        if math.dist(place, [q + share * (r - q) for q, r in zip(a, b)]) <= TOLERANCE_MM:
            yield [place, *points[i + 1 :]]


def rest_of(points, place, along):
    """@return the first of them; nothing: the place is not on the path"""
    return next(rests_of(points, place, along), None)


def line_of(samples, tolerance_mm=0.002):
    """The path of the set points, as few points as stay so close to all of them."""
    places = [samples[0].set]
    places += [b.set for a, b in zip(samples, samples[1:]) if b.set != a.set]

    def off(place, a, b):
        along = [q - p for p, q in zip(a, b)]
        length = sum(x * x for x in along)
        share = sum((r - p) * x for p, r, x in zip(a, place, along)) / length if length else 0.0
        share = min(max(share, 0.0), 1.0)
        return math.dist(place, [p + share * x for p, x in zip(a, along)])

    kept, begin = [places[0]], 0
    for end in range(2, len(places)):
        # Only some between: a curve bends the same way all along such a piece.
        between = range(begin + 1, end, max((end - begin) // 8, 1))
        if end - begin > 400 or any(
            off(places[i], places[begin], places[end]) > tolerance_mm for i in between
        ):
            begin = end - 1
            kept.append(places[begin])
    return [*kept, places[-1]]


def changes(samples):
    """Where tool, spindle and coolant change, and to what."""
    pairs = zip(samples, samples[1:])
    return [(b.equipment, a.set) for a, b in pairs if b.equipment != a.equipment]


def same_job(what, plain, streamed):
    """Two executions of a program: the same path once, and the same tool, spindle and coolant at the
    same places. @return how far they are from each other at most, in mm"""
    if not moving(plain) and not moving(streamed):
        off = 0.0
    else:
        off = judge(what, moving(streamed), line_of(moving(plain)))
    first, second = changes(plain), changes(streamed)
    if [each[0] for each in first] != [each[0] for each in second]:
        raise Failed("%s: tool, spindle, coolant: %s plain, %s as a job" % (what, first, second))
    for (equipment, a), (_, b) in zip(first, second):
        if math.dist(a, b) > TOLERANCE_MM:
            raise Failed("%s: %s at %s plain, at %s as a job" % (what, equipment, a, b))
    return off


def store(machine, name, text):
    """A program that LinuxCNC can read."""
    file = machine.folder / name
    file.write_text(text + "\n", encoding="ascii", errors="replace")
    file.chmod(0o644)
    return file


def go_home(machine):
    """Between two executions: both begin at the same place, without a tool, and with nothing that the one
    before has left."""
    lines = ["G17 G21 G40 G49 G54 G90 G91.1 G94", "G92.1", "T0 M6", "G49 G53 G0 Z0", "G53 G0 X0 Y0", "M5 M9", "M2"]
    machine.executed("home", store(machine, "home.ngc", "\n".join(lines)))


def compare(machine, what, file, words):
    """A program executed by LinuxCNC alone, with the path tolerance of the loop in place of its own, and as a
    job. @return samples of both, and how far they are from each other at most, in mm"""
    text = file.read_text(encoding="ascii")
    lines = re.sub(r"(?i)G64(\s*P[\d.]+)?(\s*Q[\d.]+)?", "", text).splitlines()
    lines.insert(1 if lines and lines[0].strip() == "%" else 0, "G64 P0.01")
    go_home(machine)
    plain = machine.executed(what, store(machine, "plain-" + file.name, "\n".join(lines)))
    go_home(machine)
    since = machine.mark()
    report = json.loads(machine.answer(what, machine.job(file, [*words, "--from-start"])))
    machine.mark()
    job = machine.samples(since)
    if report["outcome"] != "completed":
        raise Failed("%s: %s" % (what, report))
    return plain, job, same_job(what, plain, job)


def from_first(samples, points):
    """Without the way to the first point."""
    start = next(i for i, s in enumerate(samples) if math.dist(s.set, points[0]) < TOLERANCE_MM)
    return samples[start:]


def even_part(samples, points):
    """Of a run along a wave: from 20 mm after its first point to 5 mm before its end."""
    samples = from_first(samples, points)
    first, last = points[0][0] + 20.0, points[-1][0] - 5.0
    begin = next(i for i, s in enumerate(samples) if s.set[0] > first)
    end = next(i for i in range(begin, len(samples)) if samples[i].set[0] > last)
    return samples[begin:end]


def stops(samples, below_mm_per_s=0.01):
    """Standstills between the first motion and the last: (first cycle, cycles)."""
    found, begin = [], None
    for i, sample in enumerate(samples):
        if sample.speed < below_mm_per_s:
            begin = i if begin is None else begin
        elif begin is not None:
            found.append((begin, i - begin))
            begin = None
    return found
