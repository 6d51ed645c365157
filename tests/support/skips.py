"""How Python tests are skipped: the reason goes to the file that SELVEDGE_TEST_SKIPS names, of which scripts/test makes a
summary, as test_main.cpp does for those of C++."""

from __future__ import annotations

import os
import unittest
from typing import NoReturn

SKIPPED = 77  # what ctest takes for skipped


def _record(name: str, reason: str) -> None:
    """One write to a file opened for appending, so that programs that run at once do not mix their lines."""
    path = os.environ.get("SELVEDGE_TEST_SKIPS")
    if path:
        with open(path, "a", encoding="utf-8") as file:
            file.write(f"{name}: {' '.join(reason.split())}\n")


def skip_test(name: str, reason: str) -> NoReturn:
    """Skips the test, or the class, whose setUpClass() calls this."""
    _record(name, reason)
    raise unittest.SkipTest(reason)


def skip_program(name: str, reason: str) -> NoReturn:
    """Ends the program, all of which is skipped."""
    _record(name, reason)
    print(f"skipped: {reason}", flush=True)
    os._exit(SKIPPED)
