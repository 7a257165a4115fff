"""Our pages in Markdown, as doxygen takes them.

Headings get the anchors that GitHub gives them, equations an anchor each, symbols their index. A link to
a public header leads to its page; to another file that is no page, it becomes the file's name. A page is
called by its file: quickstart, spec, and theory_02 for docs/theory/02-....md.
"""

import html
import posixpath
import re

from headers import EQUATION, SYMBOL, equation_links


def slug(title):
    """The anchor that GitHub gives a heading."""
    kept = re.sub(r"[^\w\- ]", "", title.replace("`", "").lower())
    return kept.replace(" ", "-")


def page_name(path):
    """README, quickstart, theory_02 ... : what a page is called in links."""
    stem = posixpath.splitext(posixpath.basename(path))[0]
    theory = re.fullmatch(r"(\d\d)-.*", stem)
    return f"theory_{theory.group(1)}" if theory else stem.lower()


def page_link(path, text, target, headers):
    """`[text](target)` of the page `path`, as doxygen takes it."""
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    name, _, anchor = target.partition("#")
    where = posixpath.normpath(posixpath.join(posixpath.dirname(path), name)) if name else path
    if where in headers and where.endswith(".hpp"):
        return f'@ref {where} "{text}"'
    if not where.endswith(".md"):
        return text  # a file that is no page: its name is enough
    return f"[{text}](#{page_name(where)}{'-' + anchor if anchor else ''})"


def page(path, text, headers=()):
    here, out, inside = page_name(path), [], False
    # A link that is broken over two lines is put on one.
    text = re.sub(r"\[([^\[\]`\n]*)\n([^\[\]`\n]*)\]\(([^)\n]+)\)", r"[\1 \2](\3)", text)
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if line.lstrip().startswith("```"):
            inside = not inside
            if inside:  # every equation of the block gets an anchor before it
                for label in block_labels(lines[number + 1:]):
                    out.append(f"@anchor eq_{label.replace('.', '_')}")
                out.append("")
            out.append("```{.unparsed}" if inside else "```")
            continue
        if inside:
            out.append(line)
            continue
        heading = re.match(r"^(#+) (.*)$", line)
        if heading:
            marks, title = heading.groups()
            name = here if marks == "#" else f"{here}-{slug(title)}"
            # Headings with a name stand in the tree of contents; those of the main page need not.
            out.append(line if here == "readme" else f"{marks} {title} {{#{name}}}")
            continue
        out.append(page_line(path, line, headers))
    return "\n".join(out)


def page_line(path, line, headers):
    """Links, equations and symbols outside `code`. Pictures are given by their file name, as IMAGE_PATH needs."""
    line = re.sub(r'<img src="(?:[^"/]*/)*([^"/]+)" width="(\d+)" alt="([^"]*)">',
                  r'@image{inline} html \1 "\3" width=\2px', line)
    pieces = re.split(r"(`[^`]+`|!?\[[^\]]*\]\([^)]+\)|\[T\d+\.[^\]]*\])", line)
    for i, piece in enumerate(pieces):
        link = re.fullmatch(r"(!?)\[([^\]]*)\]\(([^)]+)\)", piece)
        labels = EQUATION.fullmatch(piece)
        if link and link.group(1):
            pieces[i] = f"![{link.group(2)}]({posixpath.basename(link.group(3))})"
        elif link:
            pieces[i] = page_link(path, link.group(2), link.group(3), headers)
        elif labels:
            pieces[i] = equation_links(labels.group(1))
        elif piece.startswith("`") and "\\|" in piece:  # a bar in a cell of a table
            pieces[i] = f"<code>{html.escape(piece[1:-1], quote=False)}</code>"
        elif not piece.startswith("`"):
            pieces[i] = SYMBOL.sub(r"<i>\1</i>\2<sub>\3</sub>\4", piece)
    return "".join(pieces)


def block_labels(lines):
    found = []
    for line in lines:
        if line.lstrip().startswith("```"):
            break
        hit = re.search(r"\[(T\d+\.\d+[a-z]?)\][ \t]*$", line)
        if hit:
            found.append(hit.group(1))
    return found
