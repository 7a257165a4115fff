"""Our headers, said in doxygen's words.

A header is plain text for people first. What doxygen cannot see by itself:

    opening     the // comment before #pragma once is the file's description; lines that stand in are
                a table of symbols and stay as they are; "theory: docs/theory/..." becomes a link
    labels      `/// Formula   ...` (Units, Domain, Accuracy, Errors, Laws, ...) opens a paragraph with
                that heading; lines that stand in under it continue it
    members     `///< m_n  mm, text`: the symbol, its unit, the rest
    symbols     m_n is an m with an index, in comments only and outside `code`
    equations   [T2.1] is a link to the equation in the theory pages

A header keeps its number of lines, so that doxygen's messages name the line of the source.
"""

import html
import re

WORDS = "Formula|Units|Domain|Accuracy|Errors|Laws|Throws|Facts|Returns|Work|Cost"
LABELLED = re.compile(rf"^ {{0,3}}({WORDS})  +(?=\S)")
UNIT = re.compile(r"(mm²|mm/rad|rad/mm|rad/rad|1/mm|µm|mm|rad|N|°|px/mm|px)(?=[,;:.\s)]|$)")
EQUATION = re.compile(r"\[((?:T\d+\.\d+[a-z]?)(?:, ?T\d+\.\d+[a-z]?)*)\]")
THEORY = re.compile(r"\s*theory:\s*(docs/theory/(\d\d)-[-\w]+\.md)(?:,\s*((?:\d+\.\d+)|\[T.*\]))?")
LETTER = "A-Za-zα-ωΑ-Ωξ∂Δ"
SYMBOL = re.compile(rf"(?<![\w{LETTER}])([{LETTER}])(′?)_([0-9A-Za-zα-ω]{{1,4}})(?![\w{LETTER}(])(\*?)")
CODE = re.compile(r"`([^`]+)`")


# ---- words of a comment ----

def plain(text):
    """Text that means nothing to doxygen: no markup, no command, no link, no emphasis."""
    text = re.sub(r"([\\@#%])", r"\\\1", text)
    text = re.sub(r"(?<![\w′])\*(?=\S)|\](?=\()|`", r"\\\g<0>", text)
    return html.escape(text, quote=False)


def kept(text):
    """The same within <pre>, where only commands and markup mean something."""
    return html.escape(re.sub(r"([\\@#%])", r"\\\1", text), quote=False)


def words(text):
    """A comment's text with symbols, code and equations marked up."""
    parts, at = [], 0
    for hit in re.finditer(rf"{CODE.pattern}|{EQUATION.pattern}", text):
        parts.append(symbols(text[at:hit.start()]))
        if hit.group(1) is not None:
            parts.append(f"<code>{plain(hit.group(1))}</code>")
        else:
            parts.append(equation_links(hit.group(2)))
        at = hit.end()
    return "".join(parts) + symbols(text[at:])


def symbols(text):
    parts, at = [], 0
    for hit in SYMBOL.finditer(text):
        letter, prime, index, star = hit.groups()
        parts.append(plain(text[at:hit.start()]))
        parts.append(f"<i>{letter}</i>{prime}<sub>{index}</sub>{plain(star)}")
        at = hit.end()
    return "".join(parts) + plain(text[at:])


def equation_links(labels):
    links = [f'@ref eq_{label.strip().replace(".", "_")} "{label.strip()}"' for label in labels.split(",")]
    return "\\[" + ", ".join(links) + "\\]"


# ---- lines of a header ----

def member(text):
    """`m_n  mm, of the rack` -> symbol, unit, text."""
    head, gap, rest = re.match(r"(.*?)(?:( {2,})(.*))?$", text).groups()
    out = ""
    if gap is None:
        head, rest = "", text
    elif head == "N" or not UNIT.match(head):  # N, the distance of the base tangent points
        out = f'<span class="symbol">{words(head)}</span> '
    else:
        rest = head + " " + rest
    unit = UNIT.match(rest)
    if unit:
        after = rest[unit.end():]
        return f'{out}<span class="unit">{unit.group(1)}</span>{words(after)}'
    return out + words(rest)


def opening(lines):
    """The first comment of a header as its file's description, in one line more than it had."""
    text = "\n".join(line[2:][1:] if line.startswith("// ") else line[2:] for line in lines)
    links = [(m.group(2), m.group(3)) for m in THEORY.finditer(text)]
    text = THEORY.sub("", text)
    out, inside = ["/// @file"], False
    for line in text.split("\n"):
        table = line.startswith("  ")
        if table and not inside:
            out.append(f'/// <pre class="notation">{kept(line[2:])}')
        elif table:
            out.append("/// " + kept(line[2:]))
        else:
            if inside:
                out[-1] += "</pre>"
            label = LABELLED.match(line)
            out.append("/// " + words(line) if not label else f"/// {labelled(line, label)}")
        inside = table
    if inside:
        out[-1] += "</pre>"
    if links:
        out[-1] += "".join(
            f' @gw{{Theory}} @ref theory_{page} "page {int(page)}"{", " + words(where) if where else ""}'
            for page, where in dict.fromkeys(links))
    padding = len(lines) + 1 - len(out)
    return out + ["///"] * max(0, padding)


def labelled(text, hit):
    return f"@gw{{{hit.group(1)}}} {words(text[hit.end():])}"


def comment(text, state):
    """One line after `///`."""
    hit = LABELLED.match(text)
    if hit:
        state["label"] = hit.group(1)
        return " " + labelled(text, hit)
    body = text.strip()
    if not body:
        state["label"] = None
        return ""
    if state["label"] == "Laws" and re.match(r"\(\d+\)", body):
        return " <br>" + words(body)
    if not state["label"] and re.match(r" {4,}\S", text):  # an example of code stays as it is
        return text
    return " " + words(body)


def header(text):
    lines = text.split("\n")
    out, number, state = [], 0, {"label": None}
    first = []
    while number < len(lines) and lines[number].startswith("//"):
        first.append(lines[number])
        number += 1
    if number < len(lines) and lines[number] == "#pragma once":
        out += opening(first)
        number += 1
    else:
        number = 0
    for line in lines[number:]:
        hit = re.match(r"^(.*?)///(<?)(.*)$", line)
        if not hit or '"' in hit.group(1):
            state["label"] = None
            out.append(line)
            continue
        before, after, body = hit.groups()
        if after:
            state["label"] = None
            out.append(f"{before}///< {member(body.strip())}")
        elif before.strip() == "" and re.search(r"///<", "".join(out[-1:])):
            out.append(f"{before}///< {words(body.strip())}")  # a member's comment goes on
        else:
            out.append(f"{before}///{comment(body, state)}")
    return "\n".join(out)
