# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Programs of the corpus as whole jobs on LinuxCNC, beside LinuxCNC alone (rig.compare), as a table.

usage: jobs.py SOURCE BRIDGE CLI DOCS   Writes DOCS/linuxcnc-jobs.md. Exit code 77: as test_linuxcnc."""

import datetime
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import rig  # noqa: E402  beside this file

LONGEST_S = 12.0
REACH_MM = 450.0  # of the axes
LINES = (100_000, 400, 200, 100, 50, 25)
ENDINGS = (".ngc", ".nc", ".tap", ".gcode")
RAPID_MM_PER_S = 100.0


def facts(machine, file):
    """What Rivulet says of the path; nothing: it does not read the program."""
    words = ["check", "--json", "--dialect", "linuxcnc", "--units", "mm", file]
    try:
        output = machine.client(*words).communicate()[0]
        found = json.loads(output)
    except (ValueError, subprocess.SubprocessError):
        return None
    return found if "bounds" in found else None


def lasts_s(found):
    feeds = sorted(found["feeds"]) or [1000.0]
    feed = max(feeds[len(feeds) // 4], 1.0) / 60.0
    return found["length_mm"]["cut"] / feed + found["length_mm"]["rapid"] / RAPID_MM_PER_S


def beginning(machine, source):
    """As many of its first lines as fit into the time. @return file and their number; nothing: none"""
    lines = source.read_text(encoding="utf-8", errors="replace").splitlines()
    for count in LINES:
        part = [line for line in lines[:count] if line.strip() != "%"]
        if not any(re.match(r"(?i)^[^(;]*\bM0?(2|30)\b", line) for line in part):
            part.append("M2")
        file = rig.store(machine, re.sub(r"\W", "_", source.stem) + ".ngc", "\n".join(part))
        found = facts(machine, file)
        if found is None or lasts_s(found) > LONGEST_S or count >= 2 * len(lines) and count < 1000:
            continue
        far = [abs(x) for axis in found["bounds"].values() for x in axis if x is not None]
        return (file, min(count, len(lines)), len(lines)) if max(far, default=0.0) < REACH_MM else None
    return None


def row(machine, corpus, source):
    name = str(source.relative_to(corpus))
    part = beginning(machine, source)
    if part is None:
        return None
    file, count, whole = part
    what = name if count == whole else "%s, first %d lines of %d" % (name, count, whole)
    words = ["job", file, "--dialect", "linuxcnc", "--control", "linuxcnc", "--units", "mm", "--json"]
    made = machine.client(*words, "--output", machine.folder / "made")
    output = made.communicate()[0]
    if made.returncode != 0:
        said = re.search(r'"message": "((?:[^"\\\\]|\\\\.)*)', output)
        return (what, "", "refused: " + (said.group(1) if said else output.strip()[:200]))
    try:
        plain, job, off = rig.compare(machine, what, file, ["--units", "mm", *rig.WINDOW])
    except rig.Failed as why:
        machine.executed("abort", "--abort")
        said = re.search(r'"message": "((?:[^"\\\\]|\\\\.)*)', str(why))
        return (what, "", said.group(1) if said else str(why).splitlines()[0].replace(what + ": ", ""))
    times = [len(rig.moving(samples)) * rig.CYCLE_S for samples in (job, plain)]
    result = "%.3f mm, %d changes" % (off, len(rig.changes(job)))
    return (what, "%.1f s, %.1f s" % tuple(times), result)


def measure(machine, corpus):
    rig.CLIENT_S = 4.0 * LONGEST_S
    machine.calibrate()
    found = []
    for source in sorted(corpus.rglob("*")):
        if source.suffix.lower() not in ENDINGS or source.stat().st_size > 1_000_000:
            continue
        each = row(machine, corpus, source)
        if each is not None:
            found.append(each)
            print(*each, sep=" | ", flush=True)
    return found


def page(rows):
    same = sum(1 for each in rows if each[1])
    lines = [
        "<!--",
        "SPDX-" "FileCopyrightText: 2026 The Rivulet authors",
        "SPDX-" "License-Identifier: GPL-3.0-or-later",
        "-->",
        "# LinuxCNC: whole jobs beside LinuxCNC alone",
        "",
        "Made by `scripts/linuxcnc --jobs` on %s. Each program of the corpus, or the" % datetime.date.today(),
        "beginning of one that takes longer than %.0f s, was executed by LinuxCNC alone (with `G64 P0.01`)" % LONGEST_S,
        "and as a whole job by Rivulet, on the simulated machine of `examples/linuxcnc`. LinuxCNC's own sampler",
        "has recorded both in each servo cycle. A row with times: the job has gone the same way once, no farther",
        "from it than the third column says, and tool, spindle and coolant have changed in the same order at the",
        "same places. The others were refused before anything moved, or say what differs. Times are of one run each, on a",
        "computer that also did other things.",
        "",
        "%d of %d programs were the same." % (same, len(rows)),
        "",
        "| program | job, LinuxCNC alone | farthest from each other, changes of tool, spindle and coolant |",
        "|---|---|---|",
    ]
    lines += ["| %s | %s | %s |" % (a, b, c.replace("|", "/")) for a, b, c in rows]
    return "\n".join([*lines, ""])


def main():
    source, bridge, cli, docs = sys.argv[1:5]
    corpus = pathlib.Path(source).resolve().parent / "shared" / "corpus"
    if not corpus.is_dir():
        print("skipped: the corpus is not here")
        return rig.SKIPPED
    with rig.Machine(source, bridge, cli) as machine:
        rows = measure(machine, corpus)
    (pathlib.Path(docs) / "linuxcnc-jobs.md").write_text(page(rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
