# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A computer of its own for each test: folders, virtual machines and services that end with it."""

import ctypes
import os
import pathlib
import signal
import subprocess

import pytest

import rivulet

PR_SET_PDEATHSIG = 1
END_S = 60.0

PART = "G71 G90 G94 F1500\n" + "".join("G1 X%d Y%d\n" % ((i + 1) // 2, i // 2) for i in range(1, 31)) + "M30\n"


def dies_with_test():
    """A test that takes too long is killed, and its servers must not stay behind."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


@pytest.fixture(autouse=True)
def folders(tmp_path, monkeypatch):
    for name in ("XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"):
        folder = tmp_path / name.lower()
        folder.mkdir()
        monkeypatch.setenv(name, str(folder))


@pytest.fixture
def part(tmp_path):
    file = tmp_path / "part.mpf"
    file.write_text(PART)
    return file


class Server:
    """A program that prints its address when it is ready."""

    def __init__(self, *words):
        self.process = subprocess.Popen(
            [str(word) for word in words], stdout=subprocess.PIPE, text=True, preexec_fn=dies_with_test
        )
        self.address = self.process.stdout.readline().split()[-1].rstrip(".")

    def end(self):
        self.process.terminate()
        try:
            self.process.wait(END_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()


@pytest.fixture
def machine():
    """The address of a virtual machine over real sockets."""
    server = Server(os.environ["RIVULET_MACHINE"], "--port", "0", "--preset", "dmu75-arrays")
    yield server.address
    server.end()


@pytest.fixture
def service(machine, tmp_path):
    """The address of a service of that machine, whose folder of jobs has part.mpf."""
    jobs = tmp_path / "jobs"
    jobs.mkdir()
    (jobs / "part.mpf").write_text(PART)
    server = Server(os.environ["RIVULET_SERVICE"], "run", machine, "--port", "0", "--jobs", jobs)
    while rivulet.Service(server.address).show()["Monitoring/IsConnected"] != "true":
        assert server.process.poll() is None
    yield server.address
    server.end()


@pytest.fixture
def examples():
    return pathlib.Path(os.environ["RIVULET_SOURCE"]) / "examples" / "python"
