# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The benchmark of emulators: what is scored, and its open set from recording to score."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

from rivulet import Emulator

FOLDER = pathlib.Path(os.environ["RIVULET_SOURCE"]) / "bench" / "emulators"


def run(*words):
    return subprocess.run([sys.executable, *words], capture_output=True, text=True, check=False)


def scores(text):
    """RMS of the worst recording by the names of the models, µm."""
    return {name: float(rms) for name, rms in re.findall(r"^worst +(.*?) +RMS +([\d.]+)", text, re.M)}


@pytest.fixture
def bench(tmp_path):
    """Recordings of a machine that is a lag of 20 ms and nothing else: one to learn from, one held out."""
    shutil.copy(FOLDER / "score.py", tmp_path)
    (tmp_path / "recordings.tsv").write_text("open\tlearn\ta\t-\nopen\ttest\tb\t-\n")
    for name, speed in (("a", 10.0), ("b", 50.0)):
        rows = []
        for t in (0.01 * i for i in range(101)):
            x, late = speed * t, speed * (t - 0.02)
            rows.append("%.2f,%.6f,%.6f,%.6f,%.6f" % (t, x, -x, late, -late))
        (tmp_path / (name + ".csv")).write_text("\n".join(["t_s,x_cmd,y_cmd,x_fb,y_fb", *rows]) + "\n")
    return tmp_path


def answer(bench, factor):
    folder = bench / "answers"
    folder.mkdir(exist_ok=True)
    rows = [line.split(",") for line in (bench / "b.csv").read_text().splitlines()[1:]]
    lines = ["%.6f,%.6f" % (float(a) * factor, float(b) * factor) for _, _, _, a, b in rows]
    (folder / "b.csv").write_text("\n".join(["X_emulated,Y_emulated", *lines]) + "\n")
    return folder


def test_scores(bench):
    done = run(bench / "score.py", "open", bench, answer(bench, 1.0))
    assert done.returncode == 0, done.stderr
    found = scores(done.stdout)
    assert found["set point"] == pytest.approx(50 * 20 * 2**0.5, abs=0.01)  # 50 mm/s, 20 ms, two axes
    assert found["set point, late"] < 0.01 and found["emulator"] < 0.01
    assert "lags 20.00 and 20.00 ms" in done.stdout
    worse = scores(run(bench / "score.py", "open", bench, answer(bench, 1.01)).stdout)
    assert worse["emulator"] > 100.0


def test_what_is_no_answer(bench):
    folder = answer(bench, 1.0)
    file = folder / "b.csv"
    file.write_text("\n".join(file.read_text().splitlines()[:-1]) + "\n")
    assert "100 rows" in run(bench / "score.py", "open", bench, folder).stderr
    (bench / "recordings.tsv").write_text("open\tlearn\ta\t%s\n" % ("0" * 64))
    assert "not the recording" in run(bench / "score.py", "open", bench).stderr


def test_the_open_set(tmp_path):
    """Rivulet is far below both null models; the folder has the recordings it names."""
    done = run(FOLDER / "record.py", tmp_path / "recordings")
    assert done.returncode == 0, done.stderr
    files = sorted((tmp_path / "recordings").glob("*.csv"))
    listed = [line.split("\t") for line in (FOLDER / "recordings.tsv").read_text().splitlines()]
    assert [file.stem for file in files] == sorted(name for which, _, name, _ in listed if which == "open")
    learned = [file for file in files if file.stem.startswith("learn")]
    emulator = Emulator.learn(*learned, output=tmp_path / "mine.toml")
    (tmp_path / "answers").mkdir()
    for file in files:
        if file not in learned:
            emulator.simulate(file, output=tmp_path / "answers" / file.name)
    done = run(FOLDER / "score.py", "open", tmp_path / "recordings", tmp_path / "answers")
    assert done.returncode == 0, done.stderr
    found = scores(done.stdout)
    print(done.stdout)
    assert found["set point, late"] < found["set point"]
    assert found["emulator"] < 0.05 * found["set point, late"]
