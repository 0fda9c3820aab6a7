# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Numbers of a table: arrays of NumPy if it is installed, else lists."""

from __future__ import annotations

import csv
import io
from typing import Any, Dict, List, Sequence

numpy: Any
try:
    import numpy
except ImportError:
    numpy = None


def array(values: Sequence[float]) -> Any:
    return list(values) if numpy is None else numpy.array(values, dtype=float)


def number(text: str) -> float:
    """@return  not a number for an empty cell"""
    return float(text) if text else float("nan")


def read(text: str, separator: str = ",") -> "Dict[str, List[str]]":
    """Columns of a table by their headings, as text."""
    rows = list(csv.reader(io.StringIO(text), delimiter=separator))
    return {
        heading.strip(): [row[index].strip() if index < len(row) else "" for row in rows[1:]]
        for index, heading in enumerate(rows[0] if rows else [])
    }
