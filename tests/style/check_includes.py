"""Who may include whom, and which module owns which package (docs/modules.md)."""
import rules
from sources import Fault, includes_of


def module_of(path, table):
    """The module a file stands in: the longest folder that the table names."""
    modules = [module for module in table.may_include if path.startswith(module + "/")]
    return max(modules, key=len, default=None)


def check_directions(sources, table):
    """Every include of our own files against the table."""
    for source in sources:
        module = module_of(source.path, table)
        if module is None:
            yield Fault(source.path, 1, "stands in no module of the table")
            continue
        for line, name, is_ours in includes_of(source):
            if is_ours:
                problem = _direction_problem(module, name, table)
                if problem:
                    yield Fault(source.path, line, problem)


def _direction_problem(module, name, table):
    other = module_of(name, table)
    if other is None:
        return f'"{name}" is no path from the root into a module'
    allowed = table.may_include[module]
    if other == module or allowed is None or other in allowed:
        return None
    return f"{module} may not include {other}"


def check_allowances(sources, table):
    """The table allows nothing that no file uses."""
    used = set()
    for source in sources:
        for _, name, is_ours in includes_of(source):
            if is_ours:
                used.add((module_of(source.path, table), module_of(name, table)))
    for module, others in table.may_include.items():
        for other in others or []:
            if (module, other) not in used:
                yield Fault(rules.MODULES, table.lines[module], f"{module} never includes {other}")


def check_packages(sources, table):
    """Every include of a package against its owners. Tests may judge by any tool."""
    for source in sources:
        if source.path.startswith("tests/"):
            continue
        for line, name, _ in includes_of(source):
            for package, owners in table.owners.items():
                if name.startswith(package) and not any(source.path.startswith(owner) for owner in owners):
                    yield Fault(source.path, line, f"<{name}> belongs to {' and '.join(owners)} alone")


def check_own_header(sources):
    """A source includes the header of its name before anything else: so its compilation shows that the header compiles
    alone."""
    paths = {source.path for source in sources}
    for source in sources:
        own = source.path.removesuffix(".cpp") + ".h"
        if not source.path.endswith(".cpp") or own not in paths:
            continue
        first = next(((line, name) for line, name, _ in includes_of(source)), (1, ""))
        if first[1] != own:
            yield Fault(source.path, first[0], f'does not include "{own}" first')


def check_cycles(sources, table):
    """Files that include each other in a circle, and modules that do."""
    paths = {source.path for source in sources}
    files, modules = {}, {}
    for source in sources:
        for line, name, is_ours in includes_of(source):
            if is_ours and name in paths:
                files.setdefault(source.path, {}).setdefault(name, (source.path, line))
                here, there = module_of(source.path, table), module_of(name, table)
                if here != there:
                    modules.setdefault(here, {}).setdefault(there, (source.path, line))
    for graph in (files, modules):
        yield from _cycle_faults(graph)


def check_table(table):
    """The table itself has no cycle either."""
    yield from _cycle_faults({module: {other: (rules.MODULES, table.lines[module]) for other in others}
                              for module, others in table.may_include.items() if others})


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
