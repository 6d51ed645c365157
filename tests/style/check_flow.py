"""The picture in docs/architecture.md of a panel's way from file to pixel: types are nodes, and each arrow is labelled
with the function or data member that leads from one to the other and with the header that declares it. check_flow()
says where the picture differs from the code."""
import re

import rules
from sources import Fault, without_comments_and_strings

BEGIN, END = ["```mermaid", "flowchart TD"], "```"
ARROW = re.compile(r'\s*(\w+)(?:\["([^"]+)"\])? -->\|"([\w:]+)<br>([\w/.]+)"\| (\w+)(?:\["([^"]+)"\])?$')


def arrows_of(text):
    """(line number, type, name, header, type) for each arrow; (line number, None, line, None, None) for other lines.
    None if there is no picture."""
    lines = text.split("\n")
    begin = next((i for i in range(len(lines)) if lines[i:i + 2] == BEGIN), None)
    if begin is None:
        return None
    labels, arrows = {}, []
    for number in range(begin + 2, lines.index(END, begin)):
        match = ARROW.match(lines[number])
        if not match:
            arrows.append((number + 1, None, lines[number].strip(), None, None))
            continue
        start, start_label, name, header, end, end_label = match.groups()
        for node, label in ((start, start_label), (end, end_label)):
            labels[node] = label or labels.get(node, node)
        arrows.append((number + 1, labels[start], name, header, labels[end]))
    return arrows


def declarations_of(text, name):
    """What declares `name` in a header: the declaration without its initializers, and the name of the class around it
    if the name is Class::member."""
    text = without_comments_and_strings(text)
    scope, _, simple = name.rpartition("::")
    if scope:
        text = _body_of(text, scope)
    for match in re.finditer(rf"\b{simple}\b(?=\s*(?P<next>[({{;=]))", text):
        head = re.split(r"[;{}]|\b(?:public|private|protected):", text[:match.start()])[-1]
        if not head.strip() or re.search(r"[(=]|\breturn\b|\busing\b", head):
            continue  # a call, a parameter or an initializer
        parameters = _parenthesized(text, match.end("next") - 1) if match.group("next") == "(" else ""
        yield f"{scope} {head} {simple}{parameters}"


def _body_of(text, scope):
    match = re.search(rf"\b(?:class|struct) {scope}\b[^;{{]*{{", text)
    if not match:
        return ""
    depth, position = 1, match.end()
    while depth > 0 and position < len(text):
        depth += {"{": 1, "}": -1}.get(text[position], 0)
        position += 1
    return text[match.end():position - 1]


def _parenthesized(text, begin):
    depth = 0
    for position in range(begin, len(text)):
        depth += {"(": 1, ")": -1}.get(text[position], 0)
        if depth == 0:
            return text[begin:position + 1]
    return text[begin:]


def _mentions(declaration, name):
    return re.search(rf"(?<!\w){re.escape(name)}(?!\w)", declaration)


def check_flow(sources, page):
    """Each arrow is declared where it says, and its declaration mentions the types at both of its ends. page: the text of
    docs/architecture.md."""
    arrows = arrows_of(page)
    if not arrows:
        yield Fault(rules.ARCHITECTURE, 1, "has no picture of a panel's way from file to pixel")
        return
    texts = {source.path: source.text for source in sources}
    for line, start, name, header, end in arrows:
        if start is None:
            yield Fault(rules.ARCHITECTURE, line, f"'{name}' is no arrow of the picture")
            continue
        declarations = list(declarations_of(texts.get(header, ""), name))
        if not declarations:
            yield Fault(rules.ARCHITECTURE, line, f"{header} does not declare {name}")
        elif not any(_mentions(found, start) and _mentions(found, end) for found in declarations):
            yield Fault(rules.ARCHITECTURE, line, f"no declaration of {name} mentions {start} and {end}")
