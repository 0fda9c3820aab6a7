# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A machine that has a service (docs/service.md), on this computer and without encryption. A run of a
service goes on if this program dies: the service is its client."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import time
from types import TracebackType
from typing import Any, Dict, Optional, Type

from . import command
from .errors import BadInput, ConnectionFailed, RivuletError, RunFailed
from .report import Report, report_of

NO_SERVICE = 3  # exit code of rivulet-service
REFUSED = 1
LOOK_S = 0.1
AGAIN = "again in a second."  # the same call has the answer then


class Service:
    """A context: leaving it by an exception stops the run that was started in it.
    @param address  "opc.tcp://127.0.0.1:4841" """

    def __init__(self, address: str) -> None:
        self.address = address
        self._has_started = False

    def show(self) -> Dict[str, str]:
        """All variables by their identifiers, as text: "Monitoring/State"."""
        lines = self._run("show", self.address).splitlines()
        return dict(line.partition("=")[::2] for line in lines)

    def call(self, method: str, *inputs: str) -> str:
        """@return  what it answers; of a preflight, the confirmation of a start @raise BadInput  refused"""
        while True:
            try:
                lines = self._run("call", self.address, method, *inputs).splitlines()
                break
            except BadInput as refused:
                if not str(refused).endswith(AGAIN):
                    raise
                time.sleep(1.0)
        for line in lines:
            if line.startswith("confirmation: "):
                return line.partition(": ")[2]
        return "\n".join(lines)

    def load(self, path: command.PathLike, **settings: Any) -> None:
        """@param path  in the folder of jobs @param settings  feed=1500, points=7"""
        text = ";".join("%s=%s" % (name, command.text_of(value)) for name, value in settings.items())
        self.call("LoadJob", os.fspath(path), text)

    def start(self) -> None:
        confirmation = self.call("Preflight")
        self._has_started = True
        self.call("Start", confirmation)

    def hold(self) -> None:
        self.call("Hold")

    def resume(self) -> None:
        self.call("Resume")

    def override(self, percent: float) -> None:
        self.call("SetOverride", "%g" % percent)

    def stop(self) -> None:
        self.call("Stop")

    @property
    def executed(self) -> int:
        return int(self.show()["Production/ActiveProgram/PointsDone"])

    @property
    def late(self) -> int:
        return int(self.show()["Monitoring/LateWindows"])

    @property
    def state(self) -> str:
        return self.show()["Monitoring/State"]

    def wait(self) -> Report:
        """Until the run has ended. @raise RunFailed  it was not completed"""
        while True:
            shown = self.show()
            is_active = shown["Monitoring/State"] in ("armed", "running", "holding", "stopping")
            # Right after the start, the service may not have heard of the run yet.
            if not is_active and (shown["Session/LastOutcome"] or not self._has_started):
                break
            time.sleep(LOOK_S)
        self._has_started = False
        file = pathlib.Path(shown["Session/LastReport"])
        report = report_of(json.loads(file.read_text(encoding="utf-8"))) if file.is_file() else Report()
        if shown["Session/LastOutcome"] != "completed":
            raise RunFailed(shown["Notification/Message"] or shown["Session/LastOutcome"], report=report)
        return report  # type: ignore[no-any-return]

    def __enter__(self) -> "Service":
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        if kind is not None and self._has_started:
            self.stop()

    def _run(self, *words: str) -> str:
        done = subprocess.run(
            [command.find("rivulet-service"), *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="replace",
            check=False,
        )
        if done.returncode == 0:
            return done.stdout
        said = (done.stdout if done.returncode == REFUSED else done.stderr).strip()
        if done.returncode == NO_SERVICE:
            raise ConnectionFailed(said, exit_code=done.returncode)
        if done.returncode == REFUSED or done.stderr:
            raise BadInput(said, exit_code=done.returncode)
        raise RivuletError(said, exit_code=done.returncode)
