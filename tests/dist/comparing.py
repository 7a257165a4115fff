"""Compares the answers and the files of two programs, for all verbs and examples."""
import json
import pathlib
import struct

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
VERBS = "gear pair contact load measure rate identify fit drive outline".split()
# Verbs whose tables for spreadsheets are compared.
TABLES = "gear pair measure drive outline".split()
# Verbs that take long are compared for one example.
LONG = {"scattered_pair": "scatter", "misaligned_pair": "compensate", "quiet_pair": "propose", "housing_search": "search",
        "gearbox_search": "search"}
# Texts that need no spec.
TEXTS = ("--help", "--version", "run --help", "manual", "schema spec", "schema result", "completion bash", "completion zsh",
         "completion fish")


def some_examples(count):
    """Returns `count` examples, evenly spread over all."""
    examples = sorted([*SOURCE.glob("examples/*.toml"), *SOURCE.glob("examples/drives/*.toml")])
    count = min(count, len(examples))
    return [examples[i * len(examples) // count] for i in range(count)]


def place(x):
    """Converts a double to an integer. The order of the doubles is kept, and neighbours differ by
    1, the unit in the last place."""
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(bits & 0x7FFFFFFFFFFFFFFF)


class Differences:
    """Compares the numbers of two answers. Counts them, and stores the ulp of each difference and the
    path of the greatest relative difference."""

    def __init__(self):
        self.values, self.ulps, self.greatest, self.where, self.broken = 0, [], 0.0, "", ""

    def compare(self, a, b, path=""):
        number = (int, float)
        if isinstance(a, dict) and isinstance(b, dict):
            if list(a) != list(b):
                self.broken = f"{path}: keys {sorted(set(a) ^ set(b)) or 'in another order'}"
                return
            for key in a:
                self.compare(a[key], b[key], f"{path}.{key}")
        elif isinstance(a, list) and isinstance(b, list):
            if len(a) != len(b):
                self.broken = f"{path}: {len(a)} and {len(b)} entries"
                return
            for i, (x, y) in enumerate(zip(a, b)):
                self.compare(x, y, f"{path}.{i}")
        elif isinstance(a, number) and isinstance(b, number) and not isinstance(a, bool) and not isinstance(b, bool):
            self.values += 1
            if a == b:
                return
            self.ulps.append(abs(place(float(a)) - place(float(b))))
            relative = abs(a - b) / max(abs(a), abs(b), 1.0)
            if relative > self.greatest:
                self.greatest, self.where = relative, path
        elif a != b and not (isinstance(a, str) and isinstance(b, str)):
            self.broken = f"{path}: {a} and {b}"  # messages may contain rounded numbers


def compare_texts(programs, report, examples, folder):
    """Compares the tables of the examples, and the texts that need no spec. Only messages contain paths."""
    runs = [*(f"{verb} {example.stem} --csv" for example in examples for verb in TABLES), *TEXTS]
    paths = {example.stem: example for example in examples}
    cases = sorted(SOURCE.glob("tests/golden/*.json"))
    runs = [[paths.get(word, word) for word in run.split()] for run in runs] + [["verify", case] for case in cases]
    for arguments in runs:
        status, text, _ = programs.run(programs.native, *arguments, folder=folder)
        other, other_text, errors = programs.run(programs.other, *arguments, folder=folder)
        name = " ".join(getattr(a, "name", a) for a in arguments)
        report.check(name, (status, text) == (other, other_text), f"status {other}, native {status}: {errors[-300:]}")
    print(f"{len(runs)} tables and texts")


def compare_answers(programs, report, examples, folder):
    total, answers, equal_bytes, shares = Differences(), 0, 0, []
    for example in examples:
        for verb in [*VERBS, *([LONG[example.stem]] if example.stem in LONG else [])]:
            status, text, _ = programs.run(programs.native, verb, example, "--json", folder=folder)
            other, other_text, errors = programs.run(programs.other, verb, example, "--json", folder=folder)
            name = f"{verb} {example.name}"
            if status != other:
                report.check(name, False, f"status {other}, native {status}: {errors[-300:]}")
                continue
            if status != 0:
                report.passed += 1
                continue
            one = Differences()
            one.compare(json.loads(text), json.loads(other_text))
            report.check(name, text == other_text, one.broken or f"{one.where} differs by {one.greatest:.3g}")
            answers, equal_bytes = answers + 1, equal_bytes + (text == other_text)
            total.values, total.ulps = total.values + one.values, total.ulps + one.ulps
            if one.greatest > total.greatest:
                total.greatest, total.where = one.greatest, f"{name}{one.where}"
            if one.ulps:
                shares.append(f"  {name}: {len(one.ulps)} of {one.values}, greatest {one.greatest:.1e} at {one.where}")
    print("\n".join(shares))
    below = [sum(u <= limit for u in total.ulps) for limit in (1, 4, 64)]
    print(f"answers {answers}, of which {equal_bytes} have the same bytes; numbers {total.values}, of which "
          f"{len(total.ulps)} differ: {below[0]} by 1 ulp, {below[1]} by at most 4, {below[2]} by at most 64; "
          f"greatest relative difference {total.greatest:.1e} ({total.where})", flush=True)


def compare_files(programs, report, examples, folder):
    kinds = {}
    for example in examples:
        ends = []
        for command, out in ((programs.native, "native"), (programs.other, "other")):
            status, _, errors = programs.run(command, "run", example, "--out", f"{example.stem}_{out}", folder=folder)
            ends.append(status)
        report.check(f"run {example.name}", ends[0] == ends[1], f"status {ends[1]}, native {ends[0]}: {errors[-300:]}")
        one, two = (pathlib.Path(folder, f"{example.stem}_{out}") for out in ("native", "other"))
        names = sorted(p.name for p in one.iterdir()) if one.exists() else []
        others = sorted(p.name for p in two.iterdir()) if two.exists() else []
        report.check(f"files of {example.name}", names == others, f"{others}, native {names}")
        for name in sorted(set(names) & set(others)):
            count = kinds.setdefault(pathlib.Path(name).suffix, [0, 0])
            same = (one / name).read_bytes() == (two / name).read_bytes()
            count[0] += 1
            count[1] += same
            report.check(f"{name} of {example.name}", same, "has other bytes")
    print("files with the same bytes: " + ", ".join(f"{k} {same} of {n}" for k, (n, same) in sorted(kinds.items())))
