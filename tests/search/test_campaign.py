"""Tests a search in many chunks. The files equal the files of a single process, no matter which processes
compute the chunks and which of them are killed.

    shards   one after the other, or at the same time
    killed   kill -9 at random moments, while chunks are computed and while files are written
    stopped  SIGINT and SIGTERM: exit status 3, and --resume continues the search
    damaged  damaged or lost chunks and journal
"""
import json
import os
import signal
import subprocess
import time
import unittest

from campaign import Campaign
from searching import BIN, SMALL, WIDE, chunks, contents, duckdb, end, folder, spec, start, wait_until

MOST_BYTES = 500e6


class OneMachine(Campaign):
    def test_this_is_a_campaign(self):
        self.assertEqual(chunks(self.where / "alone"), self.CHUNKS)

    def test_no_campaign_at_all(self):
        self.assertEqual(end(start(self.where, self.out))[0], 0)
        # The search is larger than one default chunk. The size of the chunks does not affect the result.
        self.assertEqual(contents(self.out), self.alone)
        self.assertEqual(chunks(self.out), 17)

    def test_threads(self):
        self.go("--threads", 2)
        self.assertEqual(self.check(), {"search"})

    def test_shards_one_after_another(self):
        for i in (2, 3):
            said = self.go("--shard", f"{i}/3")
            self.assertIn("of 22 chunks are done", said)
            self.assertFalse((self.out / "search.json").exists())
        self.assertEqual(json.loads(self.go("--shard", "1/3", "--json"))["search"]["feasible_count"], 3633)
        self.assertEqual(self.check(), {"shard 1/3", "shard 2/3", "shard 3/3"})

    def test_shards_at_once(self):
        shards = [self.begin("--shard", f"{i}/3", "--threads", 1) for i in (1, 2, 3)]
        for shard in shards:
            status, _, err = end(shard)
            self.assertEqual(status, 0, err)
        self.assertEqual(self.check(), {"shard 1/3", "shard 2/3", "shard 3/3"})

    def test_more_shards_than_chunks(self):
        small = folder(spec())
        for i in range(8, 0, -1):
            self.assertEqual(end(start(small, "o", "--shard", f"{i}/8", "--chunk", 100))[0], 0)
        self.assertEqual(chunks(small / "o"), 5)
        end(start(small, "alone"))
        self.assertEqual(contents(small / "o"), contents(small / "alone"))

    def test_shards_with_whole_overlap_ratios(self):
        where = folder(spec(SMALL | {"helix_angle_deg": [-20, 20], "overlap_ratio": [1, 2], "face_width_mm": [20, 40]}))
        for i in (3, 1, 2):
            self.assertEqual(end(start(where, "o", "--shard", f"{i}/3", "--chunk", 2000))[0], 0)
        self.assertGreater(chunks(where / "o"), 3)
        end(start(where, "alone"))
        self.assertEqual(contents(where / "o"), contents(where / "alone"))

    def test_unfinished_json(self):
        told = json.loads(self.go("--shard", "1/11", "--json"))
        self.assertEqual(told["search"], {"finished": False, "stopped": False, "chunks_done": 2, "chunks": 22})
        # A single process with --resume computes the chunks of the other shards.
        self.go("--resume")
        self.check()

    def test_killed_and_resumed(self):
        self.kill_at_random(lambda *args: self.begin("--threads", 1, *args))
        self.forget_parts()
        self.check()

    def test_killed_at_its_beginning(self):
        for _ in range(8):
            process = self.begin("--threads", 1, *(("--resume",) if chunks(self.out) else ("--shard", "1/1")))
            time.sleep(self.random.uniform(0, 0.15))
            process.kill()
            end(process)
        self.go("--shard", "1/1")
        self.forget_parts()
        self.check()

    def test_shards_killed_and_begun_again(self):
        for _ in range(2):
            shards = [self.begin("--shard", f"{i}/3", "--threads", 1) for i in (1, 2, 3)]
            for shard in shards:
                time.sleep(self.random.uniform(0, self.seconds / 3))
                shard.kill()
            for shard in shards:
                end(shard)
        shards = [self.begin("--shard", f"{i}/2", "--threads", 1) for i in (1, 2)]
        for shard in shards:
            status, _, err = end(shard)
            self.assertEqual(status, 0, err)
        self.forget_parts()
        self.check()

    def test_killed_while_the_files_are_written(self):
        self.go("--shard", "1/2")
        self.go("--shard", "2/2")
        for _ in range(4):
            for name in self.alone:
                (self.out / name).unlink(missing_ok=True)
            process = self.begin("--resume")
            time.sleep(self.random.uniform(0.1, 0.5) * self.seconds)
            process.kill()
            end(process)
            for name, whole in self.alone.items():  # each file is either complete or missing
                if (self.out / name).exists():
                    self.assertEqual((self.out / name).read_bytes(), whole)
        self.go("--resume")
        # Killed processes have left these files. The program never reads them.
        for part in self.out.glob("*.part*"):
            part.unlink()
        self.check()

    def test_interrupt(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            process = self.begin("--threads", 1, *(("--resume",) if self.out.exists() else ()))
            before = chunks(self.out)
            self.assertTrue(wait_until(lambda: chunks(self.out) > before + 1))
            process.send_signal(how)
            status, out, err = end(process)
            self.assertEqual([status, out], [3, ""], err)
            self.assertIn("--resume continues the search", err)
            self.assertIn(f"{chunks(self.out)} of 22 chunks are done", err)
            self.assertEqual(list(self.out.glob("*.json")), [])
            self.assertEqual(list(self.out.glob("chunks/*.part*")), [])
        self.go("--resume")
        self.check()

    def test_interrupt_of_a_search_without_a_folder(self):
        text = spec(WIDE, modules_mm=[1 + i / 8 for i in range(25)], pinion_teeth=[10, 1000], helix_step_deg=0.6)
        where = folder(text)
        process = subprocess.Popen([BIN, "search", "case.toml", "--json"], cwd=where, text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        status, out, err = end(process)
        self.assertEqual(status, 3, err)
        self.assertIn("nothing is saved", err)
        self.assertEqual([json.loads(out)["search"][key] for key in ("finished", "stopped")], [False, True])

    def test_a_damaged_and_a_lost_chunk_are_computed_again(self):
        self.go("--threads", 2)
        for name in self.alone:
            (self.out / name).unlink()
        damaged = self.out / "chunks/000003.chunk"
        damaged.write_bytes(damaged.read_bytes()[:-1])
        (self.out / "chunks/000007.chunk").unlink()
        status, _, err = end(self.begin("--resume"))
        self.assertEqual(status, 0, err)
        self.assertIn("000003.chunk", err)
        self.assertIn("000007.chunk is in the journal but not in the folder", err)
        (self.out / "chunks/000003.chunk.damaged").unlink()
        self.check()

    def test_the_journal_may_be_lost(self):
        self.go("--shard", "1/2")
        (self.out / "journal.sqlite").unlink()
        self.go("--resume")
        self.check()

    @unittest.skipIf("GW_SANITIZED" in os.environ, "sanitizers keep freed memory")
    def test_memory_of_ten_million_candidates(self):
        text = spec(WIDE, modules_mm=[1 + i / 8 for i in range(25)], pinion_teeth=[10, 400], helix_step_deg=0.6)
        where = folder(text)
        for args in (("--out", "o"), ("--json", "--top", "10")):
            process = subprocess.Popen([BIN, "search", "case.toml", *args], cwd=where, stdout=subprocess.PIPE, text=True)
            with process.stdout:
                out = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            self.assertLess(usage.ru_maxrss * 1024, MOST_BYTES)
        self.assertGreater(json.loads(out)["search"]["tested"], 8e6)


class FinishedFolder(unittest.TestCase):
    """If the spec has changed, the files of a finished search are not replaced."""

    def test_another_spec_is_refused(self):
        where = folder(spec())

        def run(*args):
            return end(start(where, "o", *args))

        self.assertEqual(run()[0], 0)
        before = contents(where / "o")
        self.assertEqual(run()[0], 0)  # the same spec gives the same files again
        self.assertEqual(contents(where / "o"), before)
        (where / "case.toml").write_text('title = "other words"\n' + spec())
        self.assertEqual(run()[0], 0)  # the title does not affect the result
        before = contents(where / "o")
        (where / "case.toml").write_text(spec(contact_ratio_min=1.3))
        for args in ((), ("--chunk", 50), ("--threads", 1)):
            status, _, err = run(*args)
            self.assertEqual(status, 1, err)
            for words in ("--out", "finished search with another spec", "search.contact_ratio_min was not set and is now 1.3", "another folder"):
                self.assertIn(words, err)
        self.assertEqual(contents(where / "o"), before)
        self.assertFalse((where / "o/journal.sqlite").exists())
        (where / "o/search.parquet").unlink()
        self.assertEqual(run()[0], 0)


class Grid(unittest.TestCase):
    def test_points_of_the_grid_too(self):
        text = spec(shift_step=0.05)
        where = folder(text)
        for out, *args in (("alone",), ("threads", "--threads", 2, "--chunk", 20), ("shards", "--chunk", 30, "--shard", "2/2"),
                           ("shards", "--chunk", 30, "--shard", "1/2")):
            status, _, err = end(start(where, out, *args))
            self.assertEqual(status, 0, err)
        points = (where / "alone/points.parquet").read_bytes()
        for out in ("threads", "shards"):
            self.assertEqual(contents(where / out), contents(where / "alone"))
            self.assertTrue((where / out / "points.parquet").read_bytes() == points)
        counted = json.loads((where / "alone/search.json").read_text())["search"]
        rows = duckdb(where / "alone/points.parquet", "select count(*) as n, min(contact_ratio) as eps, min(x1) as x from data")
        self.assertEqual(rows[0]["n"], counted["points_feasible"])
        self.assertGreaterEqual(counted["points_tested"], counted["points_feasible"])
        self.assertGreaterEqual(rows[0]["eps"], 1.2 - 1e-9)
        self.assertGreaterEqual(rows[0]["x"], -0.6 - 1e-9)


if __name__ == "__main__":
    unittest.main()
