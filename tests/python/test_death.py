# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A script that dies in mid-motion, over real sockets: the axes stand, though there are points left."""

import os
import signal
import subprocess
import sys

from rivulet import command

SCRIPT = """
import sys, rivulet
with rivulet.live(box=((-1, -20, 0), (90, 20, 100)), feed=300, machine=sys.argv[1], ahead=1000,
                  step_max=6, start_within=6, **({"silence_limit": float(sys.argv[2])} if len(sys.argv) > 2 else {})) as run:
    for i in range(1, 15):
        run.move(5.0 * i, 0)
    while run.executed < 1:
        assert run._process.poll() is None, run.messages
    print(run._process.pid, flush=True)
    run.wait()
"""


def in_mid_motion(machine, *words):
    """@return  the script, and the process of its rivulet-cli; each of its two windows takes 7 s"""
    script = subprocess.Popen([sys.executable, "-c", SCRIPT, machine, *words], stdout=subprocess.PIPE, text=True)
    line = script.stdout.readline()
    assert line, "the script has ended"
    return script, int(line)


def on_control(machine):
    """What the control says of its run. The question takes longer than the silence limit: whether the
    run has its client is watched for 2.5 s."""
    return command.ask(["runs", "--endpoint", machine]).on_control


def kill(script, *processes):
    for process in processes:
        os.kill(process, signal.SIGKILL)
    script.kill()
    script.wait()
    script.stdout.close()




def requires_rest(machine):
    """The program would execute both windows that it has in 14 s."""
    for _ in range(8):
        seen = on_control(machine)
    assert seen is not None, "the program has ended"
    assert not seen.has_client
    assert seen.windows_executed < seen.windows_delivered, "all that was sent has been executed"


def test_the_script_dies(machine):
    """Its rivulet-cli holds the axes at once, and leaves them held."""
    script, _ = in_mid_motion(machine)
    kill(script)
    requires_rest(machine)


def test_both_die(machine):
    """Nobody can say anything: the control stops the axes, because it hears nothing."""
    script, client = in_mid_motion(machine)
    kill(script, client)
    requires_rest(machine)
