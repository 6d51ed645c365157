"""What can be seen in a file without parsing it, and the lengths of files and functions."""
import re

import rules
from sources import Fault, functions_of


def check_lines(sources):
    """Tabs, space at line ends, a missing last newline, words and paths that have no place here."""
    forbidden = {re.compile(pattern): why for pattern, why in rules.FORBIDDEN_TEXT.items()}
    for source in sources:
        if source.text and not source.text.endswith("\n"):
            yield Fault(source.path, len(source.lines), "no newline at the end")
        for number, line in enumerate(source.lines, 1):
            if "\t" in line:
                yield Fault(source.path, number, "a tab")
            if line != line.rstrip():
                yield Fault(source.path, number, "space at the end of the line")
            for pattern, why in forbidden.items():
                if pattern.search(line):
                    yield Fault(source.path, number, why)


def check_headers(sources):
    """A header begins with #pragma once, then says what it is for."""
    for source in sources:
        if not source.path.endswith(".h"):
            continue
        if source.lines[0] != "#pragma once":
            yield Fault(source.path, 1, "a header begins with #pragma once")
        elif len(source.lines) < 2 or not source.lines[1].startswith("//"):
            yield Fault(source.path, 2, "a header says first what it is for")


def check_lengths(sources):
    """Files and functions that are too long."""
    for source in sources:
        count = source.text.count("\n")
        if count > rules.MAX_FILE_LINES:
            yield Fault(source.path, rules.MAX_FILE_LINES, f"{count} lines, more than {rules.MAX_FILE_LINES}")
        for function in long_functions(source, rules.MAX_FUNCTION_LINES):
            yield Fault(source.path, function.line,
                        f"{function.name} has {function.length} lines, more than {rules.MAX_FUNCTION_LINES}")


def long_functions(source, limit):
    return [function for function in functions_of(source) if function.length > limit]
