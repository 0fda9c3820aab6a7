# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Rivulet from Python: streams a CNC machine's trajectory while it moves. See docs/python.md."""

from .emulator import Emulator
from .errors import (
    BadInput,
    ConnectionFailed,
    NotFound,
    RivuletError,
    RuleApplies,
    RunFailed,
    TooOld,
)
from .live import LiveRun, live
from .program import Program, check, judge, open, stream
from .report import Report
from .run import Run, State, start
from .service import Service
from .trace import Trace, analyse

__version__ = "0.1.0"

__all__ = [
    "BadInput",
    "ConnectionFailed",
    "Emulator",
    "LiveRun",
    "NotFound",
    "Program",
    "Report",
    "RivuletError",
    "RuleApplies",
    "Run",
    "RunFailed",
    "Service",
    "State",
    "TooOld",
    "Trace",
    "analyse",
    "check",
    "judge",
    "live",
    "open",
    "start",
    "stream",
]
