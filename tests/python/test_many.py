"""Tests many pairs and many threads. No memory is lost, and several threads give the same bits as one."""

import concurrent.futures
import gc
import json
import resource

import pytest

import gearwright as gw
from common import pair, pinion, wheel


def resident_kb():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() // 1024


def test_no_leak():
    gear, mate = pinion(), wheel()

    def rounds(n):
        for i in range(n):
            assert gw.Pair(gear, mate, center_distance=78.5 + 1e-6 * i).backlash.normal > -1
            if i % 10 == 0:
                with pytest.raises(gw.SpecError):
                    gw.solve({"gear1": {"teeth": 0, "normal_module_mm": 2 + i}})
        gc.collect()
        return resident_kb()

    warm = rounds(1000)
    assert rounds(40_000) - warm < 700  # kB; a loss of 32 bytes per pair would exceed this


def test_threads_have_the_bits_of_one():
    distances = [78.5 + 0.01 * i for i in range(40)]

    def work(shift):
        return [json.dumps(pair(center_distance=a).replace(gear1={"profile_shift": shift}).result())
                for a in distances]

    shifts = [0.30, 0.31, 0.32, 0.33] * 2
    alone = [work(shift) for shift in shifts[:4]] * 2
    with concurrent.futures.ThreadPoolExecutor(8) as threads:
        assert list(threads.map(work, shifts)) == alone
