# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""NC programs: read, judged, streamed."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Optional

from . import columns, command
from .report import Report
from .run import start

NOT_OK = (0, 1)  # the command ran, and its result may be that something is wrong


class Program:
    """An NC program. @param options  how it is read, for all that is asked of it: dialect="fanuc",
    units="mm", accept=["M90"] (docs/cli.md, Reading programs)"""

    def __init__(self, path: command.PathLike, **options: Any) -> None:
        self.path = os.fspath(path)
        self._options = options

    def __fspath__(self) -> str:
        return self.path

    def __repr__(self) -> str:
        return "rivulet.open(%r)" % self.path

    def _words(self, options: Dict[str, Any]) -> List[str]:
        return command.words_of({**self._options, **options})

    def check(self, **options: Any) -> Report:
        """The findings: `streamable`, `diagnostics`, `bounds`, `length_mm`, …"""
        return command.ask(["check", self.path, *self._words(options)], NOT_OK)  # type: ignore[no-any-return]

    def points(self, **options: Any) -> Dict[str, Any]:
        """The points by columns: "line", "kind" (text), "x_mm", "feed_mm_per_min", … Numbers are arrays of
        NumPy, if it is installed; what is not known is not a number."""
        _, text = command.call(["points", self.path, *self._words(options)])
        table = columns.read(text)
        return {
            name: values if name == "kind" else columns.array([columns.number(value) for value in values])
            for name, values in table.items()
        }

    def judge(self, **options: Any) -> Report:
        """The verdict before anything moves: `feasible`, `limiting`, `feed_mm_per_min_max`, …"""
        return judge(self.path, **{**self._options, **options})

    def stream(self, machine: str = command.SIMULATE, **options: Any) -> Report:
        """Runs the program and waits for its end. @return  the report @raise RunFailed  its `report`
        is that of the run"""
        with start(self.path, machine, **{**self._options, **options}) as run:
            return run.wait()


def open(path: command.PathLike, **options: Any) -> Program:  # noqa: A001  rivulet.open
    """An NC program: see Program. @raise BadInput  it cannot be read"""
    program = Program(path, **options)
    program.check()
    return program


def check(path: command.PathLike, **options: Any) -> Report:
    return Program(path).check(**options)


def judge(path: Optional[command.PathLike] = None, **options: Any) -> Report:
    """@param path  of a program; None: points that are d_min (mm) apart"""
    words = [] if path is None else ["--program", path]
    return command.ask(["feasibility", *words, *command.words_of(options)], NOT_OK)  # type: ignore[no-any-return]


def stream(path: command.PathLike, machine: str = command.SIMULATE, **options: Any) -> Report:
    """@param machine  "simulate", the address of a control, or "service:" and the address of a service,
    which has the program in its folder of jobs"""
    if machine.startswith("service:"):
        from .service import Service

        with Service(machine[len("service:") :]) as service:
            service.load(path, **options)
            service.start()
            return service.wait()
    return Program(path).stream(machine, **options)
