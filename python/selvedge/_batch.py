"""Many dressings, by the program's command `batch`."""

from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from typing import Any, NoReturn

from selvedge._errors import InputError
from selvedge._pattern import PathLike


def program() -> pathlib.Path:
    """The program that belongs to this module: $SELVEDGE_PROGRAM, or the one that a wheel has in it, or that is beside
    the module in the build folder or the install prefix, or the one on the path. Raises InputError if there is none."""
    named = os.environ.get("SELVEDGE_PROGRAM")
    if named:
        return pathlib.Path(named)
    for folder in pathlib.Path(__file__).resolve().parents:
        for candidate in (folder / "selvedge", folder / "bin" / "selvedge"):
            if candidate.is_file() and os.access(candidate, os.X_OK):
                return candidate
    found = shutil.which("selvedge")
    if found:
        return pathlib.Path(found)
    raise InputError("", "SELVEDGE_PROGRAM", "the program selvedge was not found: name it in this variable")


def run_program() -> NoReturn:
    """Becomes the program, with the arguments of this process: the command `selvedge` that a wheel installs."""
    command = program()
    os.execv(command, [os.fspath(command), *sys.argv[1:]])


_COUNT = re.compile(r"\] (\d+) of (\d+)")


def batch(
    manifest: PathLike,
    output: PathLike,
    *,
    jobs: int | None = None,
    progress: Callable[[float, str], object] | None = None,
) -> list[dict[str, Any]]:
    """Runs `selvedge batch MANIFEST -o OUTPUT` and returns the rows of OUTPUT/results.jsonl: one dict for each job.

    jobs: how many garments are dressed at once; None: the command's default. progress: called as progress(done, line)
    for each line that the command writes of its progress, every few seconds and at the end, done from 0 to 1. An
    exception in it ends the command and is raised.
    Raises InputError with the command's message if it refuses its input, or if a job left no result. Jobs with a fault,
    or that failed, have rows. Ctrl+C raises KeyboardInterrupt, and another signal that stopped the command RuntimeError;
    the same call then goes on from there.
    """
    command = [os.fspath(program()), "batch", os.fspath(manifest), "-o", os.fspath(output)]
    if jobs is not None:
        command += ["--jobs", str(int(jobs))]
    message = ""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stderr is not None
            for line in process.stderr:
                message = line.strip() or message
                count = _COUNT.search(line)
                if progress is not None and count:
                    progress(int(count[1]) / max(1, int(count[2])), message)
        except BaseException:
            _end(process)
            raise
    if process.returncode == 130:
        raise KeyboardInterrupt
    if process.returncode < 0 or process.returncode > 128:
        raise RuntimeError(f"the command was stopped by a signal: it ended with {process.returncode}")
    if process.returncode not in (0, 1):
        raise InputError("", "", message.removeprefix("selvedge: ") or f"the command ended with {process.returncode}")
    results = pathlib.Path(output) / "results.jsonl"
    return [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines() if line]


def _end(process: subprocess.Popen[str]) -> None:
    """Ends the command: the first signal asks it to, a second one makes it."""
    for _ in range(2):
        process.terminate()
        try:
            process.wait(timeout=1)
            return
        except subprocess.TimeoutExpired:
            continue
    process.kill()
