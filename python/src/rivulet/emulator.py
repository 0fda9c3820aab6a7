# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A digital emulator of the axes, learned from traces (docs/emulator.md)."""

from __future__ import annotations

import os
from typing import Any, Dict, Sequence, Tuple

from . import columns, command
from .report import Report


class Emulator:
    """@param path  file of the emulator, which is a preset of the virtual machine too"""

    def __init__(self, path: command.PathLike) -> None:
        self.path = os.fspath(path)
        self.report = Report()

    def __fspath__(self) -> str:
        return self.path

    @classmethod
    def learn(cls, *traces: command.PathLike, output: command.PathLike, **options: Any) -> "Emulator":
        """Finds the parameters of each axis. @param output  file, .toml; what was found is in `report`"""
        emulator = cls(output)
        emulator.report = command.ask(
            ["emulator", "learn", *traces, "--output", output, *command.words_of(options)], (0, 1)
        )
        return emulator

    def test(self, *traces: command.PathLike, **options: Any) -> Any:
        """How far it is off on other runs."""
        return self._ask("test", traces, options)

    def monitor(self, *traces: command.PathLike, **options: Any) -> Any:
        """Where a trace departs from what was expected."""
        return self._ask("monitor", traces, options)

    def simulate(self, trace: command.PathLike, **options: Any) -> Dict[str, Any]:
        """Set points, emulated positions and speeds, by columns."""
        words = ["emulator", "simulate", trace, "--emulator", self.path, *command.words_of(options)]
        _, text = command.call(words)
        return {
            name: columns.array([columns.number(value) for value in values])
            for name, values in columns.read(text).items()
        }

    def design(
        self,
        output: command.PathLike,
        box: Tuple[Sequence[float], Sequence[float]] = ((0, 0), (60, 60)),
        feeds: Tuple[float, float] = (60, 3000),
        **options: Any,
    ) -> Any:
        """Writes the NC program that tells most about what is not known yet: what to record next.
        @param box  least and largest X Y (and perhaps Z), mm @param feeds  least and largest, mm/min
        @param options  seconds=25, seed=1"""
        given = {
            "box": ",".join(command.text_of(float(value)) for axis in zip(*box) for value in axis),
            "feeds": ",".join(command.text_of(float(feed)) for feed in feeds),
            "output": output,
            **options,
        }
        words = ["emulator", "design", "--emulator", self.path, *command.words_of(given)]
        return command.ask(words)

    def _ask(self, name: str, traces: Any, options: Dict[str, Any]) -> Any:
        return command.ask(
            ["emulator", name, *traces, "--emulator", self.path, *command.words_of(options)], (0, 1)
        )
