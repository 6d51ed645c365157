"""Bodies, dressing, pictures and sessions: what has many arguments, over the native part."""

from __future__ import annotations

import numbers
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Union

from selvedge import _selvedge
from selvedge._pattern import PathLike, Pattern, document_of
from selvedge._selvedge import AnimationFrame, Body, Frame, Mesh, Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Picture = npt.NDArray[np.uint8]
PatternLike = Union[Pattern, PathLike]
BodyLike = Union[Body, PathLike]
Progress = Callable[[float, str], object]


def _body_of(body: BodyLike) -> Body:
    if isinstance(body, Body):
        return body
    if not isinstance(body, (str, os.PathLike)):
        raise TypeError(f"body must be a Body or a path, not {type(body).__name__}")
    return _selvedge._body_named(os.fspath(body))


def body_if_any(body: BodyLike | None) -> Body | None:
    """The body of an argument. Not a part of the interface."""
    return None if body is None else _body_of(body)


def documents_of(over: Sequence[PatternLike]) -> list[_selvedge._Document]:
    """The documents of patterns. Not a part of the interface."""
    if isinstance(over, (str, os.PathLike, Pattern)):
        raise TypeError("over must be a list of patterns or paths")
    return [document_of(one) for one in over]


def mannequin(
    sex: str = "female",
    *,
    height: float | None = None,
    inseam: float | None = None,
    waist_height: float | None = None,
    shoulder: float | None = None,
    arm: float | None = None,
    bust: float | None = None,
    underbust: float | None = None,
    waist: float | None = None,
    high_hip: float | None = None,
    hip: float | None = None,
    neck: float | None = None,
    biceps: float | None = None,
    elbow: float | None = None,
    forearm: float | None = None,
    wrist: float | None = None,
    thigh: float | None = None,
    mid_thigh: float | None = None,
    knee: float | None = None,
    calf: float | None = None,
    ankle: float | None = None,
    resolution: int = 2,
    stance: float | None = None,
) -> Body:
    """A mannequin from measurements in metres; those that are not given follow from the others.

    sex: 'female' or 'male'. height, inseam (floor to crotch), waist_height (floor to waist), shoulder (joint to joint) and
    arm (shoulder joint to wrist) are lengths, the others girths. resolution: steps of subdivision, 1 to 4. stance:
    angle of each leg outward from the vertical, rad. Body.measures has what was reached, Body.notes what could not be met.
    Raises InputError for a measure out of its range.
    """
    measures = {name: value for name, value in locals().items() if name not in ("sex", "resolution", "stance")}
    given = {name: value for name, value in measures.items() if value is not None}
    for name, value in given.items():
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"mannequin(): {name} must be a number, not {type(value).__name__}")
    return _selvedge._mannequin(sex, given, resolution, stance)


def dress(
    pattern: PatternLike,
    body: BodyLike | None = None,
    *,
    fabric: str | None = None,
    seconds: float = 12,
    edge_length: float | None = None,
    max_level: int = 3,
    shortest_edge: float = 0.02,
    triangles: int | None = None,
    self_collision: bool = True,
    over: Sequence[PatternLike] = (),
    threads: int | None = None,
    progress: Progress | None = None,
) -> Result:
    """Puts a garment on a body and drapes it until it is at rest: the same bits as `selvedge dress`.

    pattern: a Pattern or the path of a garment file. body: a Body, 'mannequin:bust=92,...' as the command
    takes it (in cm), or the path of a body file; None: the one that the pattern names.
    fabric: a shipped fabric or a fabric file, of all panels; None: the pattern's. seconds: longest simulated time,
    0.01 to 600. edge_length: of the base mesh, 0.005 to 0.3 m; None: the pattern's, or 0.05. max_level: times an edge
    may be halved, 0 to 8. shortest_edge: shorter ones are not halved, m. triangles: number to keep near.
    self_collision: whether the cloth collides with itself. over: garments worn over it, from the inside out.
    threads: most threads to use, of all that the process dresses at the time; the result is the same for any.
    progress: called as progress(done, text), done from 0 to 1, some times in a second. What it raises ends the
    dressing and is raised here; so is KeyboardInterrupt.

    The interpreter's lock is released meanwhile, so several threads can dress at once.
    Raises InputError for wrong input. What is wrong with the drape is in Result.faults.
    """
    arguments = _selvedge._DressArguments(
        fabric or "", edge_length, max_level, shortest_edge, triangles, self_collision
    )
    outer = documents_of(over)
    return _selvedge._dress(document_of(pattern), body_if_any(body), outer, arguments, seconds, threads, progress)


def _option(name: str, value: object) -> str:
    return f"--{name}={value}"


def _numbers(values: Sequence[float] | npt.NDArray[np.float64], scale: float = 1) -> str:
    return ",".join(repr(round(float(value) * scale, 12)) for value in values)


def numbers_option(name: str, values: Sequence[float]) -> str:
    """An option of numbers. Not a part of the interface."""
    return _option(name, _numbers(values))


def number_option(name: str, value: int) -> str:
    """An option of a whole number. Not a part of the interface."""
    return _option(name, int(value))


def picture_options(
    size: tuple[int, int],
    view: str,
    camera: Sequence[float] | None,
    frame: str,
    show: str,
    tartan: str | None,
    design: str | None,
    sett_size: float | None,
    sett_position: tuple[float, float] | None,
    surface: str | None,
    samples: int,
    supersample: int,
) -> list[str]:
    """The options of pictures, as the command takes them. Not a part of the interface."""
    if isinstance(size, str) or len(size) != 2:
        raise TypeError("size must be (width, height)")
    width, height = size
    options = [_option("size", f"{int(width)}x{int(height)}"), _option("frame", frame), _option("show", show)]
    options += [_option("samples", samples), _option("supersample", supersample)]
    options.append(_option("view", view) if camera is None else _option("camera", _numbers(camera)))
    texts = {"tartan": tartan, "design": design, "surface": surface}
    options += [_option(name, text) for name, text in texts.items() if text is not None]
    if sett_size is not None:
        options.append(_option("sett-size", _numbers([sett_size], 100)))
    if sett_position is not None:
        options.append(_option("sett-position", _numbers(sett_position, 100)))
    return options


def render(
    subject: Result | Mesh | Frame | AnimationFrame | Body,
    body: BodyLike | None = None,
    *,
    size: tuple[int, int] = (1024, 1024),
    view: str = "front",
    camera: Sequence[float] | None = None,
    frame: str = "all",
    show: str = "tartan",
    tartan: str | None = None,
    design: str | None = None,
    sett_size: float | None = None,
    sett_position: tuple[float, float] | None = None,
    surface: str | None = None,
    samples: int = 4,
    supersample: int = 1,
    transparent: bool = False,
    fabric: str | None = None,
) -> Picture:
    """Draws a garment: the picture of `selvedge dress --render`, or for others than a Result that of `selvedge render`.

    Returns uint8 of shape (height, width, 4): red, green, blue, alpha, from the top left.
    body: drawn with it, as of dress(); None: a result's own body, and for a mesh none. size: (width, height) in pixels.
    view: front, back, left, right, three-quarter, ... camera: instead of the view, (azimuth, elevation[, zoom]) in
    degrees, or eye and target in m, six numbers. frame: what fills the picture, 'all' or 'garment'.
    show: tartan, plain, edges, level, strain, clearance, panels, seams, ... tartan: a shipped one or a threadcount;
    None: the pattern's. design: instead of a tartan, a colour '#RRGGBB', a picture's path or 'test'. sett_size: repeat
    of either, m. sett_position: where it begins, (weft, warp), m. surface: draw a curved surface: flat, constant,
    linear, ... fabric: of a mesh, how it takes light. Raises InputError.
    """
    if not isinstance(subject, (Result, Mesh, Frame, AnimationFrame, Body)):
        raise TypeError(f"subject must be a Result, a Mesh, a frame or a Body, not {type(subject).__name__}")
    options = picture_options(
        size, view, camera, frame, show, tartan, design, sett_size, sett_position, surface, samples, supersample
    )
    if transparent:
        options.append("--transparent")
    if isinstance(subject, Result):
        return _selvedge._render_result(subject, body_if_any(body), options)
    if isinstance(subject, Body):
        mesh = Mesh(subject.vertices, subject.triangles)
    else:
        mesh = subject if isinstance(subject, Mesh) else subject.mesh
    return _selvedge._render_mesh(mesh, body_if_any(body), options, fabric or "")


def export(
    result: Result,
    path: PathLike,
    *,
    textures: bool = True,
    texture_size: int = 2048,
    with_body: bool = False,
    thickness: float | str | None = None,
) -> None:
    """Writes a result as .obj, .glb, .ply or .stl, as `selvedge dress --export` does; also Result.export().

    textures: with the cloth's colours (.glb and .obj), of texture_size pixels a side. with_body: the body in the same
    file. thickness: a closed solid, so thick in m, or 'fabric' for the fabrics' own. Raises InputError.
    """
    options = [_option("texture-size", texture_size)]
    if not textures:
        options.append("--no-textures")
    if with_body:
        options.append("--with-body")
    if thickness is not None:
        text = thickness if isinstance(thickness, str) else _numbers([thickness], 1000)
        options.append(_option("thickness", text))
    result._export(os.fspath(path), options)


class Session(_selvedge._Session):
    """A drape that is stepped by hand, for as long as one likes: the editor's, without a thread of its own.

    start() and advance() sew the garment and let it fall. Meanwhile its cloth can be pinned and pulled, and its pattern
    and body changed. What is asked for is carried out by the next advance(). Threads may share a session.
    """

    def __init__(
        self,
        pattern: PatternLike,
        body: BodyLike | None = None,
        *,
        fabric: str | None = None,
        edge_length: float | None = None,
        max_level: int = 3,
        shortest_edge: float = 0.02,
        triangles: int | None = None,
        self_collision: bool = True,
        threads: int | None = None,
    ) -> None:
        """The panels of the pattern, placed round the body. The arguments are those of dress()."""
        arguments = _selvedge._DressArguments(
            fabric or "", edge_length, max_level, shortest_edge, triangles, self_collision
        )
        super().__init__(document_of(pattern), body_if_any(body), arguments, threads)

    def set_body(self, body: BodyLike) -> None:
        """Changes the body; the garment starts again. Raises InputError for a wrong one, and changes nothing then."""
        super().set_body(_body_of(body))

    def set_pattern(self, pattern: PatternLike) -> None:
        """Changes the pattern. If its panels, edges and seams stay the same in number and kind, the cloth goes on from
        where it hangs; otherwise it starts again. Raises InputError for a wrong pattern, and changes nothing then."""
        self._set_document(document_of(pattern))
