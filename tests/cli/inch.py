"""Specs and answers in inch, made from those in mm by renaming and dividing. It shares no code with the program."""
import csv
import itertools
import re

MM, UM = 25.4, 0.0254  # mm per inch, µm per microinch
# Ending in mm, ending in inch, and the factor to inch. The first ending that matches counts.
UNITS = [("_mm_per_rad", "_in_per_rad", 1 / MM), ("_mm_per_turn", "_in_per_turn", 1 / MM), ("_per_mm", "_per_in", MM),
         ("_per_um", "_per_uin", UM), ("_mm", "_in", 1 / MM), ("_um", "_uin", 1 / UM)]
CSV_UNITS = {"mm": ("in", 1 / MM), "µm": ("µin", 1 / UM), "1/mm": ("1/in", MM), "mm/rad": ("in/rad", 1 / MM)}
PURE = {"cpk", "shape"}  # numbers of a toleranced length that are not lengths
SAME = {"module_mm", "normal_module_mm", "transverse_module_mm", "modules_mm"}
NAMED = {"x_range": "x", "x_values": "x", "y_range": "y", "y_values": "y", "value": "unit", "expected": "unit",
         "expect": "unit", "tool": "tool_unit", "points": "unit", "amount": "unit", "leading": "unit", "trailing": "unit"}
PATH = re.compile(r"[A-Za-z0-9_.]+")


def unit(key):
    """Returns (name in inch, factor) for the key of a length, otherwise None."""
    last = key.rsplit(".", 1)[-1]
    if last in SAME or "_N_" in last or last.endswith("_per_N"):
        return None
    return next(((key[:-len(mm)] + inch, factor) for mm, inch, factor in UNITS if key.endswith(mm)), None)


def scaled(value, factor):
    if isinstance(value, list):
        return [scaled(v, factor) for v in value]
    if isinstance(value, dict):  # a toleranced number, or numbers by member
        return {k: v if k in PURE else scaled(v, factor) for k, v in value.items()}
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return value * factor if factor > 1 else value / round(1 / factor, 4)


def word(value):
    """Returns a value with the name of its key in inch, if the value is itself the key of a length."""
    if isinstance(value, list):
        return [word(v) for v in value]
    if isinstance(value, str) and PATH.fullmatch(value) and unit(value):
        return unit(value)[0]
    return value


def spec_in_inch(table):
    """Returns the spec with every length in inch, but without the key `units`."""
    out = {}
    for key, value in table.items():
        named = unit("_" + str(table[NAMED[key]])) if key in NAMED and NAMED[key] in table else None
        if unit(key):
            inner = value
            if isinstance(value, list) and value and isinstance(value[0], dict):
                inner = [spec_in_inch(v) for v in value]
            else:
                inner = scaled(value, unit(key)[1])
            out[unit(key)[0]] = inner
        elif named:
            out[key] = scaled(value, named[1])
        elif isinstance(value, dict):
            out[key] = spec_in_inch(value)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            out[key] = [spec_in_inch(v) for v in value]
        else:
            out[key] = word(value)
    return out


def numbers(answer, path=(), factor=1.0, per=1.0, inch=False):
    """Returns {path of keys in inch: number in inch} for all numbers of an answer, which is in mm
    unless `inch` is true."""
    found = {}
    if isinstance(answer, dict):
        for key, value in answer.items():
            name, own = key, None
            if not inch and unit(key):
                name, own = unit(key)
            inner, outer = factor, per
            if own and key.endswith(("_per_mm", "_per_um")) and isinstance(value, dict):
                inner, outer = 1.0, own
            elif own:
                inner = own
            elif re.search(r"_(deg|arcsec|MPa|Nm|N|kW|rpm|kg|C|hz|m_per_s)$", key):
                inner = 1.0
            elif not inch and key in NAMED and isinstance(answer.get(NAMED[key]), str):
                inner = (unit("_" + answer[NAMED[key]]) or ("", 1.0))[1]
            elif key in PURE:
                inner = 1.0
            found |= numbers(value, (*path, name), inner, outer, inch)
    elif isinstance(answer, list):
        for i, value in enumerate(answer):
            found |= numbers(value, (*path, i), factor, per, inch)
    elif isinstance(answer, (int, float)) and not isinstance(answer, bool):
        found[path] = answer * factor * per
    return found


def metric_texts(answer, path=()):
    """Returns the texts of an answer in inch, with their paths, that contain a length in mm or µm. Titles and specs are
    words of the user, and a module stays in mm."""
    if isinstance(answer, dict):
        return [found for key, value in answer.items() if key not in ("spec", "title", "name", "module")
                for found in metric_texts(value, (*path, key))]
    if isinstance(answer, list):
        return [found for i, value in enumerate(answer) for found in metric_texts(value, (*path, i))]
    metric = isinstance(answer, str) and re.search(r"\d (mm|µm)\b", re.sub(r"[Mm]odules? (of )?[\d.]+ mm", "", answer))
    return [(path, answer)] if metric else []


def differences(mm, inch, tolerance=1e-12):
    """Returns the paths at which the numbers of two answers differ by more than the tolerance, and those of texts in mm.
    The tolerance is relative for numbers above 1e-3, and absolute for smaller numbers. The specs of
    identified gears have six decimals of their own unit."""
    texts = metric_texts(inch)
    a, b = numbers(mm), numbers(inch, inch=True)
    far = [(p, a[p], b[p]) for p in a.keys() & b.keys()
           if abs(a[p] - b[p]) > (1e-6 if {"candidates", "spec"} <= set(p) else
                                  tolerance * max(abs(a[p]), abs(b[p]), 1e-3))]
    return far + [(p, a.get(p), b.get(p)) for p in a.keys() ^ b.keys()] + texts


def csv_differences(mm, inch, tolerance=1e-12):
    """Returns the rows of the CSV of quantities (key, quantity, symbol, unit, values) that differ
    between both systems."""
    far = []
    for a, b in itertools.zip_longest(csv.reader(mm.splitlines()[1:]), csv.reader(inch.splitlines()[1:]), fillvalue=[""] * 6):
        name = ".".join(unit(part)[0] if unit(part) else part for part in a[0].split("."))
        module = a[0].rsplit(".", 1)[-1] in SAME
        text, factor = (a[3], 1.0) if module else CSV_UNITS.get(a[3], (a[3], 1.0))
        words = unit(a[1])[0] if unit(a[1]) else a[1]  # a record has its key instead of words
        same = name == b[0] and words == b[1] and text == b[3] and all(
            x == y or (x and y and abs(float(x) * factor - float(y)) <= tolerance * max(abs(float(y)), 1e-3))
            for x, y in zip(a[4:6], b[4:6]))
        if not same:
            far.append((a[:6], b[:6]))
    return far
