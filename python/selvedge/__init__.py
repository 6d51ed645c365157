"""Selvedge: sewing patterns, dressed on bodies, as NumPy arrays and pictures.

Lengths are metres, angles radians, times seconds; y is up, +z to the front, +x to the body's left, the floor at y = 0.
Arrays of results are read-only views without a copy. Wrong input raises InputError, a ValueError.

    import selvedge

    result = selvedge.dress("tshirt.json", selvedge.mannequin(bust=0.92))
    print(result.settled, result.positions.shape, result.faults)
    selvedge.write_png(selvedge.render(result), "tshirt.png")
"""

from __future__ import annotations

try:
    import numpy
except ModuleNotFoundError:
    raise ModuleNotFoundError("selvedge needs NumPy, which is not installed: pip install numpy") from None

from selvedge import _arguments, _selvedge

_arguments.check_arguments_of(_selvedge)  # first: the others take the functions from there

from selvedge._animate import Animation, animate
from selvedge._batch import batch, program
from selvedge._dress import Session, dress, export, mannequin, render
from selvedge._errors import InputError
from selvedge._pattern import (
    Edge,
    Elastic,
    Fault,
    InternalLine,
    Notch,
    Panel,
    Pattern,
    Seam,
    SeamSide,
    Thread,
    Topstitch,
    check,
    load_pattern,
)
from selvedge._selvedge import (
    AnimationFrame,
    Body,
    Frame,
    Mesh,
    Result,
    fabric_names,
    load_body,
    load_mesh,
    tartan_names,
    write_png,
)
from selvedge._selvedge import version as __version__

from selvedge import _notebook  # isort: skip

Result.export = export

del numpy, _notebook

__all__ = [
    "Animation",
    "AnimationFrame",
    "Body",
    "Edge",
    "Elastic",
    "Fault",
    "Frame",
    "InputError",
    "InternalLine",
    "Mesh",
    "Notch",
    "Panel",
    "Pattern",
    "Result",
    "Seam",
    "SeamSide",
    "Session",
    "Thread",
    "Topstitch",
    "animate",
    "batch",
    "check",
    "dress",
    "export",
    "fabric_names",
    "load_body",
    "load_mesh",
    "load_pattern",
    "mannequin",
    "program",
    "render",
    "tartan_names",
    "write_png",
]
