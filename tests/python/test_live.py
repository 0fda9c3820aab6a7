# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points that a script computes while the machine moves."""

import math
import subprocess
import sys

import pytest

import rivulet

BOX = ((-20, -20, 0), (20, 20, 100))
SIMULATED = {"preset": "dmu75-arrays"}


def script(machine, **options):
    """The same for each kind of machine. @return  the run"""
    with rivulet.live(box=BOX, feed=1200, machine=machine, **options) as run:
        assert run.position == (0.0, 0.0, 50.0)
        most = 0
        for i in range(1, 101):
            run.move(0.1 * i, 0.05 * i, feed_factor=0.5 if i > 50 else 1.0)
            most = max(most, i - run.executed)
    assert most <= 21  # three windows of 7
    return run


@pytest.mark.parametrize("where", ["simulate", "machine"])
def test_a_script_moves(where, request):
    if where == "simulate":
        run = script(where, **SIMULATED)
    else:
        run = script(request.getfixturevalue(where))
    assert (run.report.outcome, run.report.finding, run.report.executed) == ("completed", "faultless", 100)
    assert run.executed == run.accepted == 100 and run.position == (10.0, 5.0, 50.0)
    assert run.late >= 0 and run.state.name == "done"


def test_an_exception_holds_the_axes(machine):
    """Without the stop, all that was sent would be executed."""
    with pytest.raises(ZeroDivisionError):
        with rivulet.live(box=BOX, feed=60, machine=machine, ahead=40) as run:
            for i in range(1, 41):
                run.move(0.2 * i, 0)
            while run.executed < 2:
                run.move(8, 0.001)
            print(1 / 0)
    report = run.report
    assert report.outcome == "stopped" and report.left_held
    assert report.executed < 40 and report.feed[-1].percent == 0.0 and report.feed[-1].stood.after_s is not None
    assert run.state.stands


@pytest.mark.parametrize(
    "point, said",
    [((30.0, 0.0), "outside the box"), ((8.0, 0.0), "step"), ((float("nan"), 0.0), "finite"), ((), "coordinates")],
)
def test_a_point_that_was_not_agreed(point, said):
    with pytest.raises(rivulet.RivuletError, match=said):
        with rivulet.live(box=BOX, feed=1200, **SIMULATED) as run:
            run.move(0.5, 0)
            run.move(*point)
            for i in range(40):
                run.move(0.5 + 0.1 * i, 0)
    assert run.report.executed <= 1


def test_a_box_that_nobody_can_keep():
    with pytest.raises(rivulet.BadInput, match="box"):
        rivulet.live(box=((5, 0, 0), (0, 1, 1)), feed=100)


def test_an_option_that_does_not_exist():
    with pytest.raises(rivulet.TooOld, match="--no-such"):
        rivulet.live(box=BOX, feed=100, no_such=1)


def test_two_scripts_at_once(machine):
    """The second one is refused, and the first one goes on."""
    with rivulet.live(box=BOX, feed=600, machine=machine) as first:
        for i in range(1, 20):
            first.move(0.1 * i, 0)
        while first.executed < 2:
            assert first._process.poll() is None, first.messages
        with pytest.raises(rivulet.RivuletError) as caught:
            with rivulet.live(box=BOX, feed=600, machine=machine) as second:
                for i in range(40):
                    second.move(0.1 * i, 0)
        assert caught.value.exit_code == 2, caught.value
        for i in range(20, 40):
            first.move(0.1 * i, 0)
    assert first.report.finding == "faultless" and first.report.executed == 39


def test_the_machine_goes_away(machine):
    """@return  an error of the connection, soon"""
    with pytest.raises(rivulet.RivuletError) as caught:
        with rivulet.live(box=BOX, feed=60, machine="opc.tcp://127.0.0.1:1") as run:
            run.move(0, 0)
    assert caught.value.exit_code == 3


@pytest.mark.parametrize("name", ["spiral.py", "force.py", "camera.py"])
def test_examples(examples, name):
    done = subprocess.run([sys.executable, examples / name], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    if name != "force.py":
        assert "completed, faultless" in done.stdout
    else:
        assert float(done.stdout.split()[2]) < 20.0, done.stdout
    print(done.stdout)


def test_the_line_that_move_sends(monkeypatch):
    sent = []
    run = rivulet.LiveRun.__new__(rivulet.LiveRun)
    monkeypatch.setattr(run, "_send", sent.append, raising=False)
    monkeypatch.setattr(run, "_wait_until", lambda is_so: None, raising=False)
    monkeypatch.setattr(run, "_require_alive", lambda: None, raising=False)
    run._feed, run._given = 1200.0, 0
    run.move(1, 2.5, feed_factor=0.5)
    run.move(math.pi, feed=100)
    assert sent == ["X1.000000 Y2.500000 F600", "X3.141593 F100"]
