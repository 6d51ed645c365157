#!/usr/bin/env python3
"""Checks the tree's style: check_style.py includes|modules|types|fields|flow|text|lengths|examples|format [ROOT].
Prints file:line: problem; exit 1 when there is any, 77 when the check cannot be made here (ctest then says skipped)."""
import pathlib
import sys

import check_examples
import check_fields
import check_flow
import check_format
import check_includes
import check_text
import check_types
import draw_modules
import rules
from sources import read_tree

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import skips


def cpp_sources(root):
    return read_tree(root, rules.SOURCE_FOLDERS, rules.SOURCE_SUFFIXES)


def includes(root):
    sources, table = cpp_sources(root), rules.Modules.of(root)
    for check in (check_includes.check_directions, check_includes.check_allowances, check_includes.check_packages,
                  check_includes.check_cycles):
        yield from check(sources, table)
    yield from check_includes.check_own_header(sources)
    yield from check_includes.check_table(table)


def modules(root):
    table = rules.Modules.of(root)
    yield from draw_modules.check_picture(table)
    yield from draw_modules.check_names(table, rules.architecture_of(root))


def types(root):
    yield from check_types.check_types(cpp_sources(root))


def fields(root):
    sources = cpp_sources(root)
    yield from check_fields.check_fields(sources, check_fields.Parts.of(sources))


def flow(root):
    yield from check_flow.check_flow(cpp_sources(root), rules.architecture_of(root))


def text(root):
    yield from check_text.check_lines(read_tree(root, rules.TEXT_FOLDERS, rules.TEXT_SUFFIXES))
    yield from check_text.check_headers(cpp_sources(root))
    yield from check_text.check_paths(cpp_sources(root))


def lengths(root):
    sources = cpp_sources(root)
    for source in sources:
        for function in check_text.long_functions(source, rules.LONG_FUNCTION_LINES):
            print(f"long, but passes: {source.path}:{function.line}: {function.name}, {function.length} lines")
    yield from check_text.check_lengths(sources)


def examples(root):
    pages = [page for page in read_tree(root, ["docs"], [".md"]) if page.path.startswith("docs/adding-")]
    yield from check_examples.check_examples(pages, read_tree(root, ["tests/docs"], rules.TEXT_SUFFIXES))


def formatting(root):
    program, why_not = check_format.find_clang_format()
    if not program:
        skips.skip_program("style.format", why_not)
    yield from check_format.check_format(root, cpp_sources(root), program)


CHECKS = {"includes": includes, "modules": modules, "types": types, "fields": fields, "flow": flow,
          "text": text, "lengths": lengths, "examples": examples, "format": formatting}


def main(arguments):
    if not arguments or arguments[0] not in CHECKS:
        print(__doc__, file=sys.stderr)
        return 2
    root = arguments[1] if len(arguments) > 1 else pathlib.Path(__file__).parents[2]
    faults = list(CHECKS[arguments[0]](root))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
