"""Specs and answers in inch, made from those in mm by renaming and dividing. It shares no code with the program."""
import re

MM, UM = 25.4, 0.0254  # mm per inch, µm per microinch
# Ending in mm, ending in inch, and the factor to inch. The first ending that matches counts.
UNITS = [("_mm_per_rad", "_in_per_rad", 1 / MM), ("_mm_per_turn", "_in_per_turn", 1 / MM), ("_per_mm", "_per_in", MM),
         ("_per_um", "_per_uin", UM), ("_mm", "_in", 1 / MM), ("_um", "_uin", 1 / UM)]
SAME = {"module_mm", "normal_module_mm", "transverse_module_mm", "modules_mm"}
NAMED = {"x_range": "x", "x_values": "x", "y_range": "y", "y_values": "y", "value": "unit"}
PATH = re.compile(r"[A-Za-z0-9_.]+")


def unit(key):
    """(name in inch, factor) of a key of a length, or None."""
    last = key.rsplit(".", 1)[-1]
    if last in SAME or "_N_" in last or last.endswith("_per_N"):
        return None
    return next(((key[:-len(mm)] + inch, factor) for mm, inch, factor in UNITS if key.endswith(mm)), None)


def scaled(value, factor):
    if isinstance(value, list):
        return [scaled(v, factor) for v in value]
    if isinstance(value, dict):  # a toleranced number
        return {k: scaled(v, factor) if k in ("range", "offset") else v for k, v in value.items()}
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return value * factor if factor > 1 else value / round(1 / factor, 4)


def word(value):
    """A key that is the value of another key, in a list or alone."""
    if isinstance(value, list):
        return [word(v) for v in value]
    if isinstance(value, str) and PATH.fullmatch(value) and unit(value):
        return unit(value)[0]
    return value


def spec_in_inch(table):
    """The spec with every length in inch, but without the key `units`."""
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
    """{path of keys in inch: number in inch} of all numbers of an answer in mm, or of one in inch."""
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
            found |= numbers(value, (*path, name), inner, outer, inch)
    elif isinstance(answer, list):
        for i, value in enumerate(answer):
            found |= numbers(value, (*path, i), factor, per, inch)
    elif isinstance(answer, (int, float)) and not isinstance(answer, bool):
        found[path] = answer * factor * per
    return found


def differences(mm, inch, tolerance=1e-12):
    """Paths at which the numbers of two answers differ by more than the tolerance, relative or, for small numbers,
    absolute."""
    a, b = numbers(mm), numbers(inch, inch=True)
    far = [(p, a[p], b[p]) for p in a.keys() & b.keys()
           if abs(a[p] - b[p]) > tolerance * max(abs(a[p]), abs(b[p]), 1e-3)]
    return far + [(p, a.get(p), b.get(p)) for p in a.keys() ^ b.keys()]
