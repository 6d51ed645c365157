"""What the style tests check, as data. Who may include whom and who owns which package is read from docs/modules.md:
the tables that people read are the ones that are checked."""
import pathlib
import re

ARCHITECTURE = "docs/architecture.md"
MODULES = "docs/modules.md"
NOTHING = "nothing of ours"
EVERYTHING = "everything"


def rows_of(text, heads):
    """(line number, cells) for each row of the table whose header cells these are."""
    inside = False
    for number, line in enumerate(text.split("\n"), 1):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")] if line.startswith("|") else None
        if cells is None:
            inside = False
        elif cells == heads:
            inside = True
        elif inside and not set(cells[0]) <= set("-: "):
            yield number, cells


class Modules:
    """The tables of docs/modules.md. may_include: module -> modules, None where it may include everything; lines: module
    -> line in the page; owners: beginning of an included name -> beginnings of the paths that may include it; text: the
    page."""

    def __init__(self, text):
        self.text = text
        self.may_include, self.lines, self.owners = {}, {}, {}
        for number, (modules, others) in rows_of(text, ["module", "may include"]):
            for module in modules.split(", "):
                self.lines[module] = number
                if others == EVERYTHING:
                    self.may_include[module] = None
                else:
                    self.may_include[module] = [] if others == NOTHING else others.split(", ")
        for _, (_, includes, owners) in rows_of(text, ["package", "its headers", "owner"]):
            for include in re.findall(r"`([^`]+)`", includes):
                self.owners[include] = re.findall(r"`([^`]+)`", owners)

    @classmethod
    def of(cls, root):
        return cls(pathlib.Path(root, MODULES).read_text(encoding="utf-8"))


def architecture_of(root):
    """The text of docs/architecture.md."""
    return pathlib.Path(root, ARCHITECTURE).read_text(encoding="utf-8")


SOURCE_FOLDERS = ["sim", "render", "editor", "selvedge", "batch", "app", "bench", "python", "tests"]
SOURCE_SUFFIXES = [".h", ".cpp"]
TEXT_FOLDERS = SOURCE_FOLDERS + ["shaders", "cmake", "scripts", ".ci", "docs", "examples"]
TEXT_SUFFIXES = SOURCE_SUFFIXES + [".py", ".pyi", ".cmake", ".txt", ".md", ".glsl", ".vert", ".frag", ".sh", ""]

MAX_FILE_LINES = 700
MAX_FUNCTION_LINES = 60  # fails above; a function should fit on one screen
LONG_FUNCTION_LINES = 45  # is named above, and does not fail
CLANG_FORMAT_VERSION = 14  # others break lines elsewhere

# Written so that no pattern finds itself.
FORBIDDEN_TEXT = {
    r"\b(?:TO[D]O|FIX[M]E|X[X]X)\b": "an open end: do it, or write an issue",
    r"(?<![\w.])/(?:wor[k]|hom[e]|roo[t]|tm[p]|var/tm[p])/": "a path of one machine",
}
