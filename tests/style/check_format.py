"""clang-format changes nothing."""
import re
import shutil
import subprocess

import rules
from sources import Fault


def find_clang_format():
    """The program of the right version, or None and why."""
    for name in (f"clang-format-{rules.CLANG_FORMAT_VERSION}", "clang-format"):
        program = shutil.which(name)
        if program and f"version {rules.CLANG_FORMAT_VERSION}." in _output_of([program, "--version"]):
            return program, None
    return None, f"no clang-format {rules.CLANG_FORMAT_VERSION}"


def _output_of(command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def check_format(root, sources, program):
    """The first place in each file that clang-format would write otherwise."""
    command = [program, "--dry-run", "--style=file", *[source.path for source in sources]]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    seen = set()
    for path, line in re.findall(r"^(\S+?):(\d+):\d+: warning: code should be", result.stderr, re.MULTILINE):
        if path not in seen:
            seen.add(path)
            yield Fault(path, int(line), "clang-format -i would write this otherwise")
    if result.returncode != 0:
        yield Fault(".clang-format", 1, result.stderr.strip().split("\n")[0])
