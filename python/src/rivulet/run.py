# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A run in progress: a rivulet-cli of its own that gets its orders from here, and says how far it is
(docs/python.md). If this program dies, its orders end, and rivulet-cli holds the axes at once; if both
die, the axes stand when the control has heard nothing for the silence limit (docs/stop.md)."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from types import TracebackType
from typing import IO, Any, Dict, List, Optional, Sequence, Tuple, Type, TypeVar

from . import command
from .errors import RivuletError, RunFailed, TooOld
from .report import Report, report_of

PROGRESS_VERSION = 1  # of the lines of --progress
STOP_S = 60.0  # rivulet-cli waits 30 s for a stop to be confirmed

Position = Tuple[float, float, float]
RunType = TypeVar("RunType", bound="Run")


@dataclass(frozen=True)
class State:
    """What rivulet-cli said last of the run. Every None is something that it does not know (yet)."""

    name: str = "idle"  # armed, running, holding, stopping, done, stopped, aborted
    waiting_for: str = ""  # "": for nothing; claim, network, proof, cycle-start, ...
    override_percent: Optional[float] = None
    holds: bool = False  # by an order to hold
    stands: bool = False  # and the axes were seen to stand
    points: int = 0
    sent: int = 0
    executed: int = 0
    late_windows: int = 0
    margin_ms: Optional[float] = None  # until the next points are needed
    position_mm: Optional[Position] = None  # of the tool, as it was read last
    wrong_motion: str = ""

    @classmethod
    def of(cls, line: Dict[str, Any]) -> "State":
        known = {name: line[name] for name in cls.__dataclass_fields__ if name in line}
        if "position_mm" in known:
            known["position_mm"] = tuple(known["position_mm"])
        return cls(name=str(line.get("state", "idle")), **known)


class Run:
    """A context: leaving it waits for the end of the run; leaving it by an exception stops the run."""

    def __init__(self, words: Sequence[command.PathLike]) -> None:
        self._change = threading.Condition()
        self._state = State()
        self._too_old = ""
        self._report: Optional[Report] = None
        self._reading: List[threading.Thread] = []
        program = command.find()
        read_end, write_end = os.pipe()
        with contextlib.ExitStack() as undo:
            progress = undo.enter_context(os.fdopen(read_end, encoding="utf-8"))
            # In files, they are never full, so the run never waits for their reader.
            self._output = undo.enter_context(tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace"))
            self._messages = undo.enter_context(tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace"))
            try:
                self._process = subprocess.Popen(
                    [program, *[os.fspath(word) for word in words], "--json"]
                    + ["--orders", "-", "--end-with-orders", "--progress", "/dev/fd/%d" % write_end],
                    stdin=subprocess.PIPE,
                    stdout=self._output,
                    stderr=self._messages,
                    pass_fds=(write_end,),
                )
            finally:
                os.close(write_end)
            self._files = undo.pop_all()
        self._read_by_thread(self._read_progress, progress)

    # --- what is asked -------------------------------------------------------------------------

    @property
    def state(self) -> State:
        with self._change:
            return self._state

    @property
    def executed(self) -> int:
        """Points that are known to be executed."""
        return self.state.executed

    @property
    def position(self) -> Optional[Position]:
        """Of the tool, mm, as it was read last; None: not yet."""
        return self.state.position_mm

    @property
    def late(self) -> int:
        """How often the next points were due before they could be there."""
        return self.state.late_windows

    @property
    def messages(self) -> str:
        """What rivulet-cli has said for people so far."""
        return self._text(self._messages)

    @property
    def report(self) -> Report:
        """Of the run that has ended, as `stream --json` prints it; empty before that."""
        return self._report if self._report is not None else Report()

    # --- what is ordered -----------------------------------------------------------------------

    def hold(self) -> None:
        """The axes stand at once, on the path."""
        self._order("hold")

    def resume(self) -> None:
        """They go on after a hold."""
        self._order("continue")

    def override(self, percent: float) -> None:
        """Path override of the run, 0 to 120."""
        self._order("override %g" % percent)

    def stop(self) -> Report:
        """Holds the axes at once and ends the run. Its program stays held on the control: `rivulet-cli
        runs --end` lets it go on to the end of its window, a reset ends it. @return  the report"""
        self._leave()
        return self.report

    def wait(self, timeout_s: Optional[float] = None) -> Report:
        """Until the run has ended. @raise RunFailed  it failed, or is not known to be right
        @raise TimeoutError  it has not ended"""
        try:
            code = self._process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            raise TimeoutError("The run is still in progress.") from None
        self._take_report()
        if code != 0:
            raise self._failure()
        return self.report

    def __enter__(self: "RunType") -> "RunType":
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        if kind is None:
            try:
                self.wait()
            except BaseException:
                self._leave()
                raise
        else:
            self._leave()

    # --- inside --------------------------------------------------------------------------------

    def _order(self, line: str) -> None:
        if self._process.stdin is not None and not self._process.stdin.closed:
            with contextlib.suppress(BrokenPipeError):
                self._process.stdin.write(line.encode("ascii") + b"\n")
                self._process.stdin.flush()

    def _leave(self) -> None:
        """The end of the orders is a stop. A rivulet-cli that does not obey is ended: then the control
        hears nothing more, and stops the axes itself."""
        if self._process.stdin is not None:
            with contextlib.suppress(BrokenPipeError):
                self._process.stdin.close()
        try:
            self._process.wait(STOP_S)
        except BaseException:
            self._process.kill()
            self._process.wait()
            raise
        finally:
            self._take_report()

    def _take_report(self) -> None:
        for thread in self._reading:
            thread.join()
        if self._report is None:
            try:
                self._report = report_of(json.loads(self._text(self._output)))
            except ValueError:
                self._report = Report()

    def _failure(self) -> RivuletError:
        if self._too_old:
            return TooOld(self._too_old, exit_code=self._process.returncode)
        error = command.failure(self._process.returncode, json.dumps(self.report), self.messages)
        if isinstance(error, RunFailed) and "outcome" in self.report and "error" not in self.report:
            return RunFailed(
                "The run has %s, but it is %s: %s repeated, %s skipped, %s foreign."
                % tuple(self.report.get(name) for name in ("outcome", "finding", "repeated", "skipped", "foreign")),
                report=self.report,
            )
        return error

    @staticmethod
    def _text(file: IO[str]) -> str:
        # A place of its own: rivulet-cli writes where this description of the file stands.
        return os.pread(file.fileno(), os.fstat(file.fileno()).st_size, 0).decode("utf-8", "replace")

    def _read_by_thread(self, read: Any, file: IO[str]) -> None:
        thread = threading.Thread(target=read, args=(file,), daemon=True)
        self._reading.append(thread)
        thread.start()

    def _read_progress(self, lines: IO[str]) -> None:
        with lines:
            for text in lines:
                line = json.loads(text)
                if line.get("rivulet_progress", PROGRESS_VERSION) != PROGRESS_VERSION:
                    self._too_old = (
                        "This rivulet-cli tells its progress in version %s, and this package reads "
                        "version %d. Install the same version of both." % (line["rivulet_progress"], PROGRESS_VERSION)
                    )
                    self._order("hold")
                    if self._process.stdin is not None:
                        self._process.stdin.close()
                with self._change:
                    if "state" in line:
                        self._state = State.of(line)
                    self._change.notify_all()
        with self._change:
            self._change.notify_all()


def start(program: command.PathLike, machine: str = command.SIMULATE, **options: Any) -> Run:
    """Streams a program, and does not wait for the end: see Run.
    @param machine  "simulate" or an address, opc.tcp://… @param options  those of
    `rivulet-cli stream`: feed=1000, points=7, motion_only=True"""
    return Run(["stream", program, *command.machine_words(machine), *command.words_of(options)])
