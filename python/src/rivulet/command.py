# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The command line of Rivulet, as it is documented in docs/cli.md: how it is found, called and read."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any, List, Mapping, Sequence, Tuple, Union

from .errors import NotFound, RivuletError, TooOld, error_for
from .report import Report, report_of

PathLike = Union[str, "os.PathLike[str]"]

SIMULATE = "simulate"  # in place of the address of a machine


def find(program: str = "rivulet-cli") -> str:
    """The program RIVULET_CLI (RIVULET_SERVICE, …) names, else the one on the PATH."""
    variable = program.upper().replace("-", "_")
    named = os.environ.get(variable)
    found = shutil.which(named or program)
    if found is None:
        raise NotFound(
            "%s is not there: correct the variable %s." % (named, variable)
            if named
            else "%s is not installed, or not on the PATH: install Rivulet, or say where it is in the "
            "variable %s." % (program, variable)
        )
    return found


def words_of(options: Mapping[str, Any]) -> List[str]:
    """Options of the command line from those of Python: feed_max=1200 is --feed-max 1200, True is an
    option without a value, a list repeats the option; None and False are left out."""
    words: List[str] = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
            continue
        for each in value if isinstance(value, (list, set)) else [value]:
            words.append(option)
            words += [text_of(part) for part in each] if isinstance(each, tuple) else [text_of(each)]
    return words


def text_of(value: Any) -> str:
    if isinstance(value, float):
        return repr(float(value))  # also of a number of NumPy
    return str(os.fspath(value)) if isinstance(value, os.PathLike) else str(value)


def machine_words(machine: str) -> List[str]:
    return ["--simulate"] if machine == SIMULATE else ["--endpoint", machine]


def failure(exit_code: int, output: str, messages: str) -> RivuletError:
    """What a command that has ended so says, as an exception."""
    try:
        report = report_of(json.loads(output))
    except ValueError:
        report = None
    error = report.get("error") if isinstance(report, dict) else None
    if isinstance(error, dict):
        text = str(error["message"])
        if error.get("context"):
            text = "%s: %s" % (error["context"], text)
        return error_for(exit_code, text, str(error.get("code", "")), report)
    if "argument was not expected: --" in messages:
        return TooOld(
            "This rivulet-cli does not know an option: %s. If it stands in docs/cli.md, install the "
            "version of Rivulet that belongs to this package." % messages.strip().splitlines()[0],
            exit_code=exit_code,
        )
    lines = [line for line in messages.strip().splitlines() if line]
    text = lines[-1] if lines else "rivulet-cli has ended with exit code %d." % exit_code
    if lines and lines[-1].startswith("Run with --help"):
        text = lines[0]
    return error_for(exit_code, text, report=report if isinstance(report, Report) else None)


def call(words: Sequence[PathLike], good: Sequence[int] = (0,)) -> Tuple[int, str]:
    """Runs a command and waits for it. @return exit code, one of `good`, and what it has printed"""
    done = subprocess.run(
        [find(), *[os.fspath(word) for word in words]],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    if done.returncode not in good:
        raise failure(done.returncode, done.stdout, done.stderr)
    return done.returncode, done.stdout


def ask(words: Sequence[PathLike], good: Sequence[int] = (0,)) -> Any:
    """The JSON that a command prints; each object is a Report. A failure that has no exit code of its
    own among `good` is an exception, and so is one that is all the command has to say."""
    code, text = call([*words, "--json"], good)
    value = report_of(json.loads(text))
    if code != 0 and isinstance(value, Report) and set(value) == {"error"}:
        raise failure(code, text, "")
    return value
