# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What can go wrong. Each error has the sentence of Rivulet, which says what to do, and its code."""

from __future__ import annotations

from typing import Optional

from .report import Report


class RivuletError(Exception):
    """@param code  as in JSON, "streaming:9"; "": none  @param exit_code  of rivulet-cli; None: it
    was not asked"""

    def __init__(self, message: str, code: str = "", exit_code: Optional[int] = None) -> None:
        super().__init__(message)
        self.code = code
        self.exit_code = exit_code


class NotFound(RivuletError):
    """A program of Rivulet is not on this computer."""


class TooOld(RivuletError):
    """A program of Rivulet does not know what this package needs."""


class RunFailed(RivuletError):
    """Exit code 1: it ran, but the result is wrong. `report` says what is known; it may be empty."""

    def __init__(
        self, message: str, code: str = "", exit_code: Optional[int] = 1, report: Optional[Report] = None
    ) -> None:
        super().__init__(message, code, exit_code)
        self.report = report if report is not None else Report()


class BadInput(RivuletError):
    """Exit code 2: wrong usage, or input that cannot be used."""


class ConnectionFailed(RivuletError):
    """Exit code 3: not reachable, lost, no answer in time."""


class RuleApplies(RivuletError):
    """Exit code 4: a rule of `fail_if` applies."""


def error_for(exit_code: int, message: str, code: str = "", report: Optional[Report] = None) -> RivuletError:
    """The exception that belongs to an exit code (docs/cli.md)."""
    kinds = {2: BadInput, 3: ConnectionFailed, 4: RuleApplies}
    if exit_code in kinds:
        return kinds[exit_code](message, code, exit_code)
    return RunFailed(message, code, exit_code, report)
