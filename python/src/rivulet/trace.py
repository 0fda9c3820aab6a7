# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the axes did: recordings, traces of a control, files of other tools (docs/traces.md)."""

from __future__ import annotations

import os
import pathlib
import re
import tempfile
from typing import Any, Dict, Iterator, Optional

from . import columns, command
from .report import Report


class Trace:
    """A trace and its analysis. trace["x_act"] are the samples of a signal, trace.times["x_act"] their
    times in s; arrays of NumPy, if it is installed."""

    def __init__(self, path: command.PathLike, options: Dict[str, Any]) -> None:
        self.path = os.fspath(path)
        self._words = [self.path, *command.words_of(options)]
        self.report: Report = command.ask(["analyse", *self._words], (0, 1))
        self._units: Dict[str, str] = {}
        self._times: Dict[str, Any] = {}
        self._signals: Optional[Dict[str, Any]] = None

    def __repr__(self) -> str:
        return "rivulet.analyse(%r)" % self.path

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "report":
            raise AttributeError(name)
        return getattr(self.report, name)

    def __getitem__(self, signal: str) -> Any:
        return self.signals[signal]

    def __iter__(self) -> Iterator[str]:
        return iter(self.signals)

    @property
    def signals(self) -> Dict[str, Any]:
        """All signals by name. What is not there is not a number."""
        if self._signals is None:
            self._signals = self._read()
        return self._signals

    @property
    def times(self) -> Dict[str, Any]:
        """Of the samples of each signal, s."""
        return self._times if self.signals else {}

    @property
    def units(self) -> Dict[str, str]:
        """Of each signal: "mm"; "": none."""
        return self._units if self.signals else {}

    def _read(self) -> Dict[str, Any]:
        with tempfile.TemporaryDirectory(prefix="rivulet-") as folder:
            saved = pathlib.Path(folder) / "signals.csv"
            command.call(["analyse", *self._words, "--save", saved], (0, 1))
            table = columns.read(saved.read_text(encoding="utf-8"), ";")
        signals: Dict[str, Any] = {}
        times: Any = columns.array([])
        for heading, texts in table.items():
            name, _, unit = heading.partition(" [")
            values = columns.array([columns.number(text) for text in texts if text])
            if re.fullmatch(r"t( \d+)?", name):
                times = values
                continue
            signals[name] = values
            self._units[name] = unit.partition("]")[0]
            self._times[name] = times
        return signals


def analyse(path: command.PathLike, program: Optional[command.PathLike] = None, **options: Any) -> Trace:
    """@param program  the NC program that the trace should show; a recording has its own points
    @param options  those of `rivulet-cli analyse`: map="x_act=X1:mm", rate=500
    @raise RuleApplies  with fail_if="skipped>0" """
    return Trace(path, {"program": program, **options})
