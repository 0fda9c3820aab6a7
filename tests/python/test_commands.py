# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What waits for its result: reading, judging, streaming, analysing; and what can be wrong with it."""

import math
import os
import stat

import pytest

import rivulet
from rivulet import columns, command


def program_that(tmp_path, text):
    """A program in the place of rivulet-cli."""
    file = tmp_path / "rivulet-cli"
    file.write_text("#!/bin/sh\n" + text)
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return str(file)


def test_options_are_those_of_the_command_line():
    options = {"feed": 1000, "points": 7, "motion_only": True, "record": None, "json": False, "box": (1.0, 2.5)}
    words = ["--feed", "1000", "--points", "7", "--motion-only", "--box", "1.0", "2.5"]
    assert command.words_of(options) == words
    assert command.words_of({"accept": ["M90", "M91"]}) == ["--accept", "M90", "--accept", "M91"]


def test_a_program_is_read_and_judged(part):
    program = rivulet.open(part)
    seen = program.check()
    assert seen.streamable and seen.bounds.X == [1.0, 15.0]
    points = program.points()
    assert len(points["x_mm"]) == 30 and points["x_mm"][-1] == 15.0 and points["kind"][0] == "line"
    assert program.judge(feed=1000).feasible
    assert not rivulet.judge(d_min=0.01, feed=3000, method="position").feasible
    with pytest.raises(AttributeError, match="streamable"):
        print(seen.no_such_member)


def test_without_numpy_numbers_are_lists(monkeypatch):
    monkeypatch.setattr(columns, "numpy", None)
    assert columns.array([1.0, 2.0]) == [1.0, 2.0]


def test_findings_are_a_result_and_no_exception(tmp_path):
    file = tmp_path / "wrong.mpf"
    file.write_text("G71 G90\nG1 X1 F100\nNO_SUCH_CYCLE(1)\nM30\n")
    seen = rivulet.check(file)
    assert not seen.streamable
    assert [finding.line for finding in seen.diagnostics if finding.severity == "error"] == [3]


def test_a_file_that_is_missing(tmp_path):
    with pytest.raises(rivulet.BadInput, match="does not exist") as caught:
        rivulet.open(tmp_path / "none.mpf")
    assert caught.value.exit_code == 2 and caught.value.code.startswith("gcode:")


@pytest.mark.parametrize("where", ["simulate", "machine"])
def test_a_program_is_streamed(part, where, request):
    address = where if where == "simulate" else request.getfixturevalue(where)
    report = rivulet.stream(part, address, motion_only=True)
    assert (report.outcome, report.finding, report.executed) == ("completed", "faultless", 30)


def test_a_run_is_held_and_goes_on(part, machine):
    with rivulet.start(part, machine, motion_only=True, feed=120) as run:
        while run.executed < 2:
            assert run._process.poll() is None, run.messages
        run.hold()
        while not run.state.stands:
            assert run._process.poll() is None, run.messages
        assert run.state.holds and run.state.override_percent == 0.0
        held = run.executed
        run.override(120)
        run.resume()
    assert held < 30 and run.report.executed == 30 and run.report.finding == "faultless"
    assert [order.percent for order in run.report.feed] == [0.0, 120.0]
    assert run.position is not None and math.dist(run.position[:2], (15.0, 15.0)) < 5.0


def test_a_stop_is_no_error(part, machine):
    run = rivulet.start(part, machine, motion_only=True, feed=120)
    while run.executed < 2:
        assert run._process.poll() is None, run.messages
    report = run.stop()
    assert report.outcome == "stopped" and report.executed < 30 and report.left_held


def test_a_whole_job_obeys_too(machine, tmp_path):
    """Its blocks for the control make a job of the program."""
    file = tmp_path / "job.mpf"
    file.write_text("G71 G90 G94 F120\nM8\n" + "".join("G1 X%d\n" % i for i in range(1, 31)) + "M9\nM30\n")
    run = rivulet.start(file, machine)
    while run.executed < 2:
        assert run._process.poll() is None, run.messages
    run.hold()
    while not run.state.stands:
        assert run._process.poll() is None, run.messages
    report = run.stop()
    assert report.outcome == "stopped" and report.stretches == 1 and report.executed_points < 30


def test_the_end_of_orders_is_that_of_standard_input(part):
    for words in (["--end-with-orders"], ["--end-with-orders", "--orders", str(part)]):
        with pytest.raises(rivulet.BadInput, match="--orders"):
            command.call(["stream", part, "--simulate", *words])


def test_a_run_that_is_wrong_is_an_exception(tmp_path):
    file = tmp_path / "dense.mpf"
    steps = "".join("G1 X%.2f\n" % (0.02 * i) for i in range(1, 60))
    file.write_text("G71 G90 G94 F500\n" + steps + "M30\n")
    options = {"motion_only": True, "accept_infeasible": True, "method": "position", "delta": 0.02}
    with pytest.raises(rivulet.RunFailed) as caught:
        rivulet.stream(file, feed=3000, **options)
    assert caught.value.report.finding == "faulty"


def test_nobody_answers(part):
    with pytest.raises(rivulet.ConnectionFailed) as caught:
        rivulet.stream(part, "opc.tcp://127.0.0.1:1", motion_only=True)
    assert caught.value.exit_code == 3


def test_no_rivulet_cli(part, monkeypatch):
    monkeypatch.setenv("RIVULET_CLI", "/nowhere/rivulet-cli")
    with pytest.raises(rivulet.NotFound, match="RIVULET_CLI"):
        rivulet.check(part)
    monkeypatch.delenv("RIVULET_CLI")
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(rivulet.NotFound, match="install"):
        rivulet.stream(part)


def test_an_older_rivulet_cli(part, tmp_path, monkeypatch):
    text = "echo 'The following argument was not expected: --progress' >&2\nexit 2\n"
    monkeypatch.setenv("RIVULET_CLI", program_that(tmp_path, text))
    with pytest.raises(rivulet.TooOld, match="--progress"):
        rivulet.stream(part)


def test_a_rivulet_cli_that_tells_otherwise(part, tmp_path, monkeypatch):
    """It is stopped: cat ends with its orders."""
    text = 'for word; do :; done\necho \'{"rivulet_progress":9}\' >"${word}"\ncat >/dev/null\nexit 1\n'
    monkeypatch.setenv("RIVULET_CLI", program_that(tmp_path, text))
    with pytest.raises(rivulet.TooOld, match="version 9"):
        rivulet.stream(part)


def test_a_trace(part, tmp_path):
    recording = tmp_path / "run.rivulet"
    rivulet.stream(part, motion_only=True, record=recording)
    trace = rivulet.analyse(recording)
    assert trace.judged and trace.executed == 30
    assert abs(max(trace["x_act"]) - 15.0) < 0.01 and trace.units["x_act"] == "mm"
    assert len(trace.times["x_act"]) == len(trace["x_act"])
    again = rivulet.analyse(recording)  # whatever is asked for first
    assert again.units["x_act"] == "mm" and rivulet.analyse(recording).times["x_act"][-1] > 1.0
    with pytest.raises(rivulet.RuleApplies):
        rivulet.analyse(recording, fail_if="executed>1")
    with pytest.raises(rivulet.BadInput):
        rivulet.analyse(tmp_path / "none.csv")


def test_an_emulator_learns_from_a_run(part, tmp_path):
    recording = tmp_path / "run.rivulet"
    rivulet.stream(part, motion_only=True, record=recording)
    emulator = rivulet.Emulator.learn(recording, output=tmp_path / "mine.toml")
    assert os.path.exists(emulator.path) and emulator.report
    assert emulator.test(recording)
    emulated = emulator.simulate(recording)
    assert len({len(values) for values in emulated.values()}) == 1
    asked = emulator.design(tmp_path / "next.mpf", box=((0, 0), (20, 10)), feeds=(600, 3000), seconds=3)
    assert asked and rivulet.check(tmp_path / "next.mpf").streamable
    report = rivulet.stream(part, motion_only=True, preset=emulator)  # it is a machine, too
    assert report.finding == "faultless"
