"""Errors of the native part's arguments: they name the argument, where pybind11's list all that a function takes."""

from __future__ import annotations

import ast
import functools
import inspect
import numbers
import os
from collections.abc import Callable
from typing import Any

from selvedge import _selvedge

# What the types of pybind11's signatures take, and how they are called.
_KINDS: dict[str, tuple[tuple[type, ...], str]] = {
    "float": ((numbers.Real,), "a number"),
    "int": ((numbers.Integral,), "a whole number"),
    "bool": ((bool,), "True or False"),
    "str": ((str,), "a text"),
    "os.PathLike": ((str, os.PathLike), "a path"),
}


def _default(value: ast.expr | None) -> Any:
    if value is None:
        return inspect.Parameter.empty
    return ast.literal_eval(value)


def _signature_of(function: Callable[..., Any]) -> inspect.Signature | None:
    """As the first line of the function's text has it; None for one of several forms."""
    line = (function.__doc__ or "").split("\n", 1)[0]
    head, _, returned = line.rpartition(" -> ")
    try:
        parsed = ast.parse(f"def f{head[head.index('('):]}: pass").body[0]
        assert isinstance(parsed, ast.FunctionDef)
        given = parsed.args
        required: list[ast.expr | None] = [None] * (len(given.args) - len(given.defaults))
        either, keyword = inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY
        named: list[tuple[ast.arg, Any, Any]]
        named = [(one, either, _default(value))
                 for one, value in zip(given.args, [*required, *given.defaults])]
        named += [(one, keyword, _default(value))
                  for one, value in zip(given.kwonlyargs, given.kw_defaults)]
    except (SyntaxError, ValueError):
        return None
    parameters = [
        inspect.Parameter(one.arg, kind, default=default, annotation=ast.unparse(one.annotation or ast.Constant("Any")))
        for one, kind, default in named
    ]
    return inspect.Signature(parameters, return_annotation=returned)


def _wrong(annotation: str, value: object) -> str:
    """What a value of this type should be, if the value is none; else an empty text."""
    if annotation.startswith("Optional["):
        return "" if value is None else _wrong(annotation[len("Optional[") : -1], value)
    if annotation.startswith(("List[", "Sequence[")):
        return "" if isinstance(value, (list, tuple)) else "a list"
    if annotation.startswith("selvedge."):  # None may be allowed: the signature does not tell
        kind = getattr(_selvedge, annotation.rsplit(".", 1)[1], object)
        return "" if value is None or isinstance(value, kind) else f"a {kind.__name__.lstrip('_')}"
    if annotation not in _KINDS:
        return ""
    types, text = _KINDS[annotation]
    return "" if isinstance(value, types) else text


def _explain(label: str, signature: inspect.Signature, args: tuple[Any, ...], kwargs: dict[str, Any]) -> str:
    try:
        bound = signature.bind(*args, **kwargs)
    except TypeError as error:
        return f"{label}{error}"
    for argument, value in bound.arguments.items():
        wanted = _wrong(str(signature.parameters[argument].annotation), value)
        if wanted:
            return f"{label}{argument} must be {wanted}, not {type(value).__name__}"
    return f"{label}wrong arguments, they are ({', '.join(signature.parameters)})"


def checked(function: Callable[..., Any], name: str) -> Callable[..., Any]:
    """The function, whose TypeErrors name the argument that is wrong; and its name, if one can call it by that."""
    signature = _signature_of(function)
    if signature is None:
        return function
    known = signature
    label = "" if name.startswith("_") else f"{name}(): "

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except TypeError as error:
            if "incompatible" not in str(error):
                raise
        raise TypeError(_explain(label, known, args, kwargs))

    call.__signature__ = known  # type: ignore[attr-defined]
    return call


def check_arguments_of(module: Any) -> None:
    """Replaces the functions and methods of the native module by checked ones."""
    for name, value in list(vars(module).items()):
        if inspect.isclass(value):
            for method, member in list(vars(value).items()):
                if callable(member) and (method == "__init__" or not method.startswith("__")):
                    setattr(value, method, checked(member, name if method == "__init__" else method))
        elif callable(value):
            setattr(module, name, checked(value, name))
