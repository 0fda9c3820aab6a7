# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The notebooks, executed and rendered by scripts/notebook."""

import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess

import pytest

SOURCE = pathlib.Path(os.environ["RIVULET_SOURCE"])


def test_notebooks_are_kept_without_results():
    for file in (SOURCE / "examples" / "python").glob("*.ipynb"):
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None, file


@pytest.mark.skipif(
    shutil.which("jupyter-nbconvert") is None
    or not os.path.exists("/usr/share/jupyter/kernels/python3")
    or importlib.util.find_spec("matplotlib") is None,
    reason="jupyter-nbconvert, python3-ipykernel or python3-matplotlib is not installed (scripts/setup --with-notebook)",
)
def test_notebooks_are_executed(tmp_path):
    done = subprocess.run(
        [SOURCE / "scripts" / "notebook", tmp_path / "pages"],
        env=dict(os.environ, RIVULET_SKIP_SETUP="1"), capture_output=True, text=True, check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    page = (tmp_path / "pages" / "p1_experiment.html").read_text(encoding="utf-8")
    assert "faultless: 60 points executed" in page  # what a cell has printed
    assert "RunFailed (exit code 1): The run has completed, but it is faulty" in page
    assert page.count("data:image/png;base64,") >= 4  # its figures
    assert not re.findall(r'(?:src|href)="https?:[^"]*"', page)  # nothing from the network
