# SPDX-License-Identifier: GPL-3.0-or-later
"""Hosted workflows run existing files on all supported Python versions."""

import re
import shlex
import sys
from pathlib import Path

import pytest
import yaml

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
WORKFLOWS = {file.stem: yaml.safe_load(file.read_text())
             for file in sorted((ROOT / ".github" / "workflows").iterdir())}  # fmt: skip
STEPS = [
    pytest.param(job, step, id=f"{workflow}-{name}-{number}")
    for workflow, content in WORKFLOWS.items()
    for name, job in content["jobs"].items()
    for number, step in enumerate(job["steps"])
]
# Programs of the hosted machine, and modules installed by an earlier step.
PROGRAMS = {"sudo", "cd", "samcontact", "python"}
MODULES = {"pip", "build", "cibuildwheel"}


def versions():
    """Return the Python versions that the project supports."""
    named = [name.rpartition(" :: ")[2] for name in PROJECT["project"]["classifiers"]]
    return [name for name in named if re.fullmatch(r"3\.\d+", name)]


def test_the_matrix_has_all_supported_pythons():
    assert WORKFLOWS["tests"]["jobs"]["pythons"]["strategy"]["matrix"]["python"] == versions()


def test_wheels_are_built_for_all_configured_machines():
    wheels = WORKFLOWS["wheels"]["jobs"]["wheels"]
    built = [entry["arch"] for entry in wheels["strategy"]["matrix"]["include"]]
    assert built == PROJECT["tool"]["cibuildwheel"]["linux"]["archs"]
    systems = {
        name for name in PROJECT["tool"]["cibuildwheel"] if name in ("linux", "macos", "windows")
    }
    assert systems == {"linux"}


@pytest.mark.parametrize("workflow", WORKFLOWS)
def test_jobs_are_limited_and_start_by_events(workflow):
    content = WORKFLOWS[workflow]
    assert content["permissions"] == {"contents": "read"}
    # YAML 1.1 reads the key "on" as true
    assert {"push", "pull_request", "workflow_dispatch"} == set(content[True])
    for job in content["jobs"].values():
        assert {"runs-on", "steps", "timeout-minutes"} <= set(job)
        assert job["steps"][0]["uses"].startswith("actions/checkout@")


@pytest.mark.parametrize(("job", "step"), STEPS)
def test_steps_run_existing_files(job, step):
    assert len({"uses", "run"} & set(step)) == 1
    if "uses" in step:
        assert re.fullmatch(r"actions/[\w-]+@v\d+", step["uses"])
        return
    for line in re.split(r"\n|&&", step["run"].strip()):
        program, *words = shlex.split(line)
        if program == "./test":
            tiers = re.findall(r"^    (\w+)\)", (ROOT / "test").read_text(), re.MULTILINE)
            assert len(tiers) > 5
            assert set(words) <= set(tiers)
        elif program == ".venv/bin/pytest":  # installed by ./test
            assert any(s.get("run") == "./test" for s in job["steps"])
            folders = [word for word in words if "/" in word]
            assert folders
            assert all((ROOT / folder).is_dir() for folder in folders)
        elif program == "python":
            assert words[0] == "-m"
            assert words[1] in MODULES
            assert words[1] == "pip" or installed(job, words[1])
        else:
            assert program in PROGRAMS
        if program == "samcontact":
            assert "samcontact" in PROJECT["project"]["scripts"]


def installed(job, module):
    """Return whether a step of the job installs a module by pip."""
    return any(
        re.search(rf'pip install "?{module}\b', step.get("run", "")) for step in job["steps"]
    )


@pytest.mark.parametrize(("job", "step"), STEPS)
def test_expressions_use_defined_names(job, step):
    matrix = job.get("strategy", {}).get("matrix", {})
    defined = {key for entry in matrix.get("include", [matrix]) for key in entry}
    used = re.findall(r"\$\{\{ matrix\.(\w+) \}\}", f"{job['runs-on']} {job['name']} {step}")
    assert set(used) <= defined
    if "uses" in step and "setup-python" in step["uses"]:
        version = step["with"]["python-version"]
        assert version == "${{ matrix.python }}" or version in versions()


def test_only_artifacts_made_by_a_step_are_uploaded():
    for job in WORKFLOWS["wheels"]["jobs"].values():
        folder = job["steps"][-1]["with"]["path"].split("/")[0]
        assert any(
            re.search(rf"--out(put-)?dir {folder}\b", step.get("run", "")) for step in job["steps"]
        )
