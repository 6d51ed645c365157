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


THROWING = re.compile(r"\b(?:std::filesystem|fs)::(absolute|canonical|copy|copy_file|create_directories|create_directory|"
                      r"create_symlink|current_path|directory_iterator|equivalent|exists|file_size|is_directory|"
                      r"is_empty|is_fifo|is_other|is_regular_file|is_symlink|last_write_time|permissions|proximate|"
                      r"read_symlink|recursive_directory_iterator|relative|remove|remove_all|rename|resize_file|space|"
                      r"status|symlink_status|temp_directory_path|weakly_canonical)(?: \w+)?\(")


def last_argument(text, start):
    """The last argument of a call whose bracket opens before text[start], and whether it has any."""
    depth, begin = 1, start
    for i in range(start, len(text)):
        if text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
        elif text[i] == "," and depth == 1:
            begin = i + 1
        if depth == 0:
            return text[begin:i].strip()
    return ""


def check_paths(sources):
    """Calls of std::filesystem that throw for a path that cannot be looked at, instead of taking an error code."""
    for source in sources:
        if source.path.startswith("tests/") or not source.path.endswith((".h", ".cpp")):
            continue
        codes = set(re.findall(r"\bstd::error_code&? (\w+)", source.text))
        for found in THROWING.finditer(source.text):
            argument = last_argument(source.text, found.end())
            is_status = argument == "status" or argument.startswith("std::filesystem::symlink_status(")  # asked before, not a path
            is_end = found[1].endswith("directory_iterator") and not argument
            if argument not in codes and not is_status and not is_end:
                line = source.text.count("\n", 0, found.start()) + 1
                yield Fault(source.path, line, f"{found[1]}() throws: see sim/core/file_path.h")


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
