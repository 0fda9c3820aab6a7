# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Wheel and source archive by Debian's own tools, types, and versions."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest

import rivulet

SOURCE = pathlib.Path(os.environ["RIVULET_SOURCE"])


def run(*words, **options):
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.skipif(
    not all(importlib.util.find_spec(name) for name in ("build", "setuptools", "wheel")),
    reason="python3-build, python3-setuptools or python3-wheel is not installed (scripts/setup --with-python)",
)
def test_wheel_and_source_archive(tmp_path):
    copy = tmp_path / "python"
    shutil.copytree(SOURCE / "python", copy)
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", tmp_path / "dist", copy, cwd=tmp_path)
    (wheel,) = (tmp_path / "dist").glob("*.whl")
    assert wheel.name == "rivulet-%s-py3-none-any.whl" % rivulet.__version__
    assert "rivulet/py.typed" in zipfile.ZipFile(wheel).namelist()
    (archive,) = (tmp_path / "dist").glob("*.tar.gz")
    assert any(name.endswith("src/rivulet/py.typed") for name in tarfile.open(archive).getnames())
    # It is imported from the wheel, and needs nothing else: -S leaves out all packages of Debian.
    code = "import rivulet; print(rivulet.__file__, rivulet.columns.numpy)"
    said = run(sys.executable, "-S", "-c", code, env=dict(os.environ, PYTHONPATH=str(wheel)))
    assert wheel.name in said and said.endswith("None\n")


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed (scripts/setup --with-python)")
def test_types(tmp_path):
    run("mypy", "--strict", "--python-version", "3.9", "--cache-dir", tmp_path, SOURCE / "python" / "src")


def test_versions():
    """One number everywhere."""
    project = (SOURCE / "python" / "pyproject.toml").read_text()
    assert re.search(r'^version = "(.*)"$', project, re.M).group(1) == rivulet.__version__
    citation = (SOURCE / "CITATION.cff").read_text(encoding="utf-8")
    assert re.search(r"^version: (.*)$", citation, re.M).group(1) == rivulet.__version__
    _, said = rivulet.command.call(["--version"])
    assert said.strip() == rivulet.__version__


def test_only_the_standard_library():
    code = (SOURCE / "python" / "src").rglob("*.py")
    names = {name for file in code for name in re.findall(r"^(?:import|from) (\w+)", file.read_text(), re.M)}
    assert names <= set(sys.stdlib_module_names) | {"rivulet"}, names
