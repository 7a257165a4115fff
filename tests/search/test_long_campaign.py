"""Tests a hundred million candidates. Memory use does not grow, and killing half of the processes does
not affect the result."""
import json
import os
import subprocess
import unittest

from searching import BIN, WIDE, chunks, contents, duckdb, end, folder, spec, start, wait_until

MOST_BYTES = 500e6
TEXT = spec(WIDE, modules_mm=[1 + i / 8 for i in range(25)], pinion_teeth=[10, 1000], helix_step_deg=0.3)


class Hundred(unittest.TestCase):
    def test_a_hundred_million(self):
        where = folder(TEXT)
        peaks = {}
        for name, args in (("in memory", ("--json", "--top", "1000")), ("campaign", ("--json", "--top", "1000", "--out", "whole")),
                           ("chunks of the same size", ("--out", "coarse", "--top", "1000", "--chunk", str(1 << 22)))):
            with open(where / "out", "w+") as out:
                process = subprocess.Popen([BIN, "search", "case.toml", *args], cwd=where, stdout=out)
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
                self.assertEqual(process.returncode, 0, name)
                peaks[name] = usage.ru_maxrss * 1024
                if "--json" in args:
                    out.seek(0)
                    found = json.load(out)["search"]
                    self.assertGreater(found["tested"], 1e8)
        print(", ".join(f"{name}: {peak / 1e6:.0f} MB" for name, peak in peaks.items()))
        self.assertTrue(all(peak < MOST_BYTES for peak in peaks.values()), peaks)
        whole = contents(where / "whole")
        self.assertEqual(contents(where / "coarse"), whole)
        count = duckdb(where / "whole/search.parquet", "select count(*) as n, count(distinct trial) as m from data")
        self.assertEqual(count, [{"n": found["feasible_count"], "m": found["feasible_count"]}])

        process = start(where, "killed", "--top", 1000)
        self.assertTrue(wait_until(lambda: chunks(where / "killed") > 200))
        process.kill()
        end(process)
        status, _, err = end(start(where, "killed", "--top", 1000, "--resume"), 600)
        self.assertEqual(status, 0, err)
        self.assertEqual(contents(where / "killed"), whole)


if __name__ == "__main__":
    unittest.main()
