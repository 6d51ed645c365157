"""Many dressings, by the program's command `batch`."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
from collections.abc import Callable
from typing import Any

from selvedge._errors import InputError
from selvedge._pattern import PathLike


def program() -> pathlib.Path:
    """The program that belongs to this module: $SELVEDGE_PROGRAM, or the one beside it in the build folder or the
    install prefix, or the one on the path. Raises InputError if there is none."""
    named = os.environ.get("SELVEDGE_PROGRAM")
    if named:
        return pathlib.Path(named)
    for folder in pathlib.Path(__file__).resolve().parents[1:]:
        for candidate in (folder / "selvedge", folder / "bin" / "selvedge"):
            if candidate.is_file() and os.access(candidate, os.X_OK):
                return candidate
    found = shutil.which("selvedge")
    if found:
        return pathlib.Path(found)
    raise InputError("", "SELVEDGE_PROGRAM", "the program selvedge was not found: name it in this variable")


def batch(
    manifest: PathLike,
    output: PathLike,
    *,
    jobs: int | None = None,
    progress: Callable[[float, str], object] | None = None,
) -> list[dict[str, Any]]:
    """Runs `selvedge batch MANIFEST -o OUTPUT` and returns the rows of OUTPUT/results.jsonl.

    jobs: how many garments are dressed at once; None: the command's default. progress: called as progress(0, line) for
    each line that the command prints. An exception in it, or KeyboardInterrupt, ends the command and is raised.
    Raises InputError with the command's message if it refuses its input.
    """
    command = [os.fspath(program()), "batch", os.fspath(manifest), "-o", os.fspath(output)]
    if jobs is not None:
        command += ["--jobs", str(int(jobs))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None and process.stderr is not None
            for line in process.stdout:
                if progress is not None:
                    progress(0.0, line.rstrip("\n"))
            message = process.stderr.read().strip()
        except BaseException:
            process.terminate()
            raise
    results = pathlib.Path(output) / "results.jsonl"
    if process.returncode not in (0, 3):
        lines = message.splitlines()
        raise InputError("", "", lines[-1] if lines else f"selvedge batch ended with {process.returncode}")
    return [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines() if line]
