"""Many pairs, and many threads: no memory is left behind, and the bits are those of one thread."""

import concurrent.futures
import gc
import json
import resource

import gearwright as gw
from common import pair, pinion, wheel


def resident_kb():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() // 1024


def test_no_leak():
    gear, mate = pinion(), wheel()
    kinds = (lambda a: gw.Pair(gear, mate, center_distance=a).backlash.normal,
             lambda a: gw.solve({"gear1": {"teeth": 0, "normal_module_mm": a}}))

    def rounds(n):
        for i in range(n):
            for kind in kinds:
                try:
                    kind(78.5 + 1e-6 * i)
                except gw.SpecError as e:
                    assert e.key == "gear1.teeth"
        gc.collect()
        return resident_kb()

    warm = rounds(1000)
    assert rounds(5000) - warm < 3000  # kB; a pair that stayed would be some 10 kB


def test_threads_have_the_bits_of_one():
    distances = [78.5 + 0.01 * i for i in range(40)]

    def work(shift):
        return [json.dumps(pair(center_distance=a).replace(gear1={"profile_shift": shift}).result())
                for a in distances]

    shifts = [0.30, 0.31, 0.32, 0.33] * 2
    alone = [work(shift) for shift in shifts[:4]] * 2
    with concurrent.futures.ThreadPoolExecutor(8) as threads:
        assert list(threads.map(work, shifts)) == alone
