"""The verbs search, identify, measure and verify as functions of Python."""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from . import _core
from ._core import FileError, Gear, Pair, Search
from ._errors import SpecError

Progress = Callable[[str, int, int], object]


class _Line:
    """Reports the progress of a search on stderr, beginning 1.5 s after the start."""

    def __init__(self) -> None:
        self.start = self.printed = time.monotonic()
        self.shown = False

    def __call__(self, stage: str, done: int, of: int) -> None:
        now = time.monotonic()
        if now - self.start < 1.5 or now - self.printed < 0.5:
            return
        share = f" {100 * done / of:.0f} %" if of else ""
        sys.stderr.write(f"\rgearwright: {stage} {done}{share}   ")
        sys.stderr.flush()
        self.printed, self.shown = now, True

    def end(self) -> None:
        if self.shown:
            sys.stderr.write("\n")


def _not_empty(spec: Any, verb: str, needs: str) -> None:
    """Raises SpecError for an empty dict, because the error of an empty spec describes a gear."""
    if isinstance(spec, Mapping) and not spec:
        why = f"is empty; {verb} needs {needs}"
        raise SpecError("spec", "{}", why, f"spec = {{}}: {why}", "missing")


def search(
    spec: str | os.PathLike[str] | Mapping[str, Any],
    *,
    top: int | None = None,
    progress: bool | Progress = True,
    threads: int = 0,
    out: str | os.PathLike[str] | None = None,
    resume: bool = False,
    yes_large: bool = False,
) -> Search:
    """Finds all designs that satisfy the table [search] of a spec, best first. The result can be iterated. .pair(place)
    returns a Pair, and .to_pandas() a DataFrame.

    top       greatest number of designs
    progress  True prints a line on stderr; a function is called as f(stage, done, of)
    out       folder for the program's files; with resume=True, a stopped search continues
    Ctrl-C ends the search within a tenth of a second.
    """
    _not_empty(spec, "search", "the table [search]")
    line = _Line()
    report: Progress | None = progress if callable(progress) else line if progress else None
    try:
        return _core._search(spec, top, threads, report, out, resume, yes_large)
    finally:
        line.end()


def identify(spec: str | os.PathLike[str] | Mapping[str, Any]) -> dict[str, Any]:
    """Finds the standard gears that agree with the readings of a gear. The spec, a dict or the path of a file, has the
    readings in [gear1.measured]. Returns the answer of the program as a dict."""
    _not_empty(spec, "identify", "the readings of a gear in [gear1.measured]")
    return _core.solve(spec, "identify")


def measure(value: str | os.PathLike[str] | Mapping[str, Any] | Gear | Pair) -> Any:
    """Returns the inspection dimensions of a gear by key. For a Pair, or for a spec with two gears, returns a list with
    the dimensions of both gears."""
    gears = [gear["measure"] for gear in _core.solve(value, "measure")["gears"]]
    return gears if isinstance(value, Pair) or len(gears) > 1 else gears[0]


def verify(cases: str | os.PathLike[str] | Mapping[str, Any]) -> list[dict[str, Any]]:
    """Compares published numbers with the engine. `cases` is the path of a case file of `gearwright verify`, or its
    content. Returns for each case its id, the number of compared values and a line for each difference."""
    if isinstance(cases, (str, bytes, os.PathLike)):
        try:
            file = open(cases, encoding="utf-8")
        except OSError as error:
            raise FileError(error.errno, error.strerror, error.filename) from error
        with file:
            return _core._verify(json.load(file))
    # open() would accept a number as the descriptor of an open file
    if not isinstance(cases, Mapping):
        raise TypeError(f"cases: must be the path of a case file, or its content, not {cases!r}")
    return _core._verify(cases)


def _designs(found: Search) -> Iterator[Any]:
    return (found[i] for i in range(len(found)))


def _to_pandas(found: Search) -> Any:
    """Returns the designs as a DataFrame, with a row for each design and the columns of search.parquet."""
    import pandas as pd

    return pd.DataFrame(found.to_numpy())


def _repr_html(found: Search) -> str:
    """Returns the first designs as an HTML table."""
    columns = ("module_mm", "z1", "z2", "ratio", "center_distance_mm", "x1", "x2")
    table = found.to_numpy()[:20]
    shown = [c for c in columns if c in (table.dtype.names or ())]
    head = "".join(f"<th>{c}</th>" for c in shown)
    rows = "".join("<tr>" + "".join(f"<td>{row[c]:.6g}</td>" for c in shown) + "</tr>" for row in table)
    return f"<p>{found!r}</p><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


for _name, _method in (("__iter__", _designs), ("to_pandas", _to_pandas), ("_repr_html_", _repr_html)):
    setattr(Search, _name, _method)
