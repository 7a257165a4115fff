"""Measures the overhead of Python: one Pair compared with C++, many pairs in one call, and functions of arrays.

    python3 bench/python_overhead.py BUILD      `make bench` runs it after the C++ benchmarks

The C++ side of a Pair is `spec_to_pair` of build/bench, which reads a spec, makes its gears and mounts them.
"""

import json
import pathlib
import subprocess
import sys
import time

BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release")
sys.path.insert(0, str(BUILD / "python"))

import gearwright as gw  # noqa: E402
import numpy as np  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[1]
RECORDED_PY_GEARWORKS = 14.0  # ms for one helical profile, as recorded; its dependencies are not in Debian


def best_of(work, repeats, rounds=5):
    """Returns the seconds of one call, the best of several rounds."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(repeats):
            work()
        times.append((time.perf_counter() - start) / repeats)
    return min(times)


def cpp(name):
    """Returns the seconds of a C++ benchmark, the best of five."""
    run = subprocess.run([BUILD / "bench/bench", f"--benchmark_filter=^{name}$", "--benchmark_repetitions=5",
                          "--benchmark_format=json"], capture_output=True, text=True, check=True)
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}
    return min(b["real_time"] * units[b["time_unit"]] for b in json.loads(run.stdout)["benchmarks"]
               if b["run_type"] == "iteration")


def say(what, seconds, more=""):
    print(f"{what:<58} {seconds * 1e6:12.1f} us  {more}")


def main():
    pair = gw.load(SOURCE / "examples/helical_pair.toml")
    one = best_of(lambda: gw.Pair(pair.gear1, pair.gear2, center_distance=pair.center_distance), 20)
    if (BUILD / "bench/bench").exists():
        there = cpp("spec_to_pair")
        say("a Pair in C++ (spec_to_pair)", there)
        say("a Pair from Python", one, f"{one / there:.2f} times")
    else:
        say("a Pair from Python", one)

    distances = pair.center_distance + np.linspace(0, 0.3, 2000)
    start = time.perf_counter()
    pair.sweep(center_distance=distances, threads=1)
    each = (time.perf_counter() - start) / len(distances)
    say("a pair of a sweep, one thread", each, f"{each / one:.2f} of a Pair from Python")

    errors = np.random.default_rng(1).normal(0, [0.02, 2e-4, 2e-4, 0.1, 0.005, 0.005], (2000, 6))
    for threads in (1, 0):
        start = time.perf_counter()
        pair.transmission_error(errors, positions=32, threads=threads)
        each = (time.perf_counter() - start) / len(errors)
        say(f"a mounting of 32 positions, {'one thread' if threads else 'all cores'}", each, f"1e5 in {each * 1e5:.1f} s")

    n = 1_000_000
    z1, x = np.full(n, 17.0), np.linspace(-0.3, 0.6, n)
    for name, work in (("involute", lambda: gw.involute(x)), ("inverse_involute", lambda: gw.inverse_involute(x)),
                       ("working_pressure_angle", lambda: gw.working_pressure_angle(z1, 43, x)),
                       ("contact_ratio", lambda: gw.contact_ratio(z1, 43, x)),
                       ("backlash", lambda: gw.backlash(z1, 43, x, 0.1, 31.0)),
                       ("shift_limits", lambda: gw.shift_limits(z1))):
        seconds = best_of(work, 1)
        print(f"{name:<58} {n / seconds / 1e6:12.1f} million a second")

    gear = gw.Gear(teeth=17, normal_module=2.5, helix_angle_deg=15, face_width=25)
    profile = best_of(lambda: gw.Gear(teeth=17, normal_module=2.5, helix_angle_deg=15, face_width=25).outline(200), 20)
    say("a helical gear and 200 points an arc", profile,
        f"py_gearworks: {RECORDED_PY_GEARWORKS} ms as recorded, {RECORDED_PY_GEARWORKS * 1e-3 / profile:.0f} times")
    say("its outline alone", best_of(lambda: gear.outline(200), 50))


if __name__ == "__main__":
    main()
