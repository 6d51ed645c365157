"""The error for wrong input."""

from __future__ import annotations


class InputError(ValueError):
    """Wrong input. Its text is one line, "file: place: problem"; parts that are empty are left out.

    file: the file with the fault, or empty. place: where it is, such as a JSON path or the name of an argument.
    problem: what is wrong there.
    """

    file: str
    place: str
    problem: str

    def __init__(self, file: str, place: str, problem: str) -> None:
        """An error at this place."""
        super().__init__(": ".join(part for part in (file, place, problem) if part))
        self.file = file
        self.place = place
        self.problem = problem

    def __reduce__(self) -> tuple[type[InputError], tuple[str, str, str]]:
        """How it is pickled: by its three parts."""
        return type(self), (self.file, self.place, self.problem)
