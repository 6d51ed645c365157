"""The interface as a whole: stubs and texts agree with the module, it loads quickly, and nothing from Python ends the
process."""

import ast
import inspect
import os
import random
import re
import subprocess
import sys
import unittest

import numpy as np
from support import QUICK, SOURCE, shipped, two_squares

import selvedge
from selvedge import _selvedge

STUB = SOURCE / "python/selvedge/_selvedge.pyi"


def described_parameters(function):
    """Names of the parameters in the signature that pybind11 writes on the first line of a text."""
    first = function.__doc__.split("\n")[0]
    inner = first[first.index("(") + 1 : first.rindex(") ->")]
    depth, parts = 0, [""]
    for character in inner:
        depth += (character in "[(") - (character in "])")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    names = [re.split(r"[:=]", part.strip())[0] for part in parts if part.strip()]
    return [name for name in names if name != "*"]


def stub_parameters(function):
    arguments = function.args
    return [argument.arg for argument in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]


class Interface(unittest.TestCase):
    def test_the_stub_has_what_the_module_has(self):
        tree = ast.parse(STUB.read_text(encoding="utf-8"))
        functions = {one.name: one for one in tree.body if isinstance(one, ast.FunctionDef)}
        classes = {one.name: one for one in tree.body if isinstance(one, ast.ClassDef)}
        built = {name: value for name, value in vars(_selvedge).items() if not name.startswith("__")}
        self.assertEqual(set(functions) | set(classes) | {"version"}, set(built))
        for name, function in functions.items():
            self.assertEqual(stub_parameters(function), described_parameters(built[name]), name)
        for name, stub in classes.items():
            self.compare_class(stub, built[name])

    def compare_class(self, stub, built):
        members = {one.name: one for one in stub.body if isinstance(one, ast.FunctionDef)}
        aliases = {one.targets[0].id for one in stub.body if isinstance(one, ast.Assign)}
        own = {name for name in vars(built) if not name.startswith("__") or name in members}
        own -= {"_pybind11_conduit_v1_"}
        self.assertEqual(set(members) | aliases, own, stub.name)
        for name, member in members.items():
            where = f"{stub.name}.{name}"
            is_property = any(isinstance(one, ast.Name) and one.id == "property" for one in member.decorator_list)
            self.assertEqual(is_property, isinstance(vars(built)[name], property), where)
            if not is_property:
                self.assertEqual(stub_parameters(member), described_parameters(vars(built)[name]), where)

    def test_everything_public_has_a_text(self):
        for name in selvedge.__all__:
            value = getattr(selvedge, name)
            self.assertTrue((value.__doc__ or "").strip(), name)
            if not inspect.isclass(value):
                continue
            for member, own in vars(value).items():
                if member.startswith("_") or not (callable(own) or isinstance(own, (property, classmethod))):
                    continue
                text = inspect.getdoc(own) or ""
                text = re.sub(r"^\w+\(.*\) -> .*\n*", "", text)  # pybind11's signature is no text
                self.assertTrue(text.strip(), f"{name}.{member}")

    def test_every_public_function_is_typed(self):
        for name in selvedge.__all__:
            value = getattr(selvedge, name)
            if inspect.isfunction(value):
                signature = inspect.signature(value)
                kinds = [one.annotation for one in signature.parameters.values()] + [signature.return_annotation]
                self.assertNotIn(inspect.Parameter.empty, kinds, name)

    def test_fields_of_patterns_have_a_text_each(self):
        text = (SOURCE / "python/selvedge/_pattern.py").read_text(encoding="utf-8")
        for stub in [one for one in ast.parse(text).body if isinstance(one, ast.ClassDef)]:
            for field, following in zip(stub.body, [*stub.body[1:], None]):
                if isinstance(field, ast.AnnAssign) and not field.target.id.startswith("_"):
                    is_text = isinstance(following, ast.Expr) and isinstance(following.value, ast.Constant)
                    self.assertTrue(is_text, f"{stub.name}.{field.target.id}")

    def test_it_loads_quickly_and_starts_no_thread(self):
        numpy_only = "import numpy, time; begin = time.process_time(); "
        count = "import os; print(time.process_time() - begin, len(os.listdir('/proc/self/task')))"
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        seconds = []
        for _ in range(3):
            done = subprocess.run([sys.executable, "-c", f"{numpy_only} import selvedge; {count}"], env=environment,
                                  capture_output=True, text=True, check=True)
            used, threads = done.stdout.split()
            seconds.append(float(used))
            self.assertEqual(int(threads), 1)
        self.assertLess(min(seconds), 0.3)


WRONG = [
    None, True, -1, 0, 7, 2**70, -1.5, float("nan"), float("inf"), 1e300, "", "no", "\udc80", b"bytes", (), [], {},
    [1, 2, 3], (0, 0, 0), [[float("nan")] * 3], np.zeros(3), np.zeros((0, 3)), np.ones((4, 3)), np.array("text"),
    np.array([None]), object(), lambda *_: 1 / 0, np.full((5, 3), -1), np.full((5, 3), 2**40), "x" * 100_000,
]


class Fuzz(unittest.TestCase):
    """Wrong arguments raise an exception of Python; none ends the process."""

    def setUp(self):
        self.random = random.Random(7)

    def one(self):
        return self.random.choice(WRONG)

    def call(self, function, *arguments, **named):
        try:
            function(*arguments, **named)
        except Exception:  # any is right, as long as the process goes on
            pass

    def test_functions_with_wrong_arguments(self):
        body = selvedge.mannequin(resolution=1)
        result = selvedge.dress(shipped("two_squares"), body, **{**QUICK, "seconds": 0.01})
        session = selvedge.Session(shipped("two_squares"), body, edge_length=0.1, max_level=0)
        session.start()
        session.advance(30)
        mesh = result.mesh
        calls = [
            (selvedge.load_pattern, 1), (selvedge.check, 1), (selvedge.load_body, 1), (selvedge.load_mesh, 1),
            (selvedge.Mesh, 2), (selvedge.write_png, 2), (selvedge.render, 1), (result.seam_vertices, 1),
            (result.export, 1), (mesh.export, 1), (body.export, 1), (session.pin, 2), (session.pull, 3),
            (session.pull_to, 1), (session.set_body, 1), (session.set_pattern, 1), (selvedge.Session, 1),
            (selvedge.InputError, 3), (selvedge.Panel.polygon, 2),
        ]
        for function, count in calls:
            for _ in range(25):
                self.call(function, *(self.one() for _ in range(count)))
        names = {
            selvedge.mannequin: ("bust", "height", "resolution", "stance", "sex"),
            selvedge.dress: ("fabric", "seconds", "edge_length", "max_level", "triangles", "threads", "over"),
            selvedge.render: ("size", "view", "camera", "show", "tartan", "design", "sett_size", "surface", "samples"),
        }
        for name in names[selvedge.mannequin]:
            for value in WRONG:
                if value not in (0, 7, True, None, -1, 2**70) if isinstance(value, int) else True:
                    self.call(selvedge.mannequin, **{name: value})
        for name in names[selvedge.dress]:
            for value in WRONG:  # what is right after all is ended at its first report
                arguments = {**QUICK, name: value, "progress": lambda *_: 1 / 0}
                self.call(selvedge.dress, shipped("two_squares"), body, **arguments)
        for name in names[selvedge.render]:
            for value in WRONG:
                self.call(selvedge.render, result, **{"size": (32, 32), name: value})

    def test_meshes_with_wrong_arrays(self):
        for _ in range(300):
            arguments = {name: self.one() for name in ("material", "panel") if self.random.random() < 0.5}
            self.call(lambda: selvedge.render(selvedge.Mesh(self.one(), self.one(), **arguments), size=(16, 16)))
        triangle = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=float)
        for corners in ([[0, 1, 3]], [[-1, 1, 2]], [[0, 1, 2.5]], [[0, 1]], [0, 1, 2]):
            with self.assertRaises(selvedge.InputError):
                selvedge.Mesh(triangle, corners)
        self.call(selvedge.render, selvedge.Mesh(triangle, [[0, 0, 0]]), size=(16, 16))
        self.call(selvedge.render, selvedge.Mesh(triangle * 0, [[0, 1, 2]]), size=(16, 16))

    def test_patterns_with_wrong_values(self):
        for _ in range(400):
            pattern = two_squares()
            targets = [pattern, *pattern.panels, *pattern.seams, *pattern.panels[0].edges[:3]]
            for _ in range(self.random.randint(1, 2)):
                target = self.random.choice(targets)
                name = self.random.choice([one for one in type(target).__slots__])
                setattr(target, name, self.one())
            self.call(pattern.check)

    def test_patterns_with_moved_vertices(self):
        for _ in range(60):
            pattern = two_squares()
            for _ in range(self.random.randint(1, 6)):
                panel = self.random.choice(pattern.panels)
                panel.vertices[self.random.randrange(8)] = [self.random.choice((0, 0.1, -0.28, 5, 99)) for _ in "xy"]
                edge = self.random.choice(panel.edges)
                edge.kind = self.random.choice(("line", "circle", "quadratic"))
                edge.radius = self.random.choice((0, 0.01, 0.3, 50))
                edge.control = [(0.1, self.random.choice((0, 0.5, 90)))] if edge.kind == "quadratic" else []
            if not pattern.check():
                self.call(selvedge.dress, pattern, **{**QUICK, "seconds": 0.01, "edge_length": 0.3})


if __name__ == "__main__":
    unittest.main()
