"""Tests gearwright-mpi on two ranks. The files equal the files of a single process even if processes are
killed, and no rank waits forever.

Exit status 77: mpirun is not installed.
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest

from campaign import Campaign
from searching import chunks, contents, end, folder, spec, start, wait_until

MPIRUN = shutil.which("mpirun")
MPI = (MPIRUN, "--oversubscribe", "-n", "2", os.path.join(os.environ["GW_BUILD"], "gearwright-mpi"))
# Open MPI leaks memory in modules that it unloads. A suppression list cannot name these leaks.
AS_ROOT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                        "ASAN_OPTIONS": "detect_leaks=0"}
SMALL_CHUNK = ("--chunk", 100)


class Ranks(Campaign):
    def mpi(self, *args):
        return self.begin(*args, program=MPI, env=AS_ROOT)

    def rank_processes(self, mpirun):
        """Returns the ranks, which are child processes of mpirun."""
        found = []
        for pid in os.listdir("/proc"):
            if pid.isdigit():
                try:
                    with open(f"/proc/{pid}/stat") as stat:
                        name, rest = stat.read().rsplit(")", 1)
                except OSError:
                    continue
                if int(rest.split()[1]) == mpirun.pid and "gearwright-mpi" in name:
                    found.append(int(pid))
        return found

    def test_two_ranks(self):
        self.assertEqual(json.loads(self.go("--json", program=MPI, env=AS_ROOT))["search"]["feasible_count"], 3633)
        self.assertEqual(self.check(), {"rank 0", "rank 1"})

    def kill_a_rank(self, which):
        process = self.mpi()
        self.assertTrue(wait_until(lambda: chunks(self.out) > 2))
        ranks = sorted(self.rank_processes(process))
        self.assertEqual(len(ranks), 2)
        os.kill(ranks[which], signal.SIGKILL)
        self.assertNotEqual(end(process)[0], 0)
        self.assertFalse((self.out / "search.json").exists(), "the kill came too late to test anything")

    def test_a_rank_killed_and_ranks_resume(self):
        self.kill_a_rank(0)
        status, _, err = end(self.mpi("--resume"))
        self.assertEqual(status, 0, err)
        self.check()

    def test_a_rank_killed_and_one_process_resumes(self):
        self.kill_a_rank(1)
        self.go("--resume")
        self.check()

    def test_one_process_killed_and_ranks_resume(self):
        process = self.begin("--threads", 1)
        self.assertTrue(wait_until(lambda: chunks(self.out) > 3))
        process.kill()
        end(process)
        status, _, err = end(self.mpi("--resume"))
        self.assertEqual(status, 0, err)
        self.assertEqual(self.check() - {None}, {"search", "rank 0", "rank 1"})

    def test_refusals_end_all_ranks(self):
        small = folder(spec())
        self.assertEqual(end(start(small, "o", *SMALL_CHUNK))[0], 0)

        def ask(out, *args):
            return end(start(small, out, *args, program=MPI, env=AS_ROOT), 60)

        for wanted, words, *args in ((1, "this folder contains a search", "o", *SMALL_CHUNK),
                                     (1, "this folder contains a search with another spec", "o", "--resume", "--chunk", 90),
                                     (2, "--shard", "none", "--shard", "1/2"), (2, "--top", "none", "--top", 0),
                                     (3, "/proc/none", "/proc/none")):
            status, out, err = ask(*args)
            self.assertEqual([status, out], [wanted, ""], f"{args} {err}")
            self.assertEqual(err.count(words), 1, err)  # only one rank prints the message
        (small / "case.toml").write_text(spec(ratio=[2.1, 1.9]))
        status, out, err = ask("none", "--json")
        self.assertEqual([status, json.loads(out)["error"]["key"]], [1, "search.ratio"], err)
        self.assertFalse((small / "none").exists())

    def test_the_standard_input_is_rejected(self):
        # Only rank 0 would receive the spec, and it would wait for the other rank forever.
        for verb in ("search", "scatter"):
            run = subprocess.run([*MPI, verb, "-", "--out", folder(spec()) / "found"], input=spec(), env=AS_ROOT,
                                 capture_output=True, text=True, timeout=60)
            self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
            self.assertIn("give the spec as a file", run.stderr)

    def test_fewer_chunks_than_ranks(self):
        small = folder(spec())
        self.assertEqual(end(start(small, "one"))[0], 0)
        self.assertEqual(end(start(small, "two", program=MPI, env=AS_ROOT))[0], 0)
        self.assertEqual(contents(small / "one"), contents(small / "two"))

    def test_a_full_disk_of_one_rank_ends_all(self):
        # A limit of the file size has the same effect as a full disk.
        for rank in ("0", "1"):
            shutil.rmtree(self.out, ignore_errors=True)
            script = f"if [ $OMPI_COMM_WORLD_RANK = {rank} ]; then ulimit -f 20; trap '' XFSZ; fi; exec '{MPI[-1]}' \"$@\""
            status, out, err = end(self.begin(program=(*MPI[:-1], "bash", "-c", script, "rank"), env=AS_ROOT), 60)
            self.assertEqual([status, out], [3, ""], err)
            self.assertIn(str(self.out), err)
        status, _, err = end(self.mpi("--resume"))
        self.assertEqual(status, 0, err)
        self.check()

    def test_resume_begins_too(self):
        for _ in range(3):  # a scheduler restarts a job with the same command line
            process = self.mpi("--resume")
            time.sleep(self.random.uniform(0.3, 0.6))
            process.kill()
            end(process)
        status, _, err = end(self.mpi("--resume"))
        self.assertEqual(status, 0, err)
        self.forget_parts()
        self.check()


if __name__ == "__main__":
    if not MPIRUN:
        print("skipped: no mpirun (Debian: openmpi-bin)")
        sys.exit(77)
    unittest.main()
