#!/usr/bin/env python3
"""The picture of the modules in docs/modules.md, as Mermaid draws it: draw_modules.py [ROOT] prints it, and with --write
puts it into the page. An arrow leads from a module to one that it includes; an arrow that follows from others is left
out. check_picture() says where the page's picture differs from the table of who may include whom, and
check_names() which modules docs/architecture.md does not name."""
import pathlib
import sys

import rules
from sources import Fault

BEGIN, END = ["```mermaid", "flowchart BT"], "```"


def direct_edges(may_include):
    """The table's pairs without those that a longer way gives."""
    def reach(module):
        found, open_ends = set(), list(may_include[module] or [])
        while open_ends:
            other = open_ends.pop()
            if other not in found:
                found.add(other)
                open_ends += may_include.get(other) or []
        return found

    edges = []
    for module, others in may_include.items():
        others = others or []
        for other in others:
            if not any(other in reach(between) for between in others if between != other):
                edges.append((module, other))
    return sorted(edges)


def draw(may_include):
    """The lines of the picture, the fence included."""
    drawn = {module: others for module, others in may_include.items() if others is not None}
    lines = list(BEGIN)
    for folder in dict.fromkeys(module.split("/")[0] for module in drawn):
        if folder in drawn:
            lines.append(f"  {folder}")
            continue
        lines.append(f"  subgraph {folder}")
        lines += [f"    {module.replace('/', '_')}[{module}]" for module in drawn if module.split("/")[0] == folder]
        lines.append("  end")
    lines += [f"  {a.replace('/', '_')} --> {b.replace('/', '_')}" for a, b in direct_edges(drawn)]
    return lines + [END]


def place_of_picture(lines):
    """(first line, line after the last one) of the picture, from 0; None if there is none."""
    begin = next((i for i in range(len(lines)) if lines[i:i + 2] == BEGIN), None)
    return None if begin is None else (begin, lines.index(END, begin) + 1)


def check_picture(modules):
    """The page's picture of the modules is the table's, line by line."""
    lines = modules.text.split("\n")
    place = place_of_picture(lines)
    if place is None:
        yield Fault(rules.MODULES, 1, "has no picture of the modules")
        return
    begin, end = place
    drawn, wanted = lines[begin:end], draw(modules.may_include)
    for offset, line in enumerate(drawn):
        if line not in wanted:
            yield Fault(rules.MODULES, begin + offset + 1, f"'{line.strip()}' does not follow from the table")
    for line in wanted:
        if line not in drawn:
            yield Fault(rules.MODULES, begin + 1, f"the picture lacks '{line.strip()}'")
    if sorted(drawn) == sorted(wanted) and drawn != wanted:
        offset = next(i for i, line in enumerate(drawn) if line != wanted[i])
        yield Fault(rules.MODULES, begin + offset + 1, f"'{wanted[offset].strip()}' belongs here, in the table's order")
    elif set(drawn) == set(wanted) and drawn != wanted:
        yield Fault(rules.MODULES, begin + 1, "the picture has a line twice")


def check_names(modules, architecture):
    """docs/architecture.md names every module. architecture: its text."""
    for module, line in modules.lines.items():
        if f"`{module}`" not in architecture:
            yield Fault(rules.MODULES, line, f"{rules.ARCHITECTURE} does not name {module}")


def with_picture(modules):
    """The page's text with the table's picture in the place of its own. Pre: it has one."""
    lines = modules.text.split("\n")
    begin, end = place_of_picture(lines)
    return "\n".join(lines[:begin] + draw(modules.may_include) + lines[end:])


def main(arguments):
    writes = "--write" in arguments
    roots = [argument for argument in arguments if argument != "--write"]
    root = roots[0] if roots else pathlib.Path(__file__).parents[2]
    modules = rules.Modules.of(root)
    if writes:
        pathlib.Path(root, rules.MODULES).write_text(with_picture(modules), encoding="utf-8")
    else:
        print("\n".join(draw(modules.may_include)))


if __name__ == "__main__":
    main(sys.argv[1:])
