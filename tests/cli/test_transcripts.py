"""Tests that README and quick start show the actual output of the program.

A block that begins with `$ gearwright …` is a transcript. It contains lines of the output in their order.
A line with … stands for omitted lines, also at the beginning and at the end of the output. A remark after the command describes a change of the spec. The
specs are those on the page. If GW_WRITE_DOCS is set, each group of lines is replaced by the most similar
lines of the output.
"""
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from cli import BIN, SOURCE

BLOCK = re.compile(r"```text\n(\$ (?:build/release/)?gearwright [^\n]*\n.*?)```", re.S)
GAP = re.compile(r"^\s*…$")


def toml(page, number):
    """Returns the TOML block with this number on the page, counted from 0."""
    return re.findall(r"```toml\n(.*?)```", page, re.S)[number]


def quickstart_specs(page):
    """Maps each file name to its contents, in the order in which the page uses them."""
    first, fixed, hob = toml(page, 0), toml(page, 3), toml(page, 4)
    shifted = first.replace("teeth = 17\n", "teeth = 17\n" + toml(page, 1))
    semi_topping = re.sub(r"protuberance.*", "", hob) + toml(page, 5).replace("[gear1.rack]\n", "")
    assert shifted != first and "semi_topping" in semi_topping
    crossed_fit = (SOURCE / "examples/crossed_fit.toml").read_text()
    thirteen = crossed_fit.replace("teeth = 12", "teeth = 13").replace("teeth = 24", "teeth = 26")
    assert thirteen != crossed_fit
    misspelt = shifted.replace("face_width_mm", "face_widht_mm", 1)
    return {
        "pair.toml": [first, shifted, misspelt],
        "fixed.toml": [fixed, fixed.replace("center_distance_mm = 76", "center_distance_mm = 70")],
        "hob.toml": [hob],
        "chamfer.toml": [semi_topping],
        "dp.toml": [toml(page, 6)],
        "fit13.toml": [thirteen],
    }


def changed_examples(page):
    """Maps the remark of a command to the changed example."""
    at_80 = (SOURCE / "examples/crossed_pair.toml").read_text().replace("shaft_angle_deg = 90", "shaft_angle_deg = 80")
    return {"with shaft_angle_deg = 80": at_80}


class Page:
    def __init__(self, name):
        self.path = SOURCE / name
        self.text = self.path.read_text()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="gearwright_page_"))
        shutil.copytree(SOURCE / "examples", self.folder / "examples")
        self.specs = quickstart_specs(self.text) if name.endswith("quickstart.md") else {}
        self.changes = changed_examples(self.text)

    def output_of(self, line):
        """Runs a command of the page and returns its output."""
        command, _, remark = line[2:].partition("#")
        if command.strip() == "echo $?":
            return [str(self.status)]
        words = re.sub(r"^build/release/", "", command.strip()).split()
        target = words[words.index(">") + 1] if ">" in words else None
        words = words[:words.index(">")] if target else words
        for word in words:
            if self.specs.get(word):
                (self.folder / word).write_text(self.specs[word].pop(0))
        if remark.strip() in self.changes:
            (self.folder / words[2]).write_text(self.changes[remark.strip()])
        ran = subprocess.run([BIN, *words[1:]], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.status = ran.returncode
        if target:
            (self.folder / target).write_text(ran.stdout)
            return ran.stderr.splitlines()
        return (ran.stdout + ran.stderr).splitlines()


def stretches(lines):
    """Divides lines into groups at the lines with …. Each such line is a group of its own."""
    runs = [[]]
    for line in lines:
        if GAP.match(line):
            runs += [[line], []]
        else:
            runs[-1].append(line)
    return runs


def most_alike(run, output, begin):
    """Returns the position in the output at which the lines are most similar to the group."""
    def likeness(at):
        return sum(difflib.SequenceMatcher(None, a.split(), b.split()).ratio() for a, b in zip(run, output[at:]))
    return max(range(begin, max(begin + 1, len(output) - len(run) + 1)), key=likeness)


class Transcripts(unittest.TestCase):
    maxDiff = None

    def page(self, name):
        page = Page(name)
        blocks = BLOCK.findall(page.text)
        self.assertTrue(blocks)
        text = page.text
        for block in blocks:
            text = text.replace(block, "\n".join(self.block(page, block.rstrip("\n").split("\n"))) + "\n")
        if "GW_WRITE_DOCS" in os.environ:
            page.path.write_text(text)
        else:
            self.assertEqual(page.text, text)
        shutil.rmtree(page.folder)

    def block(self, page, lines):
        made, shown = [], []
        output = None
        for line in [*lines, None]:
            if line is not None and not line.startswith("$ "):
                shown.append(line)
                continue
            if output is not None:
                made += self.shown(shown, output)
            if line is not None:
                made.append(line)
                output, shown = page.output_of(line), []
        return made

    def shown(self, lines, output):
        if lines == [] or all(GAP.match(line) or not line for line in lines):
            return lines
        made, at = [], 0
        for run in stretches(lines):
            if not run or GAP.match(run[0]):
                made += run
                continue
            begin = at
            at = most_alike(run, output, at)
            if made == [] and at > begin:
                made.append("…")
            made += output[at:at + len(run)]
            at += len(run)
        if at < len(output) and not (made[-1] == "" or GAP.match(made[-1])):
            made.append("…")
        return made

    def test_readme(self):
        self.page("README.md")

    def test_quickstart(self):
        self.page("docs/quickstart.md")


if __name__ == "__main__":
    unittest.main()
