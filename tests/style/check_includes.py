"""Who may include whom (docs/architecture.md), and which room owns which package."""
import rules
from sources import Fault, includes_of


def room_of(path):
    """The room a file stands in: the longest folder that the table names, or a folder that may include everything."""
    rooms = [room for room in [*rules.MAY_INCLUDE, *rules.MAY_INCLUDE_EVERYTHING] if path.startswith(room + "/")]
    return max(rooms, key=len, default=None)


def check_directions(sources):
    """Every include of our own files against the table."""
    for source in sources:
        room = room_of(source.path)
        if room is None:
            yield Fault(source.path, 1, "stands in no room of the table")
            continue
        for line, name, is_ours in includes_of(source):
            if is_ours:
                problem = _direction_problem(room, name)
                if problem:
                    yield Fault(source.path, line, problem)


def _direction_problem(room, name):
    if room in rules.MAY_INCLUDE_EVERYTHING:
        return None
    other = room_of(name)
    if other is None:
        return f'"{name}" is no path from the root into a room'
    if other == room or other in rules.MAY_INCLUDE[room]:
        return None
    return f"{room} may not include {other}"


def check_packages(sources):
    """Every include of a package against its owners."""
    for source in sources:
        if source.path.startswith("tests/"):
            continue
        for line, name, _ in includes_of(source):
            for package, owners in rules.PACKAGE_OWNERS.items():
                if name.startswith(package) and not any(source.path.startswith(owner) for owner in owners):
                    yield Fault(source.path, line, f"<{name}> belongs to {' and '.join(owners) or 'tests'} alone")


def check_cycles(sources):
    """Files that include each other in a circle, and rooms that do."""
    paths = {source.path for source in sources}
    files, rooms = {}, {}
    for source in sources:
        for line, name, is_ours in includes_of(source):
            if is_ours and name in paths:
                files.setdefault(source.path, {}).setdefault(name, (source.path, line))
                here, there = room_of(source.path), room_of(name)
                if here != there:
                    rooms.setdefault(here, {}).setdefault(there, (source.path, line))
    for graph in (files, rooms):
        yield from _cycle_faults(graph)


def check_table():
    """The table itself has no cycle either."""
    yield from _cycle_faults({room: {other: ("tests/style/rules.py", 1) for other in others}
                              for room, others in rules.MAY_INCLUDE.items()})


def _cycle_faults(graph):
    done = set()
    for start in sorted(graph):
        cycle = _find_cycle(graph, start, [], done)
        if cycle:
            path, line = graph[cycle[0]][cycle[1]]
            yield Fault(path, line, "a circle: " + " -> ".join(cycle))


def _find_cycle(graph, node, trail, done):
    if node in trail:
        return trail[trail.index(node):] + [node]
    if node in done:
        return None
    for other in sorted(graph.get(node, {})):
        cycle = _find_cycle(graph, other, trail + [node], done)
        if cycle:
            done.add(node)
            return cycle
    done.add(node)
    return None


def check_document(text, path="docs/architecture.md"):
    """The table that people read says the same as the one that is checked."""
    rows = {}
    for number, line in enumerate(text.split("\n"), 1):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 2 and cells[0] in rules.MAY_INCLUDE:
            rows[cells[0]] = (number, sorted(room_name.strip() for room_name in cells[1].split(",")))
    for room, others in rules.MAY_INCLUDE.items():
        number, written = rows.get(room, (1, None))
        if written != (sorted(others) or ["nothing of ours"]):
            yield Fault(path, number, f"{room} stands otherwise in tests/style/rules.py")
