"""Tests the job scripts of examples/slurm on a Slurm cluster of two nodes. The files equal those of a
single process, byte for byte, even if processes are killed.

The requirements are those of two_nodes.py. If they are not met, the test is skipped with the reason.
"""
import os
import shutil
import signal
import unittest

from searching import BIN, SOURCE, WIDE, chunks, contents, end, folder, spec, start, wait_until
from two_nodes import NODES, TwoNodes, main

SCRIPTS = SOURCE / "examples" / "slurm"
# 10 million candidates, which take ten seconds on one core.
SPEC = spec(WIDE, modules_mm=[1 + i / 8 for i in range(25)], pinion_teeth=[10, 400], helix_step_deg=0.6)
CHUNK = ("--chunk", 100_000)


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = TwoNodes()
        path = os.path.dirname(BIN) + os.pathsep + os.environ["PATH"]
        cls.cluster.environment |= {"PATH": path}
        cls.enterClassContext(cls.cluster)
        cls.where = folder(SPEC)
        status, _, err = end(start(cls.where, "alone", *CHUNK))
        assert status == 0, err
        cls.alone = contents(cls.where / "alone")

    def submit(self, *args):
        return self.cluster.submit(self.where, "--cpus-per-task=2", *args)

    def log(self, job):
        return "\n".join(path.read_text() for path in sorted(self.where.glob(f"slurm-{job}*.out"))) + self.cluster.logs()

    def finish(self, job, out):
        self.cluster.wait_for_job(job)
        self.assertTrue((self.where / out / "search.json").exists(), self.log(job))
        self.assertEqual(contents(self.where / out), self.alone)

    def test_an_array_whose_tasks_on_one_node_are_killed(self):
        out = self.where / "array"
        line = ("--array=0-3", SCRIPTS / "search_array.sbatch", "case.toml", "array", *CHUNK)
        job = self.submit(*line)
        seen = {node: set() for node in NODES}

        def both_at_work():
            for node in NODES:
                seen[node] |= set(self.cluster.processes(node, "gearwright"))
            return all(seen.values()) and chunks(out) > 0 and self.cluster.processes("n2", "gearwright")

        self.assertTrue(wait_until(both_at_work), self.log(job))
        for process in self.cluster.processes("n2", "gearwright"):
            os.kill(process, signal.SIGKILL)
        self.cluster.wait_for_job(job)
        done = chunks(out)
        self.assertFalse((out / "search.json").exists(), "the kill came too late to test anything")
        self.assertGreater(done, 0)
        self.finish(self.submit(*line), "array")
        self.assertEqual(list(out.glob("chunks/*.part.*")), [])

    def test_an_array_of_another_size_takes_over(self):
        line = (SCRIPTS / "search_array.sbatch", "case.toml", "other", *CHUNK)
        first = self.submit("--array=0-1", *line)
        self.assertTrue(wait_until(lambda: chunks(self.where / "other") > 0), self.log(first))
        self.cluster.ask("scancel", "--signal=KILL", "--full", first)
        self.cluster.ask("scancel", first)
        self.cluster.wait_for_job(first)
        self.finish(self.submit("--array=0-2", *line), "other")

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun (Debian: openmpi-bin)")
    def test_ranks_of_one_job(self):
        out = self.where / "ranks"
        line = ("--ntasks=2", "--nodes=1", "--cpus-per-task=1", SCRIPTS / "search_mpi.sbatch", "case.toml", "ranks", *CHUNK)
        job = self.cluster.submit(self.where, *line)
        self.assertTrue(wait_until(lambda: chunks(out) > 0), self.log(job))
        ranks = self.cluster.processes(name="gearwright-mpi")
        self.assertEqual(len(ranks), 2)
        os.kill(max(ranks), signal.SIGKILL)
        self.cluster.wait_for_job(job)
        self.assertFalse((out / "search.json").exists(), "the kill came too late to test anything")
        self.finish(self.cluster.submit(self.where, *line), "ranks")


if __name__ == "__main__":
    main()
