"""Sewing patterns: panels, the edges of their outlines, and seams. Lengths are metres, angles radians.

Panels are drawn as seen from the right side of their fabric; there, outlines run counter-clockwise. Everything may be
read, changed and made from nothing; what is wrong is found when a pattern is checked, saved or dressed.
"""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Union, cast

import numpy as np

from selvedge import _selvedge
from selvedge._errors import InputError

if TYPE_CHECKING:  # it is slow to import
    import numpy.typing as npt

    Points = npt.NDArray[np.float64]
PathLike = Union[str, "os.PathLike[str]"]


def _no_points() -> Points:
    return np.zeros((0, 2))


class SeamSide(NamedTuple):
    """One side of a seam: an edge of a panel."""

    panel: str
    """Name of the panel."""
    edge: int
    """Index into the panel's edges."""


class Fault(NamedTuple):
    """A fault of a pattern or its file."""

    severity: str
    """'error' or 'warning'."""
    file: str
    """The file, or empty."""
    place: str
    """Where it is: a JSON path in the file, such as pattern.panels.front.edges[3]."""
    problem: str
    """What is wrong there."""


@dataclasses.dataclass(eq=False, slots=True)
class Thread:
    """A sewing thread."""

    colour: str = "#FFFFFF"
    """#RRGGBB."""
    thickness: float = 0.0004
    """m."""


@dataclasses.dataclass(eq=False, slots=True)
class Topstitch:
    """Rows of stitches beside a line. To its left is inside along an outline, and on the first panel of a seam."""

    distances: Points = dataclasses.field(default_factory=lambda: np.full(2, 0.006))
    """Of the first row from the line, and of each further row from the one before, shape (2,), m; negative: to the
    right."""
    rows: int = 1
    """How many, 1 to 9."""
    stitch_length: float = 0.003
    """Of one stitch, m."""
    thread: Thread = dataclasses.field(default_factory=Thread)
    """The sewing thread."""


@dataclasses.dataclass(eq=False, slots=True)
class Elastic:
    """A band that is sewn along an edge and draws it together."""

    share: float = 0.7
    """Its length at rest, as a share of the edge's, 0.2 to 1."""
    stiffness: float = 30.0
    """Its tension per unit of strain, N."""


@dataclasses.dataclass(eq=False, slots=True)
class Edge:
    """One edge of a panel's outline, from one vertex to the next.

    kind is 'line', 'quadratic' or 'cubic' (Bezier curves) or 'circle' (an arc).
    """

    start: int
    """Index of the panel's vertex where it starts."""
    end: int
    """Index of the panel's vertex where it ends: the start of the next edge."""
    kind: str = "line"
    """'line', 'quadratic', 'cubic' or 'circle'."""
    control: Points = dataclasses.field(default_factory=_no_points)
    """Control points, shape (n, 2), m: one of a quadratic curve, two of a cubic one, else none."""
    radius: float = 0.0
    """Of an arc, m."""
    is_large_arc: bool = False
    """Of an arc: it is more than half of its circle."""
    turns_right: bool = False
    """Of an arc: it turns right on the way from start to end."""
    label: str = ""
    """A name by which seams and exports find it."""
    allowance: float | None = None
    """Seam allowance, m; None: the panel's."""
    allowance_corner: str = "mitred"
    """How the allowance ends: 'mitred', 'squared' or 'mirrored'."""
    topstitch: Topstitch | None = None
    """Stitches beside it; None: none."""
    elastic: Elastic | None = None
    """What draws it together; None: nothing."""


@dataclasses.dataclass(eq=False, slots=True)
class Notch:
    """A mark on an edge that is aligned with a mark on the other side of the seam."""

    edge: int
    """Index into the panel's edges."""
    at: float = 0.5
    """Fraction of the edge's length from its start, 0 to 1."""
    kind: str = "slit"
    """'slit', 'v', 't', 'castle' or 'u'."""
    count: int = 1
    """How many stand side by side, 1 to 9."""


@dataclasses.dataclass(eq=False, slots=True)
class InternalLine:
    """A line inside of a panel."""

    name: str
    """Its name."""
    points: Points
    """Shape (n, 2), m."""
    use: str = "mark"
    """'mark' or 'fold'."""
    topstitch: Topstitch | None = None
    """Stitches beside it; None: none."""


@dataclasses.dataclass(eq=False, slots=True)
class Panel:
    """A flat piece of cloth. A point p of it starts at rotation @ (x, y, 0) + translation, x negated if is_mirrored."""

    name: str
    """Its name; no two panels have the same."""
    vertices: Points
    """Corners of the outline, shape (n, 2), m."""
    edges: list[Edge]
    """The outline, counter-clockwise seen from the fabric's right side: each edge ends where the next one starts."""
    translation: Points = dataclasses.field(default_factory=lambda: np.zeros(3))
    """Where it starts, shape (3,), m."""
    rotation: Points = dataclasses.field(default_factory=lambda: np.eye(3))
    """How it starts, a rotation matrix of shape (3, 3)."""
    is_mirrored: bool = False
    """Whether x is negated before it is placed."""
    grain_angle: float = 0.0
    """From its +y to the warp, counter-clockwise, rad."""
    sett_offset: Points = dataclasses.field(default_factory=lambda: np.zeros(2))
    """By which the sett is moved under it, (weft, warp), shape (2,), m."""
    fabric: str = ""
    """A shipped fabric or the file of one; empty: the pattern's."""
    interlinings: list[str] = dataclasses.field(default_factory=list)
    """Fabrics that are fused to it."""
    layer: int = 0
    """Where panels lie on each other, a higher one is farther from the body; -1000 to 1000."""
    garment: str = ""
    """The garment it is a part of; empty: the one named as the pattern."""
    pins: list[int] = dataclasses.field(default_factory=list)
    """Indices of vertices that are pinned."""
    internal_lines: list[InternalLine] = dataclasses.field(default_factory=list)
    """Lines inside of it."""
    notches: list[Notch] = dataclasses.field(default_factory=list)
    """Marks on its edges."""
    drill_points: Points = dataclasses.field(default_factory=_no_points)
    """Where holes mark a pocket or the end of a dart, shape (n, 2), m."""
    allowance: float | None = None
    """Seam allowance, m; None: the pattern's."""
    pieces: int = 1
    """How often it is cut."""
    is_worn: bool = True
    """False: it is cut, but takes no part in the drape."""
    wrap_radius: float = 0.0
    """m; it starts bent round a cylinder of this radius, with the axis parallel to its y; 0: it starts flat."""
    mirror_of: str = ""
    """The panel whose mirror image it is kept; empty: of none."""
    copy_of: str = ""
    """The panel of which it is kept a copy, placed on its own; empty: of none."""
    label: str = ""
    """GarmentCode's part of the body, or anything."""
    sheet_position: Points | None = None
    """Of its origin on the 2D sheet, shape (2,), m; None: automatic."""
    _origin: Any = dataclasses.field(default=None, repr=False)

    @classmethod
    def polygon(cls, name: str, vertices: npt.ArrayLike, **attributes: Any) -> Panel:
        """A panel with straight edges through these vertices, (n, 2) in m, which are turned counter-clockwise.

        attributes: others of the panel. Edge i runs from vertex i to the next one.
        """
        points = np.array(vertices, dtype=float)
        if points.ndim != 2 or points.shape[1] != 2 or len(points) < 3:
            raise InputError("", "vertices", "must be an array of shape (n, 2), of three vertices or more")
        following = np.roll(points, -1, axis=0)
        if np.sum(points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]) < 0:
            points = points[::-1].copy()
        edges = [Edge(i, (i + 1) % len(points)) for i in range(len(points))]
        return cls(name, points, edges, **attributes)


@dataclasses.dataclass(eq=False, slots=True)
class Seam:
    """Joins two edges, of one panel or of two."""

    first: SeamSide | tuple[str, int]
    """A panel's name and the index of an edge of it."""
    second: SeamSide | tuple[str, int]
    """The other edge."""
    is_reversed: bool = True
    """Start is sewn to end: the right side of one panel continues that of the other. False: start is sewn to start,
    and the right side of one continues the wrong side of the other, as at a lapel."""
    name: str = ""
    """Its name; empty: made of its two edges."""
    is_eased: bool = False
    """The sides differ in length on purpose."""
    sewing: str = ""
    """The 1:N or M:N sewing it is a part of; empty: it stands alone."""
    topstitch: Topstitch | None = None
    """Stitches beside it; None: none."""


@dataclasses.dataclass(eq=False, slots=True)
class Pattern:
    """The sewing pattern of a garment."""

    name: str = ""
    """Its name."""
    panels: list[Panel] = dataclasses.field(default_factory=list)
    """Its panels."""
    seams: list[Seam] = dataclasses.field(default_factory=list)
    """Its seams."""
    fabric: str = ""
    """A shipped fabric (fabric_names()) or the file of one; empty: cotton_shirting."""
    tartan: str = ""
    """A shipped tartan (tartan_names()) or a threadcount; empty: the default."""
    sett_size: float | None = None
    """Repeat of the tartan, m; None: its own."""
    sett_position: Points = dataclasses.field(default_factory=lambda: np.zeros(2))
    """Where the sett begins, (weft, warp), shape (2,), m."""
    body: str = "mannequin:sex=female"
    """The body that the panels are placed for: "mannequin:sex=female,bust=92" (cm), or a file; empty: GarmentCode's."""
    body_height: float = 1.7199
    """Stature of that body, m."""
    edge_length: float | None = None
    """Edge length of the base mesh, m; None: 0.05."""
    allowance: float = 0.0
    """Seam allowance, m."""
    size: str = ""
    """For which it was drafted: "40", "M"."""
    _document: Any = dataclasses.field(default=None, repr=False)

    def panel(self, name: str) -> Panel:
        """The panel of that name. Raises InputError if there is none."""
        for panel in self.panels:
            if panel.name == name:
                return panel
        raise InputError("", "panels", f"no panel '{name}'")

    def save(self, path: PathLike) -> None:
        """Writes a garment file. What it does not change in the file that it was loaded from stays as it was there.

        Raises InputError for a pattern that could not be loaded again, or if the file cannot be written.
        """
        _selvedge._save(document_of(self), os.fspath(path))

    def _repr_html_(self) -> str:
        """What notebooks show: its sheet."""
        from selvedge._notebook import pattern_html  # it imports this module

        return pattern_html(self)

    def check(self) -> list[Fault]:
        """All faults of the pattern, as `selvedge check` lists them; empty: none. Does not raise InputError."""
        try:
            document = document_of(self)
        except InputError as error:
            return [Fault("error", error.file, error.place, error.problem)]
        return [Fault(*fault) for fault in _selvedge._faults(document)]


def load_pattern(path: PathLike) -> Pattern:
    """Loads a garment file (a GarmentCode specification). Raises InputError for its first fault that is an error."""
    return _pattern_of(_selvedge._load_document(os.fspath(path)))


def check(path: PathLike) -> list[Fault]:
    """All faults of a garment file, as `selvedge check` lists them; empty: none. Does not raise InputError."""
    return [Fault(*fault) for fault in _selvedge._faults_of_file(os.fspath(path))]


def _pattern_of(document: _selvedge._Document) -> Pattern:
    pattern: Pattern = _made(Pattern, _selvedge._record(document))
    pattern._document = document
    for seam in pattern.seams:
        seam.first, seam.second = SeamSide(*seam.first), SeamSide(*seam.second)
    return pattern


# The attributes that are lists of parts, and those that are a part or None.
_LISTS: dict[str, type] = {
    "panels": Panel, "seams": Seam, "edges": Edge, "notches": Notch, "internal_lines": InternalLine,
}
_PARTS: dict[str, type] = {"topstitch": Topstitch, "thread": Thread, "elastic": Elastic}
_RECORD_NAMES = {"_origin": "origin", "_document": "document"}


def _made(kind: type, record: dict[str, Any]) -> Any:
    origin = record.pop("origin", None)
    for name, value in record.items():
        if name in _LISTS:
            record[name] = [_made(_LISTS[name], one) for one in value]
        elif name in _PARTS and value is not None:
            record[name] = _made(_PARTS[name], value)
    made = kind(**record)
    if origin is not None:
        made._origin = origin
    return made


def document_of(pattern: Pattern | PathLike) -> _selvedge._Document:
    """The document of a pattern, checked, or of the file at a path. Not a part of the interface."""
    if isinstance(pattern, (str, os.PathLike)):
        return _selvedge._load_document(os.fspath(pattern))
    if not isinstance(pattern, Pattern):
        raise TypeError(f"a Pattern or a path is needed, not {type(pattern).__name__}")
    return _selvedge._make_document(_record_of(pattern, ""), pattern._document)


def _records(objects: Sequence[Any], kind: type, place: str) -> list[dict[str, Any]]:
    if not isinstance(objects, (list, tuple)):
        raise InputError("", place, f"must be a list of {kind.__name__}")
    return [_record_of(one, f"{place}[{i}]", kind) for i, one in enumerate(objects)]


def _record_of(one: Any, place: str, kind: type = Pattern) -> dict[str, Any]:
    if not isinstance(one, kind):
        raise InputError("", place, f"must be of type {kind.__name__}, not {type(one).__name__}")
    record = {}
    for field in dataclasses.fields(cast(Any, one)):
        value = getattr(one, field.name)
        inner = f"{place}.{field.name}" if place else field.name
        if field.name in _LISTS:
            value = _records(value, _LISTS[field.name], inner)
        elif field.name in _PARTS and value is not None:
            value = _record_of(value, inner, _PARTS[field.name])
        record[_RECORD_NAMES.get(field.name, field.name)] = value
    return record
