"""A search in many chunks, for tests of interrupted and distributed searches. Its files must equal the
files of a single process."""
import json
import os
import random
import sqlite3
import time
import unittest

from searching import WIDE, chunks, contents, end, folder, spec, start, wait_until

SEED = int(os.environ.get("GW_SEED", "20260917"))


class Campaign(unittest.TestCase):
    """Base class. A single process computes the reference result of a search with 22 chunks."""

    TEXT = spec(WIDE)
    CHUNK = ("--chunk", 200_000)  # gives 22 chunks
    CHUNKS = 22

    @classmethod
    def setUpClass(cls):
        cls.where = folder(cls.TEXT)
        began = time.monotonic()
        status, _, err = end(start(cls.where, "alone", "--threads", 1, *cls.CHUNK))
        assert status == 0, err
        cls.seconds = time.monotonic() - began
        cls.alone = contents(cls.where / "alone")
        cls.random = random.Random(SEED)

    def setUp(self):
        self.out = self.where / self.id().rsplit(".", 1)[-1]

    def go(self, *args, **options):
        process = self.begin(*args, **options)
        status, out, err = end(process)
        self.assertEqual(status, 0, f"{args}\n{err}")
        return out

    def begin(self, *args, **options):
        return start(self.where, self.out, *self.CHUNK, *args, **options)

    def check(self):
        """Checks that the files equal the files of a single process, and that the journal adds up. Returns
        the writers of the chunks."""
        files = contents(self.out)
        for name, one in self.alone.items():
            self.assertTrue(files[name] == one, f"{name} differs from that of one process (GW_SEED={SEED})")
        self.assertEqual(sorted(p.name for p in self.out.glob("*")), sorted(["chunks", "journal.sqlite", *self.alone]))
        names = sorted(p.name for p in (self.out / "chunks").iterdir())
        self.assertEqual(names, [f"{i:06}.chunk" for i in range(self.CHUNKS)])
        result = json.loads(files["search.json"])["search"]
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            journal.row_factory = sqlite3.Row
            rows = journal.execute("select * from chunks order by chunk").fetchall()
            of = dict(journal.execute("select key, value from campaign").fetchall())
        self.assertEqual([row["chunk"] for row in rows], list(range(self.CHUNKS)))
        self.assertEqual(of["chunks"], str(self.CHUNKS))
        self.assertEqual(sum(row["tested"] for row in rows), result["tested"])
        self.assertEqual(sum(row["feasible"] for row in rows), result["feasible_count"])
        self.assertEqual({name: sum(row[name] for row in rows) for name in result["rejected"]}, result["rejected"])
        for row in rows:
            self.assertEqual(row["tested"], row["feasible"] + sum(row[name] for name in result["rejected"]))
        return {row["writer"] for row in rows}

    def forget_parts(self):
        """Removes incomplete files that killed processes left. The program never reads them."""
        for part in self.out.glob(".*.part"):
            part.unlink()

    def kill_at_random(self, begin, kills=4):
        """Kills the process several times, each time after a random number of chunks and a random delay.
        Then lets it finish."""
        for _ in range(kills):
            process = begin("--resume") if chunks(self.out) else begin()
            enough = chunks(self.out) + self.random.randint(1, 4)
            self.assertTrue(wait_until(lambda: chunks(self.out) >= enough))
            time.sleep(self.random.uniform(0, 2 * self.seconds / self.CHUNKS))
            self.assertIsNone(process.poll(), "the kill came too late to test anything")
            process.kill()
            end(process)
        status, _, err = end(begin("--resume"))
        self.assertEqual(status, 0, err)
