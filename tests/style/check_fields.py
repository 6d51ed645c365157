"""The described parts of a pattern (sim/pattern/pattern_fields.h) are made by the names of their members, and copied as
a whole or by their fields (sim/pattern/field_moves.h): so a member that is added is neither given another one's value
nor left behind. Heuristics: names and brackets are read, types are not resolved."""
import re

from sources import Fault, without_comments_and_strings

DESCRIPTIONS = "sim/pattern/pattern_fields.h"
STRUCTS = "sim/pattern/pattern.h"
MANY = 3  # as many members that are copied one by one are a list of members

# Made of two words in one order everywhere, {panel, edge} and {number, role}: addresses, which get no properties.
ADDRESSES = {"SeamSide", "EdgeKey"}
# Tests draw outlines and seams as tables of indices: a seam as its two sides, {{0, 1}, {1, 3}}. Nothing else of it.
IN_TESTS = {"Seam": re.compile(r"\{[^{}]*\},\s*\{[^{}]*\}$"), "OutlineEdge": re.compile(r"[^{},]+,[^{},]+$")}

DESCRIBED = re.compile(r"\bfields\(const (\w+)\*\)")
FIELD = re.compile(r"\bField<&(\w+)::(\w+)")
STRUCT = re.compile(r"\bstruct (\w+) \{(.*?)\n\};", re.DOTALL)
LIST = re.compile(r"\bstd::vector<(\w+)> (\w+)")


class Parts:
    """members: part -> its members' names; lists: name of a member -> (struct that has it, part of which it is a list)."""

    def __init__(self, descriptions, structs):
        self.members = {part: set() for part in DESCRIBED.findall(descriptions) if part not in ADDRESSES}
        for part, member in FIELD.findall(descriptions):
            if part in self.members:
                self.members[part].add(member)
        self.lists = {name: (owner, part) for owner, body in STRUCT.findall(structs)
                      for part, name in LIST.findall(body) if part in self.members}

    @classmethod
    def of(cls, sources):
        texts = {source.path: source.text for source in sources}
        return cls(texts[DESCRIPTIONS], texts[STRUCTS])


def check_fields(sources, parts):
    for source in sources:
        text = without_comments_and_strings(source.text)
        for part, start, inside in braces_of(text, parts):
            is_table = source.path.startswith("tests/") and part in IN_TESTS and IN_TESTS[part].match(inside)
            if not inside.startswith(".") and not is_table:
                yield Fault(source.path, line_of(text, start), f"a {part} without the names of its members")
        for part, start, names in copies_of(text, parts):
            yield Fault(source.path, line_of(text, start), f"copies {', '.join(names)} of a {part} one by one")


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def inside_of(text, start):
    """The text between the brace at `start` and the one that closes it."""
    depth = 0
    for position in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[position], 0)
        if depth == 0:
            return text[start + 1:position]
    return text[start + 1:]


def elements_of(text, start):
    """The places of the braces that are elements of the list whose brace is at `start`."""
    inside, depth, begin = inside_of(text, start) + ",", 0, 0
    for position, character in enumerate(inside):
        depth += {"{": 1, "(": 1, "}": -1, ")": -1}.get(character, 0)
        if character == "," and depth == 0:
            element = inside[begin:position]
            if element.strip().startswith("{"):
                yield start + 1 + begin + element.index("{")
            begin = position + 1


def braces_of(text, parts):
    """(part, place, what is inside) of each {...} with something inside that makes a part."""
    for part, brace in [*_named(text, parts), *_listed(text, parts), *_returned(text, parts)]:
        inside = inside_of(text, brace).strip()
        if inside:
            yield part, brace, inside


def _named(text, parts):
    """Seam{...}, Seam seam{...}."""
    made = re.compile(rf"(?<!struct )(?<!class )(?<!class SELVEDGE_API )(?<!-> )\b({'|'.join(parts.members)})(?:\s+\w+)?\s*(?=\{{)")
    for match in made.finditer(text):
        yield match[1], match.end()


def _listed(text, parts):
    """seams = {{...}}, panel.notches.push_back({...}), std::vector<Seam> seams{{...}}."""
    for match in re.finditer(rf"\b({'|'.join(parts.lists)})(\.push_back\(|\s*=)?\s*(?=\{{)", text):
        owner, part = parts.lists[match[1]]
        before = text[:match.start()].rstrip()
        if not _holds(before, match[1], owner, part, text):
            continue
        if match[2] and match[2].startswith(".push_back"):
            yield part, match.end()
        else:
            yield from ((part, brace) for brace in elements_of(text, match.end()))


def _holds(before, name, owner, part, text):
    """Whether the list `name` behind the text `before` is one of such parts, as far as names tell."""
    object_ = re.search(r"((?:\w+(?:\(\)|\[[^\]]*\])?(?:\.|->))+)$", before)
    if not object_:
        return bool(re.search(rf"vector<(?:sim::)?{part}>\s+(?:{name}\b)", text))
    last = re.split(r"\.|->", re.sub(r"\[[^\]]*\]", "[]", object_[1].rstrip(".->")))
    if last[-1].rstrip("_()") == owner.lower():
        return True
    if owner == "Panel" and (last[-1] == "panels[]" or last[-1] in ("back()", "front()") and last[-2:-1] == ["panels"]):
        return True
    return bool(re.search(rf"\b{owner}&?\s+(?:\w+(?:\s*=[^;,]*)?,\s*)*{re.escape(last[-1])}\b", text))


def _returned(text, parts):
    """return {...}; in a function that gives a part."""
    function = re.compile(rf"\b({'|'.join(parts.members)})\s+(?:\w+::)*\w+\([^;{{}}]*\)\s*(?:const\s*)?(?=\{{)")
    for match in function.finditer(text):
        for returned in re.finditer(r"\breturn\s*(?=\{)", inside_of(text, match.end())):
            yield match[1], match.end() + 1 + returned.end()


ASSIGNED = re.compile(r"\s*([\w.\->\[\]()*:]+?)(?:\.|->)(\w+)\s*=\s*([\w.\->\[\]()*:]+?)(?:\.|->)(\w+)\s*$")


def copies_of(text, parts):
    """(part, place, names) where members of one part are copied from one object to another: a.x = b.x; a.y = b.y; ...
    What a command of the editor sets is no copy: it has just these members."""
    run, start = [], 0
    for statement in re.finditer(r"[^;{}]*[;{}]", text + ";"):
        match = ASSIGNED.match(statement[0][:-1]) if statement[0].endswith(";") else None
        copy = (match[1], match[3], match[2]) if match and match[2] == match[4] and match[3] != "command" else None
        if run and (not copy or copy[:2] != run[0][:2]):
            yield from _many(run, start, parts)
            run = []
        if copy:
            if not run:
                start = statement.end() - len(statement[0].lstrip())
            run.append(copy)


def _many(run, start, parts):
    for part, members in parts.members.items():
        names = [member for _, _, member in run if member in members]
        if len(names) >= MANY:
            yield part, start, names
            return
