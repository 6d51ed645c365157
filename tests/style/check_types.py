"""One name, one type: a type that two files define in one namespace breaks the one-definition rule, which no compiler
sees."""
import re

from sources import Fault, without_comments_and_strings

NAMESPACE = re.compile(r"\bnamespace(?:\s+([\w:]+))?\s*$")
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)(?:\s+final)?\s*"
                  r"(?::[^:][^;{}]*)?$")


def types_of(source):
    """(namespace, name, line) of each type that is defined in a namespace with a name."""
    stack, found, head_start = [], [], 0
    text = without_comments_and_strings(source.text)
    for position, character in enumerate(text):
        if character not in "{};":
            continue
        head = text[head_start:position].strip()
        if character == "{":
            namespace, type_name = NAMESPACE.search(head), TYPE.search(head)
            if namespace:
                stack.append(namespace.group(1) or "(anonymous)")
            else:
                if type_name and "(" not in head and None not in stack and "(anonymous)" not in stack:
                    found.append(("::".join(stack), type_name.group(1), text.count("\n", 0, position) + 1))
                stack.append(None)
        elif character == "}" and stack:
            stack.pop()
        head_start = position + 1
    return found


def check_types(sources):
    """A type that is defined twice."""
    first = {}
    for source in sources:
        for namespace, name, line in types_of(source):
            before = first.setdefault((namespace, name), (source.path, line))
            if before != (source.path, line):
                yield Fault(source.path, line, f"{namespace}::{name} is defined in {before[0]} too")
