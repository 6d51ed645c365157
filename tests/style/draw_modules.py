#!/usr/bin/env python3
"""The picture of the modules in docs/architecture.md, as Mermaid draws it: draw_modules.py [ROOT] prints it, to be put
into the document. An arrow leads from a module to one that it includes; an arrow that follows from others is left out.
check_picture() says where the document's picture differs from the table of who may include whom."""
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


def check_picture(architecture):
    """The document's picture of the modules is the table's."""
    lines = architecture.text.split("\n")
    begin = next((i for i in range(len(lines)) if lines[i:i + 2] == BEGIN), None)
    if begin is None:
        yield Fault(rules.ARCHITECTURE, 1, "has no picture of the modules")
        return
    drawn = lines[begin:lines.index(END, begin) + 1]
    wanted = draw(architecture.may_include)
    for offset, line in enumerate(drawn):
        if line not in wanted:
            yield Fault(rules.ARCHITECTURE, begin + offset + 1, f"'{line.strip()}' does not follow from the table")
    for line in wanted:
        if line not in drawn:
            yield Fault(rules.ARCHITECTURE, begin + 1, f"the picture lacks '{line.strip()}'")


if __name__ == "__main__":
    root = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]
    print("\n".join(draw(rules.Architecture.of(root).may_include)))
