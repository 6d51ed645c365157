"""Reading the tree for the style tests: files of it, their includes, their functions."""
import dataclasses
import pathlib
import re


@dataclasses.dataclass
class Source:
    path: str  # from the root, with forward slashes
    text: str

    @property
    def lines(self):
        return self.text.split("\n")


@dataclasses.dataclass(frozen=True)
class Fault:
    path: str
    line: int
    problem: str

    def __str__(self):
        return f"{self.path}:{self.line}: {self.problem}"


def read_tree(root, folders, suffixes):
    """The files under the root's folders whose suffix is listed, in the order of their paths."""
    root = pathlib.Path(root)
    paths = [path for folder in folders for path in (root / folder).rglob("*")
             if path.is_file() and path.suffix in suffixes and "__pycache__" not in path.parts]
    return [Source(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")) for path in sorted(paths)]


INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def includes_of(source):
    """(line, name, is_ours): ours are in quotation marks."""
    for number, line in enumerate(source.lines, 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(2), match.group(1) == '"'


TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|'
                   r"'(?:\\.|[^'\\\n])+'", re.DOTALL)


def without_comments_and_strings(text):
    """The same text, line for line, with comments and the content of literals blanked."""
    def blank(match):
        newlines = "\n" * match.group(0).count("\n")
        return newlines if match.group(0).startswith("/") else '""' + newlines
    text = re.sub(r"(?<=\d)'(?=\d)", "", text)  # digit separators are no characters
    text = TOKEN.sub(blank, text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda match: "\n" * match.group(0).count("\n"), text,
                  flags=re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class Function:
    name: str
    line: int
    length: int  # lines, from the one with the opening brace to the one with the closing brace


SCOPE = re.compile(r"\b(?:namespace|class|struct|union|enum|extern)\b[^()]*$")
NAME = re.compile(r"([~\w:]+(?:\s*(?:==|<=>|\(\)|\[\]|[-+*/<>=!]+))?)\s*\(")


def functions_of(source):
    """Function bodies that stand in a namespace or a class. A heuristic: it counts braces, it does not parse."""
    stack, functions, head_start = [], [], 0
    text = without_comments_and_strings(source.text)
    for position, character in enumerate(text):
        if character not in "{};":
            continue
        head = text[head_start:position]
        if character == "{":
            stack.append((_kind(head, stack), head, text.count("\n", 0, position) + 1))
        elif character == "}" and stack:
            kind, head, line = stack.pop()
            if kind == "function":
                functions.append(Function(_name(head), line, text.count("\n", 0, position) + 2 - line))
        head_start = position + 1
    return functions


def _kind(head, stack):
    if any(kind != "scope" for kind, _, _ in stack):
        return "block"
    if SCOPE.search(head):
        return "scope"
    return "function" if "(" in head else "block"


def _name(head):
    match = NAME.search(head)
    return match.group(1) if match else head.strip()
