# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points that are computed while the machine moves (docs/live.md)."""

from __future__ import annotations

import contextlib
import json
import math
import pathlib
import socket
import tempfile
import time
from types import TracebackType
from typing import IO, Any, List, Optional, Tuple, Type

from . import command
from .errors import BadInput, RivuletError, RunFailed
from .run import Position, Run

LOOK_S = 0.01  # how often it is looked for the socket
AXES = "XYZABC"
Corner = Tuple[float, float, float]


class LiveRun(Run):
    """A context, like Run. Leaving it says that there are no more points, and waits for the last one."""

    def __init__(self, words: List[str], feed: float, ahead: int) -> None:
        self._feed = feed
        self._ahead = ahead
        self._given = 0
        self._reply = {"accepted": 0, "executed": 0, "line": 0, "merged": 0}
        self._place: Optional[Position] = None
        self._end: Optional[Tuple[str, str]] = None
        self._is_over = False
        self._folder = tempfile.TemporaryDirectory(prefix="rivulet-")
        path = pathlib.Path(self._folder.name) / "points"
        try:
            super().__init__(["stream", "--live", "unix:%s" % path, *words])
            self._socket = self._connect(path)
        except BaseException:
            self._folder.cleanup()
            raise
        self._read_by_thread(self._read_replies, self._socket.makefile("r", encoding="utf-8"))
        self._wait_until(lambda: self._place is not None)
        if self._place is None:
            self._leave()
            raise self._failure()

    # --- what is asked -------------------------------------------------------------------------

    @property
    def executed(self) -> int:
        """Points that are known to be executed."""
        with self._change:
            return int(self._reply["executed"])

    @property
    def accepted(self) -> int:
        """Points that have been taken, without those that were merged with the one before."""
        with self._change:
            return int(self._reply["accepted"])

    @property
    def position(self) -> Position:
        """Of the point that was executed last, mm; at first, the place of the tool."""
        with self._change:
            assert self._place is not None
            return self._place

    # --- what is ordered -----------------------------------------------------------------------

    def move(self, *point: float, feed: Optional[float] = None, feed_factor: float = 1.0) -> None:
        """Sends a point, X Y Z A B C in mm and degrees; those left out keep their value. Waits while
        `ahead` points are sent but not executed. @param feed  of this point, mm/min; not given: that
        of `live` @param feed_factor  of that feed @raise RunFailed  the run has ended"""
        if not 1 <= len(point) <= len(AXES):
            raise BadInput("A point has one to six coordinates, X Y Z A B C.")
        words = ["%s%.6f" % (axis, value) for axis, value in zip(AXES, point)]
        wanted = (self._feed if feed is None else feed) * feed_factor
        if not all(math.isfinite(value) for value in (*point, wanted)):
            raise BadInput("A coordinate or feed of this point is no finite number: %s" % (point,))
        self._send(" ".join([*words, "F%.6g" % wanted]))
        self._given += 1
        self._wait_until(lambda: self._waiting() < self._ahead)
        self._require_alive()

    def wait_here(self) -> None:
        """The machine stands at the last point, and goes on with the next one."""
        self._send("hold")

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        try:
            if kind is None and not self._is_over:
                with contextlib.suppress(OSError):
                    self._socket.sendall(b"end\n")
            super().__exit__(kind, error, trace)
        finally:
            self._close()

    # --- inside --------------------------------------------------------------------------------

    def _waiting(self) -> int:
        return self._given - int(self._reply["merged"]) - int(self._reply["executed"])

    def _wait_until(self, is_so: Any) -> None:
        with self._change:
            self._change.wait_for(lambda: self._is_over or is_so())

    def _connect(self, path: pathlib.Path) -> socket.socket:
        """As soon as rivulet-cli listens, which is after it has connected to the machine."""
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            while True:
                with contextlib.suppress(FileNotFoundError, ConnectionRefusedError):
                    connection.connect(str(path))
                    return connection
                if self._process.poll() is not None:
                    self._take_report()
                    raise self._failure()
                time.sleep(LOOK_S)
        except BaseException:
            connection.close()
            self._leave()
            raise

    def _send(self, line: str) -> None:
        self._require_alive()
        try:
            self._socket.sendall(line.encode("ascii") + b"\n")
        except OSError:
            self._wait_until(lambda: False)
            self._require_alive()

    def _require_alive(self) -> None:
        if self._is_over:
            self._leave()
            if self._process.returncode:
                raise self._failure()
            raise RunFailed("The run has ended before this point.", report=self.report)

    def _failure(self) -> RivuletError:
        error = super()._failure()
        if isinstance(error, RunFailed) and self._end is not None and self._end[1]:
            return RunFailed(self._end[1], error.code, error.exit_code, error.report)
        return error

    def _read_replies(self, lines: IO[str]) -> None:
        with contextlib.suppress(OSError), lines:
            for text in lines:
                reply = json.loads(text)
                with self._change:
                    self._reply.update({name: reply[name] for name in self._reply if name in reply})
                    if "x" in reply:
                        self._place = (reply["x"], reply["y"], reply["z"])
                    if "end" in reply:
                        self._end = (str(reply["end"]), str(reply.get("error", "")))
                    self._change.notify_all()
        with self._change:
            self._is_over = True
            self._change.notify_all()

    def _close(self) -> None:
        self._socket.close()
        self._folder.cleanup()


def live(
    box: Tuple[Corner, Corner],
    feed: float,
    machine: str = command.SIMULATE,
    *,
    points: int = 7,
    ahead: Optional[int] = None,
    feed_max: Optional[float] = None,
    **options: Any,
) -> LiveRun:
    """Starts a run whose points `move` sends. The machine waits for the first one.
    @param box  what no point may leave: least and largest X Y Z, mm, frame of the workpiece
    @param feed  mm/min @param machine  "simulate": a virtual machine, at the pace of the clock; or an
    address, opc.tcp://… @param points  of a window @param ahead  points that are sent but not
    executed, at most; 3 windows @param feed_max  the largest feed; not given: feed
    @param options  those of `rivulet-cli stream`: full_within=20, step_max=1, windows=2"""
    if points < 1 or (ahead is not None and ahead < 1):
        raise BadInput("points and ahead are at least 1.")
    corners = tuple(float(value) for axis in zip(*box) for value in axis)
    given = {
        "box": corners,
        "feed": float(feed),
        "feed_max": float(feed_max if feed_max is not None else feed),
        "points": points,
        "feed_cells": "point",
        **options,
    }
    words = [*command.machine_words(machine), *command.words_of(given)]
    return LiveRun(words, feed, ahead if ahead is not None else 3 * points)
