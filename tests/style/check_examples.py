"""The code in docs/adding-*.md is code that is compiled and tested. A block follows a comment that names its origin:

    <!-- tests/docs/foundation.h: block -->

There the block stands between the lines "// [block]" and "// [/block]" ("#" in scripts). Both must be equal, apart from
the indentation of the whole; every block of a page has such a comment, and every marked region is in a page."""
import re
import textwrap

from sources import Fault

MARKER = re.compile(r"<!-- (\S+): (\w+) -->")
BEGIN = re.compile(r"\s*(?://|#) \[(\w+)\]$")


def regions_of(source):
    """name -> (line, text) of the marked regions; None as text where the end is missing."""
    regions = {}
    for number, line in enumerate(source.lines):
        match = BEGIN.match(line)
        if not match:
            continue
        end = line.replace("[", "[/")
        inside = source.lines[number + 1:]
        text = "\n".join(inside[:inside.index(end)]) if end in inside else None
        regions[match.group(1)] = (number + 1, text and textwrap.dedent(text))
    return regions


def blocks_of(page):
    """(line, text, line before) of the page's fenced blocks."""
    begin = None
    for number, line in enumerate(page.lines):
        if not line.startswith("```"):
            continue
        if begin is None:
            begin = number
        else:
            yield begin + 1, "\n".join(page.lines[begin + 1:number]), page.lines[begin - 1] if begin else ""
            begin = None


def check_examples(pages, sources):
    """pages, sources: the documents, and the files that hold the regions."""
    regions = {(source.path, name): (line, text) for source in sources
               for name, (line, text) in regions_of(source).items()}
    shown = set()
    for page in pages:
        for line, text, before in blocks_of(page):
            marker = MARKER.fullmatch(before)
            if not marker:
                yield Fault(page.path, line, "no comment above this block names the region that it shows")
                continue
            shown.add(marker.groups())
            if marker.groups() not in regions:
                yield Fault(page.path, line - 1, f"{marker.group(1)} has no region {marker.group(2)}")
            elif text != regions[marker.groups()][1]:
                yield Fault(page.path, line, f"differs from the region {marker.group(2)} of {marker.group(1)}")
    for (path, name), (line, text) in regions.items():
        if text is None:
            yield Fault(path, line, f"the region {name} has no end")
        elif (path, name) not in shown:
            yield Fault(path, line, f"no page shows the region {name}")
