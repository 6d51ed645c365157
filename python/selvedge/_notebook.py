"""What notebooks show of results, bodies and patterns. Pictures are drawn once for each object."""

from __future__ import annotations

import base64
import html
import re
import weakref
from collections.abc import Callable
from typing import TypeVar

from selvedge import _selvedge
from selvedge._dress import render
from selvedge._errors import InputError
from selvedge._pattern import Pattern, document_of
from selvedge._selvedge import Body, Result

_SIZE = (420, 560)  # px, width and height
_WIDEST = 720  # px, of a pattern's sheet
_Shown = TypeVar("_Shown", Result, Body)
_PICTURES: weakref.WeakKeyDictionary[object, bytes] = weakref.WeakKeyDictionary()


def _picture(shown: Result | Body) -> bytes:
    known = _PICTURES.get(shown)
    if known is None:
        show = "plain" if isinstance(shown, Body) else "tartan"
        known = _PICTURES[shown] = _selvedge._png(render(shown, size=_SIZE, show=show))
    return known


def _image(shown: Result | Body) -> str:
    try:
        text = base64.b64encode(_picture(shown)).decode()
    except InputError as error:  # no OpenGL, or a result that cannot be drawn
        return f"<i>{html.escape(str(error))}</i>"
    width, height = _SIZE
    return f'<img width="{width // 2}" height="{height // 2}" src="data:image/png;base64,{text}"/>'


def result_png(result: Result) -> bytes:
    """The picture of render(), as a PNG file; also Result._repr_png_()."""
    return _picture(result)


def result_html(result: Result) -> str:
    """The picture with the verdict and the faults; also Result._repr_html_()."""
    report = result.report
    lines = [f"<b>{html.escape(report['garment'])}</b> on {html.escape(report['body'])}: {verdict(result)}"]
    lines += [f"{html.escape(fault['kind'])} ({html.escape(fault['class'])}): {html.escape(fault['cause'])}"
              for fault in result.faults]
    return f"<div>{_image(result)}<br/>{'<br/>'.join(lines)}</div>"


def verdict(result: Result) -> str:
    """In words, with the number of triangles."""
    report = result.report
    outcome = str(report["outcome"]).replace("_", " ")
    rest = "at rest" if result.settled else f"not at rest: {report['stopped_because']}"
    return f"{outcome}, {rest}, {len(result.triangles)} triangles"


def body_png(body: Body) -> bytes:
    """A picture of the body; also Body._repr_png_()."""
    return _picture(body)


def body_html(body: Body) -> str:
    """The picture with name, stature and girths; also Body._repr_html_()."""
    lines = [f"<b>{html.escape(body.name)}</b>, {body.height:.2f} m"]
    girths = [f"{name} {100 * body.measures[name]:.0f} cm" for name in ("bust", "waist", "hip") if name in body.measures]
    lines += [", ".join(girths)] if girths else []
    lines += [html.escape(note) for note in body.notes]
    return f"<div>{_image(body)}<br/>{'<br/>'.join(lines)}</div>"


def pattern_html(pattern: Pattern) -> str:
    """Its sheet, as wide as a notebook, with the faults of check(); also Pattern._repr_html_()."""
    lines = [f"<b>{html.escape(pattern.name)}</b>, {len(pattern.panels)} panels, {len(pattern.seams)} seams"]
    try:
        sheet = fitted(_selvedge._svg(document_of(pattern)))
    except InputError:
        sheet = ""
    faults = pattern.check()
    lines += [html.escape(f"{fault.severity}: {fault.place}: {fault.problem}") for fault in faults]
    return f"<div>{sheet}<br/>{'<br/>'.join(lines)}</div>"


def fitted(svg: str) -> str:
    """An SVG at its true size, made as wide as a notebook."""
    text = svg[svg.index("<svg") :]
    head, rest = text[: text.index(">")], text[text.index(">") :]
    return re.sub(r'\s(width|height)="[^"]*"', "", head) + f' style="max-width:{_WIDEST}px;background:white"' + rest


def _shown_by(method: Callable[[_Shown], object], kind: type[_Shown], name: str) -> None:
    setattr(kind, name, method)


_shown_by(result_png, Result, "_repr_png_")
_shown_by(result_html, Result, "_repr_html_")
_shown_by(body_png, Body, "_repr_png_")
_shown_by(body_html, Body, "_repr_html_")
