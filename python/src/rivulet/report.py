# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""A JSON object of Rivulet, whose members are attributes too."""

from __future__ import annotations

from typing import Any, Dict


class Report(Dict[str, Any]):
    """report["executed"] is report.executed. The members are those of docs/cli.md."""

    def __getattr__(self, name: str) -> Any:
        if name in self:
            return self[name]
        raise AttributeError("there is no %r; there are: %s" % (name, ", ".join(sorted(self))))


def report_of(value: Any) -> Any:
    """The same value with a Report in the place of each object."""
    if isinstance(value, dict):
        return Report({name: report_of(member) for name, member in value.items()})
    if isinstance(value, list):
        return [report_of(member) for member in value]
    return value
