#!/usr/bin/env python3
"""Tests that the program calls no function of the C library whose last bit may differ between C
libraries (cmake/gw_elementary.cmake).

Laws
  1. The program calls two kinds of functions of libm. Those in EXACT are exact. Those in LONG_DOUBLE have results that Boost
     rounds to a double.
  2. The program calls no quotient of complex numbers of the compiler's library, which has fused multiply-adds on ARM and
     another formula in WebAssembly.
"""
import os
import pathlib
import re
import subprocess
import sys

EXACT = set("ceil copysign fabs floor fma fmax fmin fmod frexp ilogb ldexp llrint llround logb lrint lround modf nan nearbyint "
            "nextafter remainder remquo rint round scalbln scalbn sqrt trunc".split())
LONG_DOUBLE = set("atanl expl log1pl logl powl sqrtl".split())


def names(*arguments):
    listing = subprocess.run(["nm", "-D", *arguments], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r" [A-Za-z] (\w+)@", listing))


def main():
    program = pathlib.Path(os.environ["GW_BIN"])
    if not (program.parent / "elementary/libelementary.a").exists():
        sys.exit("this build has the elementary functions of the C library (Debian: musl-dev)")
    libraries = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    libm = re.search(r"libm\.so\S* => (\S+)", libraries)[1]
    called = names("--undefined-only", str(program)) & names("--defined-only", libm)
    assert called, "the program calls nothing of libm, so this test sees nothing"
    quotients = {name for name in names("--undefined-only", str(program)) if name.startswith("__div") and name.endswith("c3")}
    assert not quotients, f"divide by a reciprocal, as contact/sensitivity.cpp does: the program calls {sorted(quotients)}"
    assert called <= EXACT | LONG_DOUBLE, f"add to tools/elementary.txt: {sorted(called - EXACT - LONG_DOUBLE)}"


main()
