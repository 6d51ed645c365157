"""Garments on bodies that move: frames, films and caches, as the command `selvedge animate` makes them."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator, Sequence
from typing import Any

from selvedge import _selvedge
from selvedge._dress import (
    BodyLike,
    PatternLike,
    Progress,
    body_if_any,
    documents_of,
    number_option,
    numbers_option,
    picture_options,
)
from selvedge._pattern import PathLike, document_of
from selvedge._selvedge import AnimationFrame

_DRESSED = 0.3  # share of the whole work, for a bar that grows evenly enough


class Animation(_selvedge._Animation):
    """A garment on a body that moves, made by animate(): an iterator of its frames.

    Nothing moves before a frame is asked for. Film, caches and report are written when the last frame was given, or by
    finish(), or by stop() with the frames until then; if neither happens, they are not written.
    """

    _is_made = False

    def __init__(
        self,
        pattern: PatternLike,
        body: BodyLike | None,
        over: Sequence[PatternLike],
        arguments: _selvedge._DressArguments,
        options: list[str],
        threads: int | None,
        progress: Progress | None,
    ) -> None:
        """Dresses the body; see animate()."""
        if progress is not None and not callable(progress):
            raise TypeError("progress must be callable")
        self._progress = progress
        reports = None if progress is None else lambda done, stage: progress(_DRESSED * done, stage)
        super().__init__(
            document_of(pattern), body_if_any(body), documents_of(over), arguments, options, threads, reports
        )
        self._is_made = True

    def __iter__(self) -> Iterator[AnimationFrame]:
        """Itself."""
        return self

    def __next__(self) -> AnimationFrame:
        """The next frame. What `progress` raises, and KeyboardInterrupt, leave the animation at the frame before."""
        frame = self._next()
        if frame is None:
            raise StopIteration
        if self._progress is not None:
            moved = (frame.number + 1) / self.frame_count
            self._progress(_DRESSED + (1 - _DRESSED) * moved, "moving")
        return frame

    def finish(self) -> Animation:
        """Moves to the end and writes the files; gives itself."""
        for _ in self:
            pass
        return self

    def __del__(self) -> None:
        """Says that files were asked for and are not written."""
        if self._is_made and self._has_outputs and not self.is_finished:
            warnings.warn("an animation was given up before its files were written: finish() or stop()", stacklevel=2)

    @property
    def report(self) -> dict[str, Any]:
        """What came of it until now: the report of `selvedge animate --report`, a dict."""
        found: dict[str, Any] = json.loads(self._report())
        return found

    @property
    def outcome(self) -> str:
        """The verdict of the drape and of the motion until now, as in the report: 'dressed', 'defect', ..."""
        return str(self.report["outcome"])

    @property
    def faults(self) -> list[str]:
        """What is wrong with the garment in motion until now, a sentence each; of the drape: report['faults']."""
        return list(self.report["animation"]["faults"])

    def __repr__(self) -> str:
        """Its motion and its length."""
        return f"<selvedge.Animation '{self.motion}', {self.frame_count} frames>"


def animate(
    pattern: PatternLike,
    body: BodyLike | None = None,
    *,
    motion: str | None = None,
    open_arms: bool = False,
    start: float | None = None,
    end: float | None = None,
    seconds: float | None = None,
    speed: float = 1,
    blend: float = 1.5,
    fps: int = 25,
    fabric: str | None = None,
    edge_length: float | None = None,
    max_level: int = 3,
    shortest_edge: float = 0.02,
    triangles: int | None = None,
    self_collision: bool = True,
    over: Sequence[PatternLike] = (),
    threads: int | None = None,
    film: PathLike | None = None,
    fixed_camera: bool = False,
    size: tuple[int, int] = (720, 720),
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
    export: PathLike | Sequence[PathLike] = (),
    export_triangles: int = 20_000,
    skinned: bool = False,
    textures: bool = True,
    texture_size: int = 2048,
    report: PathLike | None = None,
    progress: Progress | None = None,
) -> Animation:
    """Dresses a body and lets it move: the same bits as `selvedge animate`. Gives an Animation, an iterator of frames.

        for frame in selvedge.animate("tshirt.json", motion="walk"): print(frame.number, frame.positions.shape)
        selvedge.animate("tshirt.json", motion="walk", film="walk.mp4", export="walk.glb").finish()

    pattern, body, fabric to threads: as of dress(); the body needs bones. motion: a shipped motion or pose, a clip of the
    body's file, or a file with one; None: the first of the body's file that moves. open_arms: opens the arms of the
    body's own motion where they would cut its trunk. start, end: of the motion, s; seconds: how much of it to show,
    instead of end. speed: of the motion. blend: time from the dressed pose into the motion, s. fps: frames per second.
    film: an .mp4 or .gif (by ffmpeg) or a folder of PNG files; size to supersample: of its pictures, as of render().
    fixed_camera: the camera does not follow. export: caches on one mesh of at most export_triangles: .pc2, .glb or a
    folder of .obj files, one or several. skinned: the garment of a .glb goes with the bones. report: a JSON file.
    progress: called as progress(done, stage), done from 0 to 1: while the body is dressed, and after each frame. What it
    raises ends the dressing, or the step to the next frame, and is raised here; so is KeyboardInterrupt.

    The interpreter's lock is released meanwhile. Raises InputError for wrong input. The verdict: Animation.outcome.
    """
    options = picture_options(
        size, view, camera, frame, show, tartan, design, sett_size, sett_position, surface, samples, supersample
    )
    numbers = {"from": start, "to": end, "seconds": seconds, "speed": speed, "blend": blend}
    options += [numbers_option(name, [value]) for name, value in numbers.items() if value is not None]
    options += [number_option("fps", fps), number_option("export-triangles", export_triangles)]
    options.append(number_option("texture-size", texture_size))
    files = [export] if isinstance(export, (str, os.PathLike)) else list(export)
    texts = [("motion", motion), ("film", film), ("report", report), *(("export", file) for file in files)]
    options += [f"--{name}={os.fspath(value)}" for name, value in texts if value is not None]
    flags = {"open-arms": open_arms, "fixed-camera": fixed_camera, "export-skinned": skinned, "no-textures": not textures}
    options += [f"--{name}" for name, is_on in flags.items() if is_on]
    arguments = _selvedge._DressArguments(
        fabric or "", edge_length, max_level, shortest_edge, triangles, self_collision
    )
    return Animation(pattern, body, over, arguments, options, threads, progress)
